"""The StatefulSet as a pod, for `podman play kube`, which knows no StatefulSet."""
import copy

import yaml

import manifests


def pod(image, name, secrets, overlay="single", farm=None):
    """YAML of the pod `name` and of what it mounts: its configuration, and the volume of its store
    (`name`-store). secrets: folder by the name of the Secret that it stands for, `remeshd-tls`. farm:
    options of the overlay `replicas` in the place of those of its ConfigMap; None leaves one out."""
    objects = manifests.rendered(overlay)
    statefulset = objects["StatefulSet"]["spec"]
    spec = copy.deepcopy(statefulset["template"]["spec"])
    configs = [{"apiVersion": "v1", "kind": "ConfigMap", "metadata": {"name": each["metadata"]["name"]},
                "data": each["data"]} for key, each in objects.items() if key.startswith("ConfigMap ")]
    for config in configs:
        if farm and config["metadata"]["name"].startswith("remeshd-farm-"):
            config["data"] = {option: value for option, value in {**config["data"], **farm}.items()
                              if value is not None}
    for claim in statefulset["volumeClaimTemplates"]:
        label = claim["metadata"]["name"]  # podman makes a volume of the claim's name
        spec["volumes"].append({"name": label,
                                "persistentVolumeClaim": {"claimName": f"{name}-{label}"}})
    for volume in spec["volumes"]:
        # podman 4.3 mounts the base64 of a Secret, not its bytes, and for all to read.
        if "secret" in volume:
            secret = volume.pop("secret")["secretName"]
            volume["hostPath"] = {"path": str(secrets[secret]), "type": "Directory"}
        # And ends by a signal where this is not said.
        if "configMap" in volume:
            volume["configMap"]["optional"] = False
    [container] = spec["containers"]
    container["image"] = image
    for each in (*spec["volumes"], *container["volumeMounts"]):
        if each["name"] == "run":  # pods of podman share an emptyDir of one name
            each["name"] = f"{name}-run"
    for variable in container.get("env", []):  # of a Secret: podman would look among its own
        source = variable.pop("valueFrom")["secretKeyRef"]
        variable["value"] = (secrets[source["name"]] / source["key"]).read_text()
    del container["livenessProbe"]  # podman asks by a shell, which the image has not
    del container["ports"]  # podman would publish them on all addresses of the machine
    return yaml.safe_dump_all([*configs, {
        "apiVersion": "v1", "kind": "Pod", "metadata": {"name": name}, "spec": spec}])
