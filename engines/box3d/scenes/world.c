#include "world.h"

#include <math.h>
#include <time.h>

enum
{
	SUBSTEPS = 4,
};

b3WorldId create_world( double slope_rad )
{
	b3WorldDef definition = b3DefaultWorldDef();
	definition.gravity = (b3Vec3){ (float)( GRAVITY * sin( slope_rad ) ), (float)( -GRAVITY * cos( slope_rad ) ), 0.0f };
	definition.enableSleep = false;
	definition.workerCount = 1;
	return b3CreateWorld( &definition );
}

void add_floor( b3WorldId world, float mu )
{
	b3BodyDef body_definition = b3DefaultBodyDef();
	body_definition.position = (b3Pos){ 0.0f, -1.0f, 0.0f };
	b3BodyId body = b3CreateBody( world, &body_definition );
	b3ShapeDef shape_definition = b3DefaultShapeDef();
	shape_definition.baseMaterial.friction = mu;
	b3BoxHull slab = b3MakeBoxHull( 50.0f, 1.0f, 50.0f );
	b3CreateHullShape( body, &shape_definition, &slab.base );
}

b3BodyId add_body( b3WorldId world, const b3HullData* hull, b3Pos position, b3Quat rotation, float mu )
{
	b3BodyDef body_definition = b3DefaultBodyDef();
	body_definition.type = b3_dynamicBody;
	body_definition.position = position;
	body_definition.rotation = rotation;
	body_definition.allowFastRotation = true;
	b3BodyId body = b3CreateBody( world, &body_definition );
	b3ShapeDef shape_definition = b3DefaultShapeDef();
	shape_definition.baseMaterial.friction = mu;
	b3CreateHullShape( body, &shape_definition, hull );
	return body;
}

void step_once( b3WorldId world, double rate_hz )
{
	b3World_Step( world, (float)( 1.0 / rate_hz ), SUBSTEPS );
}

void step_for( b3WorldId world, double seconds, double rate_hz )
{
	int steps = (int)lround( seconds * rate_hz );
	for ( int i = 0; i < steps; ++i )
	{
		step_once( world, rate_hz );
	}
}

double heading( b3BodyId body )
{
	b3Quat q = b3Body_GetRotation( body );
	return remainder( 2.0 * atan2( q.v.y, q.s ), 2.0 * M_PI );
}

Turn start_turn( b3BodyId body )
{
	return (Turn){ heading( body ), 0.0 };
}

void follow_turn( Turn* turn, b3BodyId body )
{
	double now = heading( body );
	turn->angle += remainder( now - turn->last_heading, 2.0 * M_PI );
	turn->last_heading = now;
}

double thread_seconds( void )
{
	struct timespec t;
	clock_gettime( CLOCK_THREAD_CPUTIME_ID, &t );
	return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}
