// Jolt at 3b47ec39: a box that spins stops as early as one that does not. Compile with the options of the engine: by CMake,
// find_package(Jolt CONFIG REQUIRED), add_executable(spin jolt_box_that_spins.cpp), target_link_libraries(spin Jolt::Jolt).
#include <Jolt/Jolt.h>

#include <Jolt/Core/Factory.h>
#include <Jolt/Core/JobSystemSingleThreaded.h>
#include <Jolt/Core/TempAllocator.h>
#include <Jolt/Physics/Body/BodyCreationSettings.h>
#include <Jolt/Physics/Collision/Shape/BoxShape.h>
#include <Jolt/Physics/PhysicsSystem.h>
#include <Jolt/RegisterTypes.h>

#include <cstdio>

using namespace JPH;

struct Layers final : BroadPhaseLayerInterface
{
	uint GetNumBroadPhaseLayers() const override { return 1; }
	BroadPhaseLayer GetBroadPhaseLayer(ObjectLayer) const override { return BroadPhaseLayer(0); }
};

int main()
{
	RegisterDefaultAllocator();
	Factory::sInstance = new Factory;
	RegisterTypes();
	TempAllocatorImpl memory(1 << 24);
	JobSystemSingleThreaded jobs(cMaxPhysicsJobs);
	for (auto [spin, exact] : { std::pair(0.0f, 0.1699), std::pair(50.0f, 0.4498) })
	{
		Layers layers;
		ObjectVsBroadPhaseLayerFilter any;
		ObjectLayerPairFilter pairs;
		PhysicsSystem world;
		world.Init(8, 0, 8, 8, layers, any, pairs);
		BodyInterface &bodies = world.GetBodyInterface();
		auto add = [&](Vec3 inHalf, RVec3 inPlace, EMotionType inType)
		{
			BodyCreationSettings body(new BoxShape(inHalf, 0.0005f), inPlace, Quat::sIdentity(), inType, 0);
			body.mFriction = 0.3f, body.mMaxAngularVelocity = 1000, body.mLinearDamping = body.mAngularDamping = 0, body.mAllowSleeping = false;
			return bodies.CreateAndAddBody(body, EActivation::Activate);
		};
		add(Vec3(9, 1, 9), RVec3(0, -1, 0), EMotionType::Static);
		BodyID box = add(Vec3(0.05f, 0.001f, 0.05f), RVec3(0, 0.001f, 0), EMotionType::Dynamic);
		auto steps = [&](int inCount) { for (int i = 0; i < inCount; ++i) world.Update(1 / 240.0f, 1, &memory, &jobs); };
		steps(120);
		double start = double(bodies.GetPosition(box).GetX());
		bodies.SetLinearAndAngularVelocity(box, Vec3(1, 0, 0), Vec3(0, spin, 0));
		steps(480);
		std::printf("a box of 10 cm at 1 m/s and %g rad/s goes %.4f m, exactly %.4f m\n", double(spin), double(bodies.GetPosition(box).GetX()) - start, exact);
	}
}
