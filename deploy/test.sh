#!/usr/bin/env bash
# Installs what is missing, builds and runs every test: test.sh [PRESET] (default `ci`: optimised,
# asserts on, warnings are errors, several sources compiled as one).
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
cd "$here/.."

preset=${1:-ci}
"$here/build.sh" "$preset"
ctest --preset "$preset" --parallel "$(nproc)"
