#include "rest.h"

#include "world.h"

#include <math.h>
#include <stdio.h>

enum
{
	STACKED = 10,
};
static const double rate_hz = 60.0;

static void print_row( const char* scene, const char* quantity, double value )
{
	printf( "%s,%s,%.6e\n", scene, quantity, value );
}

static b3BodyId add_cube( b3WorldId world, float half, b3Pos position, float angle, float mu )
{
	b3BoxHull cube = b3MakeBoxHull( half, half, half );
	b3Quat rotation = { { 0.0f, sinf( 0.5f * angle ), 0.0f }, cosf( 0.5f * angle ) };
	return add_body( world, &cube.base, position, rotation, mu );
}

// A cube on a slope whose tangent is this multiple of the coefficient, after one second, for four more. It stands askew:
// edges that are parallel to the floor's to a few units of rounding can upset an engine's search for contacts.
static void print_slope( const char* scene, double ratio )
{
	const float mu = 0.5f;
	b3WorldId world = create_world( atan( ratio * mu ) );
	add_floor( world, mu );
	b3BodyId cube = add_cube( world, 0.1f, (b3Pos){ 0.0f, 0.1f, 0.0f }, 0.1f, mu );
	step_for( world, 1.0, rate_hz );
	b3Pos start = b3Body_GetPosition( cube );
	double heading_at_start = heading( cube );
	step_for( world, 4.0, rate_hz );
	b3Pos end = b3Body_GetPosition( cube );
	print_row( scene, "travel_m", end.x - start.x );
	print_row( scene, "left_m", start.z - end.z );
	print_row( scene, "yaw_rad", heading( cube ) - heading_at_start );
	b3DestroyWorld( world );
}

// Ten cubes on each other, after one second, for ten more. In the turned stack each is turned by 0.1 rad against the
// one below it and shifted by 2 to 6 cm.
static void print_stack( const char* scene, float turn_rad, float shift_m )
{
	const float mu = 0.6f;
	b3WorldId world = create_world( 0.0 );
	add_floor( world, mu );
	b3BodyId cubes[STACKED];
	b3Pos starts[STACKED];
	double headings[STACKED];
	for ( int i = 0; i < STACKED; ++i )
	{
		b3Pos position = { 2.0f * shift_m * (float)( i % 2 ), 0.5f + (float)i, 3.0f * shift_m * (float)( i % 3 ) };
		cubes[i] = add_cube( world, 0.5f, position, turn_rad * (float)i, mu );
	}
	step_for( world, 1.0, rate_hz );
	for ( int i = 0; i < STACKED; ++i )
	{
		starts[i] = b3Body_GetPosition( cubes[i] );
		headings[i] = heading( cubes[i] );
	}
	step_for( world, 10.0, rate_hz );
	double drift = 0.0, yaw = 0.0;
	for ( int i = 0; i < STACKED; ++i )
	{
		b3Pos end = b3Body_GetPosition( cubes[i] );
		drift = fmax( drift, hypot( end.x - starts[i].x, end.z - starts[i].z ) );
		yaw = fmax( yaw, fabs( heading( cubes[i] ) - headings[i] ) );
	}
	print_row( scene, "drift_m", drift );
	print_row( scene, "yaw_rad", yaw );
	print_row( scene, "top_m", b3Body_GetPosition( cubes[STACKED - 1] ).y );
	b3DestroyWorld( world );
}

void print_rest( void )
{
	printf( "scene,quantity,value\n" );
	print_slope( "slope 0.95", 0.95 );
	print_slope( "slope 0.99", 0.99 );
	print_slope( "slope 1.01", 1.01 );
	print_slope( "slope 1.05", 1.05 );
	print_stack( "stack", 0.0f, 0.0f );
	print_stack( "turned stack", 0.1f, 0.01f );
}
