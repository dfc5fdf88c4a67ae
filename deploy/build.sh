#!/usr/bin/env bash
# Installs what is missing, then configures and builds a preset:
# build.sh [--without-tests] [PRESET [NINJA-TARGET...]]
# (presets: CMakePresets.json; default `release`, whose binaries come out at build/bin).
#
# With --without-tests the packages that only tests need are not installed, and a new build folder
# has no tests; one that has them keeps them.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
cd "$here/.."

tests=ON
if [ "${1-}" = --without-tests ]; then
  shift
  tests=OFF
fi
preset=${1:-release}
build=build
[ "$preset" = release ] || build=build-$preset
grep -qs '^BUILD_TESTING:BOOL=ON' "$build/CMakeCache.txt" && tests=ON

lists=()
[ "$tests" = OFF ] || lists+=(packages-test.txt)
"$here/install-deps.sh" "${lists[@]}"
cmake --preset "$preset" -DBUILD_TESTING="$tests" >/dev/null
cmake --build --preset "$preset" --parallel "$(nproc)" ${2:+--target "${@:2}"}
