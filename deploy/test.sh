#!/usr/bin/env bash
# Installs what is missing, builds and runs every test: test.sh [PRESET] (default `release`).
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
cd "$here/.."

preset=${1:-release}
"$here/build.sh" "$preset"
ctest --preset "$preset" --parallel "$(nproc)"
