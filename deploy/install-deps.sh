#!/usr/bin/env bash
# Installs the Debian packages of packages.txt that are missing, as root or through sudo, and those
# of other lists beside it: install-deps.sh [LIST...]. Does nothing, and needs neither network nor
# rights, when all are there.
#
# A list names one package a line, in one of three ways:
#   PACKAGE            is installed
#   PACKAGE/COMMAND    is installed unless COMMAND is found, which may come from elsewhere
#   =PACKAGE/COMMAND   is unpacked into build/tools for COMMAND alone, unless that is found:
#                      installing it would start a service, or replace another's file
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")"

tools=$PWD/../build/tools
found() {
  command -v "$1" >/dev/null ||
    [ -n "$(ls -d {,"$tools"}/usr/{bin,lib/postgresql/*/bin}/"$1" 2>/dev/null)" ]
}
installed() { dpkg-query -W -f '${db:Status-Status} ${Package}\n' | sed -n 's/^installed //p' | sort; }

mapfile -t entries < <(sed -e 's/#.*//' -e 's/[[:space:]]//g' -e '/^$/d' packages.txt "$@" | sort -u)
packages=() unpacked=()
for entry in "${entries[@]}"; do
  case $entry in
    =*/*) found "${entry#*/}" || { entry=${entry#=}; unpacked+=("${entry%/*}"); } ;;
    */*) found "${entry#*/}" || packages+=("${entry%/*}") ;;
    *) packages+=("$entry") ;;
  esac
done
mapfile -t missing < <(comm -23 <(printf '%s\n' "${packages[@]}" | sort -u) <(installed))
[ $((${#missing[@]} + ${#unpacked[@]})) -eq 0 ] && exit 0

as_root=()
if [ "$(id -u)" -ne 0 ]; then
  command -v sudo >/dev/null || { echo "install-deps.sh: needs root or sudo" >&2; exit 1; }
  as_root=(sudo)
fi
apt=("${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -qq -y
     -o DPkg::Lock::Timeout=300 -o Acquire::Retries=3)

# Lists may be absent or stale; where they cannot be fetched, what is there may still do.
"${apt[@]}" update || echo "install-deps.sh: package lists could not be refreshed" >&2
if [ "${#missing[@]}" -gt 0 ]; then
  echo "Installing ${#missing[@]} packages: ${missing[*]}"
  "${apt[@]}" install --no-install-recommends "${missing[@]}" </dev/null
fi
if [ "${#unpacked[@]}" -gt 0 ]; then
  echo "Unpacking into build/tools: ${unpacked[*]}"
  mkdir -p "$tools"
  for package in "${unpacked[@]}"; do
    archive=$(mktemp -d)
    (cd "$archive" && apt-get -qq -o APT::Sandbox::User=root download "$package")
    dpkg -x "$archive"/*.deb "$tools"
    rm -r "$archive"
  done
fi
