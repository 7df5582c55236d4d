// Project Chrono at 7689fbc0 with its own copy of Bullet. Needs Eigen; half an hour:
// cmake -S CHRONO -B BUILD -DCMAKE_BUILD_TYPE=Release -DBUILD_DEMOS=OFF -DBUILD_TESTING=OFF -DCH_ENABLE_YAML=OFF -DCH_ENABLE_OPENMP=OFF
// cmake --build BUILD --target Chrono_core
// g++ -std=c++17 -O2 -march=native -DNDEBUG -DEIGEN_DONT_PARALLELIZE -D_ENABLE_EXTENDED_ALIGNED_STORAGE -shared -fPIC
//     -I friction_answers -I CHRONO/src -I BUILD -I /usr/include/eigen3 chrono.cpp -o libchrono_answers.so -L BUILD/lib -lChrono_core -Wl,-rpath,BUILD/lib
#include "chrono/collision/ChCollisionShapes.h"
#include "chrono/physics/ChSystemNSC.h"
#include "chrono/physics/ChSystemSMC.h"
#include "engine.h"
using namespace chrono;
// Radius of a foot, half the side of the floor, m; times its mass that a driven body has, so that no contact slows it;
// family of driven bodies.
constexpr double FOOT = 0.01, FLOOR = 20, HEAVY = 1e6, DRIVEN = 2;
struct World {
	std::unique_ptr<ChSystem> system;
	std::vector<std::shared_ptr<ChBody>> bodies;
	double dt;
};
// Springs or cone complementarity; iterations of Barzilai and Borwein; distance at which contacts begin, m; Young's modulus, Pa.
// Chrono chooses what is 0.
const struct Setting {
	bool is_smooth;
	int iterations;
	double envelope, modulus;
} SETTINGS[] = {{false, 0, 0, 0}, {false, 300, 1e-3, 0}, {true, 0, 0, 0}, {true, 0, 0, 1e7}};
static ChVector3d vector(const double v[3]) { return {v[0], v[1], v[2]}; }
static World &of(void *world) { return *static_cast<World *>(world); }
static std::shared_ptr<ChBody> made(const fa_body &from, std::shared_ptr<ChContactMaterial> surface, const ChVector3d &gravity) {
	auto body = std::make_shared<ChBody>();
	const double *s = from.sizes, factor = from.is_driven ? HEAVY : 1;
	const ChQuaterniond turn(from.pose[0], from.pose[1], from.pose[2], from.pose[3]);
	const ChVector3d com = vector(from.com);
	body->SetMass(factor * from.mass);
	body->SetInertiaXX(factor * vector(from.inertia));
	body->SetRot(turn);
	body->SetPos(vector(from.place) + turn.Rotate(com));
	const auto add = [&](auto shape, ChVector3d place = {}, ChQuaterniond pose = QUNIT) {
		body->AddCollisionShape(shape, ChFramed(place - com, pose));
	};
	if (from.kind == FA_BOX) add(std::make_shared<ChCollisionShapeBox>(surface, 2 * s[0], 2 * s[1], 2 * s[2]));
	else if (from.kind == FA_CYLINDER) add(std::make_shared<ChCollisionShapeCylinder>(surface, s[0], 2 * s[1]));
	else if (from.kind == FA_BALL) add(std::make_shared<ChCollisionShapeSphere>(surface, s[0]));
	else if (from.kind == FA_CAPSULE) add(std::make_shared<ChCollisionShapeCapsule>(surface, s[0], 2 * s[1]), {}, QuatFromAngleY(CH_PI_2));
	else
		for (int i = 0; i < 6; i += 2) add(std::make_shared<ChCollisionShapeSphere>(surface, FOOT), ChVector3d(s[i], s[i + 1], 0));
	body->EnableCollision(true);
	body->AddAccumulator();
	if (from.is_driven) { // It bears its own weight, and touches no other of its family.
		body->AccumulateForce(0, -body->GetMass() * gravity, body->GetPos(), false);
		body->GetCollisionModel()->SetFamily(DRIVEN);
		body->GetCollisionModel()->DisallowCollisionsWith(DRIVEN);
	}
	return body;
}
const char *fa_about(void) {
	return R"({"name": "Chrono", "version": "10.0.0", "licence": "BSD-3-Clause", "kind": "mechanics", "settings": {"default": {"dt": 1e-3},
		"NSC, Barzilai-Borwein": {"dt": 1e-3, "iterations": 300, "envelope": 1e-3}, "SMC": {"dt": 1e-3}, "SMC, stiff": {"dt": 1e-4, "modulus": 1e7}}})";
}
void *fa_make(const fa_scene *scene, const char **why) {
	const Setting &setting = SETTINGS[scene->setting];
	if (scene->mu_across >= 0) return *why = "Friction is the same in all directions.", nullptr;
	if (scene->torsion > 0 && setting.is_smooth) return *why = "Smooth contacts have no spinning friction.", nullptr;
	auto world =
		new World{std::unique_ptr<ChSystem>(setting.is_smooth ? static_cast<ChSystem *>(new ChSystemSMC) : new ChSystemNSC), {}, scene->dt};
	world->system->SetCollisionSystemType(ChCollisionSystem::Type::BULLET);
	fa_gravity(world, scene->gravity);
	if (setting.iterations) {
		world->system->SetSolverType(ChSolver::Type::BARZILAIBORWEIN);
		world->system->GetSolver()->AsIterative()->SetMaxIterations(setting.iterations);
		world->system->GetSolver()->AsIterative()->SetTolerance(1e-8);
		ChCollisionModel::SetDefaultSuggestedEnvelope(setting.envelope);
		ChCollisionModel::SetDefaultSuggestedMargin(setting.envelope);
	}
	const auto surface = ChContactMaterial::DefaultMaterial(setting.is_smooth ? ChContactMethod::SMC : ChContactMethod::NSC);
	if (setting.modulus > 0) static_cast<ChContactMaterialSMC &>(*surface).SetYoungModulus(setting.modulus);
	surface->SetFriction(scene->mu);
	surface->SetRestitution(0);
	surface->SetSpinningFriction(scene->torsion);
	for (int i = 0; i < scene->count; i++) world->bodies.push_back(made(scene->bodies[i], surface, vector(scene->gravity)));
	auto bodies = world->bodies;
	if (scene->has_floor) bodies.push_back(made({FA_BOX, 0, 0, {FLOOR, FLOOR, FLOOR}, {0, 0, -FLOOR}, {1}, 1, {1, 1, 1}}, surface, {}));
	if (scene->has_floor) bodies.back()->SetFixed(true);
	for (auto &body : bodies) world->system->AddBody(body);
	return world;
}
void fa_drop(void *world) { delete &of(world); }
void fa_set(void *world, int number, const double velocity[3], const double spin[3]) {
	of(world).bodies[number]->SetLinVel(vector(velocity));
	of(world).bodies[number]->SetAngVelParent(vector(spin));
}
void fa_step(void *world) { of(world).system->DoStepDynamics(of(world).dt); }
void fa_state(void *world, int number, double state[13]) {
	const ChBody &body = *of(world).bodies[number];
	const ChVector3d place = body.GetPos(), velocity = body.GetLinVel(), spin = body.GetAngVelParent();
	for (int i = 0; i < 3; i++) state[i] = place[i], state[7 + i] = velocity[i], state[10 + i] = spin[i];
	for (int i = 0; i < 4; i++) state[3 + i] = body.GetRot()[i];
}
void fa_gravity(void *world, const double gravity[3]) { of(world).system->SetGravitationalAcceleration(vector(gravity)); }
void fa_force(void *world, int number, const double force[3]) {
	of(world).bodies[number]->EmptyAccumulator(0);
	of(world).bodies[number]->AccumulateForce(0, vector(force), of(world).bodies[number]->GetPos(), false);
}
