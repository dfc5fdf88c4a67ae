#!/usr/bin/env bash
# What a developer runs before a commit, some ten minutes on two cores from a warm build:
#
#   check.sh          # format, rules of the tree, protocol, the report's page, lint of what changed,
#                     # tests with asserts
#   check.sh --all    # lint of everything, all tests, again as released, and under ASan and UBSan
#
# What changed is told against the upstream branch, or the last commit where there is none. Stops at
# the first step that fails.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
cd "$here/.."

all=
case ${1-} in
  --all) all=1 ;;
  "") ;;
  *) echo "usage: check.sh [--all]" >&2 && exit 2 ;;
esac

step() { printf '\n== %s\n' "$1"; }

# Sources that differ from the upstream branch, as a regular expression of their paths.
changed_sources() {
  local base
  base=$(git merge-base HEAD '@{upstream}' 2>/dev/null || git rev-parse --verify -q HEAD~1 || echo HEAD)
  { git diff --name-only --diff-filter=d "$base"; git ls-files --others --exclude-standard; } |
    grep -E '^(engine|proto|server|client|tests)/.*\.cpp$' | sort -u | paste -sd '|' || true
}

lint() { # regular expression of paths
  # What g++ has precompiled, as -Wno-restrict, is its own.
  mkdir -p build-dev/lint
  sed -E 's# -include [^ ]*/cmake_pch\.hxx##; s# -Winvalid-pch##' \
    build-dev/compile_commands.json >build-dev/lint/compile_commands.json
  run-clang-tidy-16 -quiet -p build-dev/lint -j "$(nproc)" -extra-arg=-Wno-unknown-warning-option \
    "^$PWD/($1)" \
    > >(grep -vE '^(clang-tidy-16 |$)') 2> >(grep -vE '^[0-9]+ warnings? generated' >&2)
}

"$here/install-deps.sh" packages-test.txt packages-check.txt

step "format"
find engine proto server client tests \( -name '*.cpp' -o -name '*.h' -o -name '*.proto' \) -print0 |
  xargs -0 -n 32 -P "$(nproc)" clang-format --dry-run -Werror

step "protocol"
"$here/check-protocol.sh"

step "report page"
"$here/report-page.sh" --check

step "build"
"$here/build.sh" dev # also generates the sources that lint reads

step "lint"
if [ -n "$all" ]; then
  lint '(engine|proto|server|client|tests)/'
else
  sources=$(changed_sources)
  [ -z "$sources" ] || lint "($sources)\$"
fi

step "tests"
if [ -n "$all" ]; then
  ctest --preset dev --parallel "$(nproc)"
  step "tests as released"
  "$here/test.sh" release
  step "tests under ASan and UBSan"
  "$here/test.sh" asan
else
  ctest --preset dev --parallel "$(nproc)" --label-exclude '^(service|campaign|bench)$'
fi
