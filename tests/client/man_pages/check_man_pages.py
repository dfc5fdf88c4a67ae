#!/usr/bin/env python3
"""check_man_pages.py REMESH FOLDER: a page for each command, which man shows without a complaint.

Exit 0 where all is well.
"""
import os
import re
import subprocess
import sys
from pathlib import Path

CLI, FOLDER = (Path(p) for p in sys.argv[1:3])


def commands():
    text = subprocess.run([CLI, "--help"], capture_output=True, text=True, check=True).stdout
    listed = re.search(r"^Subcommands:\n((?:  .*\n)+)", text, re.M)[1]
    return re.findall(r"^  (\w+)", listed, re.M)


def check(page):
    """The text of a page as a reader sees it."""
    environment = dict(os.environ, LC_ALL="C.UTF-8", MANWIDTH="100", MANROFFOPT="-ww")
    done = subprocess.run(["man", "--warnings", "--local-file", page], env=environment,
                          capture_output=True, text=True, check=True)
    assert not done.stderr, f"{page}: {done.stderr}"
    name = page.stem
    assert f"{name.upper()}({page.suffix[1]})" in done.stdout, page
    assert re.search(rf"^NAME\n\s+{name}\s+-\s+\S", done.stdout, re.M), done.stdout[:300]
    return done.stdout


def main():
    names = commands()
    assert len(names) > 20
    pages = sorted(FOLDER.glob("man*/*"))
    wanted = {"remesh.1", "remeshd.8", *(f"remesh-{name}.1" for name in names)}
    assert {page.name for page in pages} == wanted, pages
    for page in pages:
        text = check(page)
        assert page.name == "remeshd.8" or "remesh " in text


main()
