"""How an error of each reason, and each warning, is come by: documents and commands. Those that take an unlucky moment
or a broken machine are not here."""
import json
from dataclasses import dataclass, field

from mistakes import changed

PART = {"name": "part", "parameters": {"wall": {"value": 8, "lower": 4, "upper": 12}},
        "features": [{"id": "plate", "nature": "ADDITIVE", "type": "block",
                      "parameters": {"dx": 60, "dy": 40, "dz": "wall"}},
                     {"id": "hole", "nature": "SUBTRACTIVE", "type": "cylinder",
                      "parameters": {"radius": 8, "height": "wall"}}],
        "sizes": [{"id": "fine", "on": "hole.wall", "size": 2}],
        "groups": {"load": {"on": "plate.top", "policy": {"maxAreaChange": 0.1}}}}
MESH = ("mesh", "part.json", "--nodes", "500", "-o", "part.vtu")
VALIDATE = ("validate", "part.json")
PLATE, HOLE = ("features", 0), ("features", 1)


@dataclass
class Example:
    """The last command shows it; those before it have to go well. `daemon`: options of a remeshd for it alone; such
    an example is run by --write only."""

    files: dict
    commands: list
    daemon: tuple = ()
    environment: dict = field(default_factory=dict)


def of_model(*path_and_value, command=VALIDATE):
    *path, value = path_and_value
    return Example({"part.json": changed(PART, path, value)}, [command])


def of_text(old, new):
    text = json.dumps(PART)
    assert old in text, old
    return Example({"part.json": text.replace(old, new)}, [VALIDATE])


def of_edit(*edits, more=()):
    return Example({"part.json": PART, "edit.json": {"edits": edits}},
                   [("validate", "edit.json", "--base", "part.json", *more)])


def of_parts(*commands, **others):
    return Example({"part.json": PART}, list(commands), **others)


def profile(points, kind="prism"):
    size = {"height": 4} if kind == "prism" else {}
    return of_model(*HOLE, {"id": "web", "nature": "ADDITIVE", "type": kind,
                            "parameters": {"profile": points, **size}})


def edit(base, *options):
    return ("edit", base, *options, "-o", "next.vtu")


REQUESTS = {
    "MESH_TOO_LARGE": of_parts(("validate", "part.json", "--size", "0.01")),
    "WARNING_IS_ERROR": of_parts(MESH, edit("part", "--remove", "hole", "--strict")),
    "COMPUTE_LIMIT_REACHED": of_parts(("mesh", "part.json", "--nodes", "500000", "-o", "part.vtu"),
                                      daemon=("--compute-limit", "1")),
    "TETGEN_MISSING": of_parts((*MESH, "--inside", "control-mesh"), daemon=("--workers", "1"),
                               environment={"REMESHD_TETGEN": "/nowhere/remeshd-tetgen"}),
}
REVISIONS = {
    "REVISION_NOT_FOUND": of_parts(MESH, ("get", "part@9", "-o", "part.vtu")),
    "REVISION_MISSING": of_parts(("model", "", "-o", "part.json")),
    "DESIGN_NOT_FOUND": of_parts(("log", "bracket")),
    "DESIGN_EMPTY": of_parts(MESH, ("rm", "part@1", "--allow-head"), edit("part", "--set", "wall=9"),
                             daemon=("--workers", "1")),
    "DESIGN_NAME_INVALID": of_parts((*MESH, "--design", "0123abcd")),
    "HEAD_PROTECTED": of_parts(MESH, ("rm", "part"), daemon=("--workers", "1")),
    "HEAD_CONFLICT": of_parts(MESH, edit("part", "--set", "wall=9"),
                              edit("part@1", "--set", "wall=10", "--require-head"), daemon=("--workers", "1")),
}
DOCUMENTS = {
    "DOCUMENT_TOO_LARGE": Example({"part.json": " " * (4 << 20) + json.dumps(PART)}, [VALIDATE]),
    "DOCUMENT_TOO_DEEP": of_model(*PLATE, "parameters", "dx", eval("[" * 50 + "]" * 50)),
    "DOCUMENT_MALFORMED": of_text('"dy": 40', '"dy": 40,'),
    "DOCUMENT_UNREADABLE": Example({}, [VALIDATE]),
    "DUPLICATE_KEY": of_text('"dy": 40', '"dy": 40, "dy": 50'),
    "UNKNOWN_FIELD": of_model(*PLATE, "origin", [0, 0, 0]),
    "MISSING_FIELD": of_model(*PLATE, "nature", ...),
    "WRONG_KIND": of_model("parameters", "wall", "upper", "2*wall"),
    "NO_EDITS": of_edit(),
}
MODELS = {
    "INVALID_NAME": of_model(*PLATE, "id", "2nd"),
    "DUPLICATE_FEATURE": of_model(*HOLE, "id", "plate"),
    "DUPLICATE_NAME": of_model("groups", {"hole": "hole.wall"}),
    "UNKNOWN_FEATURE": of_edit({"removeFeature": {"feature": "holes"}}),
    "UNKNOWN_FEATURE_TYPE": of_model(*PLATE, "type", "box"),
    "UNKNOWN_PARAMETER": of_edit({"setParameter": {"name": "walls", "value": 9}}),
    "UNKNOWN_SIZE": of_edit({"removeSize": {"id": "coarse"}}),
    "UNKNOWN_GROUP": of_edit({"removeGroup": {"name": "loads"}}),
    "UNKNOWN_NAME": of_model(*PLATE, "parameters", "dx", "5*width"),
    "MISSING_PARAMETER": of_model(*HOLE, "parameters", "height", ...),
    "NON_FINITE_VALUE": of_model(*PLATE, "parameters", "dx", "60/(wall - 8)"),
    "VALUE_OUT_OF_RANGE": of_edit({"setParameter": {"name": "wall", "value": 20}}),
    "BOUNDS_INVALID": of_model("parameters", "wall", "lower", 13),
    "INVALID_EXPRESSION": of_model(*PLATE, "parameters", "dx", "8*sin(30"),
    "CYCLIC_PARAMETERS": of_model("parameters", {"wall": "2*depth", "depth": "wall/2"}),
    "DEGENERATE_FEATURE": of_model(*HOLE, "parameters", "radius", 0),
    "DEGENERATE_FRAME": of_model(*HOLE, "placement", {"zAxis": [0, 0, 0]}),
    "INVALID_PROFILE": profile([[0, 0], [10, 0]]),
    "SELF_INTERSECTING_PROFILE": profile([[0, 0], [9, 9], [9, 0], [0, 9]]),
    "PROFILE_CROSSES_AXIS": profile([[-1, 0], [9, 0], [9, 9]], "revolution"),
    "NO_FEATURES": of_model("features", []),
    "NO_ADDITIVE_FEATURE": of_model(*PLATE, "nature", "SUBTRACTIVE"),
    "LIMIT_EXCEEDED": of_model("groups", {f"group{k}": "plate.top" for k in range(1001)}),
    "SELECTOR_INVALID": of_model("groups", {"load": "plate.top &"}),
    "SELECTOR_EMPTY": of_model("groups", {"load": "plates.top"}, command=MESH),
    "POLICY_BROKEN": of_parts(MESH, edit("part", "--set", "plate.dx=80")),
    "EMPTY_MODEL": of_model(*HOLE, "parameters", "radius", 80, command=MESH),
    "DISCONNECTED_MODEL": of_model(*HOLE, "type", "block", command=MESH),
    "NON_MANIFOLD_MODEL": of_model(*HOLE, "placement", {"origin": [22, 0, 0]}, command=MESH),
}
BLOCK = {"dx": 10, "dy": 60, "dz": "wall"}
MODELS["DISCONNECTED_MODEL"].files["part.json"]["features"][1]["parameters"] = BLOCK
TOKENS = {"part.json": PART, "tokens": "lab 0123456789abcdef\n", "mine": "fedcba9876543210\n"}
OPERATION = {
    "CREDENTIALS_MISSING": Example(TOKENS, [VALIDATE], ("--token-file", "tokens")),
    "CREDENTIALS_INVALID": Example(TOKENS, [("--token-file", "mine", *VALIDATE)], ("--token-file", "tokens")),
    "STORE_FOREIGN": Example({"part.json": PART, "store/notes.txt": "mine"},
                             [("--local", "--store", "store", *MESH)]),
    "STORE_LOCKED": Example({"part.json": PART}, [("--local", "--store", "../store", "--timeout", "1", *MESH)],
                            ("--store", "store")),
}
# What `remeshd` says and ends with when it starts: options.
OF_REMESHD = {
    "LISTEN_FAILED": ("--listen", "unix:/nowhere/remeshd.sock"),
    "LISTEN_INVALID": ("--listen", "localhost"),
}
ERRORS = REQUESTS | REVISIONS | DOCUMENTS | MODELS | OPERATION

# With a daemon alone: what another example has filed, and numbers that hold for one version of the algorithm.
ALONE = ("--workers", "1")
OTHER = changed(PART, (*PLATE, "parameters", "dx"), 70)
AWAY = {"edits": [{"setPlacement": {"feature": "hole", "placement": {"origin": [90, 0, 0]}}}]}
BALL = {"name": "ball", "features": [{"id": "ball", "nature": "ADDITIVE", "type": "sphere",
                                      "parameters": {"radius": 10}}]}
RING = {"name": "ring", "features": [{"id": "ring", "nature": "ADDITIVE", "type": "torus",
                                      "parameters": {"major_radius": 10, "minor_radius": 4}}]}
GROUPED = changed(changed(PART, ("sizes",), []), ("groups",), {"load": "hole.wall"})
WARNINGS = {
    "GROUP_EMPTIED": Example({"part.json": GROUPED}, [MESH, edit("part", "--remove", "hole")], ALONE),
    "FACE_LOST": of_parts(MESH, edit("part", "--remove", "hole"), daemon=ALONE),
    "FEATURE_WITHOUT_EFFECT": Example({"part.json": PART, "away.json": AWAY},
                                      [MESH, edit("part", "away.json")], ALONE),
    "FALLBACK": Example({"part.json": BALL}, [("mesh", "part.json", "--even", "--nodes", "60", "-o", "part.vtu")],
                        ALONE),
    "DETAIL_NOT_RESOLVED": of_parts((*MESH, "--min-size", "10")),
    "NODES_FAR_FROM_TARGET": of_parts(("mesh", "part.json", "--nodes", "30", "-o", "part.vtu"), daemon=ALONE),
    "EDGES_STRAIGHT": Example({"part.json": RING}, [("mesh", "part.json", "--even", "--nodes", "200", "--order", "2",
                                                     "-o", "part.vtu")], ALONE),
    "HOLD_ENDED": of_parts((*MESH, "--hold", "1"), edit("part", "--remove", "hole"), daemon=ALONE),
    "HEAD_KEPT": Example({"part.json": PART, "other.json": OTHER},
                         [MESH, ("mesh", "other.json", "--nodes", "500", "-o", "part.vtu")], ALONE),
}
