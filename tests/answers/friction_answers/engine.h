// An engine as a shared library: what `friction-answers run ./libmy_engine.so` calls. SI units, z upwards, axes of the world.
// Fill in the eight functions, or in C++ the class at the end: cc -shared -fPIC -I FOLDER_OF_THIS_FILE my_engine.c -o libmy_engine.so, and what the
// engine needs.
// An engine without cylinders takes prisms of 32 sides or more. Restitution, damping and sleep are off; friction between any two bodies is `mu`.
// Check first, in this order: `--items collide` (masses, inertia, frames of spins; a few percent at 1/60 s, less than 0.1 % at 1 ms), `--items oblique`,
// `--items box --case 0` (0.1667 m, or less by half a step at 1 m/s where steps are of first order), then `--quick`.
#pragma once
#ifdef __cplusplus
extern "C" {
#endif

enum fa_kind { FA_BOX, FA_CYLINDER, FA_BALL, FA_CAPSULE, FA_FEET };

typedef struct fa_body
{
	// Box: half sides along x, y, z. Cylinder: radius, half its height along z. Ball: radius. Capsule: radius, half the length of its straight part along x.
	// Feet: x and y of each of three balls of 1 cm radius in the plane z = 0 of the body. All about the body's origin.
	int kind;
	int is_driven; // moves with the velocity and spin that fa_set gives it before every step, whatever it touches
	int is_rim;    // a cylinder that stands on the thin rim of its face: ignored by engines that have no such face
	double sizes[6];
	double place[3], pose[4]; // of the body's origin, m; quaternion w, x, y, z
	double mass, inertia[3], com[3]; // kg, of driven bodies too; principal moments about the centre of mass, kg m^2; centre of mass in the body, m
} fa_body;

typedef struct fa_scene
{
	double mu, mu_across; // along x and y of the bodies; mu_across is negative where all directions are alike
	double torsion;       // largest torsion torque over normal force, m; 0 where points resist no spin
	double gravity[3], dt; // m/s^2; length of a step, s
	int has_floor;        // at z = 0
	int setting;          // which of fa_about's, from 0
	int count;
	const fa_body *bodies;
} fa_scene;

// Seen from outside also where an engine's flags hide all else.
#ifdef _WIN32
#define FA_CALL __declspec(dllexport)
#else
#define FA_CALL __attribute__((visibility("default")))
#endif

// {"name": …, "version": …, "licence": …, "kind": "games", "mechanics" or "gpu", "settings": {name: {"dt": s, any other options}}}: the engine's own defaults first.
// Strings live as long as the library. Several worlds may live at once, on one thread.
FA_CALL const char *fa_about(void);
// A world, or NULL and a sentence in `why` about what the engine has not: mu_across, torsion, a shape.
FA_CALL void *fa_make(const fa_scene *scene, const char **why);
FA_CALL void fa_drop(void *world);
// Velocity of the centre of mass, m/s, and spin, rad/s. Of driven bodies, it is called anew before every step.
FA_CALL void fa_set(void *world, int body, const double velocity[3], const double spin[3]);
FA_CALL void fa_step(void *world);
// Centre of mass, quaternion w, x, y, z, velocity of the centre of mass, spin.
FA_CALL void fa_state(void *world, int body, double state[13]);
FA_CALL void fa_gravity(void *world, const double gravity[3]);
// On a centre of mass in the next step, N.
FA_CALL void fa_force(void *world, int body, const double force[3]);

#ifdef __cplusplus
}
#include <algorithm>
#include <array>
// Coulomb's law at points, alike in all directions, holds all but this.
inline const char *fa_lacks(const fa_scene &scene)
{
	return scene.torsion > 0 ? "Contacts have no torsional friction." : scene.mu_across >= 0 ? "Friction is the same in all directions." : nullptr;
}
// The eight functions of a class World that is made of a fa_scene and has set, step, state, gravity and force, as above but without `world`; state gives
// an array of 13 doubles. `lacks` is fa_lacks, or one's own.
#define FA_ENGINE(World, about, lacks)                                                                                                        \
	extern "C" {                                                                                                                              \
	const char *fa_about(void) { return about; }                                                                                              \
	void *fa_make(const fa_scene *scene, const char **why) { return (*why = lacks(*scene)) ? nullptr : new World(*scene); }                   \
	void fa_drop(void *world) { delete (World *)world; }                                                                                      \
	void fa_set(void *world, int body, const double velocity[3], const double spin[3]) { ((World *)world)->set(body, velocity, spin); }       \
	void fa_step(void *world) { ((World *)world)->step(); }                                                                                   \
	void fa_state(void *world, int body, double state[13])                                                                                    \
	{                                                                                                                                         \
		const std::array<double, 13> found = ((World *)world)->state(body);                                                                   \
		std::copy(found.begin(), found.end(), state);                                                                                         \
	}                                                                                                                                         \
	void fa_gravity(void *world, const double gravity[3]) { ((World *)world)->gravity(gravity); }                                             \
	void fa_force(void *world, int body, const double force[3]) { ((World *)world)->force(body, force); }                                     \
	}
#endif
