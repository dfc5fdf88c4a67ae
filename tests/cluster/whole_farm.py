#!/usr/bin/python3
"""The farm of deploy/cluster/compose.yaml on loopback, without containers.

    PYTHONPATH=build/client/python tests/cluster/whole_farm.py build/bin/remeshd [--page PORT]

Three replicas with the options of compose.yaml, nginx as tier and as gateway with the files that
compose.yaml mounts, Debian's PostgreSQL, and deploy/cluster/study.py, which runs through it;
addresses and folders alone are others. Prints where the page is, and ends with Ctrl-C, or when the study does (--once). Options
after `--` are the study's.
"""
import argparse
import contextlib
import os
import re
import secrets
import shutil
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import yaml

from bed import NGINX, Replica, free_port, wait_for_port

CLUSTER = Path(__file__).resolve().parents[2] / "deploy/cluster"
COMPOSE = CLUSTER / "compose.yaml"
MODEL = Path(__file__).resolve().parents[1] / "cases/tool1-a.json"
CATALOGUE = "REMESHD_CATALOGUE"


def replaced(text, changes):
    """All at once: what stands for something may look like another of them."""
    return re.sub("|".join(map(re.escape, changes)), lambda found: changes[found[0]], text)


class Server:
    """nginx with nginx-main.conf and files that it includes; `changes`: what stands for what."""

    def __init__(self, folder, files, changes, port):
        folder.mkdir()
        (folder / "remeshd").mkdir()
        changes = {"/etc/nginx/remeshd": f"{folder}/remeshd", "/tmp/": f"{folder}/", **changes}
        for name, target in [("nginx-main.conf", folder / "nginx.conf"),
                             *((name, folder / "remeshd" / name) for name in files)]:
            target.write_text(replaced((CLUSTER / name).read_text(), changes))
        user = " user root;" if os.geteuid() == 0 else ""
        with (folder / "log").open("w") as log:  # each replica that was tried in vain
            self._process = subprocess.Popen([NGINX, "-p", folder, "-c", folder / "nginx.conf", "-g",
                                              f"daemon off;{user}"], stderr=log)
        try:
            wait_for_port(port)
        except TimeoutError:
            self.stop()
            raise RuntimeError((folder / "log").read_text()) from None

    def stop(self):
        self._process.terminate()
        self._process.wait()


class WholeFarm:
    """All services of compose.yaml but the study; a context manager."""

    def __init__(self, program, page_port=0, catalogue=""):
        """catalogue: URI of PostgreSQL; empty: each replica has names of its own."""
        self.folder = Path(tempfile.mkdtemp(prefix="remesh-farm-"))
        self._secrets()
        tier, self.grpc, self.page = free_port(), free_port(), page_port or free_port()
        self.address = f"127.0.0.1:{self.grpc}"
        self.url = f"http://127.0.0.1:{self.page}"
        self.study_file = self.folder / "study/study.json"
        for each in ("tier/objects", "tier/temp", "study"):
            (self.folder / each).mkdir(parents=True)
        self._servers, self.replicas = [], []
        try:
            self._servers.append(Server(self.folder / "nginx-tier", ["tier.conf"], {
                "listen 8081": f"listen 127.0.0.1:{tier}",
                "/var/lib/tier": str(self.folder / "tier")}, tier))
            options = self._options(tier, catalogue)
            for number in range(3):
                self.replicas.append(Replica(program, self.folder / f"replica-{number}", [],
                                             metrics=True, within=["env", *options]))
            names = {}
            for number, replica in enumerate(self.replicas):
                names[f"replica-{number}.remeshd:50051"] = replica.address
                names[f"replica-{number}.remeshd:50052"] = replica.metrics_address
            self._servers.append(Server(self.folder / "nginx-gateway", ["nginx.conf", "page.conf"], {
                "listen 50050": f"listen {self.address}", "listen 8080": f"listen 127.0.0.1:{self.page}",
                "/srv/page": str(CLUSTER / "page"), "/srv/study": str(self.folder / "study"), **names},
                self.page))
        except BaseException:
            self.stop()
            raise

    def _secrets(self):
        key = self.folder / "farm.key"
        key.write_text(secrets.token_hex(32))
        key.chmod(0o600)

    def _options(self, tier, catalogue):
        """The environment that compose.yaml gives a replica, here."""
        service = yaml.safe_load(COMPOSE.read_text())["services"]["replica-0"]
        given = {**service["environment"], CATALOGUE: catalogue}
        changes = {"tier:8081": f"127.0.0.1:{tier}", "/run/secrets": str(self.folder)}
        for name in ("REMESHD_LISTEN", "REMESHD_METRICS", *([] if catalogue else [CATALOGUE])):
            del given[name]  # flags say where to listen
        return [f"{name}={replaced(value, changes)}" for name, value in given.items()]

    def study(self, *options, **how):
        """Starts the study; the process."""
        return subprocess.Popen(
            [sys.executable, CLUSTER / "study.py", "--address", self.address, "--progress",
             self.study_file, "--model", MODEL, *map(str, options)], **how)

    def stop(self):
        for each in (*self._servers, *self.replicas):
            each.stop()
        shutil.rmtree(self.folder, ignore_errors=True)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.stop()


@contextlib.contextmanager
def postgres(wanted):
    """Its address; empty where it is not wanted."""
    if not wanted:
        yield ""
        return
    from postgres import Postgres
    with tempfile.TemporaryDirectory() as folder:
        server = Postgres(Path(folder) / "postgres")
        try:
            yield server.address
        finally:
            server.stop()


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("remeshd")
    parser.add_argument("--page", type=int, default=8080, metavar="PORT", help="of the page")
    parser.add_argument("--without-postgres", action="store_true",
                        help="each replica has names of its own")
    parser.add_argument("--once", action="store_true", help="end when the study does")
    arguments, study_options = parser.parse_known_args()
    with postgres(not arguments.without_postgres) as catalogue, \
            WholeFarm(arguments.remeshd, arguments.page, catalogue) as farm:
        print(f"the page: {farm.url}, clients: {farm.address}", flush=True)
        study = farm.study(*(each for each in study_options if each != "--"))
        try:
            code = study.wait()
            while not arguments.once:
                time.sleep(1)
            return code
        except KeyboardInterrupt:
            return 0
        finally:
            study.terminate()
            study.wait()


if __name__ == "__main__":
    sys.exit(main())
