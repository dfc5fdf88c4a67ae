#!/usr/bin/env bash
# Installs the Debian packages of packages.txt that are missing, as root or through sudo, and those
# of other lists beside it: install-deps.sh [LIST...]. Does nothing, and needs neither network nor
# rights, when all are there.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")"

mapfile -t packages < <(sed -e 's/#.*//' -e 's/[[:space:]]//g' -e '/^$/d' packages.txt "$@")
mapfile -t missing < <(comm -23 <(printf '%s\n' "${packages[@]}" | sort) \
  <(dpkg-query -W -f '${db:Status-Status} ${Package}\n' | sed -n 's/^installed //p' | sort))
[ "${#missing[@]}" -eq 0 ] && exit 0

as_root=()
if [ "$(id -u)" -ne 0 ]; then
  command -v sudo >/dev/null || { echo "install-deps.sh: needs root or sudo" >&2; exit 1; }
  as_root=(sudo)
fi
apt=("${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -qq -y
     -o DPkg::Lock::Timeout=300 -o Acquire::Retries=3)

echo "Installing ${#missing[@]} packages: ${missing[*]}"
# Lists may be absent or stale; where they cannot be fetched, what is there may still do.
"${apt[@]}" update || echo "install-deps.sh: package lists could not be refreshed" >&2
"${apt[@]}" install --no-install-recommends "${missing[@]}" </dev/null
