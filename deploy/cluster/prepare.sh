#!/bin/sh
# Secrets and folders of the farm of compose.yaml, made where they are missing, as root:
#
#   prepare.sh REPLICAS POSTGRES TIER STUDY
#
# REPLICAS gets farm.key, with which objects of the tier are sealed, and pgpass, the password for
# PostgreSQL as its library reads it; POSTGRES the same password for the server. TIER and STUDY become
# the folders of who writes to them. Owners: 65532 (remeshd's image; nginx and the study here), and
# postgres.
set -eu
replicas=$1 postgres=$2 tier=$3 study=$4
umask 077

word() { od -An -N32 -tx1 /dev/urandom | tr -d ' \n'; }

[ -s "$replicas/farm.key" ] || word >"$replicas/farm.key"
[ -s "$postgres/password" ] || word >"$postgres/password"
printf 'postgres:5432:remeshd:remeshd:%s\n' "$(cat "$postgres/password")" >"$replicas/pgpass"
mkdir -p "$tier/objects" "$tier/temp"

chown -R 65532:65532 "$replicas" "$tier" "$study"
chown -R postgres "$postgres"
chmod 700 "$replicas" "$postgres"
chmod 755 "$study"
