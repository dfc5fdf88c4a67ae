# A machine with systemd and remeshd, for systemd_test.py.
ARG BASE
ARG IMAGE
FROM ${IMAGE} AS remeshd

FROM ${BASE}
RUN apt-get -qq update && DEBIAN_FRONTEND=noninteractive \
    apt-get -qq -y install --no-install-recommends systemd dbus libnss-systemd procps
COPY --from=remeshd /usr/bin/ /usr/bin/
COPY --from=remeshd /usr/libexec/ /usr/libexec/
COPY --from=remeshd /usr/lib/ /usr/lib/
COPY deploy/remeshd.service /etc/systemd/system/
CMD ["/lib/systemd/systemd"]
