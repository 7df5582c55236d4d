#include "pinch.h"

#include "world.h"

#include <Jolt/Physics/Body/BodyCreationSettings.h>
#include <Jolt/Physics/Collision/Shape/BoxShape.h>
#include <Jolt/Physics/Collision/Shape/CapsuleShape.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

using namespace JPH;

namespace {

// As in bindings/python/benches/hold.py: masses in kg, lengths in m, the grip in N, the damping of a pad in 1/s.
constexpr float cMu = 0.7f, cGrip = 12.0f;
constexpr float cCapsuleMass = 0.045f, cRadius = 0.004f, cHalfLength = 0.015f;
constexpr float cPadMass = 0.2f, cPadDamping = 100.0f, cPadHalfX = 0.01f, cPadHalf = 0.02f;
constexpr double cRate = 240.0, cRamp = 0.5, cSettle = 1.0, cSeconds = 10.0;

// A pad that moves along x, without weight.
BodyID AddPad(World &ioWorld, float inSide)
{
	Ref<Shape> shape = new BoxShape(Vec3(cPadHalfX, cPadHalf, cPadHalf), 0.001f);
	BodyCreationSettings pad = World::sMakeBody(shape, RVec3(inSide * (cRadius + cPadHalfX), 0, 0), Quat::sIdentity(), cMu);
	pad.mGravityFactor = 0.0f;
	pad.mLinearDamping = cPadDamping;
	pad.mAllowedDOFs = EAllowedDOFs::TranslationX;
	pad.mOverrideMassProperties = EOverrideMassProperties::CalculateInertia;
	pad.mMassPropertiesOverride.mMass = cPadMass;
	return ioWorld.AddBody(pad);
}

} // namespace

void PrintCapsuleCreep()
{
	World world(0.0, cMu);
	BodyID left = AddPad(world, -1.0f), right = AddPad(world, 1.0f);
	Quat across = Quat::sRotation(Vec3::sAxisX(), 0.5f * JPH_PI);
	BodyCreationSettings settings = World::sMakeBody(new CapsuleShape(cHalfLength, cRadius), RVec3::sZero(), across, cMu);
	settings.mOverrideMassProperties = EOverrideMassProperties::CalculateInertia;
	settings.mMassPropertiesOverride.mMass = cCapsuleMass;
	BodyID capsule = world.AddBody(settings);

	int settle_steps = int(cSettle * cRate), steps = settle_steps + int(cSeconds * cRate);
	double start = 0.0;
	for (int i = 0; i < steps; ++i)
	{
		if (i == settle_steps)
			start = double(world.GetPosition(capsule).GetY());
		float force = cGrip * float(std::min(1.0, i / (cRamp * cRate)));
		world.AddForce(left, Vec3(force, 0, 0));
		world.AddForce(right, Vec3(-force, 0, 0));
		world.StepOnce(cRate);
	}
	std::printf("capsule,0,creep_m_s,%.9g\n", std::abs(double(world.GetPosition(capsule).GetY()) - start) / cSeconds);
}
