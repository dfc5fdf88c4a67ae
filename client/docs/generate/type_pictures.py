#!/usr/bin/python3
"""type_pictures.py [TYPE...]: draws the sample of each type to ../model/TYPE.png, and the page's `lug`, meshed by the
daemon of the Python client (`remeshd` on PATH). Each file names its model and its faces, by which model_page.py tells
whether it is still of today."""
import json
import sys

import numpy as np
import remesh_client as rc
from PIL import Image, PngImagePlugin

import drawing
import type_samples
from page import DOCS, named_models

FOLDER = DOCS / "model"


def picture(daemon, model, views):
    """The picture, and the names of the part's faces: without `part.` where that is all of it."""
    mesh = daemon.mesh(model, nodes=1500, file=False).mesh()
    owner = np.full(len(mesh.facets), -1)
    faces = sorted(mesh.faces)
    for index, face in enumerate(faces):
        owner[mesh.faces[face].facet_indices] = index
    assert (owner >= 0).all()
    names = [face.removeprefix("part.") for face in faces]
    return drawing.draw_faces(mesh.points, mesh.facets, owner, names, views), names


def main():
    FOLDER.mkdir(exist_ok=True)
    models = {name: type_samples.model(name) for name in type_samples.SAMPLES}
    models["lug"] = named_models((DOCS / "model.md").read_text())["lug"]
    with rc.local() as daemon:
        for name in sys.argv[1:] or models:
            image, faces = picture(daemon, models[name], drawing.ONE if name == "lug" else drawing.BOTH)
            facts = PngImagePlugin.PngInfo()
            facts.add_text("Model", json.dumps(models[name], sort_keys=True))
            facts.add_text("Faces", " ".join(faces))
            file = FOLDER / f"{name}.png"
            few = image.quantize(64, method=Image.Quantize.MAXCOVERAGE, dither=0)
            few.save(file, optimize=True, pnginfo=facts)
            print(file.name, file.stat().st_size, *faces)


if __name__ == "__main__":
    main()
