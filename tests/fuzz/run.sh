#!/usr/bin/env bash
# Builds the fuzzers and runs each for SECONDS of processor time, one after the other:
#
#   run.sh [SECONDS [TARGET...]]     # 600 and all targets, unless told otherwise
#   run.sh --minimise [TARGET...]    # takes what the runs found into the corpus, 200 files a target at most
#
# Prints a row a target: executions, edges covered, files that cover them, findings. A run stops at
# its first finding and leaves the input in build-fuzz/findings/TARGET, its report beside it.
# `build-fuzz/bin/fuzz_TARGET FILE` runs one input again.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."

minimise=
if [ "${1-}" = --minimise ]; then
  minimise=1
  shift
  seconds=0
else
  seconds=${1:-600}
  shift || true
fi
targets=("$@")
[ ${#targets[@]} -gt 0 ] ||
  targets=(model_json edit requests store_record array_codec revision_image journal config
           mesh_stream mesh_file)

deploy/install-deps.sh packages-test.txt packages-fuzz.txt
[ -f build-fuzz/build.ninja ] || cmake --preset fuzz >/dev/null
cmake --build --preset fuzz --parallel "$(nproc)" >build-fuzz/build.log ||
  { tail -n 40 build-fuzz/build.log >&2; exit 1; }

export ASAN_OPTIONS=allocator_may_return_null=1:handle_abort=1
export UBSAN_OPTIONS=print_stacktrace=1
export ASAN_SYMBOLIZER_PATH=${ASAN_SYMBOLIZER_PATH:-$(command -v llvm-symbolizer-16)}
corpus=tests/fuzz/corpus
# libFuzzer looks for leaks after each of the first thousand inputs that keep something, a tenth of
# a second each; the tests look for them in the corpus, under the preset asan.
# Times are the clock's: an edit takes 10 s of processor time here, and others use the machine too.
limits=(-max_len=4096 -timeout=120 -rss_limit_mb=2048 -malloc_limit_mb=1024
        -report_slow_units=120 -detect_leaks=0)

take_in() {  # TARGET
  local target=$1 merged=build-fuzz/merged/$1
  rm -rf "$merged"
  mkdir -p "$merged" "build-fuzz/corpus/$target"
  "build-fuzz/bin/fuzz_$target" "${limits[@]}" -merge=1 "$merged" "$corpus/$target" \
    "build-fuzz/corpus/$target" >"build-fuzz/merged/$target.log" 2>&1
  # Those that a person named stay; of the others, whose names are digests, any 200.
  find "$corpus/$target" -type f -regextype egrep -regex '.*/[0-9a-f]{40}' -delete
  find "$merged" -type f -size -8 | sort | awk 'NR <= 200' |
    xargs -r cp -t "$corpus/$target"
}

if [ -n "$minimise" ]; then
  for target in "${targets[@]}"; do take_in "$target"; done
  du -sh --apparent-size "$corpus"
  exit 0
fi

# libFuzzer counts seconds of the wall: a run goes on until its processor time is used up.
cpu_seconds() { awk '{print int(($14 + $15) / 100)}' "/proc/$1/stat" 2>/dev/null || echo 0; }
figure() { grep -oE "$1: *[0-9]+" "$2" | tail -n 1 | grep -oE '[0-9]+$' || echo 0; }

printf '%-16s %8s %12s %8s %8s %9s\n' target seconds executions edges files findings
failed=0
for target in "${targets[@]}"; do
  mkdir -p "build-fuzz/corpus/$target" "build-fuzz/findings/$target" "$corpus/$target"
  log=build-fuzz/findings/$target.log
  words=() dictionary=tests/fuzz/dictionaries/$target.txt
  [ ! -f "$dictionary" ] || words=(-dict="$dictionary")
  nice -n 1 "build-fuzz/bin/fuzz_$target" "${limits[@]}" -print_final_stats=1 \
    -artifact_prefix="build-fuzz/findings/$target/" "${words[@]}" \
    "build-fuzz/corpus/$target" "$corpus/$target" >"$log" 2>&1 &
  fuzzer=$!
  used=0
  while kill -0 "$fuzzer" 2>/dev/null && [ "$used" -lt "$seconds" ]; do
    sleep 1
    now=$(cpu_seconds "$fuzzer")
    used=$((now > used ? now : used))
  done
  kill -INT "$fuzzer" 2>/dev/null || true
  wait "$fuzzer" || true
  findings=$(find "build-fuzz/findings/$target" -type f | wc -l)
  failed=$((failed + findings))
  printf '%-16s %8d %12d %8d %8d %9d\n' "$target" "$used" \
    "$(grep -oE '^#[0-9]+' "$log" | tail -n 1 | tr -d '#')" \
    "$(figure cov "$log")" "$(find "build-fuzz/corpus/$target" -type f | wc -l)" "$findings"
done
[ "$failed" -eq 0 ]
