#!/usr/bin/python3
"""Loops end, and nothing is made twice over, where the network falls apart. As root.

    PYTHONPATH=build/client/python tests/cluster/partitions.py build/bin/remeshd

Two replicas, each in a network namespace of its own; what is sent to a lost address is dropped
without a word. In turn: a replica and the tier do not reach each other while loops run; nor do a
client and a replica (which it finds out by its keepalive, after some 50 s); then both replicas are
cut off from the tier and make the same revisions, and what the tier has of them in the end is one
object each, as one daemon makes it. Exits with 1 where a loop sees an error or a byte differs.
"""
import argparse
import subprocess
import sys
import time

import remesh_client as rc
from bed import Bed, FaultyTier, Replica
from loops import Loop, differences, reference, run_all

CLIENT, TIER = "10.77.0.1", "10.77.0.2"  # of this side
BRIDGE = "rmbridge"
NOWHERE = "02:00:00:00:00:99"  # a hardware address that nobody has


def ip(*arguments, inside=None):
    subprocess.run([*(["ip", "netns", "exec", inside] if inside else []), "ip", *arguments],
                   check=True)


class Network:
    """Namespaces on a bridge; a context manager."""

    def __init__(self, count):
        self.names = [f"rmreplica{number}" for number in range(count)]

    @staticmethod
    def address(number):
        return f"10.77.0.{10 + number}"

    def __enter__(self):
        ip("link", "add", BRIDGE, "type", "bridge")
        for address in (CLIENT, TIER):
            ip("addr", "add", f"{address}/24", "dev", BRIDGE)
        ip("link", "set", BRIDGE, "up")
        for number, name in enumerate(self.names):
            ip("netns", "add", name)
            ip("link", "add", f"rmveth{number}", "type", "veth", "peer", "name", "eth0", "netns", name)
            ip("link", "set", f"rmveth{number}", "master", BRIDGE, "up")
            ip("addr", "add", f"{self.address(number)}/24", "dev", "eth0", inside=name)
            for device in ("lo", "eth0"):
                ip("link", "set", device, "up", inside=name)
        return self

    def __exit__(self, *_):
        for name in self.names:
            ip("netns", "delete", name)
        ip("link", "delete", BRIDGE)

    def cut(self, number, address):
        """What a replica sends there is lost."""
        ip("neigh", "replace", address, "lladdr", NOWHERE, "nud", "permanent", "dev", "eth0",
           inside=self.names[number])

    def mend(self, number, address):
        ip("neigh", "delete", address, "dev", "eth0", inside=self.names[number])


class BedElsewhere(Bed):
    """Replicas in namespaces; the tier on this side."""

    def __init__(self, network, program, acknowledge):
        self._network = network
        super().__init__(program, lambda _: FaultyTier(host=TIER), replicas=len(network.names),
                         acknowledge=acknowledge)

    def add(self, address="", options=()):
        """In a network of its own, whatever the address."""
        number = len(self.replicas)
        self.replicas.append(Replica(
            self._program, self.folder / f"replica{number}", ["--behind-proxy", *self.options, *options],
            address=f"{self._network.address(number)}:50051",
            within=["ip", "netns", "exec", self._network.names[number]]))
        return self.replicas[-1]


def with_cut(network, bed, right, number, address, seconds):
    """Runs loops, in the middle of which a replica does not reach an address for some seconds."""
    loops = [Loop(each.number, len(each.radii), each.nodes) for each in right]
    threads = run_all(loops, bed.addresses, patience=120)
    time.sleep(1.5)
    network.cut(number, address)
    time.sleep(seconds)
    network.mend(number, address)
    for thread in threads:
        thread.join()
    print(f"longest edit {max(loop.longest for loop in loops):.1f} s", flush=True)
    return differences(loops, right)


def made_apart(network, bed, right):
    """Both replicas make the same, each cut off from the tier, which then gets it of both."""
    for number in range(2):
        network.cut(number, TIER)
    loops = [Loop(right.number, len(right.radii), right.nodes) for _ in range(2)]
    for loop, address in zip(loops, bed.addresses):
        with rc.connect(address) as daemon:
            loop.run(daemon)
    for number in range(2):
        network.mend(number, TIER)
    wrong = differences(loops, [right, right])
    ids = [each for each, _ in right.made]
    until = time.monotonic() + 60
    while time.monotonic() < until and len(bed.tier.objects) < 2 * len(ids):
        time.sleep(.2)
    if len(bed.tier.objects) != 2 * len(ids):
        wrong.append(f"the tier has {len(bed.tier.objects)} objects of {len(ids)} revisions")
    return wrong


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("remeshd")
    parser.add_argument("--edits", type=int, default=40)
    parser.add_argument("--nodes", type=int, default=2000)
    arguments = parser.parse_args()
    right = reference(arguments.remeshd, 3, arguments.edits, arguments.nodes)
    wrong = []
    with Network(2) as network:
        with BedElsewhere(network, arguments.remeshd, "tier") as bed:
            wrong += with_cut(network, bed, right, 0, TIER, 4)
        with BedElsewhere(network, arguments.remeshd, "tier") as bed:
            wrong += with_cut(network, bed, right, 0, CLIENT, 70)
        with BedElsewhere(network, arguments.remeshd, "local") as bed:
            wrong += made_apart(network, bed, right[0])
    print(f"{len(wrong)} wrong", *wrong, sep="\n  ")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
