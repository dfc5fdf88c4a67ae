#!/usr/bin/env python3
"""check_calculix.py REMESH CCX: CalculiX solves on our .inp, of tets of four and of ten nodes.

The bracket is held and pressed by its groups, the walls of its mounts and the rim of its pipe; the
reactions balance the load. Exit 0 where all is well.
"""
import math
import re
import sys
import tempfile
from pathlib import Path

from commands import mesh_bracket, run

CLI, CCX = (Path(p) for p in sys.argv[1:3])
PRESSURE = 2.0
RIM = math.pi * (16**2 - 10**2)  # area that is pressed
JOB = "\n".join([
    "*INCLUDE, INPUT=part.inp",
    "*MATERIAL, NAME=STEEL", "*ELASTIC", "210000., .3",
    "*SOLID SECTION, ELSET=remesh_all, MATERIAL=STEEL",
    "*BOUNDARY", "supports, 1, 3",
    "*STEP", "*STATIC",
    "*DSLOAD", f"load, P, {PRESSURE}",
    "*NODE PRINT, NSET=supports, TOTALS=ONLY", "RF",
    "*END STEP", ""])


def reaction(folder):
    """Force on the supports along z, as the run printed it."""
    text = (folder / "job.dat").read_text()
    found = re.search(r"total force .*\n\s*\n\s*(\S+)\s+(\S+)\s+(\S+)", text)
    assert found, text
    return float(found[3])


def check(folder, order, element, most):
    mesh_bracket(CLI, folder, "--size", 6, "--order", order, "-o", "part.inp")
    assert re.findall(r"^\*ELEMENT, TYPE=(\w+)", (folder / "part.inp").read_text(), re.M) == [element]
    (folder / "job.inp").write_text(JOB)
    said = run(CLI, folder, CCX, "job")
    assert "Job finished" in said, said
    assert not re.search(r"\*(ERROR|WARNING)", said), said
    assert abs(reaction(folder) / (PRESSURE * RIM) - 1) < most, reaction(folder)


def main():
    for order, element, most in ((1, "C3D4", 0.1), (2, "C3D10", 0.001)):
        with tempfile.TemporaryDirectory() as name:
            check(Path(name), order, element, most)


main()
