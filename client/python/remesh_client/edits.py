# SPDX-License-Identifier: Apache-2.0
"""Models and edits as documents: what the daemon's strict reader takes."""
from __future__ import annotations

import json
import os
from pathlib import Path
from typing import Any, Iterable, Mapping, NamedTuple, Sequence, Union

from remesh_client.errors import Error, made_here
from remesh_client.v1 import document_pb2

MAX_DOCUMENT = 4 << 20  # bytes, as the daemon has it
_KINDS = {"setParameter", "setFeatureParameter", "setPlacement", "addFeature", "removeFeature",
          "setSize", "removeSize", "setGroup", "removeGroup"}

Value = Union[float, int, str]  # a number or an expression
Vector = Sequence[Value]
Model = Union["os.PathLike[str]", str, Mapping[str, Any], document_pb2.FeatureModel]


class Edit(NamedTuple):
    """One edit, as it stands in a document: `{"removeFeature": {"feature": "rib"}}`."""

    document: Mapping[str, Any]


EditLike = Union[Edit, "os.PathLike[str]", str, Mapping[str, Any], document_pb2.ModelEdit,
                 Iterable[Any]]


def set_parameter(name: str, value: Value | Sequence[Any]) -> Edit:
    """Changes a parameter of the model, or of a feature: `hole.radius`."""
    feature, dot, parameter = name.rpartition(".")
    if dot:
        return Edit({"setFeatureParameter": {"feature": feature, "name": parameter,
                                             "value": value}})
    return Edit({"setParameter": {"name": name, "value": value}})


def remove(feature: str) -> Edit:
    """Removes a feature."""
    return Edit({"removeFeature": {"feature": feature}})


def add(feature: Mapping[str, Any], after: str = "") -> Edit:
    """Adds a feature, as it stands in a model document, behind another one or at the end."""
    edit: dict[str, Any] = {"feature": dict(feature)}
    if after:
        edit["after"] = after
    return Edit({"addFeature": edit})


def place(feature: str, origin: Vector | None = None, z_axis: Vector | None = None,
          x_axis: Vector | None = None) -> Edit:
    """Replaces the whole placement of a feature; what is left out takes the default."""
    axes = {"origin": origin, "zAxis": z_axis, "xAxis": x_axis}
    placement = {name: list(axis) for name, axis in axes.items() if axis is not None}
    return Edit({"setPlacement": {"feature": feature, "placement": placement}})


def set_size(id: str, size: Value | None = None, on: str = "",
             within: Mapping[str, Any] | None = None) -> Edit:
    """Adds a size control or changes the one of that id.

    size: edge length. on: a selector. within: `{"ball": [x, y, z, r]}` or `{"box": [...]}`.
    """
    control: dict[str, Any] = {"id": id}
    control |= {"size": size} if size is not None else {}
    control |= {"on": on} if on else {}
    control |= {"in": dict(within)} if within is not None else {}
    return Edit({"setSize": control})


def remove_size(id: str) -> Edit:
    """Removes a size control."""
    return Edit({"removeSize": {"id": id}})


def set_group(name: str, on: str = "", policy: Mapping[str, Any] | None = None) -> Edit:
    """Adds a group of faces or material, or changes the one of that name."""
    group: dict[str, Any] = {"name": name}
    group |= {"on": on} if on else {}
    group |= {"policy": dict(policy)} if policy is not None else {}
    return Edit({"setGroup": group})


def remove_group(name: str) -> Edit:
    """Removes a group."""
    return Edit({"removeGroup": {"name": name}})


class Document(NamedTuple):
    """A document as it is sent, and the file that it was read from, if it was."""

    text: str
    file: str = ""


def model_document(model: Model) -> Document:
    """The document of a model: a path, or a mapping as in a document.

    Raises InvalidRequest, OSError, TypeError, ValueError for NaN and infinities.
    """
    if isinstance(model, Mapping):
        return _checked(Document(_json(model)))
    if isinstance(model, (str, os.PathLike)):
        return _read(model)
    raise TypeError(f"a model is a path, a mapping or a FeatureModel, not {type(model).__name__}")


def edit_document(edits: Sequence[EditLike], parameters: Mapping[str, Any]) -> Document:
    """The document of all edits in their order, those of named parameters last."""
    alone = edits[0] if len(edits) == 1 and not parameters else None
    if isinstance(alone, (str, os.PathLike)):
        return _read(alone)  # as it stands, so that lines of errors are the file's
    found: list[Mapping[str, Any]] = []
    for edit in edits:
        found += _edits_of(edit)
    found += [set_parameter(name, value).document for name, value in parameters.items()]
    if not found:
        raise ValueError("an edit without any change")
    return _checked(Document(_json({"edits": found})))


def _edits_of(edit: EditLike) -> list[Mapping[str, Any]]:
    if isinstance(edit, Edit):
        return [edit.document]
    if isinstance(edit, (str, os.PathLike)):
        return list(json.loads(_read(edit).text)["edits"])
    if isinstance(edit, Mapping):
        return _edits_of_mapping(edit)
    if isinstance(edit, Iterable):
        return [one for part in edit for one in _edits_of(part)]
    raise TypeError(f"an edit cannot be a {type(edit).__name__}: give parameters by name, a "
                    "mapping, rc.remove(...) and the like, or a path; a ModelEdit stands alone")


def _edits_of_mapping(edit: Mapping[str, Any]) -> list[Mapping[str, Any]]:
    """A document, one of its edits, or values by name of their parameters."""
    if set(edit) == {"edits"} and isinstance(edit["edits"], Sequence):
        return list(edit["edits"])
    if len(edit) == 1 and set(edit) <= _KINDS and isinstance(next(iter(edit.values())), Mapping):
        return [edit]
    return [set_parameter(name, value).document for name, value in edit.items()]


def _read(path: os.PathLike[str] | str) -> Document:
    file = Path(path)
    size = file.stat().st_size
    _check_size(size, str(file))
    return Document(file.read_text(encoding="utf-8"), str(file))


def _checked(document: Document) -> Document:
    _check_size(len(document.text.encode("utf-8")), "the document")
    return document


def _check_size(size: int, what: str) -> None:
    if size > MAX_DOCUMENT:
        raise made_here(Error.CODE_INVALID_ARGUMENT,
                        f"{what} has {size} bytes, more than the limit of {MAX_DOCUMENT}",
                        Error.DOCUMENT_TOO_LARGE, "a model describes features, not a mesh")


def _plain(value: Any) -> Any:
    """numpy's numbers and arrays as JSON has them."""
    if hasattr(value, "tolist"):
        return value.tolist()
    raise TypeError(f"{value!r} of type {type(value).__name__} cannot stand in a document")


def _json(document: Mapping[str, Any]) -> str:
    return json.dumps(document, allow_nan=False, default=_plain)
