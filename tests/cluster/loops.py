"""Loops of edits, and what each revision of theirs has to be."""
import asyncio
import hashlib
import random
import threading
import time
from pathlib import Path

import remesh_client as rc
from remesh_client import aio

MODEL = Path(__file__).parent.parent / "cases/tool1-a.json"


def digest(mesh):
    """Of nodes and tets."""
    arrays = hashlib.sha256(mesh.points.tobytes())
    arrays.update(mesh.tets.tobytes())
    return arrays.hexdigest()


class Loop:
    """A first mesh and edits of it, one of the other, the same for the same number."""

    def __init__(self, number, edits, nodes):
        chance = random.Random(number)
        self.number, self.nodes = number, nodes
        self.radii = [round(chance.uniform(4, 6), 3) for _ in range(edits)]
        self.made = []  # (id, digest of the mesh) of each revision
        self.longest = 0.0  # s that an edit took with its mesh
        self.error = None

    def run(self, daemon, after_each=lambda: None):
        part = daemon.mesh(MODEL, nodes=self.nodes, seed=self.number + 1, file=False)
        self._note(part)
        for radius in self.radii:
            begun = time.monotonic()
            part = part.edit(pin_radius=radius, file=False)
            self._note(part)
            self.longest = max(self.longest, time.monotonic() - begun)
            after_each()

    async def run_async(self, daemon):
        """The same by the client for asyncio."""
        part = await daemon.mesh(MODEL, nodes=self.nodes, seed=self.number + 1, file=False)
        self.made.append((part.revision, digest(await part.mesh())))
        for radius in self.radii:
            begun = time.monotonic()
            part = await part.edit(pin_radius=radius, file=False)
            self.made.append((part.revision, digest(await part.mesh())))
            self.longest = max(self.longest, time.monotonic() - begun)

    def _note(self, part):
        self.made.append((part.revision, digest(part.mesh())))


def reference(program, count, edits, nodes):
    """What loops have to be: those of one daemon alone."""
    with rc.local(program) as daemon:
        loops = [Loop(number, edits, nodes) for number in range(count)]
        for loop in loops:
            loop.run(daemon)
        return loops


def run_all(loops, addresses, patience=60.0, after_each=lambda: None, tasks=False):
    """Side by side, each with a client of its own, or as tasks that share one of asyncio; an error
    of one stands in it."""
    if tasks:
        return _run_tasks(loops, addresses, patience)
    def run(loop):
        try:
            with rc.connect(addresses, patience=patience) as daemon:
                loop.run(daemon, after_each)
        except Exception as why:  # pylint: disable=broad-except
            loop.error = why
    threads = [threading.Thread(target=run, args=[loop]) for loop in loops]
    for thread in threads:
        thread.start()
    return threads


def _run_tasks(loops, addresses, patience):
    async def run(loop, daemon):
        try:
            await loop.run_async(daemon)
        except Exception as why:  # pylint: disable=broad-except
            loop.error = why

    async def main():
        async with aio.connect(addresses, patience=patience) as daemon:
            await asyncio.gather(*(run(loop, daemon) for loop in loops))
    thread = threading.Thread(target=lambda: asyncio.run(main()))
    thread.start()
    return [thread]


def differences(loops, references):
    """What is not as it has to be, a line each."""
    lines = []
    for loop, right in zip(loops, references):
        if loop.error is not None:
            lines.append(f"loop {loop.number} after {len(loop.made)} revisions: {loop.error!r}")
        elif loop.made != right.made:
            wrong = [n for n, (a, b) in enumerate(zip(loop.made, right.made)) if a != b]
            lines.append(f"loop {loop.number}: revisions {wrong} are others")
    return lines
