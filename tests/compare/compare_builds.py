#!/usr/bin/env python3
"""Compares two builds of the engine: the bytes of their meshes, or their time and memory.

compare_builds.py bytes BEFORE AFTER [-- options of remesh-digests]
compare_builds.py speed BEFORE AFTER [--rounds N] [--sizes 15000 30000]

BEFORE and AFTER are folders of programs (`build/bin`). `bytes` runs `remesh-digests` of both side by
side and exits with 1 where a line differs. `speed` runs `remesh-bench run` of both in turn on tool1-ac
and prints the medians of the ratios, after over before.
"""
import argparse
import itertools
import os
import re
import statistics
import subprocess
import sys
from pathlib import Path


def digests(folder, options):
    return subprocess.Popen([Path(folder) / "remesh-digests", *options], stdout=subprocess.PIPE,
                            text=True)


def compare_bytes(before, after, options):
    """Prints the lines that differ and returns how many do."""
    meshes = differ = 0
    programs = [digests(before, options), digests(after, options)]
    for a, b in itertools.zip_longest(*(p.stdout for p in programs)):
        meshes += 1
        if a != b:
            differ += 1
            print(f"- {a}+ {b}", end="", flush=True)
    failed = [p.args[0] for p in programs if p.wait() != 0]
    for program in failed:
        print(f"{program} failed")
    print(f"{meshes} meshes, {differ} differ")
    return differ + len(failed)


def run_once(folder, nodes):
    """Seconds of a first mesh and of a remesh, the least of three, and KiB of the most memory."""
    process = subprocess.Popen([Path(folder) / "remesh-bench", "run", "tool1-ac", str(nodes), "10",
                                "1", "3"], stdout=subprocess.PIPE, text=True)
    seconds = {"original": [], "remesh": []}
    for line in process.stdout:
        kind = line.split()[0]
        if kind in seconds and (total := re.search(r" total ([0-9.]+) ", line)):
            seconds[kind].append(float(total[1]))
    _, status, usage = os.wait4(process.pid, 0)
    if status != 0:
        sys.exit(f"{folder}/remesh-bench failed")
    return min(seconds["original"]), min(seconds["remesh"]), usage.ru_maxrss


def compare_speed(before, after, rounds, sizes):
    for nodes in sizes:
        ratios = []
        for k in range(rounds):
            order = (before, after) if k % 2 == 0 else (after, before)
            used = {folder: run_once(folder, nodes) for folder in order}
            ratios.append([a / b for a, b in zip(used[after], used[before])])
        first, remesh, memory = map(statistics.median, zip(*ratios))
        print(f"{nodes} nodes: first mesh {first:.3f}, remesh {remesh:.3f}, memory {memory:.3f} of "
              f"before; medians of {rounds} rounds", flush=True)


def main():
    options = sys.argv[1:]
    passed_on = []
    if "--" in options:
        at = options.index("--")
        options, passed_on = options[:at], options[at + 1:]
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("what", choices=["bytes", "speed"])
    parser.add_argument("before")
    parser.add_argument("after")
    parser.add_argument("--rounds", type=int, default=11)
    parser.add_argument("--sizes", type=int, nargs="+", default=[15000, 30000])
    chosen = parser.parse_args(options)
    if chosen.what == "bytes":
        sys.exit(1 if compare_bytes(chosen.before, chosen.after, passed_on) else 0)
    compare_speed(chosen.before, chosen.after, chosen.rounds, chosen.sizes)


if __name__ == "__main__":
    main()
