"""Whether an object is one that Kubernetes knows: its fields, their types, and what must be there,
as the models of its Python client have them (Debian: python3-kubernetes)."""
import re

from kubernetes import client

# The client of Kubernetes 1.22 knows it under its name before 1.23; the fields are the same.
BEFORE = {"autoscaling/v2": "autoscaling/v2beta2"}
PRIMITIVES = {"str": str, "int": int, "bool": bool, "object": (str, int, dict, list)}


def problems(document):
    """A line for each thing that is wrong with it."""
    version = BEFORE.get(document["apiVersion"], document["apiVersion"])
    group = version.rpartition("/")[2]
    model = getattr(client, group[0].upper() + group[1:] + document["kind"], None)
    if model is None:
        return [f"{document['apiVersion']} has no {document['kind']}"]
    return list(_of_model(document, model, document["kind"]))


def _of_model(value, model, where):
    if not isinstance(value, dict):
        yield f"{where}: is no mapping"
        return
    names = {field: name for name, field in model.attribute_map.items()}
    for field, each in value.items():
        if field not in names:
            yield f"{where}: has no field {field}"
        else:
            yield from _of_type(each, model.openapi_types[names[field]], f"{where}.{field}")
    try:  # it refuses what lacks a field that is required
        model(**{names[field]: each for field, each in value.items() if field in names},
              local_vars_configuration=client.Configuration())
    except ValueError as why:
        yield f"{where}: {why}"


def _of_type(value, kind, where):
    inner = re.fullmatch(r"list\[(.*)\]|dict\(str, (.*)\)", kind)
    if inner is None and kind in PRIMITIVES:
        wanted = PRIMITIVES[kind]
        if not isinstance(value, wanted) or (wanted is int and isinstance(value, bool)):
            yield f"{where}: {value!r} is no {kind}"
    elif inner is None:
        yield from _of_model(value, getattr(client, kind), where)
    elif not isinstance(value, list if inner[1] else dict):
        yield f"{where}: {value!r} is no {kind}"
    else:
        for key, each in enumerate(value) if inner[1] else value.items():
            yield from _of_type(each, inner[1] or inner[2], f"{where}.{key}")
