#!/usr/bin/env bash
# Builds the image and tries it as container, as pod and under systemd, and in farms:
# test-image.sh [--farm] [OPTION OF image.sh...]
#
#   test-image.sh --bootstrap          # from the sources, in a Debian 12 made by mmdebstrap: 15 minutes
#   test-image.sh --built build        # the programs of a build folder: a minute
#   test-image.sh --farm --built build # and farms of pods and of compose, with images of Debian's
#                                      # packages: ten minutes
#
# As root, for podman. It is no part of deploy/test.sh: machines that run that one in a container
# often may start no other in it, and the image compiles everything again.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)

[ "$(id -u)" -eq 0 ] || { echo "test-image.sh: needs root" >&2; exit 2; }
tried=(image pod systemd)
if [ "${1-}" = --farm ]; then
  tried+=(farm_pod farm_compose)
  shift
fi
"$here/install-deps.sh" packages-image.txt
"$here/image.sh" --tag remeshd-test "$@"
buildah images --quiet localhost/remeshd-base >/dev/null 2>&1 || "$here/image.sh" --bootstrap-only

# What a farm takes beside, of Debian's packages, for no registry is needed here.
cluster() {
  buildah bud --isolation chroot --format docker --build-arg BASE=localhost/remeshd-base "$@"
}
if [ "${#tried[@]}" -gt 3 ]; then
  for each in nginx postgres; do
    cluster --target "$each" -t "remeshd-test-$each" -f "$here/cluster/debian.Dockerfile" \
      "$here/cluster"
  done
  cluster -t remeshd-test-study -f "$here/cluster/study.Dockerfile" "$here/.."
fi

for facts in "${tried[@]}"; do
  # Debian's own Python has the packages of the lists.
  /usr/bin/python3 "$here/../tests/deploy/${facts}_test.py" localhost/remeshd-test
done
