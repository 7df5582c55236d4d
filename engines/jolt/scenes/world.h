// The world of the scenes: a floor, bodies on it, and the angle by which a body has turned about the vertical.
// x is the direction of a launch, y points up, and -z is to the left. Units: SI.
#pragma once

#include <Jolt/Jolt.h>

#include <Jolt/Physics/Body/BodyCreationSettings.h>
#include <Jolt/Physics/Body/BodyInterface.h>
#include <Jolt/Physics/Collision/BroadPhase/BroadPhaseLayer.h>
#include <Jolt/Physics/Collision/ObjectLayer.h>
#include <Jolt/Physics/Collision/Shape/Shape.h>
#include <Jolt/Physics/PhysicsSystem.h>

inline constexpr double cGravity = 9.81;

// Registers the engine's types and allocators, once a process.
void InitialiseEngine();

// CPU time of this thread, in s.
double ThreadSeconds();

// A world on one thread whose bodies neither sleep nor are damped. Gravity is turned about z so that a level floor is
// a slope of this angle; the floor is 100 m wide and has its upper face at y = 0.
class World
{
public:
	World(double inSlope, float inFloorMu);

	// A dynamic body of these scenes, which may be changed before it is added.
	static JPH::BodyCreationSettings sMakeBody(const JPH::Shape *inShape, JPH::RVec3Arg inPosition, JPH::QuatArg inRotation, float inMu);
	JPH::BodyID AddBody(const JPH::BodyCreationSettings &inBody);
	JPH::BodyID AddBody(const JPH::Shape *inShape, JPH::RVec3Arg inPosition, JPH::QuatArg inRotation, float inMu);

	void SetGravity(JPH::Vec3Arg inGravity) { mSystem.SetGravity(inGravity); }
	void SetVelocities(JPH::BodyID inBody, JPH::Vec3Arg inVelocity, JPH::Vec3Arg inAngularVelocity);
	void AddForce(JPH::BodyID inBody, JPH::Vec3Arg inForce);
	void Throw(JPH::BodyID inBody, JPH::Vec3Arg inVelocity, float inSpin);

	void StepOnce(double inRate);
	void StepFor(double inSeconds, double inRate);

	JPH::RVec3 GetPosition(JPH::BodyID inBody) const;
	JPH::Vec3 GetVelocity(JPH::BodyID inBody) const;
	// Angle about the vertical, in (-pi, pi].
	double GetHeading(JPH::BodyID inBody) const;

private:
	// Two layers: the floor, and the bodies, which meet the floor and each other.
	class BroadPhaseLayers : public JPH::BroadPhaseLayerInterface
	{
	public:
		JPH::uint GetNumBroadPhaseLayers() const override { return 2; }
		JPH::BroadPhaseLayer GetBroadPhaseLayer(JPH::ObjectLayer inLayer) const override { return JPH::BroadPhaseLayer(JPH::uint8(inLayer)); }
#if defined(JPH_EXTERNAL_PROFILE) || defined(JPH_PROFILE_ENABLED)
		const char *GetBroadPhaseLayerName(JPH::BroadPhaseLayer inLayer) const override { return inLayer == JPH::BroadPhaseLayer(0)? "floor" : "bodies"; }
#endif
	};

	BroadPhaseLayers mBroadPhaseLayers;
	JPH::ObjectVsBroadPhaseLayerFilter mObjectVsBroadPhase;
	JPH::ObjectLayerPairFilter mObjectPairs;
	JPH::PhysicsSystem mSystem;
};

// The angle through which a body has turned; valid for less than half a turn a step.
class Turn
{
public:
	Turn(const World &inWorld, JPH::BodyID inBody) : mLastHeading(inWorld.GetHeading(inBody)) { }

	void Follow(const World &inWorld, JPH::BodyID inBody);
	double GetAngle() const { return mAngle; }

private:
	double mLastHeading;
	double mAngle = 0.0;
};
