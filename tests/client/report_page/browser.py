"""Chromium without a screen, told what to do over a pipe by the DevTools protocol."""
import base64
import contextlib
import fcntl
import json
import os
import select
import shutil
import signal
import subprocess
import tempfile
import time

KEYS = {"Escape": 27, "ArrowLeft": 37, "Home": 36, "Enter": 13}


class Browser:
    """One page. `problems` gathers what it logs and throws, `requests` the addresses it asks for."""

    def __init__(self, patience=120):
        program = shutil.which("chromium")
        assert program, "chromium is missing: see deploy/packages-test.txt"
        self.problems, self.requests = [], []
        self.patience, self.number, self.answers, self.rest = patience, 0, {}, b""
        to_browser, self.out = os.pipe()
        self.into, from_browser = os.pipe()
        # Helpers of Chromium may write here while it ends; what they leave behind fails no test.
        self.profile = tempfile.TemporaryDirectory(prefix="browser-", ignore_cleanup_errors=True)
        # Chromium reads from 3 and writes to 4; high numbers are not in the way of that.
        ends = [fcntl.fcntl(end, fcntl.F_DUPFD, 20) for end in (to_browser, from_browser)]
        self.process = subprocess.Popen(
            ["bash", "-c", f'exec "$@" 3<&{ends[0]} 4>&{ends[1]}', "chromium", program, "--headless",
             "--no-sandbox",  # which root and containers cannot have; the page is our own
             "--disable-dev-shm-usage", "--no-first-run", "--disable-background-networking",
             "--use-angle=swiftshader", "--enable-unsafe-swiftshader",  # 3-D without a graphics card
             f"--user-data-dir={self.profile.name}", "--remote-debugging-pipe", "about:blank"],
            pass_fds=ends, start_new_session=True,
            stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        for end in (to_browser, from_browser, *ends):
            os.close(end)
        self.session = None
        target = self.call("Target.createTarget", url="about:blank")["targetId"]
        self.session = self.call("Target.attachToTarget", targetId=target, flatten=True)["sessionId"]
        for domain in ("Page", "Runtime", "Log", "Network"):
            self.call(f"{domain}.enable")

    def close(self):
        os.close(self.out)
        os.close(self.into)
        self.process.terminate()
        self.process.wait(30)
        with contextlib.suppress(ProcessLookupError):  # no helper is left
            os.killpg(self.process.pid, signal.SIGKILL)
        self.profile.cleanup()

    def receive(self, until):
        while b"\0" not in self.rest:
            ready, _, _ = select.select([self.into], [], [], max(0, until - time.monotonic()))
            assert ready, "the browser does not answer"
            read = os.read(self.into, 1 << 20)
            assert read, "the browser has ended"
            self.rest += read
        text, self.rest = self.rest.split(b"\0", 1)
        message = json.loads(text)
        if "id" in message:
            self.answers[message["id"]] = message
        else:
            self.note(message["method"], message.get("params", {}))

    def note(self, event, values):
        if event == "Runtime.exceptionThrown":
            self.problems.append(str(values["exceptionDetails"]))
        elif event == "Runtime.consoleAPICalled":
            self.problems.append(f'{values["type"]}: {[a.get("value") for a in values["args"]]}')
        elif event == "Log.entryAdded":
            text = values["entry"]["text"]
            # Said of every picture that is read back from the software renderer.
            if "GL Driver Message" not in text:
                self.problems.append(text)
        elif event == "Network.requestWillBeSent":
            self.requests.append(values["request"]["url"])

    def call(self, method, **values):
        self.number += 1
        message = {"id": self.number, "method": method, "params": values}
        if self.session:
            message["sessionId"] = self.session
        os.write(self.out, json.dumps(message).encode() + b"\0")
        until = time.monotonic() + self.patience
        while self.number not in self.answers:
            self.receive(until)
        answer = self.answers.pop(self.number)
        assert "error" not in answer, answer
        return answer["result"]

    def evaluate(self, script):
        result = self.call("Runtime.evaluate", expression=script, returnByValue=True, awaitPromise=True)
        assert "exceptionDetails" not in result, result["exceptionDetails"]
        return result["result"].get("value")

    def wait_for(self, script):
        """Waits until the expression is true; returns its value."""
        until = time.monotonic() + self.patience
        while True:
            value = self.evaluate(script)
            if value:
                return value
            assert time.monotonic() < until, f"never true: {script}"
            time.sleep(0.05)

    def open(self, page, fragment=""):
        """Opens a file and waits until it has drawn itself."""
        self.call("Page.navigate", url="about:blank")
        self.call("Page.navigate", url=f"file://{page}{fragment}")
        self.wait_for("['ready', 'failed'].includes(document.documentElement?.dataset.state)")
        self.drawn()

    def drawn(self):
        self.evaluate("new Promise(f => requestAnimationFrame(() => requestAnimationFrame(f)))")

    def look(self, width, height, scheme):
        """Size of the window, and whether the user likes it `light` or `dark`."""
        self.call("Emulation.setDeviceMetricsOverride", width=width, height=height,
                  deviceScaleFactor=1, mobile=False)
        self.call("Emulation.setEmulatedMedia", features=[
            {"name": "prefers-color-scheme", "value": scheme},
            {"name": "prefers-reduced-motion", "value": "reduce"}])

    def press(self, key):
        for kind in ("keyDown", "keyUp"):
            text = {"text": "\r"} if key == "Enter" and kind == "keyDown" else {}
            self.call("Input.dispatchKeyEvent", type=kind, key=key, code=key,
                      windowsVirtualKeyCode=KEYS[key], **text)

    def picture(self, file):
        self.drawn()
        file.write_bytes(base64.b64decode(self.call("Page.captureScreenshot", format="png")["data"]))
