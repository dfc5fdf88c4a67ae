#!/usr/bin/env bash
# What a developer runs before committing: format, protocol, lint, tests, and the tests again under
# AddressSanitizer and UBSan. Stops at the first that fails.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
cd "$here/.."

step() { printf '\n== %s\n' "$1"; }

"$here/install-deps.sh" packages-test.txt packages-check.txt

step "format"
find engine proto server client tests \( -name '*.cpp' -o -name '*.h' -o -name '*.proto' \) -print0 |
  xargs -0 -n 32 -P "$(nproc)" clang-format --dry-run -Werror

step "protocol"
"$here/check-protocol.sh"

step "build"
"$here/build.sh" release # also generates the sources that lint reads

step "lint"
run-clang-tidy-16 -quiet -p build -j "$(nproc)" "^$PWD/(engine|proto|server|client|tests)/" \
  > >(grep -vE '^(clang-tidy-16 |$)') 2> >(grep -vE '^[0-9]+ warnings? generated' >&2)

step "tests"
ctest --preset release --parallel "$(nproc)"

step "tests under ASan and UBSan"
"$here/test.sh" asan
