#include "answers.h"

#include "pinch.h"
#include "world.h"

#include <Jolt/Physics/Body/BodyCreationSettings.h>
#include <Jolt/Physics/Collision/Shape/BoxShape.h>
#include <Jolt/Physics/Collision/Shape/CylinderShape.h>
#include <Jolt/Physics/Collision/Shape/OffsetCenterOfMassShape.h>
#include <Jolt/Physics/Collision/Shape/SphereShape.h>
#include <Jolt/Physics/Collision/Shape/StaticCompoundShape.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iostream>
#include <limits>
#include <string>

using namespace JPH;

namespace {

constexpr double cRate = 240.0;
constexpr double cSettle = 0.5;
constexpr int cCostRuns = 20, cCostSteps = 40;
// Radius of the engine's rounded edges, in m: half of the narrowest body's half width.
constexpr float cConvexRadius = 0.0005f;

// A launch, in SI units. The body has 1 kg.
struct Launch
{
	std::string mName, mShape;
	// Half sides of a box, the radius of a cylinder, or the places of three feet along x and to the left.
	float mSizes[6];
	float mMu, mGravity;
	// Height of the shape's middle, of the center of mass above that, and moments of inertia.
	float mMiddle, mLow, mLevel, mUpright;
	float mSpeed, mSpin;
	double mSeconds;

	bool IsBall() const { return mShape == "ball"; }
};

std::istream &operator >> (std::istream &ioStream, Launch &outLaunch)
{
	ioStream >> outLaunch.mName >> outLaunch.mShape;
	for (float &size : outLaunch.mSizes)
		ioStream >> size;
	return ioStream >> outLaunch.mMu >> outLaunch.mGravity >> outLaunch.mMiddle >> outLaunch.mLow >> outLaunch.mLevel
		>> outLaunch.mUpright >> outLaunch.mSpeed >> outLaunch.mSpin >> outLaunch.mSeconds;
}

void PrintRow(const std::string &inScene, double inSpin, const char *inQuantity, double inValue)
{
	std::printf("%s,%g,%s,%.9g\n", inScene.c_str(), inSpin, inQuantity, inValue);
}

Ref<Shape> MakeShape(const Launch &inLaunch)
{
	const float *size = inLaunch.mSizes;
	if (inLaunch.IsBall())
		return new SphereShape(inLaunch.mMiddle);
	if (inLaunch.mShape == "box")
		return new BoxShape(Vec3(size[0], inLaunch.mMiddle, size[1]), cConvexRadius);
	if (inLaunch.mShape == "cylinder")
		return new CylinderShape(inLaunch.mMiddle, size[0], cConvexRadius);
	StaticCompoundShapeSettings feet;
	for (int i = 0; i < 3; ++i)
		feet.AddShape(Vec3(size[2 * i], 0, -size[2 * i + 1]), Quat::sIdentity(), new SphereShape(inLaunch.mMiddle));
	return feet.Create().Get();
}

BodyCreationSettings MakeBody(const Launch &inLaunch)
{
	Ref<Shape> shape = MakeShape(inLaunch);
	shape = new OffsetCenterOfMassShape(shape, Vec3(0, inLaunch.mLow, 0) - shape->GetCenterOfMass());
	BodyCreationSettings body = World::sMakeBody(shape, RVec3(0, inLaunch.mMiddle, 0), Quat::sIdentity(), inLaunch.mMu);
	body.mOverrideMassProperties = EOverrideMassProperties::MassAndInertiaProvided;
	body.mMassPropertiesOverride.mMass = 1.0f;
	body.mMassPropertiesOverride.mInertia = Mat44::sScale(Vec3(inLaunch.mLevel, inLaunch.mUpright, inLaunch.mLevel));
	// Feet stay contacts of their own.
	body.mUseManifoldReduction = inLaunch.mShape != "feet";
	return body;
}

// The body after it has settled.
struct Stage
{
	explicit Stage(const Launch &inLaunch) : mWorld(0.0, inLaunch.mMu)
	{
		mWorld.SetGravity(Vec3(0, -inLaunch.mGravity, 0));
		mBody = mWorld.AddBody(MakeBody(inLaunch));
		mWorld.StepFor(cSettle, cRate);
	}

	void Throw(const Launch &inLaunch)
	{
		Vec3 spin = inLaunch.IsBall()? Vec3(0, 0, -inLaunch.mSpin) : Vec3(0, inLaunch.mSpin, 0);
		mWorld.SetVelocities(mBody, Vec3(inLaunch.mSpeed, 0, 0), spin);
	}

	World mWorld;
	BodyID mBody;
};

void PrintLaunch(const Launch &inLaunch)
{
	Stage stage(inLaunch);
	RVec3 start = stage.mWorld.GetPosition(stage.mBody);
	Turn turn(stage.mWorld, stage.mBody);
	stage.Throw(inLaunch);
	int steps = int(std::ceil(inLaunch.mSeconds * cRate));
	for (int i = 0; i < steps; ++i)
	{
		stage.mWorld.StepOnce(cRate);
		turn.Follow(stage.mWorld, stage.mBody);
	}
	RVec3 way = stage.mWorld.GetPosition(stage.mBody) - start;
	if (inLaunch.IsBall())
	{
		PrintRow(inLaunch.mName, inLaunch.mSpin, "rolling_speed_m_s", stage.mWorld.GetVelocity(stage.mBody).GetX());
		return;
	}
	PrintRow(inLaunch.mName, inLaunch.mSpin, "along_m", double(way.GetX()));
	PrintRow(inLaunch.mName, inLaunch.mSpin, "left_m", double(-way.GetZ()));
	PrintRow(inLaunch.mName, inLaunch.mSpin, "turn_rad", turn.GetAngle());
}

// Least time of a step while the body slides.
void PrintCost(const Launch &inLaunch)
{
	double least = std::numeric_limits<double>::infinity();
	for (int run = 0; run < cCostRuns; ++run)
	{
		Stage stage(inLaunch);
		stage.Throw(inLaunch);
		double start = ThreadSeconds();
		for (int i = 0; i < cCostSteps; ++i)
			stage.mWorld.StepOnce(cRate);
		least = std::min(least, (ThreadSeconds() - start) / cCostSteps);
	}
	PrintRow("cost", inLaunch.mSpin, "step_us", 1e6 * least);
}

} // namespace

void PrintAnswers()
{
	std::printf("scene,spin_rad_s,quantity,value\n");
	for (Launch launch; std::cin >> launch; )
	{
		PrintLaunch(launch);
		if (launch.mName == "puck" && launch.mSpin == 50.0f)
			PrintCost(launch);
	}
	PrintCapsuleCreep();
}
