#!/usr/bin/env bash
# Makes client/report/bundle, what `remesh report` puts into its pages, from client/report/src and the
# libraries at the versions and checksums of client/report/package-lock.json:
#
#   report-page.sh            # writes the bundle, which is committed
#   report-page.sh --check    # says whether the committed bundle is what the sources give
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
cd "$here/.."

check=
case ${1-} in
  --check) check=1 ;;
  "") ;;
  *) echo "usage: report-page.sh [--check]" >&2 && exit 2 ;;
esac

if ! command -v npm >/dev/null; then
  "$here/install-deps.sh" packages-check.txt || true
  if ! command -v npm >/dev/null; then
    echo "report-page.sh: npm is missing, so the report's page cannot be built;" \
      "install the packages of deploy/packages-check.txt" >&2
    exit 1
  fi
fi

# Libraries and a copy of the sources, so that nothing is written beside them.
work=build/report
mkdir -p "$work"
if ! cmp -s client/report/package-lock.json "$work/installed.json" ||
  [ ! -x "$work/node_modules/.bin/esbuild" ]; then
  cp client/report/package.json client/report/package-lock.json "$work"
  # Not `npm ci`: it wants esbuild for all platforms in the lock file, Debian's are enough.
  npm install --prefix "$work" --ignore-scripts --no-audit --no-fund --loglevel=error &&
    "$work/node_modules/.bin/esbuild" --version >/dev/null || {
    echo "report-page.sh: npm could not install what the report's page is built from" >&2
    exit 1
  }
  cp client/report/package-lock.json "$work/installed.json"
fi

bundle=client/report/bundle
[ -z "$check" ] || bundle=$work/bundle
# Libraries are looked for in the folder of the work, not above the sources.
NODE_PATH=$work/node_modules "$work/node_modules/.bin/esbuild" client/report/src/main.js --bundle \
  --outfile="$bundle/report.js" --format=iife --target=es2022 --minify --legal-comments=none \
  --loader:.txt=text --log-level=warning \
  --banner:js='// SPDX-License-Identifier: Apache-2.0 AND MIT' \
  --banner:css='/* SPDX-License-Identifier: Apache-2.0 AND MIT */'

[ -n "$check" ] || exit 0
for file in report.js report.css; do
  cmp "$bundle/$file" "client/report/bundle/$file" || {
    echo "report-page.sh: client/report/bundle/$file is not what its sources give;" \
      "run deploy/report-page.sh and commit it" >&2
    exit 1
  }
done
