"""Facts about deploy/grafana/dashboard.json and deploy/prometheus/alerts.yaml."""
import json
import tempfile
import unittest
from pathlib import Path

import monitoring
from programs import run


class DashboardTest(unittest.TestCase):
    def test_prometheus_understands_every_expression(self):
        with tempfile.TemporaryDirectory() as folder:
            rules = Path(folder) / "dashboard.rules.yaml"
            rules.write_text(monitoring.as_rules(monitoring.dashboard_expressions()))
            run("promtool", "check", "rules", rules)

    def test_every_panel_says_what_it_shows(self):
        panels = json.loads(monitoring.DASHBOARD.read_text())["panels"]
        for panel in panels:
            if panel["type"] != "row":
                self.assertTrue(panel["targets"], panel["title"])
                self.assertTrue(panel["description"].endswith("."), panel["title"])

    def test_no_panel_covers_another(self):
        panels = json.loads(monitoring.DASHBOARD.read_text())["panels"]
        taken = {}
        for panel in panels:
            place = panel["gridPos"]
            self.assertLessEqual(place["x"] + place["w"], 24, panel["title"])
            for x in range(place["x"], place["x"] + place["w"]):
                for y in range(place["y"], place["y"] + place["h"]):
                    self.assertNotIn((x, y), taken, f"{panel['title']} on {taken.get((x, y))}")
                    taken[x, y] = panel["title"]

    def test_every_id_is_one_panel_s(self):
        ids = [panel["id"] for panel in json.loads(monitoring.DASHBOARD.read_text())["panels"]]
        self.assertEqual(len(ids), len(set(ids)))

    def test_a_variable_that_nobody_fills_in_is_told(self):
        with self.assertRaisesRegex(ValueError, "Panel: unknown variable"):
            monitoring.as_rules([("Panel", "rate(remeshd_calls_total[$interval])")])


class MetricsTest(unittest.TestCase):
    def test_every_metric_that_is_asked_for_is_one_of_the_server_s(self):
        registered = monitoring.registered_metrics()
        for title, expression in [*monitoring.dashboard_expressions(),
                                  *monitoring.alert_expressions()]:
            self.assertLessEqual(monitoring.metrics(expression), registered, title)

    def test_every_metric_of_the_server_is_on_the_dashboard(self):
        shown = set()
        for _, expression in monitoring.dashboard_expressions():
            shown |= monitoring.metrics(expression)
        self.assertEqual(monitoring.registered_metrics() - shown, set())


class AlertsTest(unittest.TestCase):
    def test_prometheus_understands_every_rule(self):
        run("promtool", "check", "rules", monitoring.ALERTS)

    def test_the_configuration_of_prometheus_takes_them(self):
        run("promtool", "check", "config", monitoring.ALERTS.with_name("prometheus.yaml"))

    def test_alerts_fire_when_they_should_and_only_then(self):
        run("promtool", "test", "rules", monitoring.ALERT_TESTS)

    def test_every_alert_has_a_test(self):
        tests = monitoring.ALERT_TESTS.read_text()
        for alert, _ in monitoring.alert_expressions():
            self.assertIn(alert, tests)


if __name__ == "__main__":
    unittest.main(verbosity=2)
