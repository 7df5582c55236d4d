#!/bin/sh
# Applies `../friction_model.diff` to Rapier and runs the same scenes before and after.
#
#     check.sh REPOSITORY [FOLDER]
#
# REPOSITORY is a clone of https://github.com/dimforge/rapier that has the commit below; FOLDER (a new one in
# the folder for temporary files, if it is not given) receives copies and results.
set -eu

COMMIT=ccd01cd294e84945da55d61548002a5b6f73df31
here=$(cd "$(dirname "$0")" && pwd)
repository=${1:?usage: check.sh REPOSITORY [FOLDER]}
folder=${2:-$(mktemp -d)}
mkdir -p "$folder"
folder=$(cd "$folder" && pwd)

git -C "$repository" cat-file -e "$COMMIT^{commit}" ||
    { echo "check.sh: $repository does not have the commit $COMMIT" >&2; exit 1; }
[ ! -e "$folder/before" ] ||
    { echo "check.sh: $folder has results of an earlier check: give a new folder" >&2; exit 1; }
for copy in before after; do
    mkdir -p "$folder/$copy/rapier/crates/rapier3d"
    git -C "$repository" archive "$COMMIT" Cargo.toml LICENSE src > "$folder/$copy/rapier.tar"
    tar x -C "$folder/$copy/rapier" -f "$folder/$copy/rapier.tar"
    git -C "$repository" show "$COMMIT:crates/rapier3d/Cargo.toml" > "$folder/$copy/rapier/crates/rapier3d/Cargo.toml"
    # One crate of the workspace: the others need more than this check.
    sed -i -e '/^members = \[/,/^\]/c members = ["crates/rapier3d"]' \
        -e '/^default-members = \[/,/^\]/d' -e '/{ git = /d' "$folder/$copy/rapier/Cargo.toml"
    cp -r "$here/scenes" "$folder/$copy/"
done
(cd "$folder/after/rapier" && patch -p1 < "$here/../friction_model.diff")
for copy in before after; do
    features=$([ $copy = after ] && echo "--features area" || echo "")
    (cd "$folder/$copy/scenes" &&
        CARGO_TARGET_DIR="$folder/target" cargo build --release $features)
    "$folder/target/release/scenes" | tee "$folder/$copy.md"
done
echo "results: $folder/before.md $folder/after.md"
