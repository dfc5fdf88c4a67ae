"""The dashboard's and the alerts' expressions, as text and as rules that promtool can check."""
import json
import re
from pathlib import Path

import yaml

TOP = Path(__file__).resolve().parents[2]
DASHBOARD = TOP / "deploy/grafana/dashboard.json"
ALERTS = TOP / "deploy/prometheus/alerts.yaml"
ALERT_TESTS = Path(__file__).with_name("alerts.test.yaml")

METRIC = re.compile(r"\bremeshd_[a-z_]+\b")
# A name as the server's sources write it where they register a metric.
REGISTERED = re.compile(r'"(remeshd_[a-z_]+)"')
# What Grafana puts in the place of a variable, as an example.
VARIABLES = {"$__rate_interval": "5m", "$instance": ".+"}


def dashboard_expressions():
    """(title of the panel, expression) of every query of the dashboard."""
    dashboard = json.loads(DASHBOARD.read_text())
    for panel in dashboard["panels"]:
        for target in panel.get("targets", []):
            yield panel["title"], target["expr"]
    for annotation in dashboard["annotations"]["list"]:
        yield annotation["name"], annotation["expr"]


def alert_expressions():
    """(name of the alert, expression)."""
    for group in yaml.safe_load(ALERTS.read_text())["groups"]:
        for rule in group["rules"]:
            yield rule["alert"], rule["expr"]


def as_rules(expressions):
    """A rule file with one recording rule per expression. Throws ValueError where a variable is
    left that Grafana would fill in and this does not know."""
    rules = []
    for number, (title, expression) in enumerate(expressions):
        for name, value in VARIABLES.items():
            expression = expression.replace(name, value)
        if "$" in expression:
            raise ValueError(f"{title}: unknown variable in {expression}")
        rules.append({"record": f"dashboard:{number}", "expr": expression,
                      "labels": {"panel": title}})
    return yaml.safe_dump({"groups": [{"name": "dashboard", "rules": rules}]})


def metrics(expression):
    """The names of remeshd's metrics in it, without the endings of a histogram's series."""
    return {re.sub(r"_(bucket|sum|count)$", "", name) for name in METRIC.findall(expression)}


def registered_metrics():
    """The names that the server registers."""
    found = set()
    for source in (TOP / "server/observe").glob("*.cpp"):
        found |= set(REGISTERED.findall(source.read_text()))
    return found
