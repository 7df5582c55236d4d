// box3d at 30c67b5e, by CMakeLists.txt.
#include "box3d/box3d.h"
#include "engine.h"

#include <stdlib.h>

#ifndef ANSWERS_NAME
#define ANSWERS_NAME "box3d"
#endif

enum { SIDES = 32 }; // of a prism in place of a cylinder
static const int substeps[] = { 4, 4, 8 };

typedef struct World
{
	b3WorldId id;
	b3BodyId *bodies;
	int substeps;
	float dt;
} World;

static b3Vec3 vec( const double v[3] ) { return (b3Vec3){ (float)v[0], (float)v[1], (float)v[2] }; }
static b3Quat quat( const double q[4] ) { return (b3Quat){ { (float)q[1], (float)q[2], (float)q[3] }, (float)q[0] }; }

static void add_shapes( b3BodyId id, const fa_body *body, float mu )
{
	const double *size = body->sizes;
	float radius = (float)size[0];
	b3ShapeDef def = b3DefaultShapeDef();
	def.baseMaterial.friction = mu; // a contact has the geometric mean of both
	for ( int i = 0; body->kind == FA_FEET && i < 3; ++i )
		b3CreateSphereShape( id, &def, &(b3Sphere){ { (float)size[2 * i], (float)size[2 * i + 1], 0.0f }, 0.01f } );
	if ( body->kind == FA_BALL )
		b3CreateSphereShape( id, &def, &(b3Sphere){ { 0 }, radius } );
	if ( body->kind == FA_CAPSULE )
		b3CreateCapsuleShape( id, &def, &(b3Capsule){ { (float)-size[1], 0, 0 }, { (float)size[1], 0, 0 }, radius } );
	if ( body->kind == FA_BOX )
		b3CreateHullShape( id, &def, &(b3BoxHull[]){ b3MakeBoxHull( radius, (float)size[1], (float)size[2] ) }->base );
	if ( body->kind == FA_CYLINDER )
	{
		b3HullData *prism = b3CreateCylinder( (float)( 2 * size[1] ), radius, (float)-size[1], SIDES ); // along y
		b3Transform upright = { b3Vec3_zero, { { 0.70710678f, 0, 0 }, 0.70710678f } };
		b3CreateTransformedHullShape( id, &def, prism, upright, b3Vec3_one );
		b3DestroyHull( prism );
	}
}

static b3BodyId add_body( b3WorldId world, const fa_body *body, b3BodyType type, float mu )
{
	b3BodyDef def = b3DefaultBodyDef();
	def.type = type, def.position = b3ToPos( vec( body->place ) ), def.rotation = quat( body->pose ), def.allowFastRotation = true;
	b3BodyId id = b3CreateBody( world, &def );
	add_shapes( id, body, mu );
	b3Vec3 i = vec( body->inertia );
	if ( type == b3_dynamicBody )
		b3Body_SetMassData( id, (b3MassData){ (float)body->mass, vec( body->com ), { { i.x, 0, 0 }, { 0, i.y, 0 }, { 0, 0, i.z } } } );
	return id;
}

const char *fa_about( void )
{
	return "{\"name\": \"" ANSWERS_NAME "\", \"version\": \"30c67b5e\", \"licence\": \"MIT\", \"kind\": \"games\", \"settings\": {"
		   "\"default\": {\"dt\": 0.016666666666666666, \"substeps\": 4},"
		   "\"240 Hz\": {\"dt\": 0.004166666666666667, \"substeps\": 4}, \"1 ms, 8 substeps, no recycling\": {\"dt\": 0.001, \"substeps\": 8}}}";
}

void *fa_make( const fa_scene *scene, const char **why )
{
	*why = scene->torsion > 0 ? "Balls have no torsional friction." : "Friction is the same in all directions.";
	if ( scene->torsion > 0 || scene->mu_across >= 0 )
		return NULL;
	World *world = malloc( sizeof *world );
	b3WorldDef def = b3DefaultWorldDef();
	def.gravity = vec( scene->gravity ), def.enableSleep = false, def.workerCount = 1;
	*world = (World){ b3CreateWorld( &def ), malloc( (size_t)scene->count * sizeof( b3BodyId ) ), substeps[scene->setting], (float)scene->dt };
	if ( scene->setting == 2 )
		b3World_SetContactRecycleDistance( world->id, 0 );
	fa_body slab = { .kind = FA_BOX, .sizes = { 50, 50, 1 }, .place = { 0, 0, -1 }, .pose = { 1 } };
	if ( scene->has_floor )
		add_body( world->id, &slab, b3_staticBody, (float)scene->mu );
	for ( int i = 0; i < scene->count; ++i )
		world->bodies[i] = add_body( world->id, &scene->bodies[i], scene->bodies[i].is_driven ? b3_kinematicBody : b3_dynamicBody, (float)scene->mu );
	return world;
}

void fa_drop( void *at )
{
	b3DestroyWorld( ( (World *)at )->id );
	free( ( (World *)at )->bodies );
	free( at );
}

void fa_set( void *at, int body, const double velocity[3], const double spin[3] )
{
	b3Body_SetLinearVelocity( ( (World *)at )->bodies[body], vec( velocity ) );
	b3Body_SetAngularVelocity( ( (World *)at )->bodies[body], vec( spin ) );
}

void fa_step( void *at ) { b3World_Step( ( (World *)at )->id, ( (World *)at )->dt, ( (World *)at )->substeps ); }

void fa_state( void *at, int body, double state[13] )
{
	b3BodyId id = ( (World *)at )->bodies[body];
	b3Pos p = b3Body_GetWorldCenter( id );
	b3Quat q = b3Body_GetRotation( id );
	b3Vec3 v = b3Body_GetLinearVelocity( id ), w = b3Body_GetAngularVelocity( id );
	double all[13] = { p.x, p.y, p.z, q.s, q.v.x, q.v.y, q.v.z, v.x, v.y, v.z, w.x, w.y, w.z };
	for ( int i = 0; i < 13; ++i )
		state[i] = all[i];
}

void fa_gravity( void *at, const double gravity[3] ) { b3World_SetGravity( ( (World *)at )->id, vec( gravity ) ); }

void fa_force( void *at, int body, const double force[3] ) { b3Body_ApplyForceToCenter( ( (World *)at )->bodies[body], vec( force ), true ); }
