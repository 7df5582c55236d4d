// Jolt at 3b47ec39, by CMakeLists.txt.
#include <Jolt/Jolt.h>

#include <Jolt/Core/Factory.h>
#include <Jolt/Core/JobSystemSingleThreaded.h>
#include <Jolt/Core/TempAllocator.h>
#include <Jolt/Physics/Body/BodyCreationSettings.h>
#include <Jolt/Physics/Collision/Shape/BoxShape.h>
#include <Jolt/Physics/Collision/Shape/CapsuleShape.h>
#include <Jolt/Physics/Collision/Shape/CylinderShape.h>
#include <Jolt/Physics/Collision/Shape/OffsetCenterOfMassShape.h>
#include <Jolt/Physics/Collision/Shape/RotatedTranslatedShape.h>
#include <Jolt/Physics/Collision/Shape/SphereShape.h>
#include <Jolt/Physics/Collision/Shape/StaticCompoundShape.h>
#include <Jolt/Physics/PhysicsSystem.h>
#include <Jolt/RegisterTypes.h>

#include "engine.h"

using namespace JPH;

#ifndef ANSWERS_NAME
#define ANSWERS_NAME "Jolt"
#endif

namespace {

constexpr float cEdge = 0.0005f; // radius of rounded edges, m: half of the narrowest half width
constexpr int cVelocitySteps[] = { 10, 10, 50 }, cPositionSteps[] = { 2, 2, 5 };

Vec3 ToVec(const double *inV) { return Vec3(float(inV[0]), float(inV[1]), float(inV[2])); }

struct Layers final : BroadPhaseLayerInterface
{
	uint GetNumBroadPhaseLayers() const override { return 1; }
	BroadPhaseLayer GetBroadPhaseLayer(ObjectLayer) const override { return BroadPhaseLayer(0); }
};

Ref<Shape> MakeShape(const fa_body &inBody)
{
	const double *size = inBody.sizes;
	Quat upright = Quat::sRotation(Vec3::sAxisX(), 0.5f * JPH_PI), lying = Quat::sRotation(Vec3::sAxisZ(), 0.5f * JPH_PI);
	switch (inBody.kind)
	{
	case FA_BOX: return new BoxShape(ToVec(size), cEdge);
	case FA_BALL: return new SphereShape(float(size[0]));
	case FA_CYLINDER: return new RotatedTranslatedShape(Vec3::sZero(), upright, new CylinderShape(float(size[1]), float(size[0]), cEdge));
	case FA_CAPSULE: return new RotatedTranslatedShape(Vec3::sZero(), lying, new CapsuleShape(float(size[1]), float(size[0])));
	}
	StaticCompoundShapeSettings feet;
	for (int i = 0; i < 3; ++i)
		feet.AddShape(Vec3(float(size[2 * i]), float(size[2 * i + 1]), 0), Quat::sIdentity(), new SphereShape(0.01f));
	return feet.Create().Get();
}

struct Simulation
{
	explicit Simulation(const fa_scene &inScene) : mStep(float(inScene.dt))
	{
		mSystem.Init(16, 0, 64, 64, mLayers, mBroadPhase, mPairs);
		mSystem.SetGravity(ToVec(inScene.gravity));
		PhysicsSettings settings = mSystem.GetPhysicsSettings();
		settings.mNumVelocitySteps = uint(cVelocitySteps[inScene.setting]), settings.mNumPositionSteps = uint(cPositionSteps[inScene.setting]);
		mSystem.SetPhysicsSettings(settings);
		if (inScene.has_floor)
			Add(BodyCreationSettings(new BoxShape(Vec3(50, 50, 1)), RVec3(0, 0, -1), Quat::sIdentity(), EMotionType::Static, 0), inScene.mu);
		for (int i = 0; i < inScene.count; ++i)
			mBodies.push_back(Add(Settings(inScene.bodies[i]), inScene.mu));
	}

	static BodyCreationSettings Settings(const fa_body &inBody)
	{
		Ref<Shape> shape = MakeShape(inBody);
		shape = new OffsetCenterOfMassShape(shape, ToVec(inBody.com) - shape->GetCenterOfMass());
		const double *q = inBody.pose;
		EMotionType motion = inBody.is_driven ? EMotionType::Kinematic : EMotionType::Dynamic;
		BodyCreationSettings body(shape, RVec3(ToVec(inBody.place)), Quat(float(q[1]), float(q[2]), float(q[3]), float(q[0])), motion, 0);
		body.mOverrideMassProperties = EOverrideMassProperties::MassAndInertiaProvided;
		body.mMassPropertiesOverride.mMass = float(inBody.mass);
		body.mMassPropertiesOverride.mInertia = Mat44::sScale(ToVec(inBody.inertia));
		body.mUseManifoldReduction = inBody.kind != FA_FEET; // or three feet have one contact
		return body;
	}

	BodyID Add(BodyCreationSettings inBody, double inMu)
	{
		inBody.mFriction = float(inMu), inBody.mAllowSleeping = false, inBody.mMaxAngularVelocity = 1000;
		inBody.mLinearDamping = inBody.mAngularDamping = 0;
		return Bodies().CreateAndAddBody(inBody, EActivation::Activate);
	}

	BodyInterface &Bodies() { return mSystem.GetBodyInterfaceNoLock(); }

	Layers mLayers;
	ObjectVsBroadPhaseLayerFilter mBroadPhase;
	ObjectLayerPairFilter mPairs;
	PhysicsSystem mSystem;
	Array<BodyID> mBodies;
	float mStep;
};

Simulation &At(void *inWorld) { return *static_cast<Simulation *>(inWorld); }

} // namespace

const char *fa_about()
{
	return "{\"name\": \"" ANSWERS_NAME "\", \"version\": \"3b47ec39\", \"licence\": \"MIT\", \"kind\": \"games\", \"settings\": {"
		   "\"default\": {\"dt\": 0.016666666666666666},"
		   "\"240 Hz\": {\"dt\": 0.004166666666666667}, \"1 ms, 50 iterations\": {\"dt\": 0.001, \"velocity\": 50, \"position\": 5}}}";
}

void *fa_make(const fa_scene *inScene, const char **outWhy)
{
	*outWhy = inScene->torsion > 0 ? "Balls have no torsional friction." : "Friction is the same in all directions.";
	if (inScene->torsion > 0 || inScene->mu_across >= 0)
		return nullptr;
	if (Factory::sInstance == nullptr)
	{
		RegisterDefaultAllocator();
		Factory::sInstance = new Factory;
		RegisterTypes();
	}
	return new Simulation(*inScene);
}

void fa_drop(void *inWorld) { delete &At(inWorld); }

void fa_set(void *inWorld, int inBody, const double *inVelocity, const double *inSpin)
{
	At(inWorld).Bodies().SetLinearAndAngularVelocity(At(inWorld).mBodies[inBody], ToVec(inVelocity), ToVec(inSpin));
}

void fa_step(void *inWorld)
{
	static TempAllocatorImpl sMemory(10 << 20);
	static JobSystemSingleThreaded sJobs(cMaxPhysicsJobs);
	At(inWorld).mSystem.Update(At(inWorld).mStep, 1, &sMemory, &sJobs);
}

void fa_state(void *inWorld, int inBody, double *outState)
{
	BodyInterface &bodies = At(inWorld).Bodies();
	BodyID id = At(inWorld).mBodies[inBody];
	RVec3 p = bodies.GetCenterOfMassPosition(id);
	Quat q = bodies.GetRotation(id);
	Vec3 v = bodies.GetLinearVelocity(id), w = bodies.GetAngularVelocity(id);
	double all[] = { p.GetX(), p.GetY(), p.GetZ(), q.GetW(), q.GetX(), q.GetY(), q.GetZ(), v.GetX(), v.GetY(), v.GetZ(), w.GetX(), w.GetY(), w.GetZ() };
	std::copy(std::begin(all), std::end(all), outState);
}

void fa_gravity(void *inWorld, const double *inGravity) { At(inWorld).mSystem.SetGravity(ToVec(inGravity)); }

void fa_force(void *inWorld, int inBody, const double *inForce) { At(inWorld).Bodies().AddForce(At(inWorld).mBodies[inBody], ToVec(inForce)); }
