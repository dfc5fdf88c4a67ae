#!/usr/bin/env python3
"""check_documents.py REMESH CASES: `remesh schema` and `remesh example`. Exit 0 where all is well.

The schemas take every document of the cases and every example; what they refuse the daemon refuses
too (exit code 3). Each example is meshed.
"""
import copy
import json
import os
import subprocess
import sys
import tempfile
from pathlib import Path

from jsonschema import Draft202012Validator

CLI, CASES = (Path(p) for p in sys.argv[1:3])
NODES = "1500"

# For models that have groups; the daemon does not do them yet, the schemas do.
GROUPS = {"supports": "mount*.wall",
          "load": {"on": "base.top & z > 10", "policy": {"maxAreaChange": 0.2, "onEmptied": "fail"}}}
GROUP_EDITS = [{"setGroup": {"name": "load", "on": "pipe.top"}},
               {"setGroup": {"name": "load", "policy": {"onEmptied": "warn"}}},
               {"removeGroup": {"name": "load"}}]


def remesh(*arguments, folder, code=0):
    environment = dict(os.environ, REMESH_ADDRESS="local", XDG_CACHE_HOME=str(folder))
    done = subprocess.run([CLI, *map(str, arguments)], env=environment, capture_output=True, text=True)
    assert done.returncode == code, f"{arguments}: exit {done.returncode}\n{done.stderr}"
    return done


def changed(document, *path_and_value):
    """A copy with the value at a path replaced; `...` takes it away."""
    *path, last, value = path_and_value
    copied = copy.deepcopy(document)
    place = copied
    for key in path:
        place = place[key]
    if value is ...:
        del place[last]
    else:
        place[last] = value
    return copied


def wrong_models(model):
    """Documents that are nearly `model`, the example bracket; each has one fault."""
    at = ("features", 0)
    pipe = ("features", 6, "parameters", "height")
    size = [{"id": "s", "on": "hole.wall", "size": 1}]
    return [
        changed(model, "features", []),
        changed(model, "features", ...),
        changed(model, "colour", "red"),
        changed(model, *at, "id", "2nd"),
        changed(model, *at, "id", "x" * 65),
        changed(model, *at, "nature", "additive"),
        changed(model, *at, "nature", ...),
        changed(model, *at, "type", "cube"),
        changed(model, *at, "parameters", "dz", ...),
        changed(model, *at, "parameters", "radius", 3),
        changed(model, *at, "parameters", "dx", True),
        changed(model, *at, "parameters", "dx", None),
        changed(model, *pipe, 0),
        changed(model, *pipe, -2.5),
        changed(model, "features", 1, "placement", "origin", [0, 0]),
        changed(model, "features", 8, "parameters", "profile", [[0, 12], [1]]),
        changed(model, "features", 8, "parameters", "profile", "triangle"),
        changed(model, "parameters", "pi", 3),
        changed(model, "parameters", "wall", {"lower": 1}),
        changed(model, "parameters", "wall", "lower", "4"),
        changed(changed(model, *at, "reference", "CENTRE"), *at, "referencePoint", [0, 0, 0]),
        changed(model, "sizes", changed(size, 0, "size", ...)),
        changed(model, "sizes", changed(size, 0, "on", ...)),
        changed(model, "sizes", changed(size, 0, "in", {"ball": [0, 0, 0, 1]})),
        changed(model, "sizes", [{"id": "s", "in": {"ball": [0, 0, 0]}, "size": 1}]),
        changed(model, "sizes", changed(size, 0, "size", 0)),
        changed(model, "groups", {"load": 3}),
        changed(model, "groups", {"load": {"policy": {}}}),
        changed(model, "groups", {"load": {"on": "hole.wall", "policy": {"max": 1}}}),
    ]


def wrong_edits():
    cylinder = {"id": "pin", "nature": "ADDITIVE", "type": "cylinder", "parameters": {"radius": 1}}
    each = [
        {},
        {"setParameter": {"name": "wall"}},
        {"setParameter": {"name": "wall", "value": [8]}},
        {"setParameter": {"name": "wall", "value": 8}, "removeFeature": {"feature": "rib"}},
        {"setParameters": {"name": "wall", "value": 8}},
        {"setFeatureParameter": {"feature": "hole", "value": 8}},
        {"setPlacement": {"feature": "hole", "placement": {"origin": [0, 0, 0, 0]}}},
        {"removeFeature": {"id": "rib"}},
        {"addFeature": {"feature": cylinder}},
        {"setSize": {"on": "hole.wall", "size": 1}},
        {"removeSize": {"name": "s"}},
        {"setGroup": {"on": "hole.wall"}},
        {"removeGroup": {"id": "load"}},
    ]
    return [{"edits": []}, {}, *({"edits": [edit]} for edit in each)]


def check_refusals(validator, documents, folder, *base):
    for number, document in enumerate(documents):
        assert not validator.is_valid(document), f"the schema takes {document}"
        file = folder / f"wrong-{number}.json"
        file.write_text(json.dumps(document))
        remesh("validate", file, *base, folder=folder, code=3)


def main():
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        schemas = {kind: json.loads(remesh("schema", kind, folder=folder).stdout)
                   for kind in ("model", "edit")}
        assert json.loads(remesh("schema", folder=folder).stdout) == schemas["model"]
        for schema in schemas.values():
            Draft202012Validator.check_schema(schema)
        models, edits = (Draft202012Validator(schemas[kind]) for kind in ("model", "edit"))

        names = [line.split()[0] for line in remesh("example", folder=folder).stdout.splitlines()]
        for example in names:
            remesh("example", example, "-o", folder / f"{example}.json", folder=folder)
        examples = {example: json.loads((folder / f"{example}.json").read_text()) for example in names}
        documents = list(examples.values()) + [json.loads(file.read_text())
                                               for file in sorted(CASES.rglob("*.json"))]
        assert len(documents) > 40
        for document in documents:
            (edits if "edits" in document else models).validate(document)
        models.validate(changed(examples["bracket"], "groups", GROUPS))
        edits.validate({"edits": GROUP_EDITS})

        for example, document in examples.items():
            file, mesh = folder / f"{example}.json", folder / "mesh.vtu"
            if "edits" in document:
                base = folder / f"{example.removesuffix('.edit')}.json"
                remesh("edit", base, file, "--nodes", NODES, "-o", mesh, folder=folder)
            else:
                remesh("mesh", file, "--nodes", NODES, "-o", mesh, folder=folder)

        bracket = examples["bracket"]
        check_refusals(models, wrong_models(bracket), folder)
        check_refusals(edits, wrong_edits(), folder, "--base", folder / "bracket.json")
        # What both take in snake_case the daemon takes, and the schema says that it does not.
        snake = changed(bracket, "features", 8, "placement", {"z_axis": [0, -1, 0]})
        (folder / "snake.json").write_text(json.dumps(snake))
        remesh("validate", folder / "snake.json", folder=folder)
        assert not models.is_valid(snake)


main()
