#!/usr/bin/python3
"""model_page.py REMESH [--write]: the generated parts of ../model.md, of what REMESH says. With --write they are
written; without it the exit code is 0 where they, the pictures, and every JSON block of the page are right."""
import json
import re
import sys
import tempfile

import mistakes
import type_samples
from page import DOCS, ROOT, Remesh, cell, json_blocks, named_models, replaced, settle

PAGE = DOCS / "model.md"
LIMITS = (("features", "engine/model/limits.h", r"kMaxFeatures = (\d+);"),
          ("parameters", "engine/model/expression.h", r"kMaxParameters = (\d+);"),
          ("sizes, and groups, each", "engine/model/limits.h", r"kMaxSelections = (\d+);"),
          ("entries of a profile", "engine/model/profile.h", r"kMaxProfileEntries = (\d+);"),
          ("characters of an expression", "engine/model/expression.h", r"kMaxExpressionLength = (\d+);"),
          ("terms of a selector", "engine/model/selection/selector.h", r"terms = (\d+);"),
          ("characters of a term, without its condition", "engine/model/selection/selector.h", r"term_length = (\d+);"),
          ("conditions of a model, for each feature selected", "engine/model/selection/selector.h",
           r"conditions = ([\d']+);"),
          ("MiB of a document", "proto/json_reader.h", r"bytes = std::size_t\{(\d+)\} << 20;"),
          ("lists and objects inside each other", "proto/json_reader.h", r"depth = (\d+);"),
          ("greatest length or coordinate, in the model's unit", "engine/model/limits.h", r"kMaxLength = (\w+);"))
LEAST = ("least length of a feature", "engine/model/limits.h", r"kMinSize = ([\w-]+);")


def feature_lines(type_name):
    """The sample as JSON, as a person would write it."""
    feature = type_samples.feature(type_name)
    parameters = json.dumps(feature.pop("parameters"))
    return ('{"name": "sample_%s", "features": [\n  %s,\n   "parameters": %s}\n]}'
            % (type_name, json.dumps(feature)[:-1], parameters))


def type_section(kind):
    rows = [f"| `{p['name']}` | {p['unit']} | {p['default_value'] or '-'} | {cell(p['description'])} |"
            for p in kind["parameters"]]
    faces = ", ".join(f"`{face}`" for face in kind["faces"]).replace("`side#`", "`side1`, `side2`, ...")
    name = kind["name"]
    names = ", ".join(type_samples.faces(kind))
    return "\n".join([f"### {name}", "", kind["description"][:1].upper() + kind["description"][1:] + ".", "",
                      "| parameter | unit | default | |", "|---|---|---|---|", *rows, "",
                      f"Faces: {faces}.", "", f"![{name} and its faces: {names}](model/{name}.png)", "",
                      "```json", feature_lines(name), "```", ""])


def limits():
    rows = []
    for what, file, pattern in (*LIMITS, LEAST):
        value = re.search(pattern, (ROOT / file).read_text())[1].replace("'", "")
        rows.append(f"| {what} | {int(value):,} |" if value.isdigit() else f"| {what} | {value} |")
    return "\n".join(["| at most | |", "|---|---|", *rows[:-1], "", "| at least | |", "|---|---|", rows[-1]])


def made(text, types, remesh):
    """The page as it has to be."""
    missing = [kind["name"] for kind in types if kind["name"] not in type_samples.SAMPLES]
    assert not missing, f"type_samples.py has no sample of {missing}"
    text = replaced(text, "types", "\n".join(type_section(kind) for kind in types))
    text = replaced(text, "limits", limits())
    return replaced(text, "mistakes", mistakes.table(named_models(text)["lug"], remesh))


def texts_of(png):
    """Keys and values of the text chunks of a PNG file."""
    texts, at = {}, 8
    while at < len(png):
        size = int.from_bytes(png[at:at + 4], "big")
        if png[at + 4:at + 8] == b"tEXt":
            key, value = png[at + 8:at + 8 + size].split(b"\0", 1)
            texts[key.decode()] = value.decode()
        at += size + 12
    return texts


def check_pictures(types, models):
    """Each is of today's sample, and of the type's faces."""
    for kind in types:
        file = DOCS / "model" / f"{kind['name']}.png"
        texts = texts_of(file.read_bytes())
        assert json.loads(texts["Model"]) == type_samples.model(kind["name"]), f"{file}: of another part"
        assert sorted(texts["Faces"].split()) == sorted(type_samples.faces(kind)), f"{file}: of other faces"
    lug = texts_of((DOCS / "model" / "lug.png").read_bytes())
    assert json.loads(lug["Model"]) == models["lug"], "lug.png: of another lug"
    total = sum(file.stat().st_size for file in (DOCS / "model").glob("*.png"))
    assert total < 400_000, f"{total} bytes of pictures"


def check_blocks(text, remesh):
    """Every JSON block is a model that is valid, or an edit that is, of the model named before it."""
    models = named_models(text)
    for name, model in models.items():
        (remesh.folder / f"{name}.json").write_text(json.dumps(model))
    blocks = json_blocks(text)
    assert len(blocks) == text.count("```json"), "a block is not read"
    for index, (of, block) in enumerate(blocks):
        file = remesh.folder / f"block{index}.json"
        file.write_text(block)
        assert (of is not None) == ("edits" in json.loads(block)), f"no model is named for\n{block}"
        remesh.output("validate", file, *(["--base", f"{of}.json"] if of else []))
    kinds = json.loads(remesh.output("schema", "edit"))["$defs"]["edit"]["properties"]
    unused = [kind for kind in kinds if f'"{kind}"' not in text]
    assert len(kinds) >= 9 and not unused, f"no edit of the page is of kind {unused}"


def main():
    with tempfile.TemporaryDirectory() as folder, Remesh(sys.argv[1], folder) as remesh:
        text = PAGE.read_text()
        types = json.loads(remesh.output("types", "--json", "-"))["types"]
        new = made(text, types, remesh)
        settle(PAGE, text, new)
        check_pictures(types, named_models(new))
        check_blocks(new, remesh)


if __name__ == "__main__":
    main()
