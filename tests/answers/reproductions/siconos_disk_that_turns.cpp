// Siconos 4.5.0 at 6070f0f6: a disk that only spins on its face turns 2.3 times as far as it should. Built as adapters/siconos.cpp is.
// Three or four contact points bear it, found by Bullet, which tilts it a little three times (perturbationIterations). They are anywhere on the face, near its middle
// too, so that they resist with half the lever of the face or less. With eight tilts the points are on the rim: it turns as on corners, 2/3 of the exact angle.
#include <FrictionContact.hpp>
#include <MoreauJeanOSI.hpp>
#include <NewtonImpactFrictionNSL.hpp>
#include <RigidBodyDS.hpp>
#include <SiconosBulletCollisionManager.hpp>
#include <SiconosShape.hpp>
#include <TimeDiscretisation.hpp>
#include <TimeStepping.hpp>

#include <cstdio>

using namespace siconos;
using namespace collision;
using std::make_shared;

static auto shape(std::shared_ptr<SiconosShape> of, double w, double x, double z) {
	Eigen::VectorXd offset(7);
	offset << 0, 0, z, w, x, 0, 0;
	of->setInsideMargin(1e-3);
	auto made = make_shared<SiconosContactorSet>();
	made->push_back(make_shared<SiconosContactor>(of, offset));
	return made;
}

int main() {
	const double mu = 0.3, g = 9.81, r = 0.08, half = 0.01, upright = 0.5 * r * r, spin = 12.5, dt = 1e-3;
	std::printf("exactly %.4f rad, lever of friction 2/3 r = %.4f m\n", spin * spin * upright / (2 * 2 * mu * g * r / 3), 2 * r / 3);
	for (unsigned tilts : {3, 8}) {
		auto system = make_shared<modeling::NonSmoothDynamicalSystem>(0.0, 1e6);
		auto simulation = make_shared<simulation::TimeStepping>(system, make_shared<simulation::TimeDiscretisation>(0.0, dt));
		auto problem = make_shared<nonsmooth_formulations::FrictionContact>(3);
		auto options = make_shared<bullet::SiconosBulletOptions>();
		options->perturbationIterations = options->minimumPointsPerturbationThreshold = tilts; // by default 3
		auto manager = make_shared<bullet::SiconosBulletCollisionManager>(options);
		manager->insertNonSmoothLaw(make_shared<modeling::NewtonImpactFrictionNSL>(0.0, 0.0, mu, 3), 0, 0);
		simulation->insertIntegrator(make_shared<integrators::MoreauJeanOSI>(0.5));
		simulation->insertNonSmoothProblem(problem);
		simulation->insertInteractionManager(manager);
		simulation->setWarningNonsmoothSolver(false), simulation->setNewtonWarningOnNonConvergence(false);
		algebra::SiconosVector7 place;
		place << 0, 0, 0, 1, 0, 0, 0; // the centre of mass lies in the plane of contact
		const algebra::SiconosMatrix33 inertia = algebra::SiconosVector3(0.55 * upright, 0.55 * upright, upright).asDiagonal();
		auto disk = make_shared<RigidBodyDS>(place, algebra::SiconosVector6::Zero(), 1.0, inertia);
		disk->setUseContactorInertia(false);
		disk->setContactors(shape(make_shared<SiconosCylinder>(r, 2 * half), std::sqrt(0.5), std::sqrt(0.5), half));
		algebra::SiconosVector3 weight(0, 0, -g);
		disk->setConstantFext(weight, algebra::alias_t);
		system->insertDynamicalSystem(disk);
		manager->addStaticBody(shape(make_shared<SiconosBox>(40.0, 40.0, 1.0), 1, 0, -0.5));
		simulation->initialize();
		const auto step = [&] { simulation->computeOneStep(), simulation->nextStep(); };
		for (int i = 0; i < 500; ++i) step();
		*disk->twist() << 0, 0, 0, 0, 0, spin;
		disk->swapInMemory();
		double turned = 0, before = spin;
		for (int i = 1; i <= 1000; ++i) {
			step();
			turned += disk->twist_read()(5) * dt;
			if (i % 100 == 0 && before > 0.1) {
				const double lever = upright * (before - disk->twist_read()(5)) / (mu * g * 100 * dt);
				std::printf("%u tilts, %.1f s: %d points, %.2f rad/s, lever of the last 0.1 s %.4f m\n", tilts, i * dt, problem->getSizeOutput() / 3, disk->twist_read()(5), lever);
				before = disk->twist_read()(5);
			}
		}
		std::printf("%u tilts of Bullet: turned %.4f rad\n", tilts, turned);
	}
}
