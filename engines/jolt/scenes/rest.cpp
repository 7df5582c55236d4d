#include "rest.h"

#include "world.h"

#include <Jolt/Physics/Collision/Shape/BoxShape.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

using namespace JPH;

namespace {

constexpr int cStacked = 10;
constexpr double cRate = 60.0;

void PrintRow(const char *inScene, const char *inQuantity, double inValue)
{
	std::printf("%s,%s,%.6e\n", inScene, inQuantity, inValue);
}

// A cube on a slope whose tangent is this multiple of the coefficient, after one second, for four more. It stands askew:
// edges that are parallel to the floor's to a few units of rounding can upset an engine's search for contacts.
void PrintSlope(const char *inScene, double inRatio)
{
	constexpr float cMu = 0.5f;
	World world(std::atan(inRatio * double(cMu)), cMu);
	BodyID cube = world.AddBody(new BoxShape(Vec3::sReplicate(0.1f)), RVec3(0, 0.1f, 0), Quat::sRotation(Vec3::sAxisY(), 0.1f), cMu);
	world.StepFor(1.0, cRate);
	RVec3 start = world.GetPosition(cube);
	double heading = world.GetHeading(cube);
	world.StepFor(4.0, cRate);
	RVec3 way = world.GetPosition(cube) - start;
	PrintRow(inScene, "travel_m", double(way.GetX()));
	PrintRow(inScene, "left_m", double(-way.GetZ()));
	PrintRow(inScene, "yaw_rad", world.GetHeading(cube) - heading);
}

// Ten cubes on each other, after one second, for ten more. In the turned stack each is turned by 0.1 rad against the
// one below it and shifted by 2 to 6 cm.
void PrintStack(const char *inScene, float inTurn, float inShift)
{
	constexpr float cMu = 0.6f;
	World world(0.0, cMu);
	Ref<Shape> shape = new BoxShape(Vec3::sReplicate(0.5f));
	BodyID cubes[cStacked];
	for (int i = 0; i < cStacked; ++i)
		cubes[i] = world.AddBody(shape, RVec3(2.0f * inShift * float(i % 2), 0.5f + float(i), 3.0f * inShift * float(i % 3)), Quat::sRotation(Vec3::sAxisY(), inTurn * float(i)), cMu);
	world.StepFor(1.0, cRate);
	RVec3 starts[cStacked];
	double headings[cStacked];
	for (int i = 0; i < cStacked; ++i)
	{
		starts[i] = world.GetPosition(cubes[i]);
		headings[i] = world.GetHeading(cubes[i]);
	}
	world.StepFor(10.0, cRate);
	double drift = 0.0, yaw = 0.0;
	for (int i = 0; i < cStacked; ++i)
	{
		RVec3 way = world.GetPosition(cubes[i]) - starts[i];
		drift = std::max(drift, std::hypot(double(way.GetX()), double(way.GetZ())));
		yaw = std::max(yaw, std::abs(world.GetHeading(cubes[i]) - headings[i]));
	}
	PrintRow(inScene, "drift_m", drift);
	PrintRow(inScene, "yaw_rad", yaw);
	PrintRow(inScene, "top_m", double(world.GetPosition(cubes[cStacked - 1]).GetY()));
}

} // namespace

void PrintRest()
{
	std::printf("scene,quantity,value\n");
	PrintSlope("slope 0.95", 0.95);
	PrintSlope("slope 0.99", 0.99);
	PrintSlope("slope 1.01", 1.01);
	PrintSlope("slope 1.05", 1.05);
	PrintStack("stack", 0.0f, 0.0f);
	PrintStack("turned stack", 0.1f, 0.01f);
}
