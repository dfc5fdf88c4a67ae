#!/usr/bin/env bash
# Checks the protocol with buf: its style (lint), and that nothing of the committed image of it,
# proto/remesh.v1.binpb, is broken (breaking). proto/README.md tells more.
#
# buf comes from npm at the version and checksums of deploy/buf/package-lock.json, into build/buf.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
cd "$here/.."

# By the command and not by the package: npm may come from elsewhere.
if ! command -v npm >/dev/null; then
  "$here/install-deps.sh" packages-check.txt || true
  if ! command -v npm >/dev/null; then
    echo "check-protocol.sh: npm is missing, so there is no buf and the protocol is not checked;" \
      "install the packages of deploy/packages-check.txt" >&2
    exit 1
  fi
fi

mkdir -p build/buf
buf=build/buf/node_modules/.bin/buf
if ! cmp -s deploy/buf/package-lock.json build/buf/installed.json || [ ! -x "$buf" ]; then
  cp deploy/buf/package.json deploy/buf/package-lock.json build/buf
  # Not `npm ci`: it wants the programs of all platforms in the lock file, Debian's are enough.
  npm install --prefix build/buf --ignore-scripts --no-audit --no-fund --loglevel=error &&
    "$buf" --version >/dev/null || {
    echo "check-protocol.sh: npm could not install buf, so the protocol is not checked" >&2
    exit 1
  }
  cp deploy/buf/package-lock.json build/buf/installed.json
fi

"$buf" lint proto
"$buf" breaking proto --against proto/remesh.v1.binpb
