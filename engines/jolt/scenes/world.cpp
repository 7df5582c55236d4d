#include "world.h"

#include <Jolt/Core/Factory.h>
#include <Jolt/Core/JobSystemSingleThreaded.h>
#include <Jolt/Core/TempAllocator.h>
#include <Jolt/Physics/Collision/Shape/BoxShape.h>
#include <Jolt/RegisterTypes.h>

#include <cmath>
#include <ctime>

using namespace JPH;

static constexpr ObjectLayer cFloorLayer = 0, cBodyLayer = 1;
static constexpr int cTempBytes = 64 << 20;

static TempAllocator *sTempAllocator = nullptr;
static JobSystem *sJobSystem = nullptr;

void InitialiseEngine()
{
	RegisterDefaultAllocator();
	Factory::sInstance = new Factory;
	RegisterTypes();
	sTempAllocator = new TempAllocatorImpl(cTempBytes);
	sJobSystem = new JobSystemSingleThreaded(cMaxPhysicsJobs);
}

double ThreadSeconds()
{
	timespec t;
	clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
	return double(t.tv_sec) + 1e-9 * double(t.tv_nsec);
}

World::World(double inSlope, float inFloorMu)
{
	constexpr uint cMaxBodies = 1024, cDefaultMutexes = 0, cMaxPairs = 8192, cMaxContacts = 8192;
	mSystem.Init(cMaxBodies, cDefaultMutexes, cMaxPairs, cMaxContacts, mBroadPhaseLayers, mObjectVsBroadPhase, mObjectPairs);
	mSystem.SetGravity(Vec3(float(cGravity * std::sin(inSlope)), float(-cGravity * std::cos(inSlope)), 0));

	BodyCreationSettings floor(new BoxShape(Vec3(50, 1, 50)), RVec3(0, -1, 0), Quat::sIdentity(), EMotionType::Static, cFloorLayer);
	floor.mFriction = inFloorMu;
	mSystem.GetBodyInterfaceNoLock().CreateAndAddBody(floor, EActivation::DontActivate);
}

BodyCreationSettings World::sMakeBody(const Shape *inShape, RVec3Arg inPosition, QuatArg inRotation, float inMu)
{
	BodyCreationSettings body(inShape, inPosition, inRotation, EMotionType::Dynamic, cBodyLayer);
	body.mFriction = inMu;
	body.mLinearDamping = 0;
	body.mAngularDamping = 0;
	body.mMaxAngularVelocity = 1000;
	body.mAllowSleeping = false;
	return body;
}

BodyID World::AddBody(const BodyCreationSettings &inBody)
{
	return mSystem.GetBodyInterfaceNoLock().CreateAndAddBody(inBody, EActivation::Activate);
}

BodyID World::AddBody(const Shape *inShape, RVec3Arg inPosition, QuatArg inRotation, float inMu)
{
	return AddBody(sMakeBody(inShape, inPosition, inRotation, inMu));
}

void World::SetVelocities(BodyID inBody, Vec3Arg inVelocity, Vec3Arg inAngularVelocity)
{
	mSystem.GetBodyInterfaceNoLock().SetLinearAndAngularVelocity(inBody, inVelocity, inAngularVelocity);
}

void World::AddForce(BodyID inBody, Vec3Arg inForce)
{
	mSystem.GetBodyInterfaceNoLock().AddForce(inBody, inForce);
}

void World::Throw(BodyID inBody, Vec3Arg inVelocity, float inSpin)
{
	SetVelocities(inBody, inVelocity, Vec3(0, inSpin, 0));
}

void World::StepOnce(double inRate)
{
	mSystem.Update(float(1.0 / inRate), 1, sTempAllocator, sJobSystem);
}

void World::StepFor(double inSeconds, double inRate)
{
	long steps = std::lround(inSeconds * inRate);
	for (long i = 0; i < steps; ++i)
		StepOnce(inRate);
}

RVec3 World::GetPosition(BodyID inBody) const
{
	return mSystem.GetBodyInterfaceNoLock().GetCenterOfMassPosition(inBody);
}

Vec3 World::GetVelocity(BodyID inBody) const
{
	return mSystem.GetBodyInterfaceNoLock().GetLinearVelocity(inBody);
}

double World::GetHeading(BodyID inBody) const
{
	Quat q = mSystem.GetBodyInterfaceNoLock().GetRotation(inBody);
	return std::remainder(2.0 * std::atan2(double(q.GetY()), double(q.GetW())), 2.0 * M_PI);
}

void Turn::Follow(const World &inWorld, BodyID inBody)
{
	double now = inWorld.GetHeading(inBody);
	mAngle += std::remainder(now - mLastHeading, 2.0 * M_PI);
	mLastHeading = now;
}
