#!/usr/bin/env python3
"""report_page.py REMESHD REMESH CASES PICTURES: the page of a real edit in a browser, from a file.

Leaves pictures of it in the folder PICTURES, for people to look at. Exit 0 where all is well.
"""
import json
import re
import signal
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import matplotlib.image
import meshio
import numpy as np

from browser import Browser

DAEMON, CLI, CASES, PICTURES = (Path(p).resolve() for p in sys.argv[1:5])


class Daemon:
    def __init__(self, folder):
        port = folder / "port"
        self.process = subprocess.Popen(
            [DAEMON, "--listen", "127.0.0.1:0", "--port-file", port, "--log-file", folder / "log"])
        until = time.monotonic() + 30
        while not (port.exists() and port.read_text().strip()):
            assert time.monotonic() < until and self.process.poll() is None, "no daemon"
            time.sleep(0.02)
        self.address = port.read_text().strip()

    def remesh(self, *arguments):
        subprocess.run([CLI, "--address", self.address, "-q", *map(str, arguments)], check=True,
                       stdout=subprocess.DEVNULL)

    def end(self):
        self.process.send_signal(signal.SIGTERM)
        assert self.process.wait(10) == 0


def make(folder):
    """Meshes, their Reports and the pages, in a folder."""
    daemon = Daemon(folder)
    try:
        daemon.remesh("mesh", CASES / "tool1-a.json", "--nodes", 2500, "-o", folder / "base.vtu")
        daemon.remesh("edit", "tool1-a", CASES / "tool1-ac.edit.json", "-o", folder / "new.vtu",
                      "--json", folder / "new.json")
        daemon.remesh("report", "tool1-a@1", "tool1-a@2", "-o", folder / "edit.html")
        daemon.remesh("report", "tool1-a@1", "-o", folder / "first.html")
        daemon.remesh("report", "tool1-a@2", "--surfaces", "-o", folder / "surfaces.html")
    finally:
        daemon.end()
    return json.loads((folder / "new.json").read_text())


def read_faces(browser):
    """Number of faces drawn, by mesh."""
    return [int(n) for n in browser.wait_for("document.querySelector('.views').dataset.faces").split()]


def faces_behind(file, axis, side, middle):
    """Faces between tets whose centroid lies behind a plane and what is not."""
    mesh = meshio.read(file)
    tets = mesh.cells_dict["tetra"]
    centroids = mesh.points[tets].mean(axis=1)[:, axis]
    behind = tets[side * (centroids - middle) <= 0]
    faces = np.sort(np.concatenate([np.delete(behind, k, axis=1) for k in range(4)]), axis=1)
    return int((np.unique(faces, axis=0, return_counts=True)[1] == 1).sum())


def share(part, whole):
    return f"{100 * part / whole:.1f} %"


def check_texts(browser, report):
    text = browser.evaluate("document.body.innerText")
    title = browser.evaluate("document.title")
    assert title == "tool1-a@1 \u2192 tool1-a@2", title
    for words in ("What changed", "hole_circle", "38", "hole_turn", "15", "local", "Warnings",
                  share(report["nodes_kept"], report["nodes"]), share(report["tets_kept"], report["tets"]),
                  f'{report["tets"]:,}', "Groups: ", "hole1.wall", "Volume-length, mean",
                  "Dihedral angles", "Seconds by phase", "three-mesh-bvh", "MIT"):
        assert words in text, f"the page lacks `{words}`"
    order = [text.index(heading) for heading in
             ("What changed", "Figures of the meshes", "Groups: ", "Meshes\n", "Quality\n", "Time\n", "Worst tets")]
    assert order == sorted(order), order
    assert browser.evaluate("document.documentElement.lang") == "en"
    rows = browser.evaluate("document.querySelectorAll('.fly').length")
    assert rows == 20, rows


def check_cut(browser, folder, report):
    assert read_faces(browser)[1] == report["boundary_facets"]
    sides = {"y": -1, "z": 1}  # away from the camera, so that the cut is seen
    for axis, side in sides.items():
        browser.open(folder / "edit.html", f"#cut={axis}")
        k = "xyz".index(axis)
        middle = np.mean([f(meshio.read(folder / "base.vtu").points[:, k]) for f in (np.min, np.max)])
        for file, shown in zip(("base.vtu", "new.vtu"), read_faces(browser)):
            expected = faces_behind(folder / file, k, side, middle)
            # Single floats may put a centroid to the other side of the plane.
            assert abs(shown - expected) <= 8, f"{axis}, {file}: {shown} faces for {expected}"


def check_colours(browser):
    """Each mode draws, and its legend is there."""
    for mode, words in (("quality", "volume-length"), ("feature", "hub"), ("face", "hole1.wall"),
                        ("size", "logarithmic"), ("state", "Kept")):
        browser.open(browser.page, f"#colour={mode}")
        legend = browser.evaluate("document.querySelector('.legend').innerText")
        assert words in legend, f"{mode}: {legend}"
    browser.evaluate("document.querySelector('.legend button').click()")
    assert browser.evaluate("document.querySelectorAll('.legend [aria-pressed=true]').length") == 1


def check_keys(browser):
    """A worst tet is reached by keys alone, and left again."""
    picture = "document.querySelector('.views canvas').toDataURL()"
    before = browser.evaluate(picture)
    browser.evaluate("document.querySelector('.fly').focus()")
    browser.press("Enter")
    browser.drawn()
    assert browser.evaluate("document.activeElement.tagName") == "CANVAS"
    there = browser.evaluate(picture)
    assert there != before, "nothing flew"
    browser.press("ArrowLeft")
    browser.drawn()
    assert browser.evaluate(picture) != there, "nothing turned"
    browser.press("Escape")
    browser.press("Home")
    browser.drawn()
    assert browser.evaluate("document.querySelectorAll('.fly[aria-current]').length") == 0


def check_picture(file):
    """The meshes are in it: pixels of the colour of what has gone of the base."""
    red, green, blue = np.moveaxis(matplotlib.image.imread(file)[:, :, :3], 2, 0)
    gone = (red > 0.55) & (green < 0.55 * red) & (blue < 0.2)
    assert gone.sum() > 1500, f"{file}: {gone.sum()} pixels"


def check_pictures(browser, folder):
    for scheme in ("light", "dark"):
        for name, width in (("wide", 1400), ("narrow", 420)):
            browser.look(width, 900, scheme)
            browser.open(folder / "edit.html")
            browser.evaluate("document.getElementById('meshes').scrollIntoView()")
            file = PICTURES / f"{scheme}-{name}.png"
            browser.picture(file)
            check_picture(file)
            beyond = browser.evaluate("document.documentElement.scrollWidth - innerWidth")
            assert beyond <= 0, f"{file.name}: the page is {beyond} pixels too wide"


def check_others(browser, folder):
    browser.open(folder / "first.html")
    text = browser.evaluate("document.body.innerText")
    assert "A first mesh" in text and "BASE" not in text, text[:500]
    browser.open(folder / "surfaces.html", "#worst=1")
    text = browser.evaluate("document.body.innerText")
    assert "the interior was left out" in text and "Cutting plane" not in text, text[:500]
    broken = (folder / "edit.html").read_text(encoding="utf-8")
    broken = re.sub(r'(id="data-base-tets">.{40}).{8}', r"\1AAAAAAAA", broken)
    (folder / "broken.html").write_text(broken, encoding="utf-8")
    assert not browser.problems, browser.problems
    browser.open(folder / "broken.html")
    assert browser.evaluate("document.documentElement.dataset.state") == "failed"
    assert "cannot be shown" in browser.evaluate("document.body.innerText")


def main():
    PICTURES.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        report = make(folder)
        browser = Browser()
        try:
            browser.page = folder / "edit.html"
            browser.look(1400, 900, "light")
            browser.open(browser.page)
            assert browser.evaluate("document.documentElement.dataset.state") == "ready"
            check_texts(browser, report)
            check_cut(browser, folder, report)
            check_colours(browser)
            check_keys(browser)
            check_pictures(browser, folder)
            check_others(browser, folder)
            asked = {url.split(":")[0] for url in browser.requests if url != "about:blank"}
            assert asked <= {"file", "data", "blob"}, asked
        finally:
            browser.close()


main()
