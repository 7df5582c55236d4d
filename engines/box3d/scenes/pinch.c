#include "pinch.h"

#include "world.h"

#include <math.h>
#include <stdio.h>

// As in bindings/python/benches/hold.py: masses in kg, lengths in m, the grip in N, the damping of a pad in 1/s.
static const float mu = 0.7f, grip = 12.0f;
static const float capsule_mass = 0.045f, radius = 0.004f, half_length = 0.015f;
static const float pad_mass = 0.2f, pad_damping = 100.0f;
static const b3Vec3 pad_half_sides = { 0.01f, 0.02f, 0.02f };
static const double rate_hz = 240.0, ramp_s = 0.5, settle_s = 1.0, seconds = 10.0;

static void set_box_mass( b3BodyId body, float mass, b3Vec3 half )
{
	b3Vec3 square = { half.x * half.x, half.y * half.y, half.z * half.z };
	b3Matrix3 inertia = { { square.y + square.z, 0.0f, 0.0f }, { 0.0f, square.x + square.z, 0.0f }, { 0.0f, 0.0f, square.x + square.y } };
	float third = mass / 3.0f;
	inertia = (b3Matrix3){ b3MulSV( third, inertia.cx ), b3MulSV( third, inertia.cy ), b3MulSV( third, inertia.cz ) };
	b3Body_SetMassData( body, (b3MassData){ mass, b3Vec3_zero, inertia } );
}

// A pad that moves along x, without weight.
static b3BodyId add_pad( b3WorldId world, float side )
{
	b3BodyDef definition = b3DefaultBodyDef();
	definition.type = b3_dynamicBody;
	definition.position = (b3Pos){ side * ( radius + pad_half_sides.x ), 0.0f, 0.0f };
	definition.gravityScale = 0.0f;
	definition.linearDamping = pad_damping;
	definition.motionLocks = (b3MotionLocks){ false, true, true, true, true, true };
	b3BodyId pad = b3CreateBody( world, &definition );
	b3ShapeDef shape_definition = b3DefaultShapeDef();
	shape_definition.baseMaterial.friction = mu;
	b3BoxHull box = b3MakeBoxHull( pad_half_sides.x, pad_half_sides.y, pad_half_sides.z );
	b3CreateHullShape( pad, &shape_definition, &box.base );
	set_box_mass( pad, pad_mass, pad_half_sides );
	return pad;
}

static b3BodyId add_capsule( b3WorldId world )
{
	b3BodyDef definition = b3DefaultBodyDef();
	definition.type = b3_dynamicBody;
	b3BodyId body = b3CreateBody( world, &definition );
	b3ShapeDef shape_definition = b3DefaultShapeDef();
	shape_definition.baseMaterial.friction = mu;
	b3Capsule capsule = { { 0.0f, 0.0f, -half_length }, { 0.0f, 0.0f, half_length }, radius };
	b3CreateCapsuleShape( body, &shape_definition, &capsule );
	set_box_mass( body, capsule_mass, (b3Vec3){ radius, radius, radius + half_length } );
	return body;
}

void print_capsule_creep( void )
{
	b3WorldId world = create_world( 0.0 );
	b3BodyId pads[] = { add_pad( world, -1.0f ), add_pad( world, 1.0f ) };
	b3BodyId capsule = add_capsule( world );
	int settle_steps = (int)( settle_s * rate_hz ), steps = settle_steps + (int)( seconds * rate_hz );
	double start = 0.0;
	for ( int i = 0; i < steps; ++i )
	{
		if ( i == settle_steps )
		{
			start = b3Body_GetPosition( capsule ).y;
		}
		float force = grip * (float)fmin( 1.0, i / ( ramp_s * rate_hz ) );
		b3Body_ApplyForceToCenter( pads[0], (b3Vec3){ force, 0.0f, 0.0f }, true );
		b3Body_ApplyForceToCenter( pads[1], (b3Vec3){ -force, 0.0f, 0.0f }, true );
		step_once( world, rate_hz );
	}
	printf( "capsule,0,creep_m_s,%.9g\n", fabs( b3Body_GetPosition( capsule ).y - start ) / seconds );
	b3DestroyWorld( world );
}
