# SPDX-License-Identifier: Apache-2.0
"""Requests for the stream, made of what users give."""
from __future__ import annotations

import hashlib
import json
import os
from typing import Any, Callable, Mapping, Sequence

from remesh_client._assembler import Content
from remesh_client._exchange import Exchange, OnProgress
from remesh_client.edits import EditLike, Model, edit_document, model_document
from remesh_client.options import mesh_options
from remesh_client.v1 import (document_pb2, mesh_pb2, model_pb2, revision_pb2, stream_pb2)

_UNNAMED = "model"  # the design of a model without a name
FORMATS = {"vtu": "vtu", "msh": "msh", "inp": "inp", "step": "step", "stp": "step"}


def head_update(file: bool | None) -> revision_pb2.HeadUpdate | None:
    return None if file is None else revision_pb2.HeadUpdate(file=file)


def put_model(request: revision_pb2.CreateRevisionRequest | model_pb2.ValidateModelRequest,
              model: Model) -> str:
    """Puts a model into a request; returns the file that it was read from, if it was."""
    if isinstance(model, document_pb2.FeatureModel):
        request.model.CopyFrom(model)
        return ""
    request.document, source = model_document(model)
    return source


def first_mesh(model: Model, options: Mapping[str, Any], design: str, file: bool | None,
               with_mesh: bool, on_progress: OnProgress | None,
               route: str | None = None) -> Exchange:
    """Meshes a model. route: default: the design that it joins, in none the request's own. Raises
    what `model_document` and `mesh_options` raise."""
    create = revision_pb2.CreateRevisionRequest(
        options=mesh_options(options), design=design, head=head_update(file),
        threads=options.get("threads", 0))
    source = put_model(create, model)
    mesh = mesh_pb2.MeshSelection() if with_mesh else None
    if route is None:
        route = design or (_name_of(create) if file is not False else "") or _digest(create)
    return Exchange(stream_pb2.EditStreamRequest(create=create, mesh=mesh), source,
                    on_progress=on_progress, route=route)


def _name_of(create: revision_pb2.CreateRevisionRequest) -> str:
    """Of its model, after which the design is called that it joins by default; empty where that
    cannot be read, which the daemon will say."""
    name: Any = create.model.name
    if create.document:
        try:
            document = json.loads(create.document)
        except ValueError:
            return ""
        name = document.get("name", "") if isinstance(document, dict) else ""
    return name or _UNNAMED if isinstance(name, str) else ""


def _digest(create: revision_pb2.CreateRevisionRequest) -> str:
    return hashlib.sha256(create.SerializeToString(deterministic=True)).hexdigest()


def edit_of(base: str, edits: Sequence[EditLike], parameters: Mapping[str, Any],
            options: Mapping[str, Any], file: bool | None, with_mesh: bool,
            content: Callable[[], Content | None] | None,
            on_progress: OnProgress | None, route: str = "", design: str = "") -> Exchange:
    """Edits a revision. content: gives the base's mesh once that has come; None: there is none.
    design: that is to have the edit; empty: the daemon finds it."""
    edit = revision_pb2.EditRevisionRequest(base=base, options=mesh_options(options),
                                            design=design, head=head_update(file),
                                            threads=options.get("threads", 0))
    source = ""
    if len(edits) == 1 and isinstance(edits[0], document_pb2.ModelEdit) and not parameters:
        edit.edit.CopyFrom(edits[0])
    else:
        edit.document, source = edit_document(edits, parameters)
    mesh = mesh_pb2.MeshSelection(delta=content is not None) if with_mesh else None
    return Exchange(stream_pb2.EditStreamRequest(edit=edit, mesh=mesh), source,
                    content or (lambda: None), on_progress, route)


def format_of(path: os.PathLike[str] | str) -> str:
    """The format of a file by the ending of its name. Raises ValueError."""
    ending = os.path.splitext(os.fspath(path))[1].removeprefix(".")
    if ending not in FORMATS:
        raise ValueError(f"{os.fspath(path)}: unknown format {ending!r}; the endings known "
                         "are .vtu, .msh, .inp, .step and .stp")
    return FORMATS[ending]
