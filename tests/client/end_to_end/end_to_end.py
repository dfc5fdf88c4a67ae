#!/usr/bin/env python3
"""end_to_end.py REMESHD REMESH CASES: the executables as a user runs them. Exit 0 where all is well."""
import json
import os
import re
import signal
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import meshio

from kept import check_maps, check_mesh

DAEMON, CLI, CASES = (Path(p) for p in sys.argv[1:4])
NODES = "2500"


class Daemon:
    def __init__(self, folder):
        self.log = folder / "daemon.log"
        self.process = subprocess.Popen(
            [DAEMON, "--listen", "127.0.0.1:0", "--store", folder / "store", "--log-file", self.log])
        until = time.monotonic() + 30
        while time.monotonic() < until:
            found = self.log.exists() and re.search(r"serving .* on (\S+:\d+)", self.log.read_text())
            if found:
                self.address = found.group(1)
                return
            time.sleep(0.02)
        raise AssertionError("the daemon does not serve")

    def end(self):
        self.process.send_signal(signal.SIGTERM)
        assert self.process.wait(10) == 0


def remesh(*arguments, code=0, address=None):
    environment = dict(os.environ, REMESH_ADDRESS=address or "127.0.0.1:1")
    done = subprocess.run([CLI, *map(str, arguments)], env=environment, capture_output=True, text=True)
    assert done.returncode == code, f"{arguments}: exit {done.returncode}\n{done.stderr}"
    return done


def case(name):
    """`tool1-ac`: the model tool1-a and the edit that makes tool1-c."""
    stem, letters = name.rsplit("-", 1)
    return CASES / f"{stem}-{letters[0]}.json", CASES / f"{name}.edit.json"


def without_seconds(report):
    return {key: value for key, value in report.items() if key not in ("seconds", "cached")}


def check_case(name, folder, address):
    model, edit = case(name)
    before, after, report = folder / "a.vtu", folder / "b.vtu", folder / "b.json"
    remesh("mesh", model, "--nodes", NODES, "-o", before, address=address)
    remesh("edit", model, edit, "--nodes", NODES, "-o", after, "--json", report, address=address)
    report = json.loads(report.read_text())
    for mesh in (before, after):
        check_mesh(mesh)
    nodes, tets = check_maps(before, after)
    assert (report["nodes_kept"], report["tets_kept"]) == (nodes, tets)
    assert abs(report["volume"] / report["exact_volume"] - 1) < 0.01, report["volume"]
    print(f"{name}: {nodes} of {report['nodes']} nodes and {tets} of {report['tets']} tets kept")


def check_same_bytes(folder, address):
    """A chain of edits gives the same bytes in the daemon and with --local, and again from the store."""
    (folder / "continue.json").write_text(
        '{"edits": [{"setParameter": {"name": "hole_circle", "value": 38.01}}]}')
    model, first = case("tool1-ac")
    edits = [first, folder / "continue.json", case("tool1-ab")[1]]
    chains = []
    for way in ([], ["--local", "--store", folder / "local"], []):
        base, chain = model, []
        for edit in edits:
            remesh("edit", base, edit, *(["--nodes", NODES] if base == model else []), "--seed", 3,
                   "-o", folder / "same.vtu", "--json", folder / "r.json", *way, address=address)
            report = json.loads((folder / "r.json").read_text())
            chain.append((report, (folder / "same.vtu").read_bytes()))
            base = report["revision"]
        chains.append(chain)
    for here, local, again in zip(*chains):
        assert here[1] == local[1] == again[1]
        assert without_seconds(here[0]) == without_seconds(local[0]) == without_seconds(again[0])
        assert [r["cached"] for r, _ in (here, local, again)] == [False, False, True]
        assert here[0]["seconds"] == again[0]["seconds"], "a cached Report is the stored one"
    ways = [report["way"] for report, _ in chains[0]]
    assert ways == ["WAY_LOCAL", "WAY_CONTINUED", "WAY_LOCAL"], ways


def check_sweep(folder, address):
    done = remesh("sweep", CASES / "simple-a.json", "top_x", -10, 30, 3, "-o", folder / "sweep",
                  "--nodes", NODES, address=address)
    rows = [line.split("\t") for line in done.stdout.splitlines()]
    assert [row[:3] for row in rows[1:]] == [["1", "-10", "ok"], ["2", "10", "ok"], ["3", "30", "ok"]]
    check_maps(folder / "sweep" / "step-1.vtu", folder / "sweep" / "step-2.vtu")
    # The model falls apart in the second step.
    done = remesh("sweep", "simple-a", "top_x", 0, 400, 2, code=4, address=address)
    assert "DisconnectedModel" in done.stdout.splitlines()[2]


def check_refusals(folder, address):
    """Bad input is told in words and by its exit code, and the daemon goes on serving."""
    def document(name, text):
        (folder / name).write_text(text)
        return folder / name

    def block(dx, nature="ADDITIVE", more=""):
        return (f'{{"id": "a", "nature": "{nature}", "type": "block", '
                f'"parameters": {{"dx": {dx}, "dy": 1, "dz": 1{more}}}}}')

    def model(*features):
        return '{"name": "m", "features": [' + ", ".join(features) + "]}"

    bad = {
        "negative": model(block(-1)),
        "nan": model(block("NaN")),
        "nan_expression": model(block('"sqrt(-1)"')),
        "null": model(block("null")),
        "extra": model(block(1, more=', "radius": 2')),
        "twice": model(block(1), block(2)),
        "cycle": '{"name": "m", "parameters": {"p": "q", "q": "p"}, "features": [' + block('"p"') + "]}",
        "empty": model(block(1, "SUBTRACTIVE")),
        "deep": "[" * 100_000,
        "comma": model(block(1)) + ",",
        "large": " " * 100_000_000,
    }
    for name, text in bad.items():
        done = remesh("mesh", document(name + ".json", text), "-o", folder / "x.vtu", code=3,
                      address=address)
        assert done.stderr.strip() and not done.stdout
        assert not (folder / "x.vtu").exists()
    remove = document("remove.json", '{"edits": [{"removeFeature": {"feature": "base"}}, '
                                     '{"removeFeature": {"feature": "top"}}]}')
    unknown = document("unknown.json", '{"edits": [{"removeFeature": {"feature": "hole"}}]}')
    for edit in (remove, unknown):
        remesh("edit", CASES / "simple-a.json", edit, "--nodes", NODES, "-o", folder / "x.vtu", code=3,
               address=address)
    done = remesh("edit", "no-such-design", unknown, "-o", folder / "x.vtu", code=3, address=address)
    remesh("revisions", code=5)
    assert "block" in remesh("types", address=address).stdout


def check_interrupt(folder, address):
    """An interrupt ends the command at once, with the daemon and without."""
    for way in ([], ["--local", "--store", folder / "interrupted"]):
        process = subprocess.Popen(
            [CLI, "mesh", CASES / "tool1-a.json", "--nodes", "400000", "-o", folder / "big.vtu", *way],
            env=dict(os.environ, REMESH_ADDRESS=address), stderr=subprocess.PIPE, text=True)
        for line in process.stderr:
            if "optimise" in line:
                break
        process.send_signal(signal.SIGINT)
        assert process.wait(20) == 130
        assert not (folder / "big.vtu").exists()


def check_revisions(folder, address):
    assert "simple-a@1" in remesh("log", "simple-a", address=address).stdout
    remesh("model", "simple-a@1", "-o", folder / "model.json", address=address)
    written, original = (json.loads(p.read_text()) for p in (folder / "model.json", CASES / "simple-a.json"))
    assert written == original
    remesh("get", "simple-a@1", "-o", folder / "get.inp", address=address)
    assert len(meshio.read(folder / "get.inp").points) > 0
    remesh("rm", "simple-a@1", address=address)
    remesh("get", "simple-a@1", "-o", folder / "get.inp", code=3, address=address)


def main():
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        daemon = Daemon(folder)
        try:
            for name in ("simple-ab", "tool1-ab", "tool1-ac", "tool2-ab", "tool2-bc", "tool2-cd", "tool3-ab"):
                check_case(name, folder, daemon.address)
            check_same_bytes(folder, daemon.address)
            check_sweep(folder, daemon.address)
            check_refusals(folder, daemon.address)
            check_interrupt(folder, daemon.address)
            check_revisions(folder, daemon.address)
            daemon.end()
        finally:  # left alone it would keep ctest waiting for its output
            daemon.process.kill()


main()
