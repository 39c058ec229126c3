#!/usr/bin/env bash
# All tests of the core and the command line under the address and undefined-behaviour sanitizers and under the thread sanitizer, and
# the window closed in the middle of its work under those of addresses and threads; and the kernels compiled for one lane only. Hours
# on two slow cores: the first part builds for half an hour and tests for three quarters.
#
#   scripts/sanitize.sh          everything
#   scripts/sanitize.sh core     every part of the core, the hard cases and the steps, without what only adds scenes and seeds: less
#                                than an hour on two slow cores
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
# shellcheck source=scripts/packages.sh
source scripts/packages.sh

require_packages "${packages_to_build[@]}" "${packages_for_the_window[@]}" "${packages_to_test[@]}"

if [[ "${1:-}" == core ]]; then
    build_preset debug-asan-ubsan core_tests agreement_tests replay_tests obj_mutation_test
    long='OnTheSharedModels|AgreementOnGenerated|InSoups|OnSoups|Faults|Approximations|AgreementInside|HardE|HardF|FalseCulls'
    long+='|ExplainsAThousandPixels|OnePicture|Tally|Mirrored|Coherence|Plain'
    run_tests debug-asan-ubsan -E "NOT_BUILT|$long"
    exit
fi

build_preset debug-asan-ubsan all
run_tests debug-asan-ubsan -E OnTheSharedModels

# The thread sanitizer maps a file of its own when a program starts, and dies where files may not grow.
build_preset tsan all
run_tests tsan -E 'OnTheSharedModels|AFileThatMayNotGrow'

# The window, closed in the middle of whatever it does: its own code under both. What Qt keeps to the end is no leak of ours: the
# presets say so.
for preset in window-tsan window-asan; do
    build_preset "$preset" ui_tests
    run_tests "$preset" -R '^ui\.closing_test$'
done

# Kernels compiled for one lane only: the same pictures and the same steps.
build_preset plain agreement_tests replay_tests
run_tests plain -R 'Agreement|Replay|SweepState' -E 'NOT_BUILT|OnTheSharedModels'
