"""What `kubectl kustomize deploy/kubernetes` renders."""
from pathlib import Path

import yaml

from programs import run

FOLDER = Path(__file__).resolve().parents[2] / "deploy/kubernetes"


def rendered():
    """The objects by kind; there is one of each. Throws where a kind comes twice."""
    found = {}
    for document in yaml.safe_load_all(run("kubectl", "kustomize", FOLDER)):
        if document["kind"] in found:
            raise AssertionError(f"two objects of kind {document['kind']}")
        found[document["kind"]] = document
    return found


def container(objects):
    """The one container of the StatefulSet."""
    containers = objects["StatefulSet"]["spec"]["template"]["spec"]["containers"]
    if len(containers) != 1:
        raise AssertionError(f"{len(containers)} containers")
    return containers[0]
