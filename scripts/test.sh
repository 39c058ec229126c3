#!/usr/bin/env bash
# Everything that has to hold before a change goes in, from nothing: installs what is missing, builds, tests; less than an hour
# on two cores. The release build runs every test and comes last; before it a part of the same sources runs under sanitizers,
# with one lane, and without Qt. scripts/sanitize.sh runs the sanitizers over all of it.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
# shellcheck source=scripts/packages.sh
source scripts/packages.sh

require_packages "${packages_to_build[@]}" "${packages_for_the_window[@]}" "${packages_to_test[@]}" "${packages_to_compare[@]}"

# Threads: the thread sanitizer must find the seeded race and nothing else.
build_preset tsan threads_test seeded_race
run_tests tsan -L threads

# Memory and undefined behaviour, in the core. The longest tests add time and hardly new code.
build_preset debug-asan-ubsan all
run_tests debug-asan-ubsan -LE cli -E "$long_under_sanitizers"

# One lane only: the same pictures and the same steps. The window, closed in the middle of whatever it does: its own code.
build_preset window-asan agreement_test replay_test sweep_state_test closing_test
run_tests window-asan -R 'Agreement|Replay|SweepState|^ui\.closing_test$' -E 'NOT_BUILT|OnTheSharedModels'

build_preset ci all
run_tests ci
