#include "cost.h"

#include "world.h"

#include <math.h>

static const double rate_hz = 60.0;

static b3BodyId add_unit_box( b3WorldId world, float x, float y, float z, float mu )
{
	b3BoxHull cube = b3MakeBoxHull( 0.5f, 0.5f, 0.5f );
	return add_body( world, &cube.base, (b3Pos){ x, y, z }, b3Quat_identity, mu );
}

static double microseconds_a_step( b3WorldId world, int steps )
{
	double start = thread_seconds();
	for ( int i = 0; i < steps; ++i )
	{
		step_once( world, rate_hz );
	}
	return 1e6 * ( thread_seconds() - start ) / steps;
}

double pile_microseconds( void )
{
	const float mu = 0.5f;
	b3WorldId world = create_world( 0.0 );
	add_floor( world, mu );
	// Eight layers of 5 by 5, each shifted against the one below it.
	for ( int i = 0; i < 200; ++i )
	{
		int layer = i / 25, column = i % 5, row = i % 25 / 5;
		float x = 1.1f * (float)column - 2.2f + 0.1f * (float)( layer % 3 );
		float z = 1.1f * (float)row - 2.2f + 0.07f * (float)( layer % 2 );
		add_unit_box( world, x, 0.6f + 1.15f * (float)layer, z, mu );
	}
	step_for( world, 2.0, rate_hz );
	double cost = microseconds_a_step( world, 300 );
	b3DestroyWorld( world );
	return cost;
}

double sliding_microseconds( void )
{
	const float mu = 0.05f;
	b3WorldId world = create_world( 0.0 );
	add_floor( world, mu );
	b3BodyId boxes[196];
	for ( int i = 0; i < 196; ++i )
	{
		boxes[i] = add_unit_box( world, 6.0f * (float)( i % 14 ) - 39.0f, 0.5f, 6.0f * (float)( i / 14 ) - 39.0f, mu );
	}
	step_for( world, 0.5, rate_hz );
	for ( int i = 0; i < 196; ++i )
	{
		b3Body_SetLinearVelocity( boxes[i], (b3Vec3){ 1.8f * cosf( (float)i ), 0.0f, 1.8f * sinf( (float)i ) } );
		b3Body_SetAngularVelocity( boxes[i], (b3Vec3){ 0.0f, 3.0f + 0.01f * (float)i, 0.0f } );
	}
	double cost = microseconds_a_step( world, 60 );
	b3DestroyWorld( world );
	return cost;
}
