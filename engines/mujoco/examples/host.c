// A program without window that loads the plugin and prints how far a puck slides: on its exact patch, and on
// MuJoCo's elliptic and pyramidal cones, beside the exact travel.
//
//     host libtribos_patch.so puck.xml cone.xml

#include <mujoco/mujoco.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>
#include "tribos.h"

#define MU 0.3
#define RADIUS 0.05      // m
#define GRAVITY 10.0     // m/s^2
#define SPEED 1.0        // m/s
#define SETTLE 500       // steps
#define TO_REST 2000     // steps
#define BLOCKS 200       // of steps that are timed
#define BLOCK_STEPS 100  // sliding all the while

static mjModel *load(const char *path)
{
    char error[1000] = "";
    mjModel *model = mj_loadXML(path, NULL, error, sizeof error);
    if (!model) {
        fprintf(stderr, "%s\n", error);
        exit(1);
    }
    return model;
}

static void steps(const mjModel *model, mjData *data, int count)
{
    for (int i = 0; i < count; i++) mj_step(model, data);
}

// Lets the puck settle and throws it.
static void throw_puck(const mjModel *model, mjData *data, double spin)
{
    mj_resetData(model, data);
    steps(model, data, SETTLE);
    mju_zero(data->qvel, 6);
    data->qvel[0] = SPEED;
    data->qvel[5] = spin;
}

static double travel(const mjModel *model, mjData *data, double spin)
{
    throw_puck(model, data, spin);
    const double start = data->qpos[0];
    steps(model, data, TO_REST);
    return data->qpos[0] - start;
}

static double exact_travel(double spin)
{
    const tribos_slider_f64 slider = {MU * GRAVITY, RADIUS, 0.5};
    const tribos_motion_f64 motion = {0, SPEED, spin, 0, 0};
    tribos_rest_f64 rest;
    if (tribos_slider_to_rest_f64(&slider, &motion, &rest) != TRIBOS_STATUS_OK) exit(1);
    return rest.motion.distance;
}

static double seconds(void)
{
    struct timespec now;
    timespec_get(&now, TIME_UTC);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

static int by_size(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

int main(int count, char **arguments)
{
    if (count != 4) {
        fprintf(stderr, "usage: %s libtribos_patch.so puck.xml cone.xml\n", arguments[0]);
        return 2;
    }
    mj_loadPluginLibrary(arguments[1]);
    mjModel *models[3] = {load(arguments[2]), load(arguments[3]), load(arguments[3])};
    models[1]->opt.cone = mjCONE_ELLIPTIC;
    models[2]->opt.cone = mjCONE_PYRAMIDAL;
    mjData *data[3];
    for (int k = 0; k < 3; k++) data[k] = mj_makeData(models[k]);

    printf("spin rad/s   exact m   tribos.patch   elliptic cone   pyramid\n");
    const double spins[] = {0, 5, 12.5, 50};
    for (int i = 0; i < 4; i++) {
        const double exact = exact_travel(spins[i]);
        printf("%10.1f %9.4f", spins[i], exact);
        for (int k = 0; k < 3; k++)
            printf("    %+9.2f %%", 100 * (travel(models[k], data[k], spins[i]) / exact - 1));
        printf("\n");
    }

    // Blocks of steps in turn, such that all meet the same disturbances.
    static double times[3][BLOCKS];
    for (int block = 0; block < BLOCKS; block++)
        for (int k = 0; k < 3; k++) {
            throw_puck(models[k], data[k], 12.5);
            const double start = seconds();
            steps(models[k], data[k], BLOCK_STEPS);
            times[k][block] = (seconds() - start) / BLOCK_STEPS;
        }
    const char *names[] = {"tribos.patch", "elliptic cone", "pyramid"};
    printf("time of a step, in us: least and median of %d blocks of %d steps\n", BLOCKS, BLOCK_STEPS);
    for (int k = 0; k < 3; k++) {
        qsort(times[k], BLOCKS, sizeof(double), by_size);
        printf("%-14s %6.2f %6.2f\n", names[k], 1e6 * times[k][0], 1e6 * times[k][BLOCKS / 2]);
    }
    for (int k = 0; k < 3; k++) {
        mj_deleteData(data[k]);
        mj_deleteModel(models[k]);
    }
    return 0;
}
