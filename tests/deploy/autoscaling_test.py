"""Facts about what deploy/kubernetes/overlays/replicas scales by, filled in as prometheus-adapter does
and evaluated by promtool."""
import re
import tempfile
import unittest
from pathlib import Path

import yaml

import manifests
import monitoring
from programs import run

RULES = manifests.FOLDER / "overlays/replicas/prometheus-adapter.yaml"
LANES = Path(__file__).resolve().parents[2] / "server/session/resources.cpp"


def waits(pod, lane, seconds):
    """A pod whose work in a lane waits so many seconds more each half minute, for ten minutes."""
    series = "remeshd_queue_wait_seconds_sum"
    return {"series": f'{series}{{namespace="remeshd",pod="{pod}",lane="{lane}"}}',
            "values": f"0+{seconds}x20"}


class AutoscalingTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        [cls.rule] = yaml.safe_load(RULES.read_text())["rules"]
        cls.scaler = manifests.rendered("replicas")["HorizontalPodAutoscaler"]
        [cls.metric] = [each["pods"] for each in cls.scaler["spec"]["metrics"]
                        if each["type"] == "Pods"]

    def query(self):
        """What the adapter asks for the pods of the namespace."""
        filled = {"<<.Series>>": self.rule["seriesQuery"].split("{")[0], "<<.GroupBy>>": "pod",
                  "<<.LabelMatchers>>": 'namespace="remeshd",pod=~"remeshd-0|remeshd-1|remeshd-2"'}
        query = self.rule["metricsQuery"]
        for name, value in filled.items():
            query = query.replace(name, value)
        return query

    def test_the_autoscaler_asks_for_what_the_rule_gives(self):
        self.assertEqual(self.metric["metric"]["name"], self.rule["name"]["as"])

    def test_the_rule_is_of_the_histogram_of_queue_waits(self):
        self.assertEqual(monitoring.metrics(self.rule["seriesQuery"]),
                         {"remeshd_queue_wait_seconds"})
        self.assertLessEqual(monitoring.metrics(self.query()), monitoring.registered_metrics())
        [lane] = set(re.findall('lane="([a-z]+)"', str(self.rule)))
        self.assertIn(f'"{lane}"', LANES.read_text())

    def test_nothing_is_left_to_fill_in(self):
        self.assertNotIn("<<", self.query())

    def test_labels_are_pod_and_namespace(self):
        overrides = self.rule["resources"]["overrides"]
        self.assertEqual({label: each["resource"] for label, each in overrides.items()},
                         {"namespace": "namespace", "pod": "pod"})

    def test_tells_how_many_computations_wait_by_pod(self):
        """15 s in half a minute: one waits half of the time. One that is idle is 0, not absent."""
        series = [waits("remeshd-0", "computation", 15), waits("remeshd-1", "computation", 0),
                  waits("remeshd-2", "preparation", 60), waits("remeshd-2", "computation", 3),
                  waits("other-0", "computation", 30)]
        expected = [{"labels": f'{{pod="remeshd-{n}"}}', "value": value}
                    for n, value in enumerate((.5, 0, .1))]
        with tempfile.TemporaryDirectory() as folder:
            file = Path(folder) / "test.yaml"
            file.write_text(yaml.safe_dump({"tests": [
                {"interval": "30s", "input_series": series, "promql_expr_test": [
                    {"expr": self.query(), "eval_time": "8m", "exp_samples": expected}]}]}))
            run("promtool", "test", "rules", file)


if __name__ == "__main__":
    unittest.main(verbosity=2)
