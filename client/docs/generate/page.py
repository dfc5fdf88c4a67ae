"""Pages with generated parts, and `remesh` to make them with."""
import difflib
import json
import os
import re
import subprocess
import sys
import time
from pathlib import Path

DOCS = Path(__file__).resolve().parent.parent
ROOT = DOCS.parent.parent


def replaced(text, name, content):
    """The page with `content` between its markers of that name."""
    begin, end = f"<!-- {name}: begin -->", f"<!-- {name}: end -->"
    head, rest = text.split(begin)
    return f"{head}{begin}\n{content.strip()}\n{end}{rest.split(end)[1]}"


def cell(text):
    """Text for a cell of a table."""
    return text.replace("|", "\\|").replace("\n", "<br>")


def json_blocks(text):
    """(model that the block is an edit of or None, JSON text) of each fenced block of JSON."""
    return [(match[1], match[2])
            for match in re.finditer(r"(?:<!-- for: (\w+) -->\n)?```json\n(.*?)```", text, re.DOTALL)]


def named_models(text):
    """The models of a page by their names."""
    models = [json.loads(block) for of, block in json_blocks(text) if of is None]
    return {model["name"]: model for model in models}


def settle(file, old, new):
    """Writes the page with --write; else ends with exit code 1 where it is not as it has to be."""
    if "--write" in sys.argv:
        file.write_text(new)
    elif new != old:
        print(*difflib.unified_diff(old.splitlines(), new.splitlines(), file.name, "now", lineterm=""),
              f"{Path(sys.argv[0]).name} REMESH --write writes them", sep="\n")
        sys.exit(1)


class Remesh:
    """`remesh` in a folder, with a daemon of its own, which must lie beside it. A context manager. `options` are
    the daemon's."""

    def __init__(self, program, folder, *options, **environment):
        self.folder, self.bin, self.options = Path(folder), Path(program).resolve().parent, options
        self.environment = dict(os.environ, PATH=f"{self.bin}:{os.environ['PATH']}",
                                REMESH_ADDRESS=f"unix:{folder}/remeshd.sock", **environment)

    def __enter__(self):
        self.daemon = subprocess.Popen(
            [self.bin / "remeshd", "--listen", self.environment["REMESH_ADDRESS"], "--log-file",
             self.folder / "remeshd.log", *self.options], cwd=self.folder, env=self.environment, stderr=subprocess.DEVNULL)
        until = time.monotonic() + 60
        while self.run("info")[0] == 5:
            assert self.daemon.poll() is None and time.monotonic() < until, "remeshd does not start"
            time.sleep(0.05)
        return self

    def __exit__(self, *_):
        self.daemon.terminate()
        self.daemon.wait(60)

    def run(self, *arguments, within=".", program="remesh"):
        """Exit code, stdout, stderr. `within`: a folder in the folder."""
        done = subprocess.run([program, *map(str, arguments)], cwd=self.folder / within, env=self.environment,
                              capture_output=True, text=True)
        return done.returncode, done.stdout, done.stderr

    def output(self, *arguments):
        """stdout of a command that has to go well."""
        code, out, err = self.run(*arguments)
        assert code == 0, f"remesh {arguments}: exit {code}\n{err}"
        return out
