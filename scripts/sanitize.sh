#!/usr/bin/env bash
# All tests of the core and the command line under the address and undefined-behaviour sanitizers, and the window closed in the
# middle of its work under those of addresses and threads; and the kernels compiled for one lane only. scripts/test.sh runs a part
# of it. Hours on two cores.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
# shellcheck source=scripts/packages.sh
source scripts/packages.sh

require_packages "${packages_to_build[@]}" "${packages_for_the_window[@]}" "${packages_to_test[@]}"

build_preset debug-asan-ubsan all
run_tests debug-asan-ubsan -E OnTheSharedModels

# The window, closed in the middle of whatever it does: its own code under both. What Qt keeps to the end is no leak of ours: the
# presets say so.
for preset in window-tsan window-asan; do
    build_preset "$preset" closing_test
    run_tests "$preset" -R '^ui\.closing_test$'
done

# Kernels compiled for one lane only: the same pictures and the same steps.
build_preset scalar agreement_test replay_test sweep_state_test
run_tests scalar -R 'Agreement|Replay|SweepState' -E 'NOT_BUILT|OnTheSharedModels'
