#include "cost.h"

#include "world.h"

#include <Jolt/Physics/Collision/Shape/BoxShape.h>

#include <cmath>

using namespace JPH;

namespace {

constexpr double cRate = 60.0;

double MicrosecondsAStep(World &ioWorld, int inSteps)
{
	double start = ThreadSeconds();
	for (int i = 0; i < inSteps; ++i)
		ioWorld.StepOnce(cRate);
	return 1e6 * (ThreadSeconds() - start) / inSteps;
}

} // namespace

double PileMicroseconds()
{
	constexpr float cMu = 0.5f;
	World world(0.0, cMu);
	Ref<Shape> shape = new BoxShape(Vec3::sReplicate(0.5f));
	// Eight layers of 5 by 5, each shifted against the one below it.
	for (int i = 0; i < 200; ++i)
	{
		int layer = i / 25, column = i % 5, row = i % 25 / 5;
		float x = 1.1f * float(column) - 2.2f + 0.1f * float(layer % 3);
		float z = 1.1f * float(row) - 2.2f + 0.07f * float(layer % 2);
		world.AddBody(shape, RVec3(x, 0.6f + 1.15f * float(layer), z), Quat::sIdentity(), cMu);
	}
	world.StepFor(2.0, cRate);
	return MicrosecondsAStep(world, 300);
}

double SlidingMicroseconds()
{
	constexpr float cMu = 0.05f;
	World world(0.0, cMu);
	Ref<Shape> shape = new BoxShape(Vec3::sReplicate(0.5f));
	BodyID boxes[196];
	for (int i = 0; i < 196; ++i)
		boxes[i] = world.AddBody(shape, RVec3(6.0f * float(i % 14) - 39.0f, 0.5f, 6.0f * float(i / 14) - 39.0f), Quat::sIdentity(), cMu);
	world.StepFor(0.5, cRate);
	for (int i = 0; i < 196; ++i)
		world.Throw(boxes[i], Vec3(1.8f * std::cos(float(i)), 0, 1.8f * std::sin(float(i))), 3.0f + 0.01f * float(i));
	return MicrosecondsAStep(world, 60);
}
