#!/usr/bin/env bash
# Opens the window on a scene: scripts/run.sh [SCENE]. Where there is no display, renders the scene by every algorithm
# to out/ instead and says so. Installs what is missing, and builds what has changed, first.
set -euo pipefail
start_folder="$PWD"
cd "$(dirname "${BASH_SOURCE[0]}")/.."
# shellcheck source=scripts/packages.sh
source scripts/packages.sh

scene="${1:-assets/harbour.json}"
# A path is meant from where the user stands.
if [[ "$scene" != builtin:* && "$scene" != /* && $# -gt 0 ]]; then scene="$start_folder/$scene"; fi

require_packages "${packages_to_build[@]}" "${packages_for_the_window[@]}"
build_preset run all

if [[ -n "${DISPLAY:-}" || -n "${WAYLAND_DISPLAY:-}" ]]; then
    exec build/run/ui/zscope "$scene"
fi

echo "There is no display to open a window on, so every algorithm renders $scene to out/:"
mkdir -p out
build/run/app/zscope-cli list algorithms --json | sed -n 's/^ *"name": "\(.*\)",$/\1/p' | while read -r algorithm; do
    build/run/app/zscope-cli render "$scene" --algorithm "$algorithm" -o "out/$algorithm.png" | sed -n 1p
    echo "    out/$algorithm.png"
done
