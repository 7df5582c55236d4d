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

constexpr float cEdge = 0.0005f; // radius of rounded edges, m: half of the narrowest half width

static Vec3 ToVec(const double *inV) { return Vec3(float(inV[0]), float(inV[1]), float(inV[2])); }

static Ref<Shape> MakeShape(const fa_body &inBody) {
	const double *size = inBody.sizes;
	Quat upright = Quat::sRotation(Vec3::sAxisX(), 0.5f * JPH_PI), lying = Quat::sRotation(Vec3::sAxisZ(), 0.5f * JPH_PI);
	if (inBody.kind == FA_BOX) return new BoxShape(ToVec(size), cEdge);
	if (inBody.kind == FA_BALL) return new SphereShape(float(size[0]));
	if (inBody.kind == FA_CYLINDER) return new RotatedTranslatedShape(Vec3::sZero(), upright, new CylinderShape(float(size[1]), float(size[0]), cEdge));
	if (inBody.kind == FA_CAPSULE) return new RotatedTranslatedShape(Vec3::sZero(), lying, new CapsuleShape(float(size[1]), float(size[0])));
	StaticCompoundShapeSettings feet;
	for (int i = 0; i < 6; i += 2) feet.AddShape(Vec3(float(size[i]), float(size[i + 1]), 0), Quat::sIdentity(), new SphereShape(0.01f));
	return feet.Create().Get();
}

static const struct Engine : BroadPhaseLayerInterface {
	Engine() { RegisterDefaultAllocator(), Factory::sInstance = new Factory, RegisterTypes(); }
	uint GetNumBroadPhaseLayers() const override { return 1; }
	BroadPhaseLayer GetBroadPhaseLayer(ObjectLayer) const override { return BroadPhaseLayer(0); }
	ObjectVsBroadPhaseLayerFilter mBroadPhase;
	ObjectLayerPairFilter mPairs;
} sEngine; // before any world

struct Simulation {
	explicit Simulation(const fa_scene &inScene) : mStep(float(inScene.dt)) {
		mSystem.Init(16, 0, 64, 64, sEngine, sEngine.mBroadPhase, sEngine.mPairs);
		gravity(inScene.gravity);
		PhysicsSettings settings;
		if (inScene.setting == 2) settings.mNumVelocitySteps = 50, settings.mNumPositionSteps = 5; // the others have 10 and 2
		mSystem.SetPhysicsSettings(settings);
		const BodyCreationSettings floor(new BoxShape(Vec3(50, 50, 1)), RVec3(0, 0, -1), Quat::sIdentity(), EMotionType::Static, 0);
		if (inScene.has_floor) Add(floor, inScene.mu);
		for (int i = 0; i < inScene.count; ++i) mBodies.push_back(Add(Settings(inScene.bodies[i]), inScene.mu));
	}

	static BodyCreationSettings Settings(const fa_body &inBody) {
		Ref<Shape> bare = MakeShape(inBody), shape = new OffsetCenterOfMassShape(bare, ToVec(inBody.com) - bare->GetCenterOfMass());
		BodyCreationSettings body(shape, RVec3(ToVec(inBody.place)), Quat(Vec4(ToVec(inBody.pose + 1), float(inBody.pose[0]))), EMotionType::Dynamic, 0);
		if (inBody.is_driven) body.mMotionType = EMotionType::Kinematic;
		body.mMassPropertiesOverride = { float(inBody.mass), Mat44::sScale(ToVec(inBody.inertia)) };
		body.mOverrideMassProperties = EOverrideMassProperties::MassAndInertiaProvided;
		body.mUseManifoldReduction = inBody.kind != FA_FEET; // or three feet have one contact
		return body;
	}

	BodyID Add(BodyCreationSettings inBody, double inMu) {
		inBody.mFriction = float(inMu), inBody.mMaxAngularVelocity = 1000, inBody.mAllowSleeping = false;
		inBody.mLinearDamping = inBody.mAngularDamping = 0;
		return mApi.CreateAndAddBody(inBody, EActivation::Activate);
	}

	void set(int inBody, const double *inVelocity, const double *inSpin) {
		mApi.SetLinearAndAngularVelocity(mBodies[inBody], ToVec(inVelocity), ToVec(inSpin));
	}
	void step() { mSystem.Update(mStep, 1, &mMemory, &mJobs); }
	void gravity(const double *inGravity) { mSystem.SetGravity(ToVec(inGravity)); }
	void force(int inBody, const double *inForce) { mApi.AddForce(mBodies[inBody], ToVec(inForce)); }
	std::array<double, 13> state(int inBody) const {
		Vec3 v, w, p(mApi.GetCenterOfMassPosition(mBodies[inBody]));
		Vec4 q = mApi.GetRotation(mBodies[inBody]).GetXYZW();
		mApi.GetLinearAndAngularVelocity(mBodies[inBody], v, w);
		return { p.GetX(), p.GetY(), p.GetZ(), q.GetW(), q.GetX(), q.GetY(), q.GetZ(), v.GetX(), v.GetY(), v.GetZ(), w.GetX(), w.GetY(), w.GetZ() };
	}

	PhysicsSystem mSystem;
	BodyInterface &mApi = mSystem.GetBodyInterfaceNoLock();
	Array<BodyID> mBodies;
	TempAllocatorImpl mMemory { 10 << 20 };
	JobSystemSingleThreaded mJobs { cMaxPhysicsJobs };
	float mStep;
};

FA_ENGINE(Simulation, "{\"name\": \"" ANSWERS_NAME R"(", "version": "3b47ec39", "licence": "MIT", "kind": "games", "settings": {
	"default": {"dt": 0.016666666666666666}, "240 Hz": {"dt": 0.004166666666666667},
	"1 ms, 50 iterations": {"dt": 0.001, "velocity": 50, "position": 5}}})", fa_lacks)
