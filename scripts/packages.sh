# shellcheck shell=bash disable=SC2034
# What ZScope needs from Debian 12, and how the other scripts get it. Sourced, not run.

packages_to_build=(
    g++ cmake ninja-build pkg-config
    libglm-dev nlohmann-json3-dev libfmt-dev zlib1g-dev libpng-dev libhwy-dev libmeshoptimizer-dev libtinyobjloader-dev libcli11-dev
    libfreetype-dev libfontconfig-dev fonts-dejavu-core  # the letters of comparison sheets
    libcairo2-dev  # comparison sheets as PDF
)
packages_for_the_window=(
    qt6-base-dev qt6-svg-dev
    qt6-tools-dev qt6-l10n-tools qt6-translations-l10n  # the window in Chinese, Qt's own words too
    libqcustomplot-dev  # charts
    fonts-wqy-microhei
)
packages_to_compare=(libembree-dev libosmesa6-dev)  # other renderers, for `bench --peers`
packages_to_test=(
    libgtest-dev libgmp-dev xvfb xauth parallel poppler-utils
    libxml2-utils python3-jsonschema  # reports for courses against their schemas
    bubblewrap  # runs untrusted programs, for `grade`
    clang libomp-dev libclang-rt-14-dev llvm clang-format
)

# require_packages NAME...: installs those that are missing, and asks nobody anything. Does nothing, and needs no
# rights, where all are there.
require_packages() {
    local missing=() name
    for name in "$@"; do
        [[ "$(dpkg-query -W -f='${Status}' "$name" 2>/dev/null)" == "install ok installed" ]] || missing+=("$name")
    done
    ((${#missing[@]} == 0)) && return 0

    local as_root=()
    if ((EUID != 0)); then
        command -v sudo >/dev/null || {
            echo "These packages are missing, and installing them needs root or sudo: ${missing[*]}" >&2
            return 1
        }
        as_root=(sudo)
    fi
    echo "Installing ${#missing[@]} packages: ${missing[*]}"
    local log
    log="$(mktemp)"
    if ! { "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -qq update &&
           "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -qq -y --no-install-recommends \
               -o Dpkg::Use-Pty=0 install "${missing[@]}"; } >"$log" 2>&1; then
        tail -n 20 "$log" >&2
        rm -f "$log"
        return 1
    fi
    rm -f "$log"
}

# build_preset PRESET TARGET...: configures and builds, and shows the log only if that fails. From an empty cache each time: CMake empties
# it by itself where the compiler is found elsewhere than before, and forgets what the preset said, sanitizers included.
build_preset() {
    local preset="$1" log started=$SECONDS
    shift
    log="$(mktemp)"
    echo "Building preset '$preset'"
    if ! { cmake --fresh --preset "$preset" && cmake --build --preset "$preset" --target "$@"; } >"$log" 2>&1; then
        grep -E 'error|FAILED' "$log" | head -n 20 >&2 || true
        tail -n 20 "$log" >&2
        rm -f "$log"
        return 1
    fi
    rm -f "$log"
    echo "Built in $((SECONDS - started)) s"
}

# run_tests PRESET [CTEST OPTION...]: what the preset's build holds, or a part of it. No test at all is an error.
run_tests() {
    local preset="$1"
    shift
    ctest --preset "$preset" --parallel "$(nproc)" "$@"
}
