#!/bin/sh
# Of the variables of the usual image of PostgreSQL those that compose.yaml sets: POSTGRES_USER,
# POSTGRES_DB, POSTGRES_PASSWORD_FILE, POSTGRES_INITDB_ARGS. As the user postgres; arguments are the
# server's.
set -eu
if [ ! -s "$PGDATA/PG_VERSION" ]; then
  # shellcheck disable=SC2086  # several arguments
  initdb --username "$POSTGRES_USER" --pwfile "$POSTGRES_PASSWORD_FILE" --encoding UTF8 \
    --locale C.UTF-8 ${POSTGRES_INITDB_ARGS:-}
  echo "host all all all scram-sha-256" >>"$PGDATA/pg_hba.conf"
  echo "CREATE DATABASE \"$POSTGRES_DB\"" | postgres --single -j postgres
fi
exec postgres -c listen_addresses='*' "$@"
