# Common steps of engines/*/run.sh, which sets:
#   engine   name of its folder          commit   the engine's commit that the diff is for
#   exported paths of the engine's tree that are needed
#   header_at where the engine's build finds tribos_manifold_friction.h
# and defines: build SOURCE BUILD on|off, objects BUILD, scenes SOURCE BUILD PROGRAM, tests BUILD.

here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
repository=$(cd "$here/../.." && pwd)
work=${WORK:-$repository/target/engines/$engine}
rounds=${ROUNDS:-9}

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

# Exports the engine's tree at its commit, so that the checkout stays as it is.
export_tree() {
    rm -rf "$2"
    mkdir -p "$2"
    git -C "$1" archive "$commit" -- "${exported[@]}" | tar -x -C "$2"
}

apply_diff() {
    cp "$repository/bindings/c/include/tribos_manifold_friction.h" "$1/$header_at"
    (cd "$1" && patch -p1 --quiet --no-backup-if-mismatch <"$repository/engines/$engine/friction.diff")
}

# The engine with the diff but without the switch compiles to the objects of the engine as it is.
check_off() {
    local object
    objects "$work/before/build" | while read -r object; do
        cmp "$work/before/build/$object" "$work/off/build/${object//before/off}" ||
            die "without the switch the diff changes $object"
    done
    echo "without the switch: $(objects "$work/before/build" | wc -l) object files, all as before"
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
    local source=$1 state
    check_commit "$source"
    for state in before off after; do
        export_tree "$source" "$work/$state/source"
        [ "$state" = before ] || apply_diff "$work/$state/source"
        build "$work/$state/source" "$work/$state/build" "$([ "$state" = after ] && echo ON || echo OFF)" \
            >"$work/$state/build.log" 2>&1 || die "the build failed: see $work/$state/build.log"
    done
    check_off
    for state in before after; do
        scenes "$work/$state/source" "$work/$state/build" "$work/$state/scenes"
        "$work/$state/scenes" throws >"$work/$state/throws.csv"
        "$work/$state/scenes" rest >"$work/$state/rest.csv"
        tests "$work/$state/build" >"$work/$state/tests.log" 2>&1 || true
        summary "$work/$state/tests.log" >"$work/$state/tests.txt"
    done
    run_costs
    python3 "$here/compare.py" "$here/exact.csv" "$work" >"$work/results.md"
    echo "$work/results.md"
}
