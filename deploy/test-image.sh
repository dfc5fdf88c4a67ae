#!/usr/bin/env bash
# Builds the image and tries it as container, as pod and under systemd:
# test-image.sh [OPTION OF image.sh...]
#
#   test-image.sh --bootstrap      # from the sources, in a Debian 12 made by mmdebstrap: 15 minutes
#   test-image.sh --built build    # the programs of a build folder: a minute
#
# As root, for podman. It is no part of deploy/test.sh: machines that run that one in a container
# often may start no other in it, and the image compiles everything again.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)

[ "$(id -u)" -eq 0 ] || { echo "test-image.sh: needs root" >&2; exit 2; }
"$here/install-deps.sh" packages-image.txt
"$here/image.sh" --tag remeshd-test "$@"
buildah images --quiet localhost/remeshd-base >/dev/null 2>&1 || "$here/image.sh" --bootstrap-only
for facts in image pod systemd; do
  # Debian's own Python has the packages of the lists.
  /usr/bin/python3 "$here/../tests/deploy/${facts}_test.py" localhost/remeshd-test
done
