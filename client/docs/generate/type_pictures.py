#!/usr/bin/python3
"""type_pictures.py [TYPE...]: draws the sample of each type to ../model/TYPE.png, meshed by the daemon of the
Python client (`remeshd` on PATH). Each file names its model and its faces, by which model_page.py tells whether it
is still of today."""
import json
import sys
from pathlib import Path

import numpy as np
import remesh_client as rc
from PIL import Image, PngImagePlugin

import drawing
import type_samples

FOLDER = Path(__file__).resolve().parent.parent / "model"


def picture(daemon, name):
    """The picture, and the names of the part's faces in the mesh."""
    part = daemon.mesh(type_samples.model(name), nodes=1500, file=False)
    mesh = part.mesh()
    faces = sorted(mesh.faces)
    owner = np.full(len(mesh.facets), -1)
    for index, face in enumerate(faces):
        owner[mesh.faces[face].facet_indices] = index
    assert (owner >= 0).all()
    names = [face.removeprefix("part.") for face in faces]
    return drawing.draw_faces(mesh.points, mesh.facets, owner, names), names


def main():
    FOLDER.mkdir(exist_ok=True)
    with rc.local() as daemon:
        for name in sys.argv[1:] or type_samples.SAMPLES:
            image, faces = picture(daemon, name)
            facts = PngImagePlugin.PngInfo()
            facts.add_text("Model", json.dumps(type_samples.model(name), sort_keys=True))
            facts.add_text("Faces", " ".join(faces))
            file = FOLDER / f"{name}.png"
            image.quantize(64, method=Image.Quantize.MAXCOVERAGE, dither=0).save(file, optimize=True, pnginfo=facts)
            print(file.name, file.stat().st_size, *faces)


main()
