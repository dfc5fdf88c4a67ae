#!/usr/bin/env bash
# Installs what is missing, builds, and shows the main job: a daemon on a free port, a first mesh of
# tool1-a, three edits over one stream. Meshes go to the folder given (default: build/demo). Exit 0
# once the daemon has ended, not 0 if anything failed.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
top=$(dirname "$here")
out=${1:-$top/build/demo}

"$here/build.sh" --without-tests release remeshd remesh edit_loop
bin=$top/build/bin
cases=$top/tests/cases

store=$(mktemp -d)
daemon=
finish() {
  local status=$?
  if [ -n "$daemon" ]; then
    kill -TERM "$daemon" 2>/dev/null || true
    wait "$daemon" || { echo "demo.sh: remeshd ended with $?" >&2; status=1; }
  fi
  [ "$status" -eq 0 ] || cat "$store/remeshd.log" >&2 2>/dev/null || true
  rm -rf "$store"
  [ "$status" -ne 0 ] || echo "remeshd has stopped; meshes: $out"
  exit "$status"
}
trap finish EXIT
trap 'exit 130' INT TERM

"$bin/remeshd" --listen 127.0.0.1:0 --store "$store/revisions" >"$store/remeshd.log" 2>&1 &
daemon=$!
address=
for _ in $(seq 100); do
  address=$(sed -n 's/.* serving remesh.v1 on \([^,]*\),.*/\1/p' "$store/remeshd.log")
  [ -z "$address" ] || break
  kill -0 "$daemon"
  sleep 0.1
done
echo "remeshd listens on $address"
"$bin/edit_loop" "$address" "$out" 15000 "$cases/tool1-a.json" "$cases/tool1-ac.edit.json" \
  "$here/demo/pins-5.edit.json" "$here/demo/hub-20.edit.json"
echo
"$bin/remesh" --address "$address" log tool1-a
