"""The StatefulSet as a pod, for `podman play kube`, which knows no StatefulSet."""
import copy
from pathlib import Path

import yaml

import manifests


def pod(image, name, certificates):
    """YAML of the pod `name` and of what it mounts: its configuration, the volume of its store
    (`name`-store), and tls.crt, tls.key and ca.crt of the folder `certificates`."""
    objects = manifests.rendered()
    statefulset = objects["StatefulSet"]["spec"]
    spec = copy.deepcopy(statefulset["template"]["spec"])
    config = {"apiVersion": "v1", "kind": "ConfigMap",
              "metadata": {"name": objects["ConfigMap"]["metadata"]["name"]},
              "data": objects["ConfigMap"]["data"]}
    tls = {"apiVersion": "v1", "kind": "ConfigMap", "metadata": {"name": "remeshd-tls"},
           "data": {each: (Path(certificates) / each).read_text()
                    for each in ("tls.crt", "tls.key", "ca.crt")}}
    for claim in statefulset["volumeClaimTemplates"]:
        label = claim["metadata"]["name"]  # podman makes a volume of the claim's name
        spec["volumes"].append({"name": label,
                                "persistentVolumeClaim": {"claimName": f"{name}-{label}"}})
    for volume in spec["volumes"]:
        if volume["name"] == "tls":  # podman 4.3 mounts the base64 of a Secret, not its bytes
            del volume["secret"]
            volume["configMap"] = {"name": "remeshd-tls"}
        if "configMap" in volume:  # and ends by a signal where this is not said
            volume["configMap"]["optional"] = False
    [container] = spec["containers"]
    container["image"] = image
    del container["livenessProbe"]  # podman asks by a shell, which the image has not
    del container["ports"]  # podman would publish them on all addresses of the machine
    return yaml.safe_dump_all([tls, config, {
        "apiVersion": "v1", "kind": "Pod", "metadata": {"name": name}, "spec": spec}])
