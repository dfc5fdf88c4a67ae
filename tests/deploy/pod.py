"""The StatefulSet as a pod, for `podman play kube`, which knows no StatefulSet."""
import copy

import yaml

import manifests


def pod(image, name, certificates):
    """YAML of the pod `name` and of what it mounts: its configuration, the volume of its store
    (`name`-store), and the folder `certificates` (make-certificates.sh)."""
    objects = manifests.rendered()
    statefulset = objects["StatefulSet"]["spec"]
    spec = copy.deepcopy(statefulset["template"]["spec"])
    config = {"apiVersion": "v1", "kind": "ConfigMap",
              "metadata": {"name": objects["ConfigMap"]["metadata"]["name"]},
              "data": objects["ConfigMap"]["data"]}
    for claim in statefulset["volumeClaimTemplates"]:
        label = claim["metadata"]["name"]  # podman makes a volume of the claim's name
        spec["volumes"].append({"name": label,
                                "persistentVolumeClaim": {"claimName": f"{name}-{label}"}})
    for volume in spec["volumes"]:
        # podman 4.3 mounts the base64 of a Secret, not its bytes, and for all to read.
        if "secret" in volume:
            del volume["secret"]
            volume["hostPath"] = {"path": str(certificates), "type": "Directory"}
        # And ends by a signal where this is not said.
        if "configMap" in volume:
            volume["configMap"]["optional"] = False
    [container] = spec["containers"]
    container["image"] = image
    del container["livenessProbe"]  # podman asks by a shell, which the image has not
    del container["ports"]  # podman would publish them on all addresses of the machine
    return yaml.safe_dump_all([config, {
        "apiVersion": "v1", "kind": "Pod", "metadata": {"name": name}, "spec": spec}])
