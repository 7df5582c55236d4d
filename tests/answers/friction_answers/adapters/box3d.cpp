// box3d at 30c67b5e, by CMakeLists.txt.
#include "box3d/box3d.h"
#include "engine.h"
#include <vector>

static const int SIDES = 32; // of a prism in place of a cylinder
static const int SUBSTEPS[] = { 4, 4, 8 };

static b3Vec3 vec( const double v[3] ) { return { (float)v[0], (float)v[1], (float)v[2] }; }

static void add_shapes( b3BodyId id, const fa_body &body, float mu ) {
	const double *size = body.sizes;
	const float radius = (float)size[0];
	b3ShapeDef def = b3DefaultShapeDef();
	def.baseMaterial.friction = mu; // a contact has the geometric mean of both
	const b3Capsule capsule = { { (float)-size[1], 0, 0 }, { (float)size[1], 0, 0 }, radius };
	const auto add_ball = [&]( double x, double y, float r ) {
		const b3Sphere ball = { { (float)x, (float)y, 0 }, r };
		b3CreateSphereShape( id, &def, &ball );
	};
	for ( int i = 0; body.kind == FA_FEET && i < 6; i += 2 ) add_ball( size[i], size[i + 1], 0.01f );
	if ( body.kind == FA_BALL ) add_ball( 0, 0, radius );
	if ( body.kind == FA_CAPSULE ) b3CreateCapsuleShape( id, &def, &capsule );
	if ( body.kind == FA_BOX ) {
		const b3BoxHull hull = b3MakeBoxHull( radius, (float)size[1], (float)size[2] );
		b3CreateHullShape( id, &def, &hull.base );
	}
	if ( body.kind == FA_CYLINDER ) {
		b3HullData *prism = b3CreateCylinder( (float)( 2 * size[1] ), radius, (float)-size[1], SIDES ); // along y
		b3CreateTransformedHullShape( id, &def, prism, { b3Vec3_zero, { { 0.70710678f, 0, 0 }, 0.70710678f } }, b3Vec3_one );
		b3DestroyHull( prism );
	}
}

struct World {
	b3WorldId id;
	std::vector<b3BodyId> bodies;
	int substeps;
	float dt;

	World( const fa_scene &scene ) : substeps( SUBSTEPS[scene.setting] ), dt( (float)scene.dt ) {
		b3WorldDef def = b3DefaultWorldDef();
		def.gravity = vec( scene.gravity ), def.enableSleep = false, def.workerCount = 1;
		id = b3CreateWorld( &def );
		if ( scene.setting == 2 ) b3World_SetContactRecycleDistance( id, 0 );
		if ( scene.has_floor ) added( { FA_BOX, 0, 0, { 50, 50, 1 }, { 0, 0, -1 }, { 1 }, 1, {}, {} }, b3_staticBody, scene.mu );
		for ( int i = 0; i < scene.count; ++i )
			bodies.push_back( added( scene.bodies[i], scene.bodies[i].is_driven ? b3_kinematicBody : b3_dynamicBody, scene.mu ) );
	}
	~World() { b3DestroyWorld( id ); }
	b3BodyId added( const fa_body &body, b3BodyType type, double mu ) {
		b3BodyDef def = b3DefaultBodyDef();
		def.type = type, def.position = b3ToPos( vec( body.place ) ), def.allowFastRotation = true;
		def.rotation = { vec( body.pose + 1 ), (float)body.pose[0] };
		b3BodyId made = b3CreateBody( id, &def );
		add_shapes( made, body, (float)mu );
		const b3Vec3 i = vec( body.inertia );
		if ( type == b3_dynamicBody )
			b3Body_SetMassData( made, { (float)body.mass, vec( body.com ), { { i.x, 0, 0 }, { 0, i.y, 0 }, { 0, 0, i.z } } } );
		return made;
	}
	void set( int body, const double velocity[3], const double spin[3] ) {
		b3Body_SetLinearVelocity( bodies[body], vec( velocity ) );
		b3Body_SetAngularVelocity( bodies[body], vec( spin ) );
	}
	void step() { b3World_Step( id, dt, substeps ); }
	std::array<double, 13> state( int body ) {
		const b3Pos p = b3Body_GetWorldCenter( bodies[body] );
		const b3Quat q = b3Body_GetRotation( bodies[body] );
		const b3Vec3 v = b3Body_GetLinearVelocity( bodies[body] ), w = b3Body_GetAngularVelocity( bodies[body] );
		return { p.x, p.y, p.z, q.s, q.v.x, q.v.y, q.v.z, v.x, v.y, v.z, w.x, w.y, w.z };
	}
	void gravity( const double gravity[3] ) { b3World_SetGravity( id, vec( gravity ) ); }
	void force( int body, const double force[3] ) { b3Body_ApplyForceToCenter( bodies[body], vec( force ), true ); }
};

FA_ENGINE( World, "{\"name\": \"" ANSWERS_NAME R"(", "version": "30c67b5e", "licence": "MIT", "kind": "games", "settings": {
	"default": {"dt": 0.016666666666666666, "substeps": 4}, "240 Hz": {"dt": 0.004166666666666667, "substeps": 4},
	"1 ms, 8 substeps, no recycling": {"dt": 0.001, "substeps": 8}}})", fa_lacks )
