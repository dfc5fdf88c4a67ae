#!/usr/bin/python3
"""Loops of the command line go on where replicas are killed.

    PYTHONPATH=build/client/python tests/cluster/cli_loops.py build/bin/remeshd build/bin/remesh

Three replicas have a folder for a tier. A loop of `remesh edit`, one process an edit, and then a
`remesh sweep`, one stream for all, run against the list of their addresses, while one after another
is killed and started again. Exits with 1 where a command failed, or one byte of a mesh differs from
what one daemon makes.
"""
import argparse
import hashlib
import json
import os
import random
import shutil
import subprocess
import sys
import tempfile
import threading
import time
from pathlib import Path

from bed import Bed, Replica
from loops import MODEL


class FolderTier:
    """A folder that all replicas reach."""

    options = ()

    def __init__(self, folder):
        self.url = str(folder)

    def stop(self):
        """It goes with the bed."""


class Failed(Exception):
    """A command that did not end well."""


class Loop:
    """The same commands against any addresses; what they made."""

    def __init__(self, remesh, addresses, folder, arguments):
        self._remesh, self._folder = remesh, Path(folder)
        self._folder.mkdir()
        self._environment = dict(os.environ, REMESH_ADDRESS=",".join(addresses))
        chance = random.Random(7)
        self._radii = [round(chance.uniform(4, 6), 3) for _ in range(arguments.edits)]
        self._nodes = arguments.nodes
        self.made = []  # (id, digest of its file)
        self.longest = 0.0  # s that a command took

    def _run(self, *words):
        begun = time.monotonic()
        done = subprocess.run([self._remesh, *map(str, words)], env=self._environment,
                              capture_output=True, text=True)
        self.longest = max(self.longest, time.monotonic() - begun)
        if done.returncode != 0:
            raise Failed(f"remesh {' '.join(map(str, words))} after {len(self.made)} meshes: exit "
                         f"code {done.returncode}: {done.stderr}")
        return done.stdout

    def _make(self, *words):
        """One mesh, written and noted; its id."""
        file = self._folder / "part.vtu"
        report = json.loads(self._run(*words, "-o", file, "--json", "-"))
        self.made.append((report["revision"], hashlib.sha256(file.read_bytes()).hexdigest()))
        return report["revision"]

    def edits(self):
        """One after the other, each of the last one by its id; the id of the first mesh."""
        first = base = self._make("mesh", MODEL, "--nodes", self._nodes)
        for radius in self._radii:
            base = self._make("edit", base, "--set", f"pin_radius={radius}")
        return first

    def sweep(self, base):
        out = self._folder / "steps"
        table = self._run("sweep", base, "--set",
                          f"pin_radius={','.join(map(str, self._radii))}", "-o", out)
        rows = [line.split("\t") for line in table.splitlines()]
        column = rows[0].index("revision")
        files = sorted(out.glob("*.vtu"))
        if len(files) != len(self._radii):
            raise Failed(f"a sweep of {len(self._radii)} steps made {len(files)} meshes: {table}")
        for row, file in zip(rows[1:], files):
            self.made.append((row[column], hashlib.sha256(file.read_bytes()).hexdigest()))


class Killer:
    """Kills one replica after the other, and starts it again, until it is told to stop."""

    def __init__(self, replicas):
        self._replicas, self.kills = replicas, 0
        self._over = threading.Event()
        self._thread = threading.Thread(target=self._run)
        self._thread.start()

    def _run(self):
        chance = random.Random(1)
        while not self._over.wait(chance.uniform(.2, 1)):
            victim = self._replicas[self.kills % len(self._replicas)]
            victim.kill()
            self._over.wait(chance.uniform(0, .4))
            victim.start()
            self.kills += 1

    def stop(self):
        self._over.set()
        self._thread.join()


def run(loop):
    """What went wrong, a line each."""
    try:
        loop.sweep(loop.edits())
    except Failed as why:
        return [str(why)]
    return []


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("remeshd")
    parser.add_argument("remesh")
    parser.add_argument("--edits", type=int, default=40)
    parser.add_argument("--nodes", type=int, default=1000)
    parser.add_argument("--balancer", action="store_true",
                        help="the address of a balancer before them is given alone")
    arguments = parser.parse_args()
    folder = Path(tempfile.mkdtemp(prefix="remesh-cli-loops-"))
    try:
        alone = Replica(arguments.remeshd, folder / "alone", [])
        right = Loop(arguments.remesh, [alone.address], folder / "right", arguments)
        wrong = run(right)
        alone.stop()
        with Bed(arguments.remeshd, FolderTier) as bed:
            addresses = [bed.balance().address] if arguments.balancer else bed.addresses
            loop = Loop(arguments.remesh, addresses, folder / "farm", arguments)
            killer = Killer(bed.replicas)
            try:
                wrong += run(loop)
            finally:
                killer.stop()
        wrong += [f"mesh {k} is another" for k, (a, b) in enumerate(zip(loop.made, right.made))
                  if a != b]
        print(f"{killer.kills} kills in {arguments.edits} edits and a sweep of as many, longest "
              f"command {loop.longest:.2f} s: {len(wrong)} wrong", *wrong, sep="\n  ")
    finally:
        shutil.rmtree(folder, ignore_errors=True)
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
