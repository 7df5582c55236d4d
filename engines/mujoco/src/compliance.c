#include "compliance.h"

#include "vectors.h"

// block += left * right' / mass, a row at a time.
static void add_outer(double block[36], const double left[36], const double right[36], const double mass[6])
{
    double turned[36];
    for (int k = 0; k < 36; k++) turned[k] = right[6 * (k % 6) + k / 6] / mass[k / 6];
    for (int row = 0; row < 6; row++) {
        double sum[6] = {0, 0, 0, 0, 0, 0};
        for (int k = 0; k < 6; k++)
            for (int column = 0; column < 6; column++) sum[column] += left[6 * row + k] * turned[6 * k + column];
        for (int column = 0; column < 6; column++) block[6 * row + column] += sum[column];
    }
}

// Mass along the axes of the world and inertia about its own of a body.
static void mass_of(const view *v, int body, double mass[6])
{
    for (int k = 0; k < 3; k++) {
        mass[k] = v->body_mass[body];
        mass[3 + k] = v->body_inertia[3 * body + k];
    }
}

// Where all bodies move freely.
static void free_mobility(const view *v, foot **feet, int count, double *mobility)
{
    for (int i = 0; i < count; i++)
        for (int j = i; j < count; j++) {
            double *block = mobility + 36 * (count * i + j);
            memset(block, 0, 36 * sizeof(double));
            for (int a = 0; a < 2; a++)
                for (int b = 0; b < 2; b++) {
                    if (!feet[i]->moves[a] || feet[i]->bodies[a] != feet[j]->bodies[b]) continue;
                    double mass[6];
                    mass_of(v, feet[i]->bodies[a], mass);
                    add_outer(block, feet[i]->rows[a], feet[j]->rows[b], mass);
                }
            double *mirror = mobility + 36 * (count * j + i);
            for (int k = 0; i != j && k < 36; k++) mirror[k] = block[6 * (k % 6) + k / 6];
        }
}

// For any bodies, with MuJoCo's factors of the mass.
static void solved_mobility(const view *v, foot **feet, int count, double *rows, double *mobility)
{
    const int nv = v->nv;
    double *solved = rows + ROWS(count, nv) / 2;
    memset(rows, 0, sizeof(double) * 6 * count * nv);
    for (int i = 0; i < count; i++)
        for (int k = 0; k < feet[i]->freedom_count; k++)
            for (int row = 0; row < 6; row++)
                rows[nv * (6 * i + row) + feet[i]->freedoms[k].index] =
                    feet[i]->jacobian[MOTIONS * k + row];
    v->solve(v->model, v->data, solved, rows, 6 * count);
    for (int i = 0; i < count; i++)
        for (int j = 0; j < count; j++)
            for (int row = 0; row < 6; row++)
                for (int column = 0; column < 6; column++) {
                    double sum = 0;
                    for (int k = 0; k < feet[i]->freedom_count; k++)
                        sum += feet[i]->jacobian[MOTIONS * k + row] *
                               solved[nv * (6 * j + column) + feet[i]->freedoms[k].index];
                    mobility[36 * (count * i + j) + 6 * row + column] = sum;
                }
}

// Acceleration of each foot in its six motions by unit wrenches on each: a row-major 6 x 6 block for each pair.
static void find_mobility(const view *v, foot **feet, int count, bool is_free, double *rows, double *mobility)
{
    if (is_free)
        free_mobility(v, feet, count, mobility);
    else
        solved_mobility(v, feet, count, rows, mobility);
}

// Solves system * x = right of `size` rows for `columns` right sides at once, in place, with row pivots.
static bool eliminate(double *system, double *right, int size, int columns)
{
    for (int k = 0; k < size; k++) {
        int pivot = k;
        for (int i = k + 1; i < size; i++)
            if (fabs(system[size * i + k]) > fabs(system[size * pivot + k])) pivot = i;
        if (!(fabs(system[size * pivot + k]) > 0)) return false;
        if (pivot != k) {
            for (int j = 0; j < size; j++) {
                const double kept = system[size * k + j];
                system[size * k + j] = system[size * pivot + j];
                system[size * pivot + j] = kept;
            }
            for (int j = 0; j < columns; j++) {
                const double kept = right[columns * k + j];
                right[columns * k + j] = right[columns * pivot + j];
                right[columns * pivot + j] = kept;
            }
        }
        for (int i = k + 1; i < size; i++) {
            const double factor = system[size * i + k] / system[size * k + k];
            for (int j = k + 1; j < size; j++) system[size * i + j] -= factor * system[size * k + j];
            for (int j = 0; j < columns; j++) right[columns * i + j] -= factor * right[columns * k + j];
        }
    }
    for (int k = size - 1; k >= 0; k--) {
        double *found = right + columns * k;
        for (int i = k + 1; i < size; i++)
            for (int j = 0; j < columns; j++) found[j] -= system[size * k + i] * right[columns * i + j];
        for (int j = 0; j < columns; j++) found[j] /= system[size * k + k];
    }
    return true;
}

// The same of one body that moves freely: its mass and the springs of all its feet resist together.
static void body_compliance(const view *v, foot **feet, int count, int body, double *scratch, double *compliance)
{
    double mass[6], root[6][6] = {{0}}, inverse[6];
    mass_of(v, body, mass);
    for (int k = 0; k < 6; k++) root[k][k] = mass[k];
    for (int i = 0; i < count; i++) {
        // Lift alone shifts the body; the lower triangle is enough.
        const double *lift = feet[i]->rows[feet[i]->moves[0] ? 0 : 1] + 6 * LIFT, *turn = lift + 3;
        double moments[3][3] = {{0}};
        for (int a = 0; a < 3; a++)
            for (int b = 0; b < 3; b++) add_scaled3(moments[a], turn + 6 * b, feet[i]->stiffness[3 * a + b]);
        for (int row = 0; row < 3; row++)
            for (int k = 0; k < 3; k++) {
                root[row][k] += feet[i]->stiffness[0] * lift[row] * lift[k];
                root[3 + row][k] += moments[0][row] * lift[k];
                root[3 + row][3 + k] +=
                    turn[row] * moments[0][k] + turn[6 + row] * moments[1][k] + turn[12 + row] * moments[2][k];
            }
    }
    // Cholesky's lower triangle.
    for (int k = 0; k < 6; k++) {
        for (int j = 0; j < k; j++) root[k][k] -= root[k][j] * root[k][j];
        inverse[k] = 1 / sqrt(root[k][k]);
        for (int i = k + 1; i < 6; i++) {
            for (int j = 0; j < k; j++) root[i][k] -= root[i][j] * root[k][j];
            root[i][k] *= inverse[k];
        }
    }
    for (int i = 0; i < count; i++) {
        const double *rows = feet[i]->rows[feet[i]->moves[0] ? 0 : 1];
        double *solved = scratch + 18 * i;
        for (int row = 0; row < 3; row++)
            for (int k = 0; k < 6; k++) {
                double sum = rows[6 * row + k];
                for (int j = 0; j < k; j++) sum -= root[k][j] * solved[6 * row + j];
                solved[6 * row + k] = sum * inverse[k];
            }
    }
    for (int i = 0; i < count; i++)
        for (int j = i; j < count; j++)
            for (int row = 0; row < 3; row++)
                for (int column = 0; column < 3; column++) {
                    const double *a = scratch + 18 * i + 6 * row, *b = scratch + 18 * j + 6 * column;
                    const double sum = dot3(a, b) + dot3(a + 3, b + 3);
                    compliance[9 * (count * i + j) + 3 * row + column] = sum;
                    compliance[9 * (count * j + i) + 3 * column + row] = sum;
                }
}

// The mobility less what the springs of the contacts take, P - M K (1 + N K)^-1 M^T, in its blocks P in the plane, N along
// the normals, M between them, and the springs' stiffness K.
static void sprung_compliance(foot **feet, int count, const double *mobility, double *scratch, double *compliance)
{
    const int size = 3 * count;
    double *system = scratch, *right = scratch + size * size;
    for (int i = 0; i < count; i++)
        for (int j = 0; j < count; j++) {
            const double *block = mobility + 36 * (count * i + j), *stiffness = feet[j]->stiffness;
            for (int row = 0; row < 3; row++)
                for (int column = 0; column < 3; column++) {
                    double sum = i == j && row == column ? 1 : 0;
                    for (int k = 0; k < 3; k++)
                        sum += block[6 * (3 + row) + 3 + k] * stiffness[3 * k + column];
                    const int at = size * (3 * i + row) + 3 * j + column;
                    system[at] = sum;
                    right[at] = block[6 * (3 + row) + column];
                }
        }
    // The forces of the springs.
    if (!eliminate(system, right, size, size)) memset(right, 0, sizeof(double) * size * size);
    for (int k = 0; k < count; k++)
        for (int column = 0; column < size; column++) {
            double *at = right + 3 * size * k + column, motion[3] = {at[0], at[size], at[2 * size]};
            for (int row = 0; row < 3; row++) at[size * row] = dot3(feet[k]->stiffness + 3 * row, motion);
        }
    for (int i = 0; i < count; i++)
        for (int j = 0; j < count; j++) {
            double *block = compliance + 9 * (count * i + j);
            const double *whole = mobility + 36 * (count * i + j);
            for (int row = 0; row < 3; row++)
                for (int column = 0; column < 3; column++) block[3 * row + column] = whole[6 * row + column];
            for (int k = 0; k < count; k++) {
                const double *between = mobility + 36 * (count * i + k), *push = right + 3 * size * k + 3 * j;
                for (int row = 0; row < 3; row++)
                    for (int column = 0; column < 3; column++)
                        block[3 * row + column] -= between[6 * row + 3] * push[column] +
                                                   between[6 * row + 4] * push[size + column] +
                                                   between[6 * row + 5] * push[2 * size + column];
            }
        }
}

void find_compliance(const view *v, foot **feet, int count, bool is_free, int body, double *scratch, double *compliance)
{
    if (body) {
        body_compliance(v, feet, count, body, scratch, compliance);
        return;
    }
    double *mobility = scratch, *rest = mobility + MOBILITY(count), *rows = rest + SPRINGS(count);
    find_mobility(v, feet, count, is_free, rows, mobility);
    sprung_compliance(feet, count, mobility, rest, compliance);
}
