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
from subprocess import PIPE

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
    """The report without what a clock has a part in, and whether it came from the cache."""
    if isinstance(report, list):
        return [without_seconds(value) for value in report]
    if not isinstance(report, dict):
        return report
    timed = ("seconds", "geometry_seconds", "table3", "cached")
    return {key: without_seconds(value) for key, value in report.items() if key not in timed}


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
    remesh("edit", chains[0][0][0]["revision"], "--set", "hole_circle=38.01", "--seed", 3, "-o", folder / "same.vtu",
           "--json", folder / "r.json", address=address)
    by_words = json.loads((folder / "r.json").read_text())
    assert by_words["revision"] == chains[0][1][0]["revision"] and by_words["cached"], by_words
    ways = [report["way"] for report, _ in chains[0]]
    assert ways == ["WAY_LOCAL", "WAY_MORPHED", "WAY_LOCAL"], ways


def head(design, address):
    """Name and id of a design's head."""
    return remesh("head", design, address=address).stdout.split()


def check_sweep(folder, address):
    before = head("simple-a", address)
    done = remesh("sweep", CASES / "simple-a.json", "top_x", -10, 30, 3, "-o", folder / "sweep",
                  "--nodes", NODES, address=address)
    rows = [line.split("\t") for line in done.stdout.splitlines()]
    assert [row[:3] for row in rows[1:]] == [["1", "-10", "ok"], ["2", "10", "ok"], ["3", "30", "ok"]]
    check_maps(folder / "sweep" / "step-1.vtu", folder / "sweep" / "step-2.vtu")
    # The model falls apart in the second step.
    done = remesh("sweep", "simple-a", "top_x", 0, 400, 2, code=4, address=address)
    assert "DISCONNECTED_MODEL" in done.stdout.splitlines()[2]
    assert head("simple-a", address) == before, "a sweep moved the head"


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
    remesh("mesh", folder / "absent.json", "-o", folder / "x.vtu", code=8, address=address)
    remesh("mesh", CASES / "simple-a.json", "--timeout", 0.001, "-o", folder / "x.vtu", code=4,
           address=address)
    for arguments in (["info"], ["--help"], ["log", "simple-a"]):
        with open("/dev/full", "w") as full:
            done = subprocess.run([CLI, *arguments, "--address", address], stdout=full, stderr=PIPE)
        assert done.returncode == 8, (arguments, done)


def check_interrupt(folder, address):
    """An interrupt ends the command at once, with the daemon and without."""
    for way in ([], ["--local", "--store", folder / "interrupted"]):
        process = subprocess.Popen(
            [CLI, "mesh", CASES / "tool1-a.json", "--nodes", "400000", "-v", "-o", folder / "big.vtu", *way],
            env=dict(os.environ, REMESH_ADDRESS=address), stderr=subprocess.PIPE, text=True)
        for line in process.stderr:
            if "optimise" in line:
                break
        process.send_signal(signal.SIGINT)
        assert process.wait(20) == 130
        assert not (folder / "big.vtu").exists()


def check_order(folder, address):
    """Parameters come back in the order written, with all that was said of them."""
    wanted = {"zeta": 10, "alpha": {"value": "zeta/2", "lower": 1, "upper": 8, "unit": "mm"}, "mid": 4}
    block = {"id": "b", "nature": "ADDITIVE", "type": "block",
             "parameters": {"dx": "zeta", "dy": "alpha", "dz": "mid"}}
    model = {"name": "ordered", "parameters": wanted, "features": [block]}
    (folder / "ordered.json").write_text(json.dumps(model))
    remesh("mesh", folder / "ordered.json", "--nodes", NODES, "-o", folder / "o.vtu", address=address)
    text = remesh("model", "ordered", "-o", "-", address=address).stdout
    assert list(json.loads(text)["parameters"].items()) == list(wanted.items()), text
    (folder / "beyond.json").write_text(
        '{"edits": [{"setParameter": {"name": "alpha", "value": 9}}]}')
    done = remesh("edit", "ordered", folder / "beyond.json", "-o", folder / "o.vtu", code=3,
                  address=address)
    assert "alpha" in done.stderr and "8" in done.stderr, done.stderr


def check_heads(folder, address):
    """The head moves by request, by command, or not at all; what is there is what the commands say."""
    out = ["-o", folder / "h.vtu", "--nodes", NODES]
    edit = CASES / "simple-ab.edit.json"
    remesh("mesh", CASES / "simple-a.json", "--design", "h", *out, address=address)
    first = head("h", address)
    assert first[0] == "h@1", first
    # A model that the design did not begin with.
    remesh("mesh", CASES / "tool1-a.json", "--design", "h", "--fail-on", "HEAD_KEPT", *out, code=4,
           address=address)
    done = remesh("mesh", CASES / "tool1-a.json", "--design", "h", *out, address=address)
    assert head("h", address) == first
    command = re.search(r"remesh (head h@2)", done.stderr)
    assert command, done.stderr
    assert remesh(*command[1].split(), address=address).stdout.split()[0] == "h@2"
    assert head("h", address)[0] == "h@2"
    remesh("edit", "h@1", edit, "--require-head", *out, code=6, address=address)
    remesh("rm", "h@2", code=3, address=address)
    remesh("head", "h", first[1][:8], address=address)
    assert head("h", address) == first
    remesh("edit", "h@1", edit, "--require-head", *out, address=address)
    assert head("h", address)[0] == "h@3"
    remesh("mesh", CASES / "tool1-a.json", "--design", "h", "--head", *out, address=address)
    assert head("h", address)[0] == "h@2", "the same revision has one number in a design"
    assert "removed h with its 3 revisions" in remesh("rm", "--design", "h", address=address).stderr
    remesh("log", "h", code=3, address=address)
    remesh("head", "h", code=3, address=address)


def check_cache(folder, address):
    """Meshes go and come back, pinned ones stay, and a recipe tells what a revision is made of."""
    remesh("mesh", CASES / "simple-a.json", "--design", "c", "--nodes", NODES, "-o", folder / "c.vtu",
           address=address)
    remesh("edit", "c", CASES / "simple-ab.edit.json", "-o", folder / "c.vtu", address=address)
    recipe = json.loads(remesh("recipe", "c@2", address=address).stdout)
    first, second = recipe["parent"], recipe["revision"]
    assert recipe["edit"] == json.loads((CASES / "simple-ab.edit.json").read_text()), recipe
    assert remesh("remake", "c@2", address=address).stdout.split() == ["c@2", second]
    assert "stays" in remesh("cache", "pin", "c@1", address=address).stderr

    def states():
        text = remesh("cache", "ls", "--design", "c", "--json", "-", address=address).stdout
        return {entry["revision"]: entry["state"] for entry in json.loads(text)["entries"]}
    assert set(states().values()) == {"STATE_STORED"}, states()
    assert "freed MB" in remesh("cache", "gc", "--disk", 0, "--dry-run", address=address).stdout
    remesh("cache", "gc", "--disk", 0, address=address)
    assert states()[first] == "STATE_STORED" and states()[second] != "STATE_STORED", states()
    remesh("get", "c", "-o", folder / "again.vtu", address=address)
    assert (folder / "again.vtu").read_bytes() == (folder / "c.vtu").read_bytes()
    remesh("cache", "verify", address=address)
    stat = json.loads(remesh("cache", "stat", address=address).stdout)
    assert stat["pinned"] == 1 and int(stat["evictions"]) > 0, stat
    assert "may go" in remesh("cache", "pin", "--off", "c@1", address=address).stderr
    assert second[:12] in remesh("cache", "ls", address=address).stdout
    remesh("cache", "pin", "no-such-design", code=3, address=address)


def check_revisions(folder, address):
    assert "simple-a@1" in remesh("log", "simple-a", address=address).stdout
    remesh("model", "simple-a@1", "-o", folder / "model.json", address=address)
    written, original = (json.loads(p.read_text()) for p in (folder / "model.json", CASES / "simple-a.json"))
    assert written == original
    check_order(folder, address)
    remesh("get", "simple-a@1", "-o", folder / "get.inp", address=address)
    assert len(meshio.read(folder / "get.inp").points) > 0
    remesh("rm", "simple-a@1", address=address)
    remesh("get", "simple-a@1", "-o", folder / "get.inp", code=3, address=address)


def check_second_order(folder, address):
    """Tets of ten nodes in every format; an edit inherits them and keeps most of them where they were."""
    model, edit = case("tool1-ab")
    said = remesh("mesh", model, "--nodes", NODES, "--order", "2", "--design", "second", "-o", folder / "s.vtu",
                  address=address).stdout
    assert " on edges" in said, said
    base = meshio.read(folder / "s.vtu")
    points = set(map(tuple, base.points))
    remesh("edit", "second", edit, "-o", folder / "t.vtu", "--json", folder / "t.json", address=address)
    report = json.loads((folder / "t.json").read_text())
    assert (report["order"], report["straight_edges"]) == (2, 0), report
    nodes = report["nodes"] + report["mid_nodes"]
    for name in ("t.vtu", "t.msh", "t.inp"):
        if name != "t.vtu":
            remesh("get", "second", "-o", folder / name, address=address)
        mesh = meshio.read(folder / name)
        tets = sum(len(block.data) for block in mesh.cells if block.type == "tetra10")
        assert (len(mesh.points), tets) == (nodes, report["tets"]), name
    stayed = sum(tuple(p) in points for p in mesh.points)
    assert stayed > nodes / 2, f"{stayed} of {nodes} points are where they were"
    print(f"second order: {stayed} of {nodes} points are where they were")


def check_losses(folder, address):
    """What a model asks for and its mesh has not is told by a typed warning, and an error with --strict."""
    part = {
        "name": "losses", "parameters": {"pin_radius": 3, "hole_x": 0},
        "features": [
            {"id": "plate", "nature": "ADDITIVE", "type": "block",
             "parameters": {"dx": 60, "dy": 40, "dz": 8}},
            {"id": "pin", "nature": "ADDITIVE", "type": "cylinder",
             "parameters": {"radius": "pin_radius", "height": 12},
             "placement": {"origin": [20, 0, 2]}},
            {"id": "hole", "nature": "SUBTRACTIVE", "type": "cylinder",
             "parameters": {"radius": 5, "height": 12},
             "placement": {"origin": ["hole_x", 0, -2]}}],
        "groups": {"bore": "hole.wall"}}
    model, out = folder / "losses.json", folder / "losses.vtu"
    model.write_text(json.dumps(part))
    remesh("mesh", model, "--nodes", 800, "-o", out, address=address)
    tries = {
        "a pin as thin as nothing": (["--set", "pin_radius=1e-9"], "FEATURE_WITHOUT_EFFECT"),
        "a hole moved off the part": (["--set", "hole_x=100"], "FEATURE_WITHOUT_EFFECT"),
        "a group emptied": (["--remove", "hole"], "GROUP_EMPTIED"),
        "chords too coarse": (["--set", "hole.radius=6", "--edges-per-circle", 0, "--layers", 0,
                               "--size", 12], "CHORDS_COARSE"),
    }
    for what, (arguments, code) in tries.items():
        edit = ["edit", "losses@1", *arguments, "-o", out, "--keep-head"]
        report = json.loads(remesh(*edit, "--json", "-", address=address).stdout)
        codes = {warning["code"] for warning in report["warnings"]}
        assert code in codes, f"{what}: {codes}"
        refused = remesh(*edit, "--strict", code=4, address=address)
        assert any(code in refused.stderr for code in codes), refused.stderr


def check_pipes(folder, address):
    """A model comes through a pipe and its mesh goes out through one, in the same bytes as by files."""
    model = CASES / "simple-a.json"
    remesh("mesh", model, "--nodes", NODES, "-o", folder / "p.msh", address=address)
    with open(model, "rb") as source:
        done = subprocess.run([CLI, "mesh", "-", "--nodes", NODES, "-o", "-", "--format", "msh"], stdin=source,
                              env=dict(os.environ, REMESH_ADDRESS=address), capture_output=True, check=True)
    assert done.stdout == (folder / "p.msh").read_bytes()
    assert b"simple-a@" in done.stderr, done.stderr


def check_blame(folder, address):
    """Faces and nodes are traced to the edit that made them."""
    remesh("example", "bracket", "-o", folder / "bracket.json")
    meshes = [folder / f"{k}.vtu" for k in range(3)]
    remesh("mesh", folder / "bracket.json", "--nodes", NODES, "-o", meshes[0], address=address)
    (folder / "pin.edit.json").write_text(
        '{"edits": [{"addFeature": {"feature": {"id": "pin", "nature": "ADDITIVE", "type": "cylinder", '
        '"parameters": {"radius": 4, "height": 20}, "placement": {"origin": [-25, -20, 12]}}}}]}')
    remesh("edit", "bracket", folder / "pin.edit.json", "-o", meshes[1], address=address)
    remesh("edit", "bracket", "--set", "hole_radius=9", "-o", meshes[2], address=address)
    first, second, third = (set(meshio.read(mesh).point_data["node_id"].ravel()) for mesh in meshes)
    for what, revision, change in (("pin.top", "bracket@2", "+ pin"),
                                   ("rib.top", "bracket@1", "first mesh"),
                                   (max(third & second - first), "bracket@2", "+ pin"),
                                   (min(third & second & first), "bracket@1", "first mesh"),
                                   (max(third - second - first), "bracket@3", "hole_radius 10 -> 9")):
        told = remesh("blame", "bracket", what, address=address).stdout
        assert revision in told and change in told, f"{what}: {told}"
    done = remesh("blame", "bracket", "pin.topp", code=3, address=address)
    assert "did you mean `pin.top`?" in done.stderr, done.stderr


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
            check_order(folder, daemon.address)
            check_second_order(folder, daemon.address)
            check_heads(folder, daemon.address)
            check_losses(folder, daemon.address)
            check_cache(folder, daemon.address)
            check_pipes(folder, daemon.address)
            check_blame(folder, daemon.address)
            check_revisions(folder, daemon.address)
            daemon.end()
        finally:  # left alone it would keep ctest waiting for its output
            daemon.process.kill()


main()
