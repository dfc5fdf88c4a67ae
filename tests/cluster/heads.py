#!/usr/bin/python3
"""Heads in PostgreSQL: none is lost, none is moved twice.

    PYTHONPATH=build/client/python tests/cluster/heads.py build/bin/remeshd [--moves 1000]

Clients at three replicas edit the head of one design, each edit on condition that the head still is
the one that was edited: a compare-and-set. Meanwhile PostgreSQL is killed with all its processes,
or does not answer for a while, and goes on. In the end the design has to be one chain, each of its
revisions an edit of the one before, with every edit that a client was told of in it, once; and all
replicas have to tell the same. Exits with 1 where that is not so, or a client saw anything but that
it lost, or that it was to try again.
"""
import argparse
import collections
import itertools
import json
import random
import sys
import threading
import time

import grpc
from remesh_client.v1 import remesh_pb2_grpc, revision_pb2

from bed import Bed, NginxTier
from loops import MODEL
from postgres import Postgres


def stub_of(address):
    return remesh_pb2_grpc.RemeshServiceStub(grpc.insecure_channel(address))


class Editors:
    """Clients that move one head until it has been moved often enough."""

    def __init__(self, addresses, moves, nodes):
        self._addresses, self._moves, self._nodes = addresses, moves, nodes
        self._lock = threading.Lock()
        self._values = itertools.count()
        self.made = []                     # ids that were told to be the head
        self.told = collections.Counter()  # codes of errors
        self.longest = 0.0                 # s until a client was told
        self.errors = []

    def begin(self):
        request = revision_pb2.CreateRevisionRequest(document=MODEL.read_text(), design="part")
        request.options.nodes = self._nodes
        return stub_of(self._addresses[0]).CreateRevision(request).result.revision.id

    def done(self):
        return len(self.made) >= self._moves or bool(self.errors)

    def run(self, which):
        try:
            daemon = stub_of(self._addresses[which % len(self._addresses)])
            while not self.done():
                self._move(daemon)
        except Exception as why:  # pylint: disable=broad-except
            self.errors.append(f"client {which}: {why!r}")

    def _move(self, daemon):
        with self._lock:
            radius = round(4 + next(self._values) * 1e-4, 4)
        begun = time.monotonic()
        try:
            head = daemon.GetRevision(revision_pb2.GetRevisionRequest(revision="part"))
            request = revision_pb2.EditRevisionRequest(
                base=head.revision.id, design="part", document=json.dumps({
                    "edits": [{"setParameter": {"name": "pin_radius", "value": radius}}]}))
            request.head.require = True
            result = daemon.EditRevision(request).result
        except grpc.RpcError as why:
            self.longest = max(self.longest, time.monotonic() - begun)
            self.told[why.code().name] += 1
            if why.code() == grpc.StatusCode.UNAVAILABLE:
                time.sleep(.2)
            elif why.code() != grpc.StatusCode.ABORTED:
                raise
            return
        self.longest = max(self.longest, time.monotonic() - begun)
        with self._lock:
            self.made.append(result.revision.id)


def trouble(database, editors, chance):
    """Until the editors are done; how often it was killed and frozen."""
    counts = collections.Counter()
    while not editors.done():
        time.sleep(chance.uniform(1, 6))
        if chance.random() < .8:
            counts["killed"] += 1
            database.kill()
            time.sleep(chance.uniform(0, .5))
            database.start()
        else:
            counts["frozen"] += 1
            database.freeze()
            time.sleep(chance.uniform(.5, 5))
            database.thaw()
    return counts


def patiently(call, request):
    """While the database begins."""
    for _ in range(300):
        try:
            return call(request)
        except grpc.RpcError as why:
            if why.code() != grpc.StatusCode.UNAVAILABLE:
                raise
            time.sleep(.1)
    return call(request)


def chain_at(address):
    """Number, id and parent of each revision of the design, and the id of its head."""
    daemon, rows, token = stub_of(address), [], ""
    while True:
        page = patiently(daemon.ListRevisions, revision_pb2.ListRevisionsRequest(
            filter=revision_pb2.RevisionFilter(design="part"), page_token=token))
        rows += [(each.number, each.id, each.parent) for each in page.revisions]
        token = page.next_page_token
        if not token:
            head = patiently(daemon.GetRevision,
                             revision_pb2.GetRevisionRequest(revision="part"))
            return sorted(rows), head.revision.id


def faults(addresses, first, editors):
    """What is not as it has to be, a line each, and how many moves no client was told of."""
    lines = list(editors.errors)
    chains = [chain_at(address) for address in addresses]
    if any(chain != chains[0] for chain in chains):
        lines.append("the replicas do not tell the same")
    rows, head = chains[0]
    ids = [identity for _, identity, _ in rows]
    for (_, before, _), (number, _, parent) in zip(rows, rows[1:]):
        if parent != before:
            lines.append(f"number {number} is no edit of the one before")
    if ids[0] != first or ids[-1] != head:
        lines.append("the head is not the last of the chain")
    counted = collections.Counter(ids)
    lines += [f"{identity[:12]} is not in the design" for identity in editors.made
              if not counted[identity]]
    lines += [f"{identity[:12]} is in the design {times} times" for identity, times
              in counted.items() if times > 1]
    return lines, len(ids) - 1 - len(set(editors.made))


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("remeshd")
    parser.add_argument("--moves", type=int, default=1000)
    parser.add_argument("--clients", type=int, default=6)
    parser.add_argument("--nodes", type=int, default=200)
    arguments = parser.parse_args()
    begun = time.monotonic()
    with Bed(arguments.remeshd, NginxTier, replicas=0) as bed:
        database = Postgres(bed.folder / "postgres")
        try:
            bed.options += ["--catalogue", database.address]
            for _ in range(3):
                bed.add()
            editors = Editors(bed.addresses, arguments.moves, arguments.nodes)
            first = editors.begin()
            threads = [threading.Thread(target=editors.run, args=[which])
                       for which in range(arguments.clients)]
            for thread in threads:
                thread.start()
            counts = trouble(database, editors, random.Random(1))
            for thread in threads:
                thread.join()
            wrong, untold = faults(bed.addresses, first, editors)
        finally:
            database.stop()
    print(f"{len(editors.made)} moves by {arguments.clients} clients in "
          f"{time.monotonic() - begun:.0f} s, PostgreSQL {dict(counts)}, clients were told "
          f"{dict(editors.told)}, {untold} moves were made that a client was not told of, longest "
          f"edit {editors.longest:.1f} s: {len(wrong)} wrong", *wrong, sep="\n  ")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
