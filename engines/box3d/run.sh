#!/usr/bin/env bash
# Builds box3d before and after friction.diff, runs the scenes and the engine's tests, and writes a table that compares.
#
#     engines/box3d/run.sh SOURCE_DIR
#
# SOURCE_DIR is a git checkout of https://github.com/erincatto/box3d at the commit below; it stays as it is. Results go
# to target/engines/box3d (or $WORK), rounds of the timings are $ROUNDS (9). Nothing is fetched.
set -euo pipefail

engine=box3d
commit=30c67b5e6d0a3a66f0f506c69ce9e9e0587e3b7c
exported=(CMakeLists.txt include src shared test)
headers_at=include/box3d
switched=BOX3D_JOINT_FRICTION
compared=()

configure() { # SOURCE BUILD ON|OFF
    cmake -S "$1" -B "$2" -DCMAKE_BUILD_TYPE=Release -DBOX3D_SAMPLES=OFF "-D$switched=$3"
}

scenes() { # SOURCE BUILD PROGRAM
    local define=()
    [[ $3 == */after/* ]] && define=(-DBOX3D_JOINT_FRICTION)
    cc -O2 -std=gnu17 -Wall -Wextra "${define[@]}" -I "$1/include" -o "$3" \
        "$repository"/engines/box3d/scenes/*.c "$2/src/libbox3d.a" -lm
}

tests() { # BUILD
    (cd "$1" && bin/test) # leaves files where it runs
}

summary() { # LOG
    grep -E '^(test (passed|failed)|All Box3D|condition false)|subtest failed' "$1" || true
}

source "$(dirname "$0")/../manifold/run.sh"
run "$@"
