#!/usr/bin/env bash
# Makes a private authority, a certificate of a server and one of a client:
# make-certificates.sh FOLDER NAME...
#
# The server's holds for the names and IPv4 addresses given. In FOLDER: ca.crt, tls.crt and tls.key
# of the server, client.crt and client.key, and ca.key, which signs more of them and belongs neither
# to a server nor to a client. They hold for a year. What is there already is kept: calling it again
# with the same authority renews what was deleted.
set -euo pipefail
[ $# -ge 2 ] || { sed -n '2,10s/^# \?//p' "$0" >&2; exit 2; }
folder=$1
shift
umask 077
mkdir -p "$folder"
cd "$folder"

names=
for name in "$@"; do
  if [[ $name =~ ^[0-9.]+$ ]]; then names+=,IP:$name; else names+=,DNS:$name; fi
done

key() { openssl genpkey -quiet -algorithm EC -pkeyopt ec_paramgen_curve:P-256 -out "$1" 2>/dev/null; }

if [ ! -e ca.crt ]; then
  key ca.key
  openssl req -x509 -new -key ca.key -days 366 -subj "/CN=remeshd authority" \
    -addext basicConstraints=critical,CA:TRUE -addext keyUsage=critical,keyCertSign,cRLSign -out ca.crt
fi

# signed NAME SUBJECT USAGE [ALTERNATIVE-NAMES]
signed() {
  [ ! -e "$1.crt" ] || return 0
  key "$1.key"
  openssl req -new -key "$1.key" -subj "/CN=$2" -out "$1.csr"
  openssl x509 -req -in "$1.csr" -CA ca.crt -CAkey ca.key -CAcreateserial -days 365 -out "$1.crt" \
    -extfile <(printf 'basicConstraints=CA:FALSE\nextendedKeyUsage=%s\n%s\n' "$3" "${4-}") 2>/dev/null
  rm "$1.csr"
}
signed tls "$1" serverAuth "subjectAltName=${names#,}"
signed client "remeshd client" clientAuth
chmod 644 ./*.crt
