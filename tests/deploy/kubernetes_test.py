"""Facts about deploy/kubernetes, as kubectl renders it."""
import copy
import tomllib
import unittest
from pathlib import Path

import kubernetes_schema
import manifests
from programs import run

TOP = Path(__file__).resolve().parents[2]
BASE = {"Namespace", "ConfigMap remeshd-config", "Service", "StatefulSet", "PodDisruptionBudget",
        "NetworkPolicy"}


class OfEveryOverlay:
    """What holds for `overlay`."""

    @classmethod
    def setUpClass(cls):
        cls.objects = manifests.rendered(cls.overlay)
        cls.set = cls.objects["StatefulSet"]["spec"]
        cls.pod = cls.set["template"]["spec"]
        cls.container = manifests.container(cls.objects)

    def test_kubernetes_knows_every_field(self):
        for kind, each in self.objects.items():
            self.assertEqual(kubernetes_schema.problems(each), [], kind)

    def test_all_of_it_lies_in_its_namespace(self):
        for kind, each in self.objects.items():
            if kind != "Namespace":
                self.assertEqual(each["metadata"]["namespace"],
                                 self.objects["Namespace"]["metadata"]["name"], kind)

    def test_service_names_each_pod(self):
        service = self.objects["Service"]
        self.assertEqual(service["spec"]["clusterIP"], "None")
        self.assertEqual(self.set["serviceName"], service["metadata"]["name"])

    def test_all_select_the_pods_that_the_set_makes(self):
        labels = self.set["template"]["metadata"]["labels"]
        budget = self.objects["PodDisruptionBudget"]["spec"]["selector"]["matchLabels"]
        for selector in (self.set["selector"]["matchLabels"],
                         self.objects["Service"]["spec"]["selector"], budget,
                         self.objects["NetworkPolicy"]["spec"]["podSelector"]["matchLabels"]):
            self.assertTrue(selector)
            self.assertLessEqual(selector.items(), labels.items())

    def test_a_drain_takes_one_pod_at_a_time(self):
        self.assertEqual(self.objects["PodDisruptionBudget"]["spec"]["maxUnavailable"], 1)

    def test_metrics_are_read_by_the_namespace_for_it_alone(self):
        policy = self.objects["NetworkPolicy"]["spec"]
        self.assertEqual(policy["policyTypes"], ["Ingress", "Egress"])
        senders = {rule["ports"][0]["port"]: rule.get("from") for rule in policy["ingress"]}
        self.assertEqual(senders.keys(), {port["name"] for port in self.container["ports"]})
        self.assertTrue(senders["metrics"])

    def test_ports_of_the_service_are_the_container_s(self):
        ports = {port["name"] for port in self.container["ports"]}
        for port in self.objects["Service"]["spec"]["ports"]:
            self.assertIn(port["targetPort"], ports)

    # What the profile `restricted` of Kubernetes' Pod Security Standards asks for, and a root that
    # cannot be written to.

    def test_runs_as_the_user_of_the_image(self):
        context = self.pod["securityContext"]
        self.assertTrue(context["runAsNonRoot"])
        user = f"{context['runAsUser']}:{context['runAsGroup']}"
        self.assertIn(f"USER {user}\n", (TOP / "deploy/Dockerfile").read_text())
        self.assertEqual(context["fsGroup"], context["runAsGroup"])

    def test_has_no_right_beyond_that_user_s(self):
        context = self.container["securityContext"]
        self.assertIs(context["allowPrivilegeEscalation"], False)
        self.assertIs(context["readOnlyRootFilesystem"], True)
        self.assertEqual(context["capabilities"], {"drop": ["ALL"]})
        self.assertEqual(self.pod["securityContext"]["seccompProfile"], {"type": "RuntimeDefault"})
        self.assertIs(self.pod["automountServiceAccountToken"], False)
        for key in ("hostNetwork", "hostPID", "hostIPC"):
            self.assertNotIn(key, self.pod)

    def test_variables_of_services_do_not_look_like_options(self):
        self.assertIs(self.pod["enableServiceLinks"], False)

    def test_memory_and_processors_are_limited(self):
        for kind in ("requests", "limits"):
            self.assertLessEqual({"cpu", "memory"}, self.container["resources"][kind].keys())
        self.assertEqual(self.container["resources"]["requests"]["memory"],
                         self.container["resources"]["limits"]["memory"])

    def test_the_configuration_fits_the_limits(self):
        config = tomllib.loads(self.objects["ConfigMap remeshd-config"]["data"]["remeshd.toml"])
        limits = self.container["resources"]["limits"]
        self.assertEqual(config["workers"], int(limits["cpu"]))
        self.assertRegex(limits["memory"], "^[0-9]+Gi$")
        self.assertLessEqual(config["memory"], int(limits["memory"][:-2]) * 1024 * 2 / 3)

    def test_the_program_itself_is_the_probe(self):
        for name in ("startupProbe", "readinessProbe", "livenessProbe"):
            command = self.container[name]["exec"]["command"]
            self.assertEqual(command[:2], ["/usr/bin/remeshd", "--health"], name)
        # Else a full disk would restart a daemon that can still serve what it holds.
        self.assertIn("--live", self.container["livenessProbe"]["exec"]["command"])
        self.assertNotIn("--live", self.container["readinessProbe"]["exec"]["command"])

    def test_every_mount_has_a_volume_and_every_volume_a_mount(self):
        volumes = {volume["name"] for volume in self.pod["volumes"]}
        volumes |= {claim["metadata"]["name"] for claim in self.set["volumeClaimTemplates"]}
        self.assertEqual({mount["name"] for mount in self.container["volumeMounts"]}, volumes)

    def test_the_configuration_s_digest_is_in_its_name(self):
        name = self.objects["ConfigMap remeshd-config"]["metadata"]["name"]
        self.assertRegex(name, "^remeshd-config-[0-9a-z]{10}$")
        self.assertIn(name, [volume.get("configMap", {}).get("name")
                             for volume in self.pod["volumes"]])

    def test_kustomization_takes_the_version_of_the_project(self):
        version = (TOP / "CMakeLists.txt").read_text().split("project(remeshd VERSION ")[1].split()[0]
        self.assertEqual(self.container["image"].rsplit(":", 1)[1], version)


class SingleTest(OfEveryOverlay, unittest.TestCase):
    overlay = "single"

    def test_has_what_a_daemon_with_a_store_needs_and_no_more(self):
        self.assertEqual(set(self.objects), BASE)
        self.assertEqual(self.set["replicas"], 1)

    def test_calls_nobody(self):
        self.assertEqual(self.objects["NetworkPolicy"]["spec"]["egress"], [])

    def test_is_what_the_folder_itself_renders(self):
        self.assertEqual(run("kubectl", "kustomize", manifests.FOLDER),
                         run("kubectl", "kustomize", manifests.FOLDER / "overlays/single"))


class FarmTest(OfEveryOverlay, unittest.TestCase):
    overlay = "replicas"

    def test_has_an_autoscaler_and_what_the_replicas_share_beside(self):
        self.assertEqual(set(self.objects),
                         BASE | {"ConfigMap remeshd-farm", "HorizontalPodAutoscaler"})

    def test_there_are_three_replicas_or_more_and_none_but_the_autoscaler_says_so(self):
        scaler = self.objects["HorizontalPodAutoscaler"]["spec"]
        self.assertEqual(scaler["minReplicas"], 3)
        self.assertGreater(scaler["maxReplicas"], 3)
        target = scaler["scaleTargetRef"]
        scaled = self.objects[target["kind"]]
        self.assertEqual(target["name"], scaled["metadata"]["name"])
        self.assertEqual(target["apiVersion"], scaled["apiVersion"])
        self.assertNotIn("replicas", self.set)  # applied again, it would undo the autoscaler's

    def test_replicas_come_quickly_and_go_slowly(self):
        behaviour = self.objects["HorizontalPodAutoscaler"]["spec"]["behavior"]
        self.assertLessEqual(behaviour["scaleUp"]["stabilizationWindowSeconds"], 60)
        self.assertGreaterEqual(behaviour["scaleDown"]["stabilizationWindowSeconds"], 1800)
        [least] = behaviour["scaleDown"]["policies"]
        self.assertEqual((least["type"], least["value"]), ("Pods", 1))

    def test_the_processors_hold_replicas_where_nothing_waits(self):
        kinds = [each["type"] for each in
                 self.objects["HorizontalPodAutoscaler"]["spec"]["metrics"]]
        self.assertEqual(kinds, ["Pods", "Resource"])

    def test_an_acknowledged_edit_is_in_the_tier(self):
        shared = self.objects["ConfigMap remeshd-farm"]["data"]
        self.assertEqual(shared["REMESHD_TIER_ACK"], "tier")
        for name in ("REMESHD_TIER", "REMESHD_TIER_KEY_FILE", "REMESHD_CATALOGUE"):
            self.assertTrue(shared[name], name)

    def test_no_secret_stands_in_the_manifests(self):
        shared = self.objects["ConfigMap remeshd-farm"]["data"]
        self.assertNotRegex(shared["REMESHD_CATALOGUE"], "//[^/@]*:[^/@]*@|password=")
        [password] = self.container["env"]
        self.assertEqual(password["name"], "PGPASSWORD")
        self.assertIn("secretKeyRef", password["valueFrom"])

    def test_every_file_that_is_named_lies_in_a_volume(self):
        mounts = {each["mountPath"] for each in self.container["volumeMounts"]}
        shared = self.objects["ConfigMap remeshd-farm"]["data"]
        files = [shared["REMESHD_TIER_KEY_FILE"], shared["REMESHD_TIER_S3_CREDENTIALS_FILE"],
                 shared["REMESHD_CATALOGUE"].split("sslrootcert=")[1]]
        for file in files:
            self.assertIn(str(Path(file).parent), mounts, file)

    def test_the_shared_options_reach_the_container(self):
        [source] = self.container["envFrom"]
        self.assertEqual(source["configMapRef"]["name"],
                         self.objects["ConfigMap remeshd-farm"]["metadata"]["name"])

    def test_replicas_lie_apart_where_they_can(self):
        keys = {each["topologyKey"] for each in self.pod["topologySpreadConstraints"]}
        self.assertEqual(keys, {"topology.kubernetes.io/zone", "kubernetes.io/hostname"})
        labels = self.set["template"]["metadata"]["labels"]
        for each in self.pod["topologySpreadConstraints"]:
            self.assertLessEqual(each["labelSelector"]["matchLabels"].items(), labels.items())

    def test_calls_names_tier_and_catalogue_alone(self):
        rules = self.objects["NetworkPolicy"]["spec"]["egress"]
        ports = [sorted((each["protocol"], each["port"]) for each in rule["ports"])
                 for rule in rules]
        self.assertEqual(ports, [[("TCP", 53), ("UDP", 53)], [("TCP", 443)], [("TCP", 5432)]])
        for rule in rules:
            self.assertTrue(rule["to"], rule)  # none: anybody


class RenderingTest(unittest.TestCase):
    def test_tells_what_is_wrong(self):
        with self.assertRaisesRegex(AssertionError, "kubectl kustomize"):
            run("kubectl", "kustomize", TOP / "deploy/grafana")  # has no kustomization

    def test_what_kubernetes_does_not_know_is_told(self):
        right = manifests.rendered("replicas")["HorizontalPodAutoscaler"]
        for change, told in ((lambda spec: spec.update(minimum=3), "has no field minimum"),
                             (lambda spec: spec.update(minReplicas="3"), "'3' is no int"),
                             (lambda spec: spec.pop("scaleTargetRef"), "scale_target_ref"),
                             (lambda spec: spec["metrics"][0].pop("type"), "type")):
            wrong = copy.deepcopy(right)
            change(wrong["spec"])
            self.assertRegex("\n".join(kubernetes_schema.problems(wrong)), told)


if __name__ == "__main__":
    unittest.main(verbosity=2)
