#!/usr/bin/env bash
# A job of a CI farm: ci-job.sh CONTAINER ARTEFACTS MODEL.json [EDIT.json...]
#
# Has the daemon in CONTAINER mesh the model and apply the edits, each to the mesh of the one before,
# with the command line of the same image in a container of its own. ARTEFACTS gets a mesh (.vtu) and
# a report (.json) per step, named after the documents, and revisions.txt. The exit code is that of
# the step that failed (client/README.md, "The command line"), so that 6 (busy) can be tried
# again.
#
# CONTAINER_TOOL: podman (default; as root, for users are not mapped) or docker.
# REMESH_OPTIONS: more options for every step, as "--nodes 20000 --fail-on FALLBACK".
set -euo pipefail
[ $# -ge 3 ] || { sed -n '2,11s/^# \?//p' "$0" >&2; exit 2; }
container=$1 artefacts=$(mkdir -p "$2" && cd "$2" && pwd) tool=${CONTAINER_TOOL:-podman}
shift 2
read -ra options <<<"${REMESH_OPTIONS-}"
image=$("$tool" inspect --format '{{.Config.Image}}' "$container")

# remesh FOLDER-OF-DOCUMENTS ARGUMENTS: as whoever runs the job, so that the artefacts are theirs.
remesh() {
  local documents=$1
  shift
  "$tool" run --rm --no-healthcheck --network "container:$container" --user "$(id -u):$(id -g)" \
    --read-only --cap-drop all --security-opt no-new-privileges \
    --volume "$documents:/documents:ro" --volume "$artefacts:/artefacts" \
    --entrypoint /usr/bin/remesh "$image" "$@"
}

revision=
: >"$artefacts/revisions.txt"
for document in "$@"; do
  folder=$(cd "$(dirname "$document")" && pwd)
  file=/documents/$(basename "$document")
  name=$(basename "$document" .json)
  if [ -z "$revision" ]; then step=(mesh "$file"); else step=(edit "$revision" "$file"); fi
  remesh "$folder" "${step[@]}" "${options[@]}" -o "/artefacts/$name.vtu" \
    --json "/artefacts/$name.json"
  # By its id, and not as the design's head, which another job may move.
  revision=$(sed -n 's/^  "revision": "\([0-9a-f]*\)",$/\1/p' "$artefacts/$name.json")
  printf '%s %s\n' "$revision" "$name" >>"$artefacts/revisions.txt"
done
