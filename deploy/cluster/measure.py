#!/usr/bin/python3
"""Measures what the simulator is fed with: service times, sizes and requests of a real daemon.

    PYTHONPATH=build/client/python deploy/cluster/measure.py build/bin/remeshd -o service_times.json

Replicas with one worker share a tier (nginx) that has each recipe before an edit is acknowledged.
Only one thing is at work at a time. Takes five minutes; the machine should be idle else.
"""
import argparse
import itertools
import json
import os
import random
import re
import statistics
import sys
import tempfile
import threading
import time
from pathlib import Path

import remesh_client as rc

from bench_shared import shared_parts
from bench_tier import Balancer, LoggedTier, bytes_received, cpu_seconds, resident_bytes

TOP = Path(__file__).resolve().parent.parent.parent
sys.path.insert(0, str(TOP / "tests/cluster"))
from bed import Bed  # noqa: E402  pylint: disable=wrong-import-position

CASES = TOP / "tests/cases"
STEPS = (1, 2, 4, 8, 16, 24, 32, 48)  # of a loop after which another replica goes on
LOST = (1, 4, 16)  # packs that the tier has not got when their replica has gone


def pins(chance, _):
    return {"pin_radius": round(chance.uniform(4, 6), 3)}


def holes(chance, _):
    return {"hole_circle": round(chance.uniform(35, 37), 3), "hole_turn": chance.randint(0, 8)}


def narrowing(chance, step):
    """As an optimiser that comes to rest: steps that shrink."""
    return {"pin_radius": round(5 + chance.choice((-1, 1)) * .9 * .8 ** step, 5)}


def pipe(chance, _):
    return {"pipe_x": round(chance.uniform(12, 20), 3)}


def wall(chance, _):
    return {"wall.dz": round(chance.uniform(52, 60), 3),
            "mount1.radius": round(chance.uniform(4.5, 5.5), 3)}


LOOPS = {"tool1 pins": ("tool1-a.json", pins), "tool1 holes": ("tool1-a.json", holes),
         "tool1 narrowing": ("tool1-a.json", narrowing), "tool2 pipe": ("tool2-a.json", pipe),
         "tool2 wall": ("tool2-a.json", wall)}


def timed(work):
    begun = time.perf_counter()
    result = work()
    return result, time.perf_counter() - begun


def drained(tier, revisions, seconds=30):
    """Waits until the tier has the packs of all of them."""
    until = time.monotonic() + seconds
    while not set(revisions) <= set(tier.sizes("pack")):
        if time.monotonic() > until:
            raise TimeoutError("the tier does not get all packs")
        time.sleep(.05)


def run_loop(bed, address, name, edits, nodes, seed=1):
    """A loop at one address: a row for its first mesh and for each edit; the revisions."""
    case, change = LOOPS[name]
    chance = random.Random(seed)
    rows, parts, before = [], [], 0
    with rc.connect(address) as daemon:
        part, result = timed(lambda: daemon.mesh(CASES / case, nodes=nodes, seed=seed, file=False))
        for step in range(edits + 1):
            mesh, transfer = timed(part.mesh)
            received = bytes_received(address)
            rows.append({"result_s": result, "mesh_s": transfer,
                         "engine_s": part.report.seconds.total,
                         "way": part.report.Way.Name(part.report.way)[4:],
                         "nodes": len(mesh.points), "kept": part.report.nodes_kept,
                         "received_bytes": received - before})
            parts.append(part.revision)
            before = received
            if step < edits:
                values = change(chance, step)
                part, result = timed(lambda p=part, v=values: p.edit(v, file=False))
        drained(bed.tier, parts)
    packs, recipes = bed.tier.sizes("pack"), bed.tier.sizes("recipe")
    for row, revision in zip(rows, parts):
        row.update(pack_bytes=packs[revision], recipe_bytes=recipes[revision])
    return rows, parts


def rounded(value):
    """Four digits of each number are more than can be relied on."""
    if isinstance(value, dict):
        return {key: rounded(each) for key, each in value.items()}
    if isinstance(value, list):
        return [rounded(each) for each in value]
    return float(f"{value:.4g}") if isinstance(value, float) else value


def written(measured):
    """As JSON with each list, and each dictionary without others in it, on one line."""
    text = json.dumps(measured, indent=1)
    flat = re.compile(r"[\[{][^\[\]{}]*[\]}]")
    return flat.sub(lambda found: re.sub(r"\s*\n\s*", " ", found[0]), text) + "\n"


def request_counts(requests, edits):
    """Requests and bytes an edit, by method and kind."""
    kinds = sorted({(method, kind) for method, _, _, _, kind, _ in requests})
    return {f"{method} {kind}": {
        "requests": len(found) / edits, "bytes": sum(each[2] for each in found) / edits,
        "found": sum(each[1] != 404 for each in found) / edits,
        "median_s": statistics.median(each[3] for each in found)}
        for method, kind in kinds
        for found in [[each for each in requests if (each[0], each[4]) == (method, kind)]]}


def usual_loops(program, edits, nodes, names):
    """Loops one after another, each on a replica that has done nothing before."""
    found = {}
    for name in names:
        with Bed(program, lambda: LoggedTier(tier_folder()), replicas=1) as bed:
            replica, = bed.replicas
            idle = cpu_seconds(replica.process.pid)
            (first,), _ = run_loop(bed, replica.address, name, 0, nodes)
            begun = cpu_seconds(replica.process.pid)
            resident = resident_bytes(replica.process.pid)
            bed.tier.requests()
            rows, parts = run_loop(bed, replica.address, name, edits, nodes)
            with rc.connect(replica.address) as daemon:
                load = daemon.info().load
            found[name] = {
                "first": first, "first_cpu_s": begun - idle,
                "edits": {key: [row[key] for row in rows[1:]] for key in rows[0]},
                "cpu_s_an_edit": (cpu_seconds(replica.process.pid) - begun) / edits,
                "held_bytes_an_edit": load.memory_bytes / load.cached_revisions,
                "resident_bytes_an_edit":
                    (resident_bytes(replica.process.pid) - resident) / edits,
                "tier_an_edit": request_counts(
                    [each for each in bed.tier.requests() if each[5] in parts[1:]], edits)}
            print(name, nodes, "nodes: done", file=sys.stderr)
    return found


def balancer(program, edits, nodes):
    """CPU s of nginx for an edit with its mesh that goes through it."""
    with Bed(program, lambda: LoggedTier(tier_folder()), replicas=1) as bed:
        proxy = Balancer(bed.folder / "balancer", bed.replicas[0].address)
        try:
            run_loop(bed, proxy.address, "tool1 pins", 0, nodes)
            begun = proxy.cpu_seconds()
            rows, _ = run_loop(bed, proxy.address, "tool1 pins", edits, nodes)
            return {"cpu_s_an_edit": (proxy.cpu_seconds() - begun) / edits,
                    "received_bytes_an_edit":
                        sum(row["received_bytes"] for row in rows[1:]) / edits}
        finally:
            proxy.stop()


def tier_folder():
    return Path(tempfile.mkdtemp(prefix="remesh-tier-"))


def continue_at(bed, replica, revision, values):
    """s until another replica has a base, and of its first two edits; requests and bytes."""
    bed.tier.requests()
    with rc.connect(replica.address) as daemon:
        part, opening = timed(lambda: daemon.open(revision))
        first, edit = timed(lambda: part.edit(values[0], file=False))
        _, second = timed(lambda: first.edit(values[1], file=False))
    got = [each for each in bed.tier.requests() if each[0] == "GET" and each[1] == 200]
    packs = [each for each in got if each[4] == "pack"]
    return {"open_s": opening, "first_edit_s": edit, "second_edit_s": second, "gets": len(got),
            "packs": len(packs), "get_bytes": sum(each[2] for each in got)}


def moves(program, nodes):
    """What it takes another replica to go on: with packs from the tier, from its own store, or
    without the last packs."""
    chance = random.Random(9)
    values = [pins(chance, 0) for _ in range(40)]
    taken = {"from_tier": {}, "from_store": {}, "packs_lost": {}}
    with Bed(program, lambda: LoggedTier(tier_folder()), replicas=1) as bed:
        home, = bed.replicas
        rows, parts = run_loop(bed, home.address, "tool1 pins", max(STEPS) + 1, nodes)
        usual = statistics.median(row["result_s"] for row in rows[1:])
        for step in STEPS:
            replica = bed.add()
            taken["from_tier"][step] = continue_at(bed, replica, parts[step - 1], values)
            replica.stop()
        for step in STEPS:
            home.stop()
            home.start()
            taken["from_store"][step] = continue_at(bed, home, parts[step - 1], values[2:])
        for lost in LOST:
            bed.tier.remove("pack", parts[33 - lost:33])
            replica = bed.add()
            taken["packs_lost"][lost] = continue_at(bed, replica, parts[32], values[4:])
            replica.stop()
    return taken | {"usual_edit_s": usual}


def failover(program, nodes, kills=8):
    """s of the edit after its replica was killed, by a client that knows two replicas."""
    seconds = []
    for number in range(kills):
        with Bed(program, lambda: LoggedTier(tier_folder()), replicas=2) as bed:
            chance = random.Random(number)
            with rc.connect(bed.addresses) as daemon:
                part = daemon.mesh(CASES / "tool1-a.json", nodes=nodes, seed=number, file=False)
                for _ in range(4):
                    part = part.edit(pins(chance, 0), file=False)
                drained(bed.tier, [part.revision])
                home = max(bed.replicas, key=lambda replica: cpu_seconds(replica.process.pid))
                home.kill()
                _, taken = timed(lambda p=part: p.edit(pins(chance, 0), file=False))
                seconds.append(taken)
    return seconds


def evictions(program, nodes, budgets=(64, 96, 128, 192), loops=10, rounds=4):
    """Bases found in memory, of so many loops that take turns, by MiB that revisions may take."""
    found = {}
    for budget in budgets:
        options = ["--cache", str(budget), "--metrics", "127.0.0.1:0"]
        with Bed(program, lambda: LoggedTier(tier_folder()), replicas=1, options=options) as bed:
            chance = random.Random(5)
            with rc.connect(bed.addresses) as daemon:
                parts = [daemon.mesh(CASES / "tool1-a.json", nodes=nodes, seed=seed, file=False,
                                     with_mesh=False) for seed in range(loops)]
                taken = []
                for _ in range(rounds):
                    for n, part in enumerate(parts):
                        parts[n], seconds = timed(lambda p=part: p.edit(
                            pins(chance, 0), file=False, mesh=False))
                        taken.append(seconds)
                load = daemon.info().load
            later = taken[loops:]
            found[budget] = {"edit_s": statistics.median(later), "held": load.cached_revisions,
                             "memory_bytes": load.memory_bytes}
    return found


def several_clients(program, nodes, think=.8, seconds=60):
    """Loops side by side at one worker, one of each kind, with random think time: what the
    simulator is compared with. s of edits without their meshes."""
    def client(number, address, until, seen, thought):
        case, change = list(LOOPS.values())[number]
        chance = random.Random(number)
        with rc.connect(address) as daemon:
            part = daemon.mesh(CASES / case, nodes=nodes, seed=number + 1, file=False,
                               with_mesh=False)
            for step in itertools.count():
                thought.append(chance.expovariate(1 / think))
                time.sleep(thought[-1])
                if time.monotonic() > until:
                    return
                values = change(chance, step % 12)
                part, taken = timed(lambda p=part, v=values: p.edit(v, file=False, mesh=False))
                seen.append((time.monotonic(), taken))

    with Bed(program, lambda: LoggedTier(tier_folder()), replicas=1) as bed:
        seen, thought, until = [], [], time.monotonic() + seconds + 5
        threads = [threading.Thread(target=client,
                                    args=[n, bed.addresses[0], until, seen, thought])
                   for n in range(len(LOOPS))]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
    taken = sorted(each for when, each in seen if when > until - seconds)  # without first meshes
    return {"loops": len(LOOPS), "think_s": statistics.mean(thought),
            "edits_a_second": len(taken) / seconds,
            "mean_s": statistics.mean(taken), "p50_s": statistics.median(taken),
            "p90_s": taken[int(.9 * len(taken))], "p99_s": taken[int(.99 * len(taken))]}


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("remeshd")
    parser.add_argument("-o", "--output", type=Path, default=Path("service_times.json"))
    parser.add_argument("--edits", type=int, default=30)
    parser.add_argument("--nodes", type=int, default=15000)
    arguments = parser.parse_args()
    load = os.getloadavg()[0]
    measured = {
        "units": "s, bytes; an edit is counted with its mesh unless it says otherwise",
        "machine": "AMD EPYC, 2 cores of a virtual machine; replicas, nginx and client share it",
        "load_before": load,
        "nodes": arguments.nodes,
        "loops": usual_loops(arguments.remeshd, arguments.edits, arguments.nodes, LOOPS),
        "other_sizes": {size: usual_loops(arguments.remeshd, 8, size, ["tool1 pins"])["tool1 pins"]
                        for size in (2000, 60000)},
        "moves": moves(arguments.remeshd, arguments.nodes),
        "failover_s": failover(arguments.remeshd, arguments.nodes),
        "evictions": evictions(arguments.remeshd, arguments.nodes),
        "several_clients": several_clients(arguments.remeshd, arguments.nodes),
        "balancer": balancer(arguments.remeshd, arguments.edits, arguments.nodes),
        "shared": shared_parts(),
        "load_after": os.getloadavg()[0],
    }
    arguments.output.write_text(written(rounded(measured)))


if __name__ == "__main__":
    main()
