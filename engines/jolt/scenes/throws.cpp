#include "throws.h"

#include "world.h"

#include <Jolt/Physics/Collision/Shape/BoxShape.h>
#include <Jolt/Physics/Collision/Shape/ConvexHullShape.h>
#include <Jolt/Physics/Collision/Shape/CylinderShape.h>

#include <cmath>
#include <cstdio>

using namespace JPH;

namespace {

// Radius of the engine's rounded edges, in m: small against the bodies, which are 1 cm high.
constexpr float cConvexRadius = 0.001f;
constexpr float cPlateMu = float(3.0 / cGravity);
constexpr float cRadius = 0.08f;

struct Thrown
{
	const char *mName;
	Ref<Shape> mShape;
	float mHalfHeight;
	float mMu;
};

Ref<Shape> MakeSlab(float inHalfX, float inHalfZ)
{
	return new BoxShape(Vec3(inHalfX, 0.005f, inHalfZ), cConvexRadius);
}

// The triangle about its centroid, with a corner ahead.
Ref<Shape> MakeTriangle(float inHalfHeight)
{
	Array<Vec3> corners;
	for (int i = 0; i < 3; ++i)
		for (float side : { -1.0f, 1.0f })
		{
			float angle = float(i) * 2.0f * JPH_PI / 3.0f;
			corners.push_back(Vec3(cRadius * std::cos(angle), side * inHalfHeight, -cRadius * std::sin(angle)));
		}
	return ConvexHullShapeSettings(corners, cConvexRadius).Create().Get();
}

void ThrowBody(const Thrown &inThrown, double inRate, double inSpin)
{
	World world(0.0, inThrown.mMu);
	BodyID body = world.AddBody(inThrown.mShape, RVec3(0, inThrown.mHalfHeight, 0), Quat::sIdentity(), inThrown.mMu);
	world.StepFor(1.0, inRate);

	RVec3 start = world.GetPosition(body);
	Turn turn(world, body);
	world.Throw(body, Vec3(1, 0, 0), float(inSpin));
	for (int i = 0; i < int(4.0 * inRate); ++i)
	{
		world.StepOnce(inRate);
		turn.Follow(world, body);
	}
	RVec3 way = world.GetPosition(body) - start;
	std::printf("%s,%g,%g,%.6f,%.6f,%.5f\n", inThrown.mName, inRate, inSpin, double(way.GetX()), double(-way.GetZ()), turn.GetAngle());
}

} // namespace

void PrintThrows()
{
	const Thrown bodies[] = {
		{ "box", MakeSlab(0.05f, 0.05f), 0.005f, cPlateMu },
		{ "plank", MakeSlab(0.1f, 0.025f), 0.005f, cPlateMu },
		{ "triangle", MakeTriangle(0.005f), 0.005f, cPlateMu },
		{ "puck", new CylinderShape(0.01f, cRadius, cConvexRadius), 0.01f, 0.3f },
		{ "tall", new CylinderShape(0.08f, cRadius, cConvexRadius), 0.08f, 0.2f },
	};
	std::printf("body,rate_hz,spin_rad_s,travel_m,left_m,turn_rad\n");
	for (const Thrown &body : bodies)
		for (double rate : { 60.0, 240.0 })
			for (double spin : { 0.0, 5.0, 12.5, 25.0, 50.0 })
				ThrowBody(body, rate, spin);
}
