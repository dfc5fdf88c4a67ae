#!/usr/bin/env bash
# Installs what is missing, builds, and shows the main job: a daemon on a free port, a first mesh of
# tool1-a, three edits over one stream. Meshes go to the folder given (default: build/demo). Exit 0
# once the daemon has ended, not 0 if anything failed.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
top=$(dirname "$here")
out=${1:-$top/build/demo}

"$here/build.sh" release remeshd remesh edit_loop
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

start_daemon() { # on the first of some ports that is free
  local port try
  for try in 1 2 3 4 5 6 7 8; do
    port=$((20000 + (RANDOM % 20000)))
    address=127.0.0.1:$port
    "$bin/remeshd" --listen "$address" --store "$store/revisions" >"$store/remeshd.log" 2>&1 &
    daemon=$!
    for _ in $(seq 50); do
      kill -0 "$daemon" 2>/dev/null || break
      "$bin/remesh" --address "$address" revisions >/dev/null 2>&1 && return 0
      sleep 0.1
    done
    kill "$daemon" 2>/dev/null || true
    wait "$daemon" 2>/dev/null || true
    daemon=
  done
  echo "demo.sh: remeshd does not start (try $try)" >&2
  return 1
}

start_daemon
echo "remeshd listens on $address"
"$bin/edit_loop" "$address" "$out" 15000 "$cases/tool1-a.json" "$cases/tool1-ac.edit.json" \
  "$here/demo/pins-5.edit.json" "$here/demo/hub-20.edit.json"
echo
"$bin/remesh" --address "$address" log tool1-a
