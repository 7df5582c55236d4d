// Siconos at 6070f0f6 with Debian's Bullet. Needs gfortran, LAPACKE, OpenBLAS, SuiteSparse, Boost from 1.75 on, Eigen, nlohmann-json; a quarter of
// an hour:
// cmake -S SICONOS -B BUILD -DCMAKE_BUILD_TYPE=Release -DUSER_OPTIONS_FILE=OPTIONS
// cmake --build BUILD
// g++ -std=c++20 -O2 -shared -fPIC -I friction_answers INCLUDES siconos.cpp -o libsiconos_answers.so
//     -lsiconos_mechanics -lsiconos_kernel -lsiconos_numerics -lsiconos_externals -lBulletCollision -lLinearMath
// OPTIONS sets COMPONENTS to externals numerics kernel mechanics, WITH_BULLET on, WITH_PYB11_WRAPPER, WITH_TESTING, WITH_DOCUMENTATION, WITH_MUMPS
// off; INCLUDES are the folders and definitions of the target siconos_mechanics.
#include <FrictionContact.hpp>
#include <MoreauJeanOSI.hpp>
#include <NewtonImpactFrictionNSL.hpp>
#include <RigidBodyDS.hpp>
#include <SiconosBulletCollisionManager.hpp>
#include <SiconosShape.hpp>
#include <SolverOptions.h>
#include <TimeDiscretisation.hpp>
#include <TimeStepping.hpp>
#include "engine.h"
using namespace siconos;
using namespace collision;
using algebra::SiconosVector3, std::make_shared, Eigen::Quaterniond, Eigen::Map;
// Radius of a foot, half the side of the floor, margin of shapes, m; times its mass that a driven body has, so that no contact slows
// it; end of time, s.
constexpr double FOOT = 0.01, FLOOR = 20, MARGIN = 1e-3, HEAVY = 1e6, FOREVER = 1e6;
struct Body { std::shared_ptr<RigidBodyDS> it; bool is_driven; SiconosVector3 force; };
// Tolerance of the solver; scale of Bullet's world, distance there at which a contact point is dropped, turns of a body that look for more points.
const struct Setting { double tolerance, scale, breaking; unsigned perturbations; } SETTINGS[] = {
	{1e-4, 1, 0.02, 3}, {1e-8, 1, 0.02, 3}, {1e-4, 10, 0.002, 8}};
static Map<const SiconosVector3> vector(const double v[3]) { return Map<const SiconosVector3>(v); }
static Quaterniond turn(const RigidBodyDS &body) { return {body.q_read()(3), body.q_read()(4), body.q_read()(5), body.q_read()(6)}; }
static auto shapes(const fa_body &from) {
	auto made = make_shared<SiconosContactorSet>();
	const double *s = from.sizes, half_turn = std::sqrt(0.5);
	const auto add = [&](std::shared_ptr<SiconosShape> shape, SiconosVector3 place = {0, 0, 0}, Quaterniond pose = {1, 0, 0, 0}) {
		Eigen::VectorXd offset(7);
		offset << place - vector(from.com), pose.w(), pose.vec();
		shape->setInsideMargin(MARGIN);
		made->push_back(make_shared<SiconosContactor>(shape, offset));
	};
	// Cylinders and capsules are made along y.
	if (from.kind == FA_BOX) add(make_shared<SiconosBox>(2 * s[0], 2 * s[1], 2 * s[2]));
	else if (from.kind == FA_CYLINDER) add(make_shared<SiconosCylinder>(s[0], 2 * s[1]), {0, 0, 0}, {half_turn, half_turn, 0, 0});
	else if (from.kind == FA_BALL) add(make_shared<SiconosSphere>(s[0]));
	else if (from.kind == FA_CAPSULE) add(make_shared<SiconosCapsule>(s[0], 2 * s[1]), {0, 0, 0}, {half_turn, 0, 0, half_turn});
	else
		for (int i = 0; i < 6; i += 2) add(make_shared<SiconosSphere>(FOOT), {s[i], s[i + 1], 0});
	return made;
}
struct World {
	World(const fa_scene &scene) {
		const Setting &setting = SETTINGS[scene.setting];
		auto system = make_shared<modeling::NonSmoothDynamicalSystem>(0.0, FOREVER);
		simulation = make_shared<simulation::TimeStepping>(system, make_shared<simulation::TimeDiscretisation>(0.0, scene.dt));
		auto problem = make_shared<nonsmooth_formulations::FrictionContact>(3);
		problem->numericsSolverOptions()->dparam[SICONOS_DPARAM_TOL] = setting.tolerance;
		auto options = make_shared<bullet::SiconosBulletOptions>();
		options->worldScale = setting.scale, options->contactBreakingThreshold = setting.breaking;
		options->perturbationIterations = options->minimumPointsPerturbationThreshold = setting.perturbations;
		auto manager = make_shared<bullet::SiconosBulletCollisionManager>(options);
		manager->insertNonSmoothLaw(make_shared<modeling::NewtonImpactFrictionNSL>(0.0, 0.0, scene.mu, 3), 0, 0);
		simulation->insertIntegrator(make_shared<integrators::MoreauJeanOSI>(0.5));
		simulation->insertNonSmoothProblem(problem), simulation->insertInteractionManager(manager);
		simulation->setWarningNonsmoothSolver(false), simulation->setNewtonWarningOnNonConvergence(false);
		for (const fa_body *from = scene.bodies; from != scene.bodies + scene.count; from++) {
			algebra::SiconosVector7 place;
			place << vector(from->place), Map<const Eigen::Vector4d>(from->pose);
			place.head<3>() += Quaterniond(from->pose[0], from->pose[1], from->pose[2], from->pose[3]) * vector(from->com);
			const algebra::SiconosMatrix33 inertia = vector(from->inertia).asDiagonal();
			const double factor = from->is_driven ? HEAVY : 1;
			auto body = make_shared<RigidBodyDS>(place, algebra::SiconosVector6::Zero(), factor * from->mass, factor * inertia);
			bodies.emplace_back(new Body{body, from->is_driven != 0, SiconosVector3::Zero()});
			body->setUseContactorInertia(false), body->setContactors(shapes(*from));
			body->setConstantFext(bodies.back()->force, algebra::alias_t);
			system->insertDynamicalSystem(body);
		}
		gravity(scene.gravity);
		// A thick floor turns boxes: the Bullet of Debian has single precision.
		if (scene.has_floor) manager->addStaticBody(shapes({FA_BOX, 0, 0, {FLOOR, FLOOR, 0.5}, {}, {}, 1, {}, {0, 0, 0.5}}));
		simulation->initialize(); // which sets the velocities
	}
	void set(int number, const double velocity[3], const double spin[3]) {
		RigidBodyDS &body = *bodies[number]->it;
		*body.twist() << vector(velocity), turn(body).inverse() * vector(spin);
		body.swapInMemory(); // where a step begins
	}
	void step() { simulation->computeOneStep(), simulation->nextStep(); }
	std::array<double, 13> state(int number) const {
		const RigidBodyDS &body = *bodies[number]->it;
		std::array<double, 13> state;
		const SiconosVector3 spin = turn(body) * SiconosVector3(body.twist_read().tail<3>());
		Map<Eigen::Matrix<double, 13, 1>>{state.data()} << body.q_read(), body.twist_read().head<3>(), spin;
		return state;
	}
	void gravity(const double gravity[3]) {
		for (auto &body : bodies) if (!body->is_driven) body->force = body->it->scalarMass() * vector(gravity);
	}
	void force(int number, const double force[3]) { bodies[number]->force = vector(force); }
	std::shared_ptr<simulation::TimeStepping> simulation;
	std::vector<std::unique_ptr<Body>> bodies;
};
FA_ENGINE(World, R"({"name": "Siconos", "version": "4.5.0", "licence": "Apache-2.0", "kind": "mechanics", "settings": {
	"default": {"dt": 1e-3}, "tolerance 1e-8": {"dt": 1e-3, "tolerance": 1e-8},
	"more contact points": {"dt": 1e-3, "worldScale": 10, "contactBreakingThreshold": 0.002, "perturbationIterations": 8}}})", fa_lacks)
