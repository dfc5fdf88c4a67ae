# The study that compose.yaml runs: study.py with the Python client of this tree.
ARG BASE=docker.io/library/debian:bookworm-slim

FROM ${BASE} AS client
RUN apt-get -qq update && apt-get -qq install -y --no-install-recommends \
      python3 protobuf-compiler protobuf-compiler-grpc libprotobuf-dev
COPY proto /src/proto
COPY client/python /src/python
RUN python3 /src/python/generate.py --proto /src/proto --out /src/python/remesh_client/v1

FROM ${BASE}
RUN apt-get -qq update && apt-get -qq install -y --no-install-recommends \
      python3-numpy python3-scipy python3-grpcio python3-protobuf python3-crc32c \
    && rm -rf /var/lib/apt/lists/*
COPY --from=client /src/python/remesh_client /usr/lib/python3/dist-packages/remesh_client
COPY deploy/cluster/study.py tests/cases/tool1-a.json /usr/share/remeshd/
USER 65532:65532
ENTRYPOINT ["/usr/bin/python3", "/usr/share/remeshd/study.py"]
