#!/usr/bin/env bash
# Builds Jolt before and after friction.diff, runs the scenes and the engine's tests, and writes a table that compares.
#
#     engines/jolt/run.sh SOURCE_DIR
#
# SOURCE_DIR is a git checkout of https://github.com/jrouwe/JoltPhysics at the commit below; it stays as it is. Results
# go to target/engines/jolt (or $WORK), rounds of the timings are $ROUNDS (9). Nothing is fetched.
set -euo pipefail

engine=jolt
commit=3b47ec390cb9b933769183eff599f72195c5873c
exported=(Build Jolt UnitTests)
headers_at=Jolt/Physics/Constraints
switched=JOINT_FRICTION
compared=(ContactConstraintManager.cpp EstimateCollisionResponse.cpp PhysicsSystem.cpp)

configure() { # SOURCE BUILD ON|OFF
    # gcc 12 warns of uninitialised operands in its own intrinsics: warnings are no errors here.
    cmake -S "$1/Build" -B "$2" -DCMAKE_BUILD_TYPE=Release "-D$switched=$3" -DENABLE_ALL_WARNINGS=OFF \
        -DTARGET_SAMPLES=OFF -DTARGET_VIEWER=OFF -DTARGET_HELLO_WORLD=OFF -DTARGET_PERFORMANCE_TEST=OFF \
        -DGENERATE_DEBUG_SYMBOLS=OFF -DINTERPROCEDURAL_OPTIMIZATION=OFF -DJPH_USE_VK=OFF \
        -DPROFILER_IN_DEBUG_AND_RELEASE=OFF -DDEBUG_RENDERER_IN_DEBUG_AND_RELEASE=OFF
}

scenes() { # SOURCE BUILD PROGRAM
    cmake -S "$repository/engines/jolt/scenes" -B "$2/scenes" -DCMAKE_BUILD_TYPE=Release -DJolt_DIR="$2" &&
        cmake --build "$2/scenes" &&
        cp "$2/scenes/scenes" "$3"
}

tests() { # BUILD
    (cd "$1" && ./UnitTests)
}

summary() { # LOG
    grep -E '^(TEST CASE|\[doctest\] (test cases|assertions))' "$1" || true
}

source "$(dirname "$0")/../manifold/run.sh"
run "$@"
