# Common steps of engines/*/run.sh, which sets
#   engine      name of its folder
#   commit      the engine's commit that the diff is for
#   exported    paths of the engine's tree that are needed
#   headers_at  where the engine's build finds the two headers of this project
#   switched    the switch of the diff
#   compared    sources that must not change without the switch; none means all of src
# and defines: configure SOURCE BUILD ON|OFF, scenes SOURCE BUILD PROGRAM, tests BUILD, summary LOG.

here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
repository=$(cd "$here/../.." && pwd)
work=${WORK:-$repository/target/engines/$engine}
rounds=${ROUNDS:-9}
export CMAKE_EXPORT_COMPILE_COMMANDS=ON

die() {
    echo "$0: $*" >&2
    exit 1
}

check_commit() {
    local found
    found=$(git -C "$1" rev-parse HEAD 2>/dev/null) ||
        die "$1 is not a git checkout of $engine; clone it and check out $commit"
    [ "$found" = "$commit" ] ||
        die "$1 is at commit $found; the diff is for $commit: git -C $1 checkout $commit"
}

# Exports the engine's tree at its commit, so that the checkout stays as it is. Files have the time of the commit, so
# that a second run compiles only what the diff has changed.
export_tree() {
    local index when
    index=$(mktemp -u)
    when=$(git -C "$1" show -s --format=%cI "$commit")
    rm -rf "$2"
    mkdir -p "$2"
    GIT_INDEX_FILE=$index git -C "$1" read-tree "$commit"
    GIT_INDEX_FILE=$index git -C "$1" --work-tree="$2" ls-files -z -- "${exported[@]/#/:/}" |
        GIT_INDEX_FILE=$index git -C "$1" --work-tree="$2" checkout-index -z --stdin --prefix="$2/"
    rm -f "$index"
    find "$2" -type f -exec touch -d "$when" {} +
}

apply_diff() {
    cp "$repository/bindings/c/include/tribos_manifold_friction.h" "$here/tribos_moving_area.h" "$1/$headers_at"
    patch -d "$1" -p1 --quiet --no-backup-if-mismatch <"$repository/engines/$engine/friction.diff"
}

build() {
    configure "$1" "$2" "$3" && cmake --build "$2" -j2
}

# The engine with the diff but without the switch is the engine as it is.
check_off() {
    configure "$work/after/source" "$work/off" OFF >"$work/off.log" 2>&1 ||
        die "the configuration without the switch failed: see $work/off.log"
    python3 "$here/same_source.py" "$work/before/build" "$work/off" "${compared[@]}"
}

# The benchmark of friction, by the engine and its adapter in one library.
answers() { # before|after
    local adapters=$repository/tests/answers/friction_answers/adapters name=()
    [ "$1" = after ] && name=(-DANSWERS_NAME="$engine with tribos" "-D$switched=ON")
    cmake -S "$adapters" -B "$work/$1/answers" -DENGINE="$engine" -DSOURCE="$work/$1/source" \
        -DCMAKE_BUILD_TYPE=Release "${name[@]}" && cmake --build "$work/$1/answers" -j2 &&
        (cd "$repository/tests/answers" && python3 -m friction_answers run --out "$work/$1/answers.json" \
            "$work/$1/answers/lib${engine}_answers.so")
}

run_costs() {
    local scene round
    echo "scene,round,before,after" >"$work/cost.csv"
    for scene in pile sliding; do
        for round in $(seq "$rounds"); do
            echo "$scene,$round,$("$work/before/scenes" "$scene"),$("$work/after/scenes" "$scene")" >>"$work/cost.csv"
        done
    done
}

run() {
    [ $# -eq 1 ] || die "usage: $0 SOURCE_DIR, a git checkout of $engine at $commit"
    local source=$1 state switch=OFF
    check_commit "$source"
    mkdir -p "$work"
    for state in before after; do
        export_tree "$source" "$work/$state/source"
        if [ "$state" = after ]; then
            apply_diff "$work/$state/source"
            switch=ON
        fi
        build "$work/$state/source" "$work/$state/build" "$switch" >"$work/$state/build.log" 2>&1 ||
            die "the build failed: see $work/$state/build.log"
        scenes "$work/$state/source" "$work/$state/build" "$work/$state/scenes" >>"$work/$state/build.log" 2>&1 ||
            die "the scenes do not compile: see $work/$state/build.log"
        answers "$state" >"$work/$state/answers.log" 2>&1 || die "the benchmark fails: see $work/$state/answers.log"
        "$work/$state/scenes" throws >"$work/$state/throws.csv"
        "$work/$state/scenes" rest >"$work/$state/rest.csv"
        tests "$work/$state/build" >"$work/$state/tests.log" 2>&1 || echo "some tests of the engine fail: $state" >&2
        summary "$work/$state/tests.log" >"$work/$state/tests.txt"
    done
    check_off | tee "$work/off.txt"
    run_costs
    python3 "$here/compare.py" "$here/exact.csv" "$work" >"$work/results.md"
    echo "$work/results.md"
}
