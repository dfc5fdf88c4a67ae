#!/usr/bin/env bash
# Submits a study to Slurm: submit.sh FOLDER [OPTION OF SBATCH...]. FOLDER, on the shared file system,
# has study.json (study.py tells what is in it). Options are those of the base's job and of the tasks:
# --cpus-per-task=8 --time=1:00:00. Prints the ids of the three jobs. Called again, it has made what is
# missing.
set -euo pipefail
[ $# -ge 1 ] || { sed -n '2,5s/^# //p' "$0" >&2; exit 2; }
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
folder=$(cd "$1" && pwd)
shift
count='import json, sys; print(int(json.load(open(sys.argv[1])).get("tasks", 20)))'
tasks=$("${REMESH_PYTHON:-python3}" -c "$count" "$folder/study.json")

# The tier, unless another one is named: a folder that all nodes reach.
if [ -z "${REMESHD_TIER:-}" ]; then
  export REMESHD_TIER=$folder/tier REMESHD_TIER_KEY_FILE=$folder/key
  (umask 077; mkdir -p "$REMESHD_TIER"
   [ -s "$folder/key" ] || od -An -N24 -tx1 /dev/urandom | tr -d ' \n' > "$folder/key")
fi
export REMESHD_TIER_ACK=${REMESHD_TIER_ACK:-tier}

mkdir -p "$folder/logs"
name=$(basename "$folder")
submit() { sbatch --parsable --export=ALL "$@" | cut -d';' -f1; }
base=$(submit --job-name="$name-base" --output="$folder/logs/base.out" "$@" \
  "$here/study.sbatch" "$here" base "$folder")
array=$(submit --job-name="$name" --output="$folder/logs/%a.out" --array="0-$((tasks - 1))" \
  --dependency="afterok:$base" --kill-on-invalid-dep=yes "$@" "$here/study.sbatch" "$here" run "$folder")
# Whatever became of the tasks: it tells which designs are missing.
gather=$(submit --job-name="$name-gather" --output="$folder/logs/gather.out" \
  --dependency="afterany:$array" --kill-on-invalid-dep=yes "$here/study.sbatch" "$here" gather "$folder")
echo "$base $array $gather"
