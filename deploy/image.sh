#!/usr/bin/env bash
# Builds the image of remeshd with buildah, or docker where there is no buildah:
#
#   image.sh [--tag NAME] [--base IMAGE] [--bootstrap] [--built BUILD]
#   image.sh --bootstrap-only
#
#   --tag NAME       name of the image (default: remeshd, tagged with the version and `latest`)
#   --base IMAGE     Debian 12 image to compile in (default: that of deploy/Dockerfile)
#   --bootstrap      make that image with mmdebstrap from Debian's packages, without any registry;
#                    taken anyway where the registry cannot be reached and mmdebstrap is there
#   --bootstrap-only make that image alone, as remeshd-base
#   --built BUILD    compile nothing: take the programs of a build folder, and the libraries of this
#                    machine, which must be Debian 12
#
# `deploy/install-deps.sh packages-image.txt` installs buildah, podman and mmdebstrap.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
cd "$here/.."

fail() { echo "image.sh: $*" >&2; exit 2; }

version=$(sed -n 's/^project(remeshd VERSION \([0-9.]*\).*/\1/p' CMakeLists.txt)
name=remeshd base='' bootstrap=no built=''
while [ $# -gt 0 ]; do
  case $1 in
    --tag) name=${2:?} && shift 2 ;;
    --base) base=${2:?} && shift 2 ;;
    --bootstrap) bootstrap=yes && shift ;;
    --bootstrap-only) bootstrap=only && shift ;;
    --built) built=${2:?} && shift 2 ;;
    *) fail "unknown: $1 (the head of deploy/image.sh tells what there is)" ;;
  esac
done

scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

tool=buildah
if ! command -v buildah >/dev/null; then
  command -v docker >/dev/null || fail "neither buildah nor docker is there"
  tool=docker
fi

# The isolation asks for no rights beyond a chroot; docker's format, because OCI's has no health check.
as_image() {
  if [ "$tool" = buildah ]; then
    buildah bud --isolation chroot --format docker "$@"
  else
    docker build "$@"
  fi
}

bootstrap_base() {
  command -v mmdebstrap >/dev/null || fail "mmdebstrap is missing (deploy/packages-image.txt)"
  echo "image.sh: Debian 12 by mmdebstrap, as remeshd-base"
  mmdebstrap --quiet --variant=minbase --include=ca-certificates bookworm "$scratch/base.tar"
  # ADD unpacks it. The lists of packages are fetched again inside.
  printf 'FROM scratch\nADD base.tar /\n' >"$scratch/Dockerfile.base"
  as_image -t remeshd-base -f "$scratch/Dockerfile.base" "$scratch"
  base=localhost/remeshd-base
  [ "$tool" = buildah ] || base=remeshd-base
}

if [ "$bootstrap" = only ]; then
  bootstrap_base
  exit 0
fi

arguments=(--build-arg "VERSION=$version"
           --build-arg "REVISION=$(git rev-parse HEAD 2>/dev/null || echo unknown)"
           --build-arg "CREATED=$(date -u +%Y-%m-%dT%H:%M:%SZ)")
if [ -n "$built" ]; then
  "$here/image-root.sh" "$built" "$scratch/out"
  mkdir "$scratch/built"
  mv "$scratch/out" "$scratch/built/out"
  arguments+=(--build-context "build=$scratch/built") # takes the place of the stage of that name
else
  [ "$bootstrap" = no ] || bootstrap_base
  if [ -z "$base" ] && [ "$tool" = buildah ] && command -v mmdebstrap >/dev/null; then
    default=$(sed -n 's/^ARG BASE=//p' deploy/Dockerfile)
    buildah pull --quiet --policy missing "$default" >/dev/null 2>&1 || bootstrap_base
  fi
  [ -z "$base" ] || arguments+=(--build-arg "BASE=$base")
fi

as_image "${arguments[@]}" -t "$name" -f deploy/Dockerfile .
if [ "$name" = remeshd ]; then "$tool" tag remeshd "remeshd:$version"; fi
