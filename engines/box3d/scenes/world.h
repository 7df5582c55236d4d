// The world of the scenes: a floor, bodies on it, and the angle by which a body has turned about the vertical.
// x is the direction of a launch, y points up, and -z is to the left. Units: SI.
#pragma once

#include "box3d/box3d.h"

#define GRAVITY 9.81

// A world without sleep on one thread, its gravity turned about z so that a level floor is a slope of this angle.
b3WorldId create_world( double slope_rad );

// The floor, 100 m wide, with its upper face at y = 0. The coefficient of a contact is the geometric mean of both
// surfaces, so a body with the floor's coefficient meets that coefficient.
void add_floor( b3WorldId world, float mu );

// A dynamic body with the shape of this hull.
b3BodyId add_body( b3WorldId world, const b3HullData* hull, b3Pos position, b3Quat rotation, float mu );

// Steps the world for this time, with four substeps a step.
void step_for( b3WorldId world, double seconds, double rate_hz );
void step_once( b3WorldId world, double rate_hz );

// Angle about the vertical, in (-pi, pi].
double heading( b3BodyId body );

// Adds the change of heading since the last call to `turn`; valid for less than half a turn a step.
typedef struct Turn
{
	double last_heading;
	double angle;
} Turn;
Turn start_turn( b3BodyId body );
void follow_turn( Turn* turn, b3BodyId body );

// CPU time of this thread, in s.
double thread_seconds( void );
