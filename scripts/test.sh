#!/usr/bin/env bash
# Everything that has to hold before a change goes in, from nothing: installs what is missing, builds, tests.
# The release build runs every test and comes last; before it the same sources run under sanitizers, with one lane,
# and without Qt.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
# shellcheck source=scripts/packages.sh
source scripts/packages.sh

# run_tests PRESET [CTEST OPTION...]: what the preset's build holds, or a part of it. No test at all is an error.
run_tests() {
    local preset="$1"
    shift
    ctest --preset "$preset" --parallel "$(nproc)" "$@"
}

require_packages "${packages_to_build[@]}" "${packages_for_the_window[@]}" "${packages_to_test[@]}" "${packages_to_compare[@]}"

# Threads: the thread sanitizer must find the seeded race and nothing else.
build_preset tsan threads_test seeded_race
run_tests tsan -L threads

# The window, closed in the middle of whatever it does: its own code under both. What Qt keeps to the end is no leak of ours.
for preset in window-tsan window-asan; do
    build_preset "$preset" closing_test
    run_tests "$preset" -R '^ui\.closing_test$'
done

# Memory and undefined behaviour, in the whole core. The large models add time and no new code; the command line's tests
# start hundreds of processes, each of which would pay for the sanitizer's start.
build_preset debug-asan-ubsan all
run_tests debug-asan-ubsan -E OnTheSharedModels -LE cli

# One lane only, and no Qt: the same pictures and the same steps.
build_preset scalar agreement_test replay_test sweep_state_test
run_tests scalar -R 'Agreement|Replay|SweepState' -E 'NOT_BUILT|OnTheSharedModels'

build_preset ci all
run_tests ci
