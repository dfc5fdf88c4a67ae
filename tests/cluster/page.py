#!/usr/bin/python3
"""The page of a farm as people see it: in a browser without a screen.

    PYTHONPATH=build/client/python tests/cluster/page.py build/bin/remeshd PICTURES

First with metrics that are made up, so that what it has to show is known; then with those of the
whole farm on loopback (whole_farm.py) while a study runs through it and a replica is killed and
comes back. Leaves pictures in the folder PICTURES, for people to look at. Exit 0 where all is well.
"""
import argparse
import json
import re
import sys
import threading
import time
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "client/report_page"))
from browser import Browser  # noqa: E402
from whole_farm import CLUSTER, WholeFarm  # noqa: E402

EVERY = .25  # s between readings of the page
KINDS = {"html": "text/html", "js": "text/javascript", "json": "application/json"}


class MadeUp:
    """The page over replicas whose counters grow evenly; an HTTP server.

    rates: edits per second of each. away: names that do not answer. silent: nobody does."""

    def __init__(self, rates):
        self.rates, self.away, self.silent = rates, set(), False
        self.begun = dict.fromkeys(rates, time.monotonic())
        self.study = None
        made_up = self

        class Handler(BaseHTTPRequestHandler):
            def log_message(self, *_):
                pass

            def do_GET(self):
                path = self.path.split("?")[0].lstrip("/") or "index.html"
                if made_up.silent:
                    self.close_connection = True
                    return
                body = made_up.answer(path)
                self.send_response(404 if body is None else 200 if body else 502)
                self.send_header("Content-Type", KINDS.get(path.rpartition(".")[2], "text/plain"))
                self.end_headers()
                self.wfile.write(body or b"")

        self._server = ThreadingHTTPServer(("127.0.0.1", 0), Handler)
        self._server.daemon_threads = True
        threading.Thread(target=self._server.serve_forever, daemon=True).start()
        self.url = f"http://127.0.0.1:{self._server.server_port}"

    def answer(self, path):
        """Bytes; empty: a bad gateway; None: not found."""
        if path == "farm.json":
            return json.dumps({"workers": 2, "replicas": list(self.rates)}).encode()
        if path == "study.json":
            return json.dumps(self.study).encode() if self.study else None
        if path.startswith("metrics/"):
            name = path.partition("/")[2]
            return b"" if name in self.away else self.metrics(name).encode()
        return (CLUSTER / "page" / path).read_bytes()

    def restart(self, name):
        self.begun[name] = time.monotonic()

    def metrics(self, name):
        edits = self.rates[name] * (time.monotonic() - self.begun[name])
        return f"""# HELP remeshd_ready 1 while the daemon is ready
# TYPE remeshd_ready gauge
exposer_request_latencies{{quantile="0.5"}} Nan
remeshd_reuse_ratio_count {edits}
remeshd_queue_wait_seconds_count{{lane="computation"}} {edits}
remeshd_queue_wait_seconds_sum{{lane="computation"}} {.25 * edits}
remeshd_queue_wait_seconds_count{{lane="metadata"}} {9 * edits}
remeshd_queue_wait_seconds_sum{{lane="metadata"}} {9 * edits}
remeshd_cache_requests_total{{result="memory"}} {.6 * edits}
remeshd_cache_requests_total{{result="disk"}} {.2 * edits}
remeshd_cache_requests_total{{result="tier"}} {.15 * edits}
remeshd_cache_requests_total{{result="remade"}} {.05 * edits}
remeshd_cache_requests_total{{result="computed"}} {7 * edits}
remeshd_ready 1
remeshd_computations_running 1
remeshd_queue_depth{{lane="computation"}} 3
remeshd_tier_waiting 2
remeshd_memory_bytes {120 * 2 ** 20}
remeshd_memory_budget_bytes {1344 * 2 ** 20}
"""

    def close(self):
        self._server.shutdown()
        self._server.server_close()


class Sight:
    """What a browser shows of a page."""

    def __init__(self, browser, url):
        self.browser = browser
        browser.call("Page.navigate", url=f"{url}/?every={EVERY}")
        self.readings(3)

    def readings(self, more):
        """Waits until the page has read so many times more."""
        count = "Number(document.documentElement?.dataset.readings ?? 0)"
        now = self.browser.evaluate(count)
        self.browser.wait_for(f"{count} >= {now + more}")

    def text(self, selector):
        return self.browser.evaluate(
            f"document.querySelector({json.dumps(selector)})?.innerText ?? null")

    def figure(self, name, replica=""):
        """Text of a figure, of the farm or of a replica."""
        where = f"[data-replica={replica}]" if replica else ".tiles"
        return self.text(f"{where} [data-figure={name}]")

    def number(self, *where):
        return float(re.search(r"[\d,.]+", self.figure(*where))[0].replace(",", ""))

    def state(self, replica):
        return self.text(f"[data-replica={replica}] .state")

    def wait_for_state(self, replica, words):
        self.browser.wait_for(f"""document.querySelector('[data-replica={replica}] .state')
                                  .textContent.startsWith({json.dumps(words)})""")


def near(value, right, off=.3):  # other work may run beside it
    assert abs(value - right) <= off * abs(right) + 1e-9, f"{value} is not near {right}"


def is_(value, right):
    assert value == right, f"{value!r} is not {right!r}"


def check_figures(sight):
    sight.readings(8)
    is_(sight.text("#status"), "all 3 replicas up")
    for name, rate in (("replica-0", 4), ("replica-1", 2), ("replica-2", 40)):
        near(sight.number("edits", name), rate)
        is_(sight.state(name), "up")
    near(sight.number("edits"), 46)
    assert sight.figure("edits").endswith("per second"), sight.figure("edits")
    is_(sight.figure("busy"), "3 of 6")
    is_(sight.figure("busy", "replica-0"), "1 of 2")
    is_(sight.figure("wait"), "0.25 s on average")
    is_(sight.figure("wait", "replica-2"), "0.25 s")
    is_(sight.figure("queued", "replica-2"), "3")
    is_(sight.figure("sharing"), "6 objects")
    is_(sight.figure("memory", "replica-1"), "120 of 1,344 MiB")
    for source, share in (("memory", "60.0 %"), ("disk", "20.0 %"), ("tier", "15.0 %"),
                          ("remade", "5.0 %")):
        is_(sight.text(f"[data-source={source}]"), share)
        drawn = sight.browser.evaluate(f"""(() => {{
            const part = document.querySelector('[data-replica=replica-2] .share .{source}');
            return part.offsetWidth / part.parentElement.offsetWidth; }})()""")
        assert abs(drawn - float(share[:-2]) / 100) < .02, f"{source}: {drawn}"


def check_restart(sight, farm):
    """No rate below 0, and what was counted stays counted."""
    sight.browser.evaluate("""window.least = Infinity; new MutationObserver(() => {
        for (const each of document.querySelectorAll('[data-figure=edits]'))
          least = Math.min(least, parseFloat(each.innerText));
      }).observe(document.body, {subtree: true, childList: true, characterData: true}); 0""")
    farm.restart("replica-2")
    sight.readings(4)
    least = sight.browser.evaluate("least")
    assert least >= 0, f"{least} edits per second"
    is_(sight.text("[data-source=memory]"), "60.0 %")
    assert 5 < sight.number("edits", "replica-2") <= 52, sight.figure("edits", "replica-2")


def check_away(sight, farm):
    farm.away.add("replica-1")
    sight.wait_for_state("replica-1", "away since ")
    sight.readings(1)
    is_(sight.text("#status"), "2 of 3 replicas up")
    is_(sight.figure("busy"), "2 of 4")
    for figure in ("edits", "busy", "wait", "sharing", "memory"):
        is_(sight.figure(figure, "replica-1"), "\u2013")
    since = sight.state("replica-1")
    sight.readings(5)
    is_(sight.state("replica-1"), since)
    farm.restart("replica-1")
    farm.away.clear()
    sight.wait_for_state("replica-1", "up")
    sight.readings(8)
    near(sight.number("edits", "replica-1"), 2)
    is_(sight.text("#status"), "all 3 replicas up")


def check_study(sight, farm):
    is_(sight.text("#study-done"), "none yet")
    begun = time.time() - 100
    farm.study = {
        "model": "tool1-a", "nodes": 15000, "designs": 1000, "unit": "mm", "parameters": [],
        "state": "running", "begun": begun, "seconds": 100, "done": 500, "failed": 3, "waiting": 0,
        "lightest": {"volume": 110835.58, "values": {"pin_radius": 4, "bore.radius": 8.25}},
        "course": [[t, 5 * t] for t in range(101)], "kept": .731}
    sight.readings(2)
    is_(sight.text("#study-done"), "500 of 1,000 designs done")
    is_(sight.text("#study-facts [data-figure=speed]"), "5.0 designs per second")
    is_(sight.text("#study-facts [data-figure=left]"), "about 1 min 39 s")
    is_(sight.text("#study-facts [data-figure=failed]"), "3")
    is_(sight.text("#study-facts [data-figure=kept]"), "73 % of the nodes")
    is_(sight.text("#study-facts [data-figure=lightest]"), "110,836 mm\u00b3")
    is_(sight.text("#study-note"), "The lightest has pin radius 4, bore radius 8.25.")
    bar = "document.querySelector('#study .bar')"
    is_(sight.browser.evaluate(f"{bar}.getAttribute('aria-valuenow')"), "503")
    farm.study = {**farm.study, "waiting": 2}
    sight.readings(2)
    is_(sight.text("#study-note"), "Some of it waits for a replica.")
    farm.study = {**farm.study, "begun": begun - 60}
    sight.readings(2)
    assert sight.text("#study-note").startswith("No news of the study for 1 min"), \
        sight.text("#study-note")
    farm.study = {**farm.study, "state": "finished", "done": 997, "seconds": 200, "waiting": 0}
    sight.readings(2)
    is_(sight.text("#study-facts [data-figure=taken]"), "3 min 20 s")
    is_(sight.text("#study-facts [data-figure=speed]"), "5.0 designs per second")


def check_no_connection(sight, farm):
    farm.silent = True
    sight.browser.wait_for("document.getElementById('status').innerText == 'No connection to the farm'")
    is_(sight.state("replica-0"), "up")  # what was known stays
    farm.silent = False
    sight.browser.wait_for("document.getElementById('status').innerText == 'all 3 replicas up'")


def check_made_up(browser):
    farm = MadeUp({"replica-0": 4, "replica-1": 2, "replica-2": 40})
    try:
        sight = Sight(browser, farm.url)
        check_figures(sight)
        check_study(sight, farm)
        check_restart(sight, farm)
        check_away(sight, farm)
        check_no_connection(sight, farm)
    finally:
        farm.close()
    problems = [each for each in browser.problems if "Failed to load resource" not in each]
    is_(problems, [])
    browser.problems.clear()


def take_pictures(browser, folder, name):
    for scheme in ("light", "dark"):
        for size, width in (("wide", 1160), ("narrow", 420)):
            browser.look(width, 860, scheme)
            height = browser.evaluate("document.documentElement.scrollHeight")
            browser.look(width, height, scheme)  # all of it
            browser.drawn()
            beyond = browser.evaluate("document.documentElement.scrollWidth - innerWidth")
            assert beyond <= 0, f"{scheme} {size}: the page is {beyond} pixels too wide"
            browser.picture(folder / f"{name}-{scheme}-{size}.png")
    browser.look(1160, 860, "light")


def check_real(browser, arguments):
    with WholeFarm(arguments.remeshd) as farm:
        study = farm.study("--nodes", arguments.nodes, "--vary", f"pin_radius=4:5.5:{arguments.levels}",
                           "--vary", "hole_circle=36:33:3", "--vary", "bore.radius=9:7.5:3",
                           "--loop", 6)
        try:
            sight = Sight(browser, farm.url)
            of_all = 9 * arguments.levels
            done = "parseInt(document.getElementById('study-done').innerText) >= "
            browser.wait_for(done + str(of_all // 4))
            for number in range(3):
                is_(sight.state(f"replica-{number}"), "up")
            sight.readings(3)
            assert 0 < sight.number("edits") < 1000, sight.figure("edits")
            victim = max(range(3), key=lambda k: sum(farm.replicas[k].revisions_from().values()))
            farm.replicas[victim].kill()
            sight.wait_for_state(f"replica-{victim}", "away since ")
            is_(sight.text("#status"), "2 of 3 replicas up")
            browser.wait_for(done + str(of_all // 2))
            take_pictures(browser, arguments.pictures, "away")
            farm.replicas[victim].start()
            sight.wait_for_state(f"replica-{victim}", "up")
            is_(study.wait(600), 0)
            browser.wait_for("document.getElementById('study').dataset.state == 'finished'")
            is_(sight.text("#study-done"), f"{of_all} of {of_all} designs done")
            is_(sight.text("#study-facts [data-figure=failed]"), "0")
            take_pictures(browser, arguments.pictures, "finished")
            is_([each for each in browser.problems if "Failed to load resource" not in each], [])
            is_({re.match(r"\w+:(//[^/]*)?", url)[0] for url in browser.requests
                 if farm.url in url or "127.0.0.1" not in url} - {farm.url, "about:", "data:"}, set())
        finally:
            study.terminate()
            study.wait()


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("remeshd")
    parser.add_argument("pictures", type=Path)
    parser.add_argument("--nodes", type=int, default=15000)
    parser.add_argument("--levels", type=int, default=10, help="of one parameter; 9 times as many designs")
    arguments = parser.parse_args()
    arguments.pictures.mkdir(parents=True, exist_ok=True)
    browser = Browser()
    try:
        browser.look(1160, 860, "light")
        check_made_up(browser)
        check_real(browser, arguments)
    finally:
        browser.close()


if __name__ == "__main__":
    main()
