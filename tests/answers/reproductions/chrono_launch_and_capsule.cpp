// Chrono 10.0.0 at 7689fbc0: a ball that is set in motion on a floor jumps up, and a capsule falls through a box. Built as adapters/chrono.cpp is.
#include "chrono/collision/ChCollisionShapes.h"
#include "chrono/physics/ChSystemNSC.h"

#include <cstdio>

using namespace chrono;

static auto scene() {
    auto system = std::make_unique<ChSystemNSC>();
    system->SetCollisionSystemType(ChCollisionSystem::Type::BULLET);
    system->SetGravitationalAcceleration({0, 0, -9.81});
    return system;
}

static auto surface(float mu) {
    auto made = chrono_types::make_shared<ChContactMaterialNSC>();
    made->SetFriction(mu);
    return made;
}

static auto add(ChSystemNSC& system, std::shared_ptr<ChCollisionShape> shape, ChVector3d place, ChQuaterniond pose, bool is_fixed) {
    auto body = chrono_types::make_shared<ChBody>();
    body->AddCollisionShape(shape, ChFramed(VNULL, pose));
    body->EnableCollision(true);
    body->SetMass(1);
    body->SetInertiaXX({4e-4, 4e-4, 4e-4});
    body->SetPos(place);
    body->SetFixed(is_fixed);
    system.AddBody(body);
    return body;
}

int main() {
    {
        auto system = scene();
        add(*system, chrono_types::make_shared<ChCollisionShapeBox>(surface(0.9f), 40, 40, 2), {0, 0, -1}, QUNIT, true);
        auto ball = add(*system, chrono_types::make_shared<ChCollisionShapeSphere>(surface(0.9f), 0.03), {0, 0, 0.03}, QUNIT, false);
        for (int i = 0; i < 500; ++i) system->DoStepDynamics(1e-3);
        ball->SetLinVel({5, 0, 0});
        double highest = 0;
        for (int i = 0; i < 1000; ++i) {
            system->DoStepDynamics(1e-3);
            highest = std::max(highest, ball->GetPos().z() - 0.03);
        }
        std::printf("a ball at 5 m/s on a level floor rises by %.4f m, exactly 0\n", highest);
    }
    {
        auto system = scene();
        add(*system, chrono_types::make_shared<ChCollisionShapeBox>(surface(0.5f), 1, 1, 0.2), {0, 0, -0.1}, QUNIT, true);
        auto lying = chrono_types::make_shared<ChCollisionShapeCapsule>(surface(0.5f), 0.01, 0.04);
        auto capsule = add(*system, lying, {0, 0, 0.012}, QuatFromAngleY(CH_PI_2), false);
        for (int i = 0; i < 1000; ++i) system->DoStepDynamics(1e-3);
        std::printf("a capsule that lies on a box is %.3f m below its face after 1 s, exactly 0\n", 0.01 - capsule->GetPos().z());
    }
}
