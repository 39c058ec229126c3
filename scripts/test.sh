#!/usr/bin/env bash
# Everything that has to hold before a change goes in, from nothing: installs what is missing, builds, tests; less than an hour
# on two slow cores. The release build runs every test, in every instruction set and with one lane, and comes last; before it the
# tests of threads run under the thread sanitizer. scripts/sanitize.sh runs the sanitizers over everything, and takes hours.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
# shellcheck source=scripts/packages.sh
source scripts/packages.sh

require_packages "${packages_to_build[@]}" "${packages_for_the_window[@]}" "${packages_to_test[@]}" "${packages_to_compare[@]}"

# The layout of the code is clang-format's, as .clang-format says: `git ls-files '*.h' '*.cpp' | xargs clang-format -i` mends it.
git ls-files -z '*.h' '*.cpp' | xargs -0 clang-format --dry-run --Werror

# Threads: the thread sanitizer must find the seeded race and nothing else.
build_preset tsan threads_test seeded_race
run_tests tsan -L threads

build_preset ci all
run_tests ci
