#!/usr/bin/env bash
# All tests of the core and the command line under the address and undefined-behaviour sanitizers, and the window closed under
# the thread sanitizer: what scripts/test.sh runs a part of. An hour or more on two cores.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
# shellcheck source=scripts/packages.sh
source scripts/packages.sh

require_packages "${packages_to_build[@]}" "${packages_for_the_window[@]}" "${packages_to_test[@]}"

build_preset debug-asan-ubsan all
run_tests debug-asan-ubsan -E OnTheSharedModels

# What Qt keeps to the end is no leak of ours: the preset says so.
build_preset window-tsan closing_test
run_tests window-tsan -R '^ui\.closing_test$'
