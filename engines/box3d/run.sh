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
header_at=src/tribos_manifold_friction.h

build() { # SOURCE BUILD ON|OFF
    cmake -S "$1" -B "$2" -DCMAKE_BUILD_TYPE=Release -DBOX3D_SAMPLES=OFF -DBOX3D_JOINT_FRICTION="$3"
    cmake --build "$2" -j2
}

objects() { # BUILD
    (cd "$1" && find src -name '*.o' | sort)
}

scenes() { # SOURCE BUILD PROGRAM
    local define=()
    [[ $3 == *after* ]] && define=(-DBOX3D_JOINT_FRICTION)
    cc -O2 -std=gnu17 -Wall -Wextra "${define[@]}" -I "$1/include" -o "$3" \
        "$repository"/engines/box3d/scenes/*.c "$2/src/libbox3d.a" -lm
}

tests() { # BUILD
    "$1/bin/test"
}

summary() { # LOG
    grep -E '^(test (passed|failed)|All Box3D|.*FAILED|.*condition false)' "$1" | sort | uniq -c | sed 's/^ *1 //'
}

source "$(dirname "$0")/../manifold/run.sh"
run "$@"
