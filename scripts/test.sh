#!/usr/bin/env bash
# Everything that has to hold before a change goes in, from nothing: installs what is missing, builds, tests; less than an hour
# on two cores. The release build runs every test, in every instruction set and with one lane, and comes last; before it a part
# of the same sources runs under sanitizers, without Qt. scripts/sanitize.sh runs the sanitizers over all of it, and the build that
# has one lane only.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
# shellcheck source=scripts/packages.sh
source scripts/packages.sh

require_packages "${packages_to_build[@]}" "${packages_for_the_window[@]}" "${packages_to_test[@]}" "${packages_to_compare[@]}"

# Threads: the thread sanitizer must find the seeded race and nothing else.
build_preset tsan threads_test seeded_race
run_tests tsan -L threads

# Memory and undefined behaviour, in the core: every part, the hard cases, the steps. What only adds scenes and seeds takes long.
sanitized=(
    io_test scene_test core_polygons core_obj core_geometry core_frame_parts core_hierarchy renderer_test experiment_test obj_mutation_test
    hard_a_test hard_b_test hard_c_test hard_d_test hard_g_test cutout_test relief_test moment_test transparency_test
    replay_test sweep_state_test structure_steps_test pixel_changes_test
)
build_preset debug-asan-ubsan "${sanitized[@]}"
run_tests debug-asan-ubsan -E "NOT_BUILT|$long_under_sanitizers"

build_preset ci all
run_tests ci
