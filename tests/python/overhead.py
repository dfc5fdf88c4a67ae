#!/usr/bin/python3
"""What the client adds to the time that a mesh takes on the wire.

    PYTHONPATH=build/client/python tests/python/overhead.py build/bin/remeshd [--nodes 15000]

Each edit is made twice: by `part.edit`, after which `part.mesh()` is timed, and again by gRPC alone
(answered from the daemon's cache), timed from the result to the end of the mesh, nothing decoded.
Told are medians in ms.
"""
import argparse
import statistics
import time
from pathlib import Path

import remesh_client as rc
from remesh_client.v1 import mesh_pb2, revision_pb2, stream_pb2

MODEL = Path(__file__).parent.parent / "cases/tool1-a.json"


def wire_seconds(daemon, base, edited):
    """From the result to the end of the mesh."""
    request = stream_pb2.EditStreamRequest(
        edit=revision_pb2.EditRevisionRequest(base=base.revision, document=edited),
        mesh=mesh_pb2.MeshSelection(delta=True))
    begun = None
    for answer in daemon._stub.EditStream(iter([request])):
        if answer.HasField("result"):
            begun = time.perf_counter()
        if answer.HasField("mesh") and answer.mesh.HasField("end"):
            ended = time.perf_counter()
    return ended - begun


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("remeshd")
    parser.add_argument("--nodes", type=int, default=15000)
    parser.add_argument("--order", type=int, default=1)
    parser.add_argument("--edits", type=int, default=20)
    arguments = parser.parse_args()
    meshes, wires, shares = [], [], []
    with rc.local(arguments.remeshd) as daemon:
        part = daemon.mesh(MODEL, nodes=arguments.nodes, order=arguments.order)
        part.mesh()
        for k in range(arguments.edits):
            radius = 4.5 + .05 * k
            base, part = part, part.edit(pin_radius=radius)
            begun = time.perf_counter()
            mesh = part.mesh()
            meshes.append(1e3 * (time.perf_counter() - begun))
            document = '{"edits": [{"setParameter": {"name": "pin_radius", "value": %r}}]}' % radius
            wires.append(1e3 * min(wire_seconds(daemon, base, document) for _ in range(3)))
            shares.append(part.report.nodes_kept / part.report.nodes)
    print(f"{len(mesh.points)} nodes, order {arguments.order}, {arguments.edits} edits, "
          f"{100 * statistics.median(shares):.0f} % kept")
    print(f"part.mesh() {statistics.median(meshes):.1f} ms, wire {statistics.median(wires):.1f} ms, "
          f"overhead {statistics.median(m - w for m, w in zip(meshes, wires)):.1f} ms")


if __name__ == "__main__":
    main()
