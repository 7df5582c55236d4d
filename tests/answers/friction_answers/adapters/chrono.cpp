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
// Springs or cone complementarity; iterations of Barzilai and Borwein; distance at which contacts begin, m; Young's modulus, Pa.
// Chrono chooses what is 0.
const struct Setting { bool is_smooth; int iterations; double envelope, modulus; } SETTINGS[] = {
	{false, 0, 0, 0}, {false, 300, 1e-3, 0}, {true, 0, 0, 0}, {true, 0, 0, 1e7}};
static ChVector3d vector(const double v[3]) { return {v[0], v[1], v[2]}; }
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
struct World {
	World(const fa_scene &scene) : dt(scene.dt) {
		const Setting &setting = SETTINGS[scene.setting];
		system.reset(setting.is_smooth ? static_cast<ChSystem *>(new ChSystemSMC) : new ChSystemNSC);
		system->SetCollisionSystemType(ChCollisionSystem::Type::BULLET);
		gravity(scene.gravity);
		if (setting.iterations) {
			system->SetSolverType(ChSolver::Type::BARZILAIBORWEIN);
			system->GetSolver()->AsIterative()->SetMaxIterations(setting.iterations);
			system->GetSolver()->AsIterative()->SetTolerance(1e-8);
			ChCollisionModel::SetDefaultSuggestedEnvelope(setting.envelope);
			ChCollisionModel::SetDefaultSuggestedMargin(setting.envelope);
		}
		const auto surface = ChContactMaterial::DefaultMaterial(setting.is_smooth ? ChContactMethod::SMC : ChContactMethod::NSC);
		if (setting.modulus > 0) static_cast<ChContactMaterialSMC &>(*surface).SetYoungModulus(setting.modulus);
		surface->SetFriction(scene.mu), surface->SetRestitution(0), surface->SetSpinningFriction(scene.torsion);
		for (int i = 0; i < scene.count; i++) bodies.push_back(made(scene.bodies[i], surface, vector(scene.gravity)));
		if (scene.has_floor) bodies.push_back(made({FA_BOX, 0, 0, {FLOOR, FLOOR, FLOOR}, {0, 0, -FLOOR}, {1}, 1, {1, 1, 1}}, surface, {}));
		if (scene.has_floor) bodies.back()->SetFixed(true);
		for (auto &body : bodies) system->AddBody(body);
	}
	void set(int number, const double velocity[3], const double spin[3]) {
		bodies[number]->SetLinVel(vector(velocity)), bodies[number]->SetAngVelParent(vector(spin));
	}
	void step() { system->DoStepDynamics(dt); }
	std::array<double, 13> state(int number) const {
		const ChVector3d p = bodies[number]->GetPos(), v = bodies[number]->GetLinVel(), w = bodies[number]->GetAngVelParent();
		const ChQuaterniond q = bodies[number]->GetRot();
		return {p[0], p[1], p[2], q[0], q[1], q[2], q[3], v[0], v[1], v[2], w[0], w[1], w[2]};
	}
	void gravity(const double gravity[3]) { system->SetGravitationalAcceleration(vector(gravity)); }
	void force(int number, const double force[3]) {
		bodies[number]->EmptyAccumulator(0);
		bodies[number]->AccumulateForce(0, vector(force), bodies[number]->GetPos(), false);
	}
	std::unique_ptr<ChSystem> system;
	std::vector<std::shared_ptr<ChBody>> bodies;
	double dt;
};
static const char *lacks(const fa_scene &scene) {
	return SETTINGS[scene.setting].is_smooth || scene.mu_across >= 0 ? fa_lacks(scene) : nullptr;
}
FA_ENGINE(World, R"({"name": "Chrono", "version": "10.0.0", "licence": "BSD-3-Clause", "kind": "mechanics", "settings": {"default": {"dt": 1e-3},
	"NSC, Barzilai-Borwein": {"dt": 1e-3, "iterations": 300, "envelope": 1e-3}, "SMC": {"dt": 1e-3}, "SMC, stiff": {"dt": 1e-4, "modulus": 1e7}}})", lacks)
