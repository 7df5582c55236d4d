/* Three calls that a firmware makes. */
#include "demo.h"
#include "tribos.h"

/* Writes a number with six decimals, without printf. */
static void put_number(double x)
{
    char text[32];
    int at = sizeof text - 1;
    int64_t millionths = (int64_t)(x * 1e6 + (x < 0 ? -0.5 : 0.5));
    uint64_t left = millionths < 0 ? (uint64_t)-millionths : (uint64_t)millionths;
    int digits = 0;

    text[at] = '\0';
    while (digits < 7 || left > 0) {
        text[--at] = (char)('0' + left % 10);
        left /= 10;
        if (++digits == 6) {
            text[--at] = '.';
        }
    }
    if (millionths < 0) {
        text[--at] = '-';
    }
    put(text + at);
}

static void put_line(const char *name, double x, const char *unit)
{
    put(name);
    put_number(x);
    put(unit);
    put("\n");
}

/* Force and torque on a puck that slides and spins. */
static void puck(void)
{
    const tribos_round_f32 contact = {.coefficient = 0.3f, .radius = 0.04f}; /* m */
    const tribos_twist_f32 twist = {.x = 1.0f, .y = 0.0f, .spin = 20.0f}; /* m/s, rad/s */
    tribos_wrench_f32 wrench;

    if (tribos_disk_wrench_f32(&contact, 1.7f, &twist, &wrench) == TRIBOS_STATUS_OK) {
        put_line("puck: force  ", wrench.x, " N");
        put_line("      torque ", wrench.torque, " N m");
    }
}

/* Friction of a joint that starts to move: one hundred steps of a controller. */
static void joint(void)
{
    const tribos_lugre_f32 law = {
        .coulomb_force = 1.0f,
        .static_force = 1.5f,
        .stribeck_speed = 1e-3f, /* m/s */
        .stiffness = 1e5f, /* N/m */
        .bristle_damping = 316.0f, /* N s/m */
        .viscous_damping = 0.4f,
    };
    float deflection = 0.0f, force = 0.0f;
    int step;

    for (step = 1; step <= 100; ++step) {
        if (tribos_lugre_step_f32(&law, &deflection, 1e-3f, 1e-3f, &force) != TRIBOS_STATUS_OK) {
            return;
        }
        if (step == 1) {
            put_line("joint: force in the first ms ", force, " N");
        }
    }
    put_line("       force after 100 ms    ", force, " N");
}

/* A coin slides and spins to rest. */
static void coin(void)
{
    const tribos_slider_f64 slider = {.deceleration = 0.3 * 9.81, .radius = 0.08, .inertia_ratio = 0.5};
    const tribos_motion_f64 launched = {.speed = 1.0, .spin = 5.0};
    tribos_rest_f64 rest;

    if (tribos_slider_to_rest_f64(&slider, &launched, &rest) == TRIBOS_STATUS_OK) {
        put_line("coin: rests after ", rest.motion.time, " s");
        put_line("      distance    ", rest.motion.distance, " m");
    }
}

/* The text of a refusal. */
static void refusal(void)
{
    const tribos_round_f64 contact = {.coefficient = -0.3, .radius = 0.04};
    const tribos_twist_f64 twist = {1.0, 0.0, 20.0};
    tribos_wrench_f64 wrench;
    tribos_status status = tribos_disk_wrench_f64(&contact, 1.7, &twist, &wrench);

    put("mu = -0.3: ");
    put(tribos_status_text(status));
    put("\n");
}

void demonstrate(void)
{
    puck();
    joint();
    coin();
    refusal();
}

void put_digest(uint64_t hash)
{
    char text[] = "digest 0000000000000000\n";
    int at;

    for (at = 22; at > 6; --at) {
        text[at] = "0123456789abcdef"[hash & 15];
        hash >>= 4;
    }
    put(text);
}
