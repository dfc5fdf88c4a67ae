#!/usr/bin/python3
"""Without a database the names of each design are at one replica, its home.

    PYTHONPATH=build/client/python tests/cluster/homes.py build/bin/remeshd

Three replicas know each other's addresses. Clients that know them all make designs, and each is to be
found from there; a client that knows one replica alone is to be refused what moves heads elsewhere,
with the address of the home, and its loops by id are to go on. A home is killed: its names are
UNAVAILABLE, loops by id go on, and it has all names when it is back. Exits with 1 where that is not so.
"""
import argparse
import sys

import grpc
import remesh_client as rc
from remesh_client.v1 import remesh_pb2_grpc, revision_pb2

from bed import Bed, NginxTier
from loops import MODEL
from ports import free_port


def refusal(call):
    """Reason and home of the error."""
    try:
        call()
    except rc.RemeshError as why:
        return why.reason, why.home
    return "", ""


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("remeshd")
    parser.add_argument("--designs", type=int, default=6)
    parser.add_argument("--nodes", type=int, default=300)
    arguments = parser.parse_args()
    wrong = []
    with Bed(arguments.remeshd, NginxTier, replicas=0) as bed:
        addresses = [f"127.0.0.1:{free_port()}" for _ in range(3)]
        for address in addresses:
            bed.add(address, [*(word for each in addresses for word in ("--replicas", each)),
                              "--replica", address])
        names = [f"design {k}" for k in range(arguments.designs)]
        homes = {}
        with rc.connect(addresses) as farm:
            for k, name in enumerate(names):
                part = farm.mesh(MODEL, design=name, nodes=arguments.nodes, seed=k + 1)
                part.edit(pin_radius=5)
                if len(farm.log(name)) != 2:
                    wrong.append(f"{name} has not two revisions")
        for name in names:
            for address in addresses:
                with rc.connect(address) as daemon:
                    reason, home = refusal(lambda name=name, daemon=daemon: daemon.log(name))
                    if not reason:
                        homes.setdefault(name, []).append(address)
                        continue
                    if reason != "DESIGN_ELSEWHERE" or home not in addresses:
                        wrong.append(f"{name} at {address}: {reason}, {home!r}")
                    stub = remesh_pb2_grpc.RemeshServiceStub(grpc.insecure_channel(address))
                    try:
                        stub.SetHead(revision_pb2.SetHeadRequest(revision=f"{name}@1"))
                        wrong.append(f"{name}'s head was moved at {address}")
                    except grpc.RpcError as why:
                        if why.code() != grpc.StatusCode.FAILED_PRECONDITION:
                            wrong.append(f"{name} at {address}: {why.code()}")
        if any(len(each) != 1 for each in homes.values()) or len(homes) != len(names):
            wrong.append(f"not one home a design: {homes}")
        first = homes[names[0]][0]
        at = addresses.index(first)
        others = [each for each in addresses if each != first]
        with rc.connect(first) as daemon:
            identity = daemon.open(names[0]).revision
        bed.replicas[at].kill()
        with rc.connect(others, patience=2) as farm:
            reason, home = refusal(lambda: farm.open(names[0]))
            if (reason, home) != ("DESIGN_ELSEWHERE", first):
                wrong.append(f"while its home is away: {reason}, {home!r}")
            farm.open(identity).edit(pin_radius=5.5).edit(pin_radius=5.25)
        bed.replicas[at].start()
        with rc.connect(addresses) as farm:
            if farm.open(names[0]).revision != identity:
                wrong.append("the home came back with another head")
    print(f"{len(names)} designs at {len(set(map(tuple, homes.values())))} homes: {len(wrong)} wrong",
          *wrong, sep="\n  ")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
