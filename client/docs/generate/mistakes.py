"""What is often written wrong: a change of the lug of ../model.md, and the error it gets."""
import copy
import json
import re

# What it is; what is written, for the reader; path in the model and value there, or `...` to remove it.
MISTAKES = (
    ("a name that is not defined", '"dz": "thikness"', ("features", 0, "parameters", "dz"), "thikness"),
    ("a parameter of another type", '"r": 4', ("features", 3, "parameters", "r"), 4),
    ("a parameter too few", 'no `height`', ("features", 3, "parameters", "height"), ...),
    ("a type that there is not", '"type": "box"', ("features", 0, "type"), "box"),
    ("small letters", '"nature": "additive"', ("features", 0, "nature"), "additive"),
    ("a field at the wrong place", '`"origin"` beside `"placement"`', ("features", 3, "origin"), [1, 2, 3]),
    ("a value out of its bounds", '"thick": {"value": 20, "upper": 12}', ("parameters", "thick", "value"), 20),
    ("a circle of parameters", '"width": "height", "height": "2*width"', ("parameters",),
     {"width": "height", "height": "2*width", "thick": 8, "bore_radius": 9}),
    ("degrees for radians, one bracket short", '"height": "8*sin(30"', ("features", 3, "parameters", "height"),
     "8*sin(30"),
    ("an expression for a bound", '"upper": "2*width"', ("parameters", "thick", "upper"), "2*width"),
    ("an outline that crosses itself", '"profile": [[0, 0], [9, 9], [9, 0], [0, 9]]',
     ("features", 1, "parameters", "profile"), [[0, 0], [9, 9], [9, 0], [0, 9]]),
    ("two axes in one direction", '"zAxis": [0, 0, 1], "xAxis": [0, 0, 2]', ("features", 1, "placement"),
     {"zAxis": [0, 0, 1], "xAxis": [0, 0, 2]}),
    ("a selector that fits nothing", '"supports": "holes*.wall"', ("groups", "supports"), "holes*.wall"),
    ("a part beside the part", '`base` moved away', ("features", 0, "placement"), {"origin": [0, 0, -50]}),
    ("a hole that touches a side", '`mount1`: `"origin": [41, 0, 0]`', ("features", 3, "placement"),
     {"origin": [41, 0, 0]}),
)
# Of text that is not JSON as it should be: what, and (text, its replacement).
TEXTS = (
    ("a comma too many", '`"groups": {...},}`', ('"fail"}}}', '"fail"}}},')),
    ("a key twice", '"width": 40, "width": 50', ('"width": 40', '"width": 40, "width": 50')),
)


def changed(model, path, value):
    copied = copy.deepcopy(model)
    *outer, last = path
    place = copied
    for key in outer:
        place = place[key]
    if value is ...:
        del place[last]
    else:
        place[last] = value
    return copied


def message(text, remesh):
    """Its reason, and what `remesh validate`, or else a mesh of few nodes, says of it, without the place."""
    (remesh.folder / "lug.json").write_text(text)
    code, _, err = remesh.run("-v", "validate", "lug.json", "--nodes", 500)
    if code == 0:
        code, _, err = remesh.run("-v", "mesh", "lug.json", "--nodes", 500, "-o", "lug.vtu")
    assert code == 3, f"exit {code}\n{text}\n{err}"
    lines = [re.sub(r"^(lug.json:[0-9:]+ )?(line \d+, column \d+: )?", "", line.removeprefix("remesh: "))
             for line in err.splitlines() if line.startswith("remesh: ")]
    return re.search(r"^code \w+, reason (\w+),", err, re.MULTILINE)[1], lines


def table(model, remesh):
    """Rows of Markdown."""
    rows = ["| mistake | written | error | reason |", "|---|---|---|---|"]
    whole = json.dumps(model)
    for what, written, path, value in MISTAKES:
        rows.append(row(what, written, *message(json.dumps(changed(model, path, value), indent=1), remesh)))
    for what, written, (old, new) in TEXTS:
        assert old in whole, f"{old} is not in {whole}"
        rows.append(row(what, written, *message(whole.replace(old, new), remesh)))
    return "\n".join(rows)


def row(what, written, reason, lines):
    shown = written if "`" in written else f"`{written}`"
    said = "<br>".join(f"`{line}`".replace("|", "\\|") for line in lines)
    return f"| {what} | {shown} | {said} | [{reason}](errors.md#{reason.lower()}) |"
