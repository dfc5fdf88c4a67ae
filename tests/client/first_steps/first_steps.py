#!/usr/bin/env python3
"""first_steps.py BUILD PAGE: installs BUILD to a folder and runs the commands of PAGE, those in fences
marked `sh`, in their order in an empty folder. /usr/local stands for the folder. Exit 0 where all do
what they say."""
import os
import re
import subprocess
import sys
import tempfile
from pathlib import Path

BUILD, PAGE = Path(sys.argv[1]), Path(sys.argv[2])


def main():
    with tempfile.TemporaryDirectory(prefix="first-steps-") as name:
        prefix, folder = Path(name) / "prefix", Path(name) / "folder"
        folder.mkdir()
        subprocess.run(["cmake", "--install", BUILD, "--prefix", prefix], check=True,
                       stdout=subprocess.DEVNULL)
        blocks = re.findall(r"^```sh\n(.*?)^```", PAGE.read_text(), re.MULTILINE | re.DOTALL)
        assert len(blocks) >= 5, "the page has no commands"
        # Jobs are ended whatever fails, and a command that is to fail may.
        script = "set -e\ntrap 'kill $(jobs -p) 2>/dev/null || true' EXIT\n" + "\n".join(blocks)
        packages = next(prefix.glob("lib/python3*/dist-packages"))
        socket = f"unix:{name}/remeshd.sock"
        environment = dict(os.environ, PATH=f"{prefix}/bin:/usr/bin:{os.environ['PATH']}",
                           PYTHONPATH=str(packages), REMESHD_LISTEN=socket, REMESH_ADDRESS=socket,
                           PYTHONDONTWRITEBYTECODE="1")
        done = subprocess.run(["bash", "-c", script.replace("/usr/local", str(prefix))], cwd=folder,
                              env=environment, text=True, stdout=subprocess.PIPE,
                              stderr=subprocess.STDOUT)
        print(done.stdout)
        assert done.returncode == 0, f"exit {done.returncode}"
        assert "lightest within the limits" in done.stdout
        for file in ("first.vtu", "second.vtu", "second.inp", "second.json", "b.inp"):
            assert (folder / file).stat().st_size > 1000, file
        assert not (folder / "third.vtu").exists()


main()
