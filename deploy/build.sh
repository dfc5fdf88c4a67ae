#!/usr/bin/env bash
# Installs what is missing, then configures and builds a preset: build.sh [PRESET [NINJA-TARGET...]]
# (presets: CMakePresets.json; default `release`, whose binaries come out at build/bin).
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
cd "$here/.."

preset=${1:-release}
"$here/install-deps.sh"
cmake --preset "$preset" >/dev/null
cmake --build --preset "$preset" --parallel "$(nproc)" ${2:+--target "${@:2}"}
