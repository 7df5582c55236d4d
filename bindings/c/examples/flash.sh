#!/bin/sh
# Flash used by single functions on a Cortex-M4F, code and data: docs/tables/flash-c.csv.
#
#     cargo build --profile dist -p tribos-c --target thumbv7em-none-eabihf
#     bindings/c/examples/flash.sh target/thumbv7em-none-eabihf/dist/libtribos_c.a > docs/tables/flash-c.csv
set -eu
if [ $# -ne 1 ] || [ ! -f "$1" ]; then
  echo "usage: flash.sh path/to/libtribos_c.a (built for thumbv7em-none-eabihf)" >&2
  exit 2
fi
image=$(mktemp)
trap 'rm -f "$image"' EXIT

echo "function,bytes_f32,bytes_f64"
for name in lugre_step stribeck_friction rate_state_friction \
  disk_wrench disk_jacobian hertz_wrench ring_wrench punch_wrench \
  power_compact_build power_compact_wrench power_table_build power_table_wrench nodes_coulomb_wrench polygon_nodes \
  disk_surface_gauge disk_surface_project disk_surface_project_batch planar_disk_step planar_disk_step_batch ellipsoid_gauge \
  polygon_new polygon_lean polygon_wrench polygon_wrench_jacobian polygon_gauge polygon_project \
  slider_verlet_step slider_advance slider_to_rest \
  contact_spheres update_sliding_spheres update_all_spheres update_patch_spheres; do
  printf '%s' "$name"
  for precision in f32 f64; do
    arm-none-eabi-gcc -mcpu=cortex-m4 -mthumb -mfloat-abi=hard -mfpu=fpv4-sp-d16 -nostdlib \
      -Wl,--gc-sections -Wl,--entry="tribos_${name}_$precision" -Wl,-u,"tribos_${name}_$precision" \
      -Wl,-z,noexecstack "$1" -lgcc -o "$image"
    # Code and constants; tables of unwinding are for debuggers.
    bytes=$(arm-none-eabi-size -A "$image" | awk '$1 ~ /^\.(text|rodata|data)/ { sum += $2 } END { print sum + 0 }')
    printf ',%s' "$bytes"
  done
  echo
done
