#!/usr/bin/env bash
# Gathers the files of the image from a build folder: image-root.sh BUILD OUT
#
# OUT/image gets what root owns: remeshd, remesh and the TetGen helper, the shared libraries that
# they load and no others, certificates of public authorities, users, licences, and of each Debian
# package that a file came from its entry (so that scanners know what is in the image) and its
# copyright. OUT/state gets the folders that the daemon writes to. No shell, no other program.
#
# Runs where the programs were built: the libraries are that machine's.
set -euo pipefail
build=$1
out=$2
image=$out/image
cd "$(dirname "${BASH_SOURCE[0]}")/.."

fail() { echo "image-root.sh: $*" >&2; exit 1; }

umask 022
mkdir -p "$image" "$out"/state/{lib,run}
# Without a component: the programs. The client library's headers have one of their own.
cmake --install "$build" --component Unspecified --strip --prefix "$image/usr" >/dev/null
programs=("$image"/usr/bin/* "$image"/usr/libexec/remeshd/*)

# `NAME => PATH (ADDRESS)`, or `PATH (ADDRESS)`: the loader.
loaded=$(ldd "${programs[@]}")
! grep 'not found' <<<"$loaded" >&2 || fail "these libraries are missing"
mapfile -t libraries < <(sed -nE 's/^\t(.* => )?(\/.*) \(0x.*\)$/\2/p' <<<"$loaded" | sort -u)
[ "${#libraries[@]}" -gt 0 ] || fail "the programs load no library"
for library in "${libraries[@]}"; do
  case $library in
    */ld-linux*) target=$library ;; # the loader: its path is written into the programs
    /lib/*) target=/usr$library ;;
    /usr/lib/*) target=$library ;;
    *) fail "$library is no library of Debian's" ;;
  esac
  # By the name that the loader asks for, with the content that its symbolic link leads to.
  install -D -m 755 "$(readlink -f "$library")" "$image$target"
done

mkdir -p "$image"/{etc/ssl/certs,var/lib/dpkg/status.d,run,tmp,usr/share/doc/remeshd}
chmod 1777 "$image/tmp"
install -m 700 -d "$out/state/lib/remeshd" "$out/state/run/remeshd"
printf 'root:x:0:0:root:/:/none\nremeshd:x:65532:65532:remeshd:/var/lib/remeshd:/none\n' \
  >"$image/etc/passwd"
printf 'root:x:0:\nremeshd:x:65532:\n' >"$image/etc/group"
printf 'hosts: files dns\n' >"$image/etc/nsswitch.conf"
cp /etc/os-release "$image/etc/os-release"
cp /etc/ssl/certs/ca-certificates.crt "$image/etc/ssl/certs/"
cp LICENSE LICENSES/Apache-2.0.txt deploy/LICENSING.md "$image/usr/share/doc/remeshd/"

# dpkg knows some libraries under /usr/lib and others under /lib, which are one folder.
mapfile -t files < <(readlink -f "${libraries[@]}")
{ dpkg -S "${libraries[@]}" "${files[@]}" "${files[@]#/usr}" 2>/dev/null || true; } |
  sed 's/[:,].*//' | sort -u >"$out/packages"
[ -s "$out/packages" ] || fail "no package owns the libraries"
while read -r package; do
  dpkg-query -s "$package" >"$image/var/lib/dpkg/status.d/$package"
  install -D -m 644 "/usr/share/doc/$package/copyright" "$image/usr/share/doc/$package/copyright"
done < <(cat "$out/packages"; echo ca-certificates)
rm "$out/packages"
