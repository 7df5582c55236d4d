#!/bin/sh
# Applies `../friction_model.diff` to Rapier, runs the same scenes and Rapier's own tests before and after, and writes
# a table that compares.
#
#     check.sh REPOSITORY [FOLDER]
#
# REPOSITORY is a clone of https://github.com/dimforge/rapier that has the commit below; FOLDER (a new one in
# the folder for temporary files, if it is not given) receives copies and results. With TESTS=0 the scenes alone.
set -eu

COMMIT=ccd01cd294e84945da55d61548002a5b6f73df31
CRATES="crates/rapier2d crates/rapier3d crates/rapier2d-f64 crates/rapier3d-f64"
# The default features leave out tests of snapshots, of determinism and of several threads.
FEATURES=serde-serialize,enhanced-determinism,parallel,debug-render
here=$(cd "$(dirname "$0")" && pwd)
repository=${1:?usage: check.sh REPOSITORY [FOLDER]}
folder=${2:-$(mktemp -d)}
mkdir -p "$folder"
folder=$(cd "$folder" && pwd)
export CARGO_INCREMENTAL=0 CARGO_PROFILE_DEV_DEBUG=false

git -C "$repository" cat-file -e "$COMMIT^{commit}" ||
    { echo "check.sh: $repository does not have the commit $COMMIT" >&2; exit 1; }
[ ! -e "$folder/before" ] ||
    { echo "check.sh: $folder has results of an earlier check: give a new folder" >&2; exit 1; }

# `area` is `after` with `Area` as the default of all worlds, for Rapier's own tests.
for copy in before after area; do
    mkdir -p "$folder/$copy/rapier"
    # shellcheck disable=SC2086
    git -C "$repository" archive "$COMMIT" Cargo.toml LICENSE src $CRATES > "$folder/$copy/rapier.tar"
    tar x -C "$folder/$copy/rapier" -f "$folder/$copy/rapier.tar"
    # The other crates of the workspace need more than this check.
    members=$(printf '"%s", ' $CRATES)
    sed -i -e "/^members = \[/,/^\]/c members = [$members]" \
        -e '/^default-members = \[/,/^\]/d' -e '/{ git = /d' "$folder/$copy/rapier/Cargo.toml"
    cp -r "$here/scenes" "$folder/$copy/"
    [ $copy = before ] || (cd "$folder/$copy/rapier" && patch -p1 < "$here/../friction_model.diff")
done
sed -i -e '/#\[default\]/d' -e 's/^    Area,/    #[default]\n    Area,/' \
    "$folder/area/rapier/src/dynamics/integration_parameters.rs"

for copy in before after; do
    features=$([ $copy = after ] && echo "--features area" || echo "")
    # shellcheck disable=SC2086
    (cd "$folder/$copy/scenes" && CARGO_TARGET_DIR="$folder/target" cargo build --release $features)
    cp "$folder/target/release/scenes" "$folder/$copy/run"
    : > "$folder/$copy/tests.txt"
done

# The other two models have the same digits before and after.
for scene in throws rest; do
    for model in Simplified Coulomb; do
        for copy in before after; do
            "$folder/$copy/run" $scene $model > "$folder/$copy/$scene.$model.csv"
        done
        cmp "$folder/before/$scene.$model.csv" "$folder/after/$scene.$model.csv"
    done
    cp "$folder/before/$scene.Simplified.csv" "$folder/before/$scene.csv"
    "$folder/after/run" $scene Area > "$folder/after/$scene.csv"
done
"$folder/after/run" cost > "$folder/cost.csv"

# Tests that passed, failed and were ignored, and the names of those that failed.
tests() { # COPY WORLDS
    log="$folder/$1/tests.log"
    (cd "$folder/$1/rapier" && CARGO_TARGET_DIR="$folder/target.$1" \
        cargo test -p rapier3d --lib --tests --no-fail-fast --features "$FEATURES") > "$log" 2>&1 || true
    echo "$2 worlds:"
    awk '/^test result/ { passed += $4; failed += $6; ignored += $8 }
        / \.\.\. FAILED$/ { print "    " $2 " failed" }
        END { print "    " passed + 0 " passed, " failed + 0 " failed, " ignored + 0 " ignored" }' "$log"
}
if [ "${TESTS:-1}" != 0 ]; then
    for crate in rapier2d rapier2d-f64 rapier3d-f64; do
        (cd "$folder/after/rapier" && CARGO_TARGET_DIR="$folder/target.after" cargo check -p $crate)
    done
    tests before Simplified >> "$folder/before/tests.txt"
    tests after Simplified >> "$folder/after/tests.txt"
    tests area Area >> "$folder/after/tests.txt"
fi
python3 "$here/../../manifold/compare.py" "$here/../../manifold/exact.csv" "$folder" > "$folder/results.md"
echo "results: $folder/results.md"
