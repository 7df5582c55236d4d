#include "throws.h"

#include "world.h"

#include <math.h>
#include <stdio.h>

// Outline of the foot. Round bodies are prisms of 16 sides: box3d has no cylinder with a flat face.
typedef enum Outline
{
	RECTANGLE,
	TRIANGLE,
	SIXTEEN_SIDES,
} Outline;

typedef struct Thrown
{
	const char* name;
	Outline outline;
	// Half sides of a rectangle along x and z, or the radius of the circle around it, in m.
	float half_x, half_z;
	float height;
	float mu;
} Thrown;

#define PLATE_MU (float)( 3.0 / GRAVITY )

static const Thrown bodies[] = {
	{ "box", RECTANGLE, 0.05f, 0.05f, 0.01f, PLATE_MU },
	{ "plank", RECTANGLE, 0.1f, 0.025f, 0.01f, PLATE_MU },
	{ "triangle", TRIANGLE, 0.08f, 0.08f, 0.01f, PLATE_MU },
	{ "puck16", SIXTEEN_SIDES, 0.08f, 0.08f, 0.02f, 0.3f },
	{ "tall", SIXTEEN_SIDES, 0.08f, 0.08f, 0.16f, 0.2f },
};
static const double spins_rad_s[] = { 0.0, 5.0, 12.5, 25.0, 50.0 };
static const double rates_hz[] = { 60.0, 240.0 };

#define COUNT( array ) (int)( sizeof( array ) / sizeof( array[0] ) )

// The triangle about its centroid, with a corner ahead.
static b3HullData* create_triangle( float radius, float height )
{
	b3Vec3 corners[6];
	for ( int i = 0; i < 6; ++i )
	{
		float angle = (float)( i % 3 ) * 2.0f * (float)M_PI / 3.0f;
		float y = ( i < 3 ? -0.5f : 0.5f ) * height;
		corners[i] = (b3Vec3){ radius * cosf( angle ), y, -radius * sinf( angle ) };
	}
	return b3CreateHull( corners, 6, 6 );
}

static b3BodyId add_thrown( b3WorldId world, const Thrown* thrown )
{
	float half_height = 0.5f * thrown->height;
	b3Pos position = { 0.0f, half_height, 0.0f };
	if ( thrown->outline == RECTANGLE )
	{
		b3BoxHull slab = b3MakeBoxHull( thrown->half_x, half_height, thrown->half_z );
		return add_body( world, &slab.base, position, b3Quat_identity, thrown->mu );
	}
	b3HullData* prism = thrown->outline == TRIANGLE ? create_triangle( thrown->half_x, thrown->height )
													: b3CreateCylinder( thrown->height, thrown->half_x, -half_height, 16 );
	b3BodyId body = add_body( world, prism, position, b3Quat_identity, thrown->mu );
	b3DestroyHull( prism );
	return body;
}

static void throw_body( const Thrown* thrown, double rate_hz, double spin_rad_s )
{
	b3WorldId world = create_world( 0.0 );
	add_floor( world, thrown->mu );
	b3BodyId body = add_thrown( world, thrown );
	step_for( world, 1.0, rate_hz );

	b3Pos start = b3Body_GetPosition( body );
	Turn turn = start_turn( body );
	b3Body_SetLinearVelocity( body, (b3Vec3){ 1.0f, 0.0f, 0.0f } );
	b3Body_SetAngularVelocity( body, (b3Vec3){ 0.0f, (float)spin_rad_s, 0.0f } );
	for ( int i = 0; i < (int)( 4.0 * rate_hz ); ++i )
	{
		step_once( world, rate_hz );
		follow_turn( &turn, body );
	}
	b3Pos end = b3Body_GetPosition( body );
	printf( "%s,%g,%g,%.6f,%.6f,%.5f\n", thrown->name, rate_hz, spin_rad_s, (double)( end.x - start.x ),
			(double)( start.z - end.z ), turn.angle );
	b3DestroyWorld( world );
}

void print_throws( void )
{
	printf( "body,rate_hz,spin_rad_s,travel_m,left_m,turn_rad\n" );
	for ( int b = 0; b < COUNT( bodies ); ++b )
	{
		for ( int r = 0; r < COUNT( rates_hz ); ++r )
		{
			for ( int s = 0; s < COUNT( spins_rad_s ); ++s )
			{
				throw_body( &bodies[b], rates_hz[r], spins_rad_s[s] );
			}
		}
	}
}
