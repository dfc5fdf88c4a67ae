# nginx and PostgreSQL of Debian's packages, for compose.yaml where no registry is reached:
#
#   deploy/image.sh --bootstrap-only
#   for each in nginx postgres; do
#     buildah bud --isolation chroot --format docker --build-arg BASE=localhost/remeshd-base \
#       --target $each -t localhost/farm-$each -f deploy/cluster/debian.Dockerfile deploy/cluster
#   done
ARG BASE=docker.io/library/debian:bookworm-slim

FROM ${BASE} AS nginx
RUN apt-get -qq update && apt-get -qq install -y --no-install-recommends nginx curl \
    && rm -rf /var/lib/apt/lists/*

FROM ${BASE} AS postgres
RUN apt-get -qq update && apt-get -qq install -y --no-install-recommends postgresql-15 \
    && rm -rf /var/lib/apt/lists/*
COPY postgres-entrypoint.sh /usr/local/bin/
ENV PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin:/usr/lib/postgresql/15/bin \
    PGDATA=/var/lib/postgresql/data
RUN install -d -o postgres -g postgres -m 1777 /var/lib/postgresql/data /var/run/postgresql
VOLUME ["/var/lib/postgresql/data"]
ENTRYPOINT ["/usr/local/bin/postgres-entrypoint.sh"]
