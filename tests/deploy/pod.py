"""The StatefulSet as a pod, for `podman play kube`, which knows no StatefulSet."""
import copy
from pathlib import Path

import yaml

import manifests


def pod(image, name, certificates):
    """YAML of the pod remeshd-0 and of what it mounts: its configuration, a claim for its store,
    and a Secret of the files tls.crt, tls.key and ca.crt in the folder `certificates`."""
    objects = manifests.rendered()
    config = copy.deepcopy(objects["ConfigMap"])
    config["metadata"] = {"name": config["metadata"]["name"]}
    secret = {"apiVersion": "v1", "kind": "Secret", "metadata": {"name": "remeshd-tls"},
              # As text: podman 4.3 does not decode the base64 of `data`.
              "stringData": {each: (Path(certificates) / each).read_text()
                             for each in ("tls.crt", "tls.key", "ca.crt")}}
    statefulset = objects["StatefulSet"]["spec"]
    claims, volumes = [], copy.deepcopy(statefulset["template"]["spec"]["volumes"])
    for claim in statefulset["volumeClaimTemplates"]:
        label = claim["metadata"]["name"]
        claims.append({"apiVersion": "v1", "kind": "PersistentVolumeClaim",
                       "metadata": {"name": f"{name}-{label}"}, "spec": claim["spec"]})
        volumes.append({"name": label, "persistentVolumeClaim": {"claimName": f"{name}-{label}"}})
    spec = {**copy.deepcopy(statefulset["template"]["spec"]), "volumes": volumes}
    # Where a field is missing that Kubernetes does not ask for, podman 4.3 ends by a signal.
    for volume in volumes:
        for source in ("secret", "configMap"):
            volume.get(source, {}).setdefault("optional", False)
    spec["containers"][0]["image"] = image
    del spec["containers"][0]["livenessProbe"]  # podman asks by a shell, which the image has not
    del spec["containers"][0]["ports"]  # podman would publish them on all addresses of the machine
    pod_object = {"apiVersion": "v1", "kind": "Pod", "metadata": {"name": name}, "spec": spec}
    return yaml.safe_dump_all([secret, config, *claims, pod_object])
