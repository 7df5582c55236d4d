// box3d at 30c67b5e: a box that spins stops as early as one that does not, and a puck leaves a turntable that should carry it.
// cc -O2 -I BOX3D/include box3d_box_and_turntable.c BUILD/src/libbox3d.a -lm -o spin && ./spin
#include "box3d/box3d.h"

#include <math.h>
#include <stdio.h>

static b3BodyId add( b3WorldId world, b3BodyType type, b3Pos place, const b3HullData *hull )
{
	b3BodyDef body = b3DefaultBodyDef();
	body.type = type, body.position = place, body.allowFastRotation = true;
	b3BodyId id = b3CreateBody( world, &body );
	b3ShapeDef shape = b3DefaultShapeDef();
	shape.baseMaterial.friction = 0.3f;
	b3CreateHullShape( id, &shape, hull );
	return id;
}

static b3WorldId empty( void )
{
	b3WorldDef def = b3DefaultWorldDef();
	def.gravity = (b3Vec3){ 0, -9.81f, 0 }, def.enableSleep = false;
	return b3CreateWorld( &def );
}

static void steps( b3WorldId world, float seconds )
{
	for ( int i = 0; i < lroundf( 240 * seconds ); ++i )
		b3World_Step( world, 1 / 240.0f, 4 );
}

static void box( float spin, double exact )
{
	b3WorldId world = empty();
	b3BoxHull slab = b3MakeBoxHull( 9, 1, 9 ), flat = b3MakeBoxHull( 0.05f, 0.001f, 0.05f );
	add( world, b3_staticBody, (b3Pos){ 0, -1, 0 }, &slab.base );
	b3BodyId id = add( world, b3_dynamicBody, (b3Pos){ 0, 0.001f, 0 }, &flat.base );
	steps( world, 0.5f );
	float start = (float)b3Body_GetPosition( id ).x;
	b3Body_SetLinearVelocity( id, (b3Vec3){ 1, 0, 0 } );
	b3Body_SetAngularVelocity( id, (b3Vec3){ 0, spin, 0 } );
	steps( world, 2 );
	printf( "a box of 10 cm at 1 m/s and %g rad/s goes %.4f m, exactly %.4f m\n", spin, b3Body_GetPosition( id ).x - start, exact );
	b3DestroyWorld( world );
}

static void turntable( bool is_recycled )
{
	b3WorldId world = empty();
	if ( !is_recycled )
		b3World_SetContactRecycleDistance( world, 0 );
	b3BoxHull slab = b3MakeBoxHull( 2, 0.05f, 2 );
	b3HullData *prism = b3CreateCylinder( 0.02f, 0.04f, -0.01f, 32 );
	b3BodyId table = add( world, b3_kinematicBody, (b3Pos){ 0, -0.05f, 0 }, &slab.base ), puck = add( world, b3_dynamicBody, (b3Pos){ 0.3f, 0.01f, 0 }, prism );
	steps( world, 0.5f );
	float rate = 2.97f; // its square times 0.3 m is 0.9 of friction
	b3Pos at = b3Body_GetPosition( puck );
	b3Body_SetAngularVelocity( table, (b3Vec3){ 0, rate, 0 } );
	b3Body_SetAngularVelocity( puck, (b3Vec3){ 0, rate, 0 } );
	b3Body_SetLinearVelocity( puck, (b3Vec3){ rate * (float)at.z, 0, -rate * (float)at.x } );
	steps( world, 1 );
	at = b3Body_GetPosition( puck );
	printf( "a puck at 0.3000 m is %.4f m from the axis after 1 s on a turntable, contacts recycled: %d\n", hypot( at.x, at.z ), is_recycled );
	b3DestroyHull( prism );
	b3DestroyWorld( world );
}

int main( void )
{
	box( 0, 1 / ( 2 * 0.3 * 9.81 ) );
	box( 50, 0.449803 );
	turntable( true );
	turntable( false );
}
