"""What `kubectl kustomize` renders of deploy/kubernetes."""
import re
from pathlib import Path

import yaml

from programs import run

FOLDER = Path(__file__).resolve().parents[2] / "deploy/kubernetes"
OVERLAYS = ("single", "replicas")


def rendered(overlay="single"):
    """The objects by kind; there is one of each, but for ConfigMaps, which come with their name
    without the digest at its end: `ConfigMap remeshd-config`. Throws where one comes twice."""
    found = {}
    for document in yaml.safe_load_all(run("kubectl", "kustomize", FOLDER / "overlays" / overlay)):
        key = document["kind"]
        if key == "ConfigMap":
            key += " " + re.sub("-[0-9a-z]{10}$", "", document["metadata"]["name"])
        if key in found:
            raise AssertionError(f"two objects: {key}")
        found[key] = document
    return found


def container(objects):
    """The one container of the StatefulSet."""
    containers = objects["StatefulSet"]["spec"]["template"]["spec"]["containers"]
    if len(containers) != 1:
        raise AssertionError(f"{len(containers)} containers")
    return containers[0]
