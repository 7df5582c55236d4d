#include "answers.h"

#include "pinch.h"
#include "world.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static const double rate_hz = 240.0;
static const double settle_s = 0.5;

enum
{
	PRISM_SIDES = 16, // of a cylinder
	COST_RUNS = 20,
	COST_STEPS = 40,
};

// A launch, in SI units. The body has 1 kg.
typedef struct Launch
{
	char name[32], shape[16];
	// Half sides of a box, the radius of a cylinder, or the places of three feet along x and to the left.
	float sizes[6];
	float mu, gravity;
	// Height of the shape's middle, of the center of mass above that, and moments of inertia.
	float middle, low, level, upright;
	float speed, spin;
	double seconds;
} Launch;

typedef struct Stage
{
	b3WorldId world;
	b3BodyId body;
} Stage;

static void print_row( const char* scene, double spin_rad_s, const char* quantity, double value )
{
	printf( "%s,%g,%s,%.9g\n", scene, spin_rad_s, quantity, value );
}

static void add_ball( b3BodyId body, const b3ShapeDef* definition, float x, float left, float radius )
{
	b3Sphere ball = { { x, 0.0f, -left }, radius };
	b3CreateSphereShape( body, definition, &ball );
}

static void add_shapes( b3BodyId body, const Launch* launch )
{
	b3ShapeDef definition = b3DefaultShapeDef();
	definition.baseMaterial.friction = launch->mu;
	const float* size = launch->sizes;
	if ( strcmp( launch->shape, "feet" ) == 0 )
	{
		for ( int i = 0; i < 3; ++i )
		{
			add_ball( body, &definition, size[2 * i], size[2 * i + 1], launch->middle );
		}
	}
	else if ( strcmp( launch->shape, "ball" ) == 0 )
	{
		add_ball( body, &definition, 0.0f, 0.0f, launch->middle );
	}
	else if ( strcmp( launch->shape, "box" ) == 0 )
	{
		b3BoxHull slab = b3MakeBoxHull( size[0], launch->middle, size[1] );
		b3CreateHullShape( body, &definition, &slab.base );
	}
	else
	{
		b3HullData* prism = b3CreateCylinder( 2.0f * launch->middle, size[0], -launch->middle, PRISM_SIDES );
		b3CreateHullShape( body, &definition, prism );
		b3DestroyHull( prism );
	}
}

// The body after it has settled.
static Stage set_up( const Launch* launch )
{
	b3WorldId world = create_world( 0.0 );
	b3World_SetGravity( world, (b3Vec3){ 0.0f, -launch->gravity, 0.0f } );
	add_floor( world, launch->mu );
	b3BodyDef definition = b3DefaultBodyDef();
	definition.type = b3_dynamicBody;
	definition.position = (b3Pos){ 0.0f, launch->middle, 0.0f };
	definition.allowFastRotation = true;
	b3BodyId body = b3CreateBody( world, &definition );
	add_shapes( body, launch );
	b3Matrix3 inertia = { { launch->level, 0.0f, 0.0f }, { 0.0f, launch->upright, 0.0f }, { 0.0f, 0.0f, launch->level } };
	b3Body_SetMassData( body, (b3MassData){ 1.0f, { 0.0f, launch->low, 0.0f }, inertia } );
	step_for( world, settle_s, rate_hz );
	return (Stage){ world, body };
}

static void throw_body( Stage stage, const Launch* launch )
{
	bool is_ball = strcmp( launch->shape, "ball" ) == 0;
	b3Vec3 spin = { 0.0f, is_ball ? 0.0f : launch->spin, is_ball ? -launch->spin : 0.0f };
	b3Body_SetLinearVelocity( stage.body, (b3Vec3){ launch->speed, 0.0f, 0.0f } );
	b3Body_SetAngularVelocity( stage.body, spin );
}

static void print_launch( const Launch* launch )
{
	Stage stage = set_up( launch );
	b3Pos start = b3Body_GetWorldCenter( stage.body );
	Turn turn = start_turn( stage.body );
	throw_body( stage, launch );
	int steps = (int)ceil( launch->seconds * rate_hz );
	for ( int i = 0; i < steps; ++i )
	{
		step_once( stage.world, rate_hz );
		follow_turn( &turn, stage.body );
	}
	b3Pos end = b3Body_GetWorldCenter( stage.body );
	if ( strcmp( launch->shape, "ball" ) == 0 )
	{
		print_row( launch->name, launch->spin, "rolling_speed_m_s", b3Body_GetLinearVelocity( stage.body ).x );
	}
	else
	{
		print_row( launch->name, launch->spin, "along_m", end.x - start.x );
		print_row( launch->name, launch->spin, "left_m", start.z - end.z );
		print_row( launch->name, launch->spin, "turn_rad", turn.angle );
	}
	b3DestroyWorld( stage.world );
}

// Least time of a step while the body slides.
static void print_cost( const Launch* launch )
{
	double least = INFINITY;
	for ( int run = 0; run < COST_RUNS; ++run )
	{
		Stage stage = set_up( launch );
		throw_body( stage, launch );
		double start = thread_seconds();
		for ( int i = 0; i < COST_STEPS; ++i )
		{
			step_once( stage.world, rate_hz );
		}
		least = fmin( least, ( thread_seconds() - start ) / COST_STEPS );
		b3DestroyWorld( stage.world );
	}
	print_row( "cost", launch->spin, "step_us", 1e6 * least );
}

static bool read_launch( Launch* launch )
{
	float* s = launch->sizes;
	return scanf( "%31s %15s %f %f %f %f %f %f %f %f %f %f %f %f %f %f %lf", launch->name, launch->shape, s, s + 1, s + 2, s + 3,
				  s + 4, s + 5, &launch->mu, &launch->gravity, &launch->middle, &launch->low, &launch->level, &launch->upright,
				  &launch->speed, &launch->spin, &launch->seconds ) == 17;
}

void print_answers( void )
{
	printf( "scene,spin_rad_s,quantity,value\n" );
	Launch launch;
	while ( read_launch( &launch ) )
	{
		print_launch( &launch );
		if ( strcmp( launch.name, "puck" ) == 0 && launch.spin == 50.0f )
		{
			print_cost( &launch );
		}
	}
	print_capsule_creep();
}
