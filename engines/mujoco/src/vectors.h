// Vectors of three numbers and matrices of nine, row by row.
#ifndef TRIBOS_MUJOCO_VECTORS_H
#define TRIBOS_MUJOCO_VECTORS_H

#include <math.h>
#include <string.h>

static inline double dot3(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static inline void cross3(double out[3], const double a[3], const double b[3])
{
    out[0] = a[1] * b[2] - a[2] * b[1];
    out[1] = a[2] * b[0] - a[0] * b[2];
    out[2] = a[0] * b[1] - a[1] * b[0];
}

static inline void subtract3(double out[3], const double a[3], const double b[3])
{
    for (int i = 0; i < 3; i++) out[i] = a[i] - b[i];
}

// out += scale * a
static inline void add_scaled3(double out[3], const double a[3], double scale)
{
    for (int i = 0; i < 3; i++) out[i] += scale * a[i];
}

// Length up to which a vector has no direction but x: mjMINVAL, as in mju_normalize3.
#define LEAST_NORM 1e-15

static inline void normalise3(double a[3])
{
    const double norm = sqrt(dot3(a, a)), inverse = 1 / norm;
    for (int i = 0; i < 3; i++) a[i] = norm > LEAST_NORM ? a[i] * inverse : i == 0;
}

// out += matrix * a
static inline void add_product3(double out[3], const double matrix[9], const double a[3])
{
    for (int i = 0; i < 3; i++) out[i] += dot3(matrix + 3 * i, a);
}

static inline void product3(double out[3], const double matrix[9], const double a[3])
{
    for (int i = 0; i < 3; i++) out[i] = dot3(matrix + 3 * i, a);
}

// The inverse, or 0 where there is none.
static inline int inverse3(double out[9], const double m[9])
{
    double minors[9];
    for (int i = 0; i < 3; i++) {
        const double *next = m + 3 * ((i + 1) % 3), *last = m + 3 * ((i + 2) % 3);
        cross3(minors + 3 * i, next, last);
    }
    const double determinant = dot3(m, minors);
    if (!(fabs(determinant) > 0) || isinf(determinant)) return 0;
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++) out[3 * i + j] = minors[3 * j + i] / determinant;
    return 1;
}

#endif
