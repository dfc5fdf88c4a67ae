"""A farm on this machine: replicas of remeshd, and the tier that they share."""
import collections
import hashlib
import os
import re
import secrets
import shutil
import signal
import subprocess
import tempfile
import threading
import time
import urllib.request
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path

from ports import free_port, wait_for_port
from swift_tier import SwiftTier

NGINX = shutil.which("nginx") or "/usr/sbin/nginx"  # which is not in every user's path
BALANCER = Path(__file__).parent.parent.parent / "deploy/cluster/nginx.conf"


class FaultyTier:
    """Objects in memory over HTTP, by a server that can fail.

    mode: `well`; `failing`: answers 500; `full`: refuses PUT with 507; `cutting`: half of each
    body, then the end; `silent`: takes requests and never answers; `down`: nobody listens.
    """

    options = ()

    def __init__(self, _folder=None, host="127.0.0.1"):
        self._host = host
        self.objects = {}
        self._mode = "well"
        self._server = None
        self._port = free_port()
        self.url = f"http://{host}:{self._port}/objects"
        self._listen()

    @property
    def mode(self):
        return self._mode

    @mode.setter
    def mode(self, mode):
        before, self._mode = self._mode, mode
        if mode == "down":
            self._end()
        elif before == "down":
            self._listen()

    def _listen(self):
        tier = self

        class Handler(BaseHTTPRequestHandler):
            protocol_version = "HTTP/1.1"

            def log_message(self, *_):
                pass

            def _answer(self, status, body=b""):
                while tier.mode == "silent":
                    time.sleep(.02)
                    self.close_connection = True
                if tier.mode == "down" or self.close_connection:
                    self.close_connection = True
                    return
                if tier.mode == "failing":
                    status, body = 500, b"out of order"
                self.send_response(status)
                self.send_header("Content-Length", str(len(body)))
                self.end_headers()
                if self.command == "HEAD":
                    return
                if tier.mode == "cutting" and body:
                    self.wfile.write(body[:len(body) // 2])
                    self.close_connection = True
                else:
                    self.wfile.write(body)

            def do_GET(self):
                found = tier.objects.get(self.path)
                self._answer(404 if found is None else 200, found or b"")

            do_HEAD = do_GET

            def do_PUT(self):
                body = self.rfile.read(int(self.headers["Content-Length"]))
                if tier.mode == "full":
                    return self._answer(507)
                if tier.mode in ("well", "cutting"):
                    tier.objects[self.path] = body
                self._answer(201)

        self._server = ThreadingHTTPServer((self._host, self._port), Handler)
        self._server.daemon_threads = True
        self._server.handle_error = lambda *_: None  # of connections that replicas leave behind
        threading.Thread(target=self._server.serve_forever, daemon=True).start()

    def _end(self):
        self._server.shutdown()
        self._server.server_close()
        self._server = None

    def list(self):
        return {path[len("/objects/"):]: hashlib.sha256(body).hexdigest()
                for path, body in sorted(self.objects.items())}

    def get(self, key):
        return self.objects[f"/objects/{key}"]

    def put(self, key, body):
        self.objects[f"/objects/{key}"] = body

    def clear(self):
        self.objects.clear()

    def stop(self):
        if self._server is not None:
            self.mode = "down"


class Nginx:
    """Debian's nginx, in a folder of its own."""

    def __init__(self, folder, port, http):
        self._folder, self._port, self._process = Path(folder), port, None
        (self._folder / "temp").mkdir(parents=True)
        (self._folder / "nginx.conf").write_text(f"""
worker_processes 1; daemon off; pid {self._folder}/pid; error_log {self._folder}/error.log;
{"user root;" if os.geteuid() == 0 else ""}
events {{}}
http {{
  access_log off; client_body_temp_path {self._folder}/temp;
  {http}
}}""")
        self.start()

    def start(self):
        self._process = subprocess.Popen([NGINX, "-p", self._folder, "-c",
                                          self._folder / "nginx.conf"], stderr=subprocess.DEVNULL)
        wait_for_port(self._port)

    def stop(self):
        if self._process is not None:
            self._process.terminate()
            self._process.wait()
            self._process = None


class Balancer(Nginx):
    """The balancer of deploy/cluster/nginx.conf before these replicas."""

    def __init__(self, folder, addresses):
        port = free_port()
        self.address = f"127.0.0.1:{port}"
        lines = [line.replace("listen 50050", f"listen {self.address}")
                 for line in BALANCER.read_text().splitlines()]
        server = next(line for line in lines if line.startswith("  server "))
        at = lines.index(server)
        lines = [line for line in lines if not line.startswith("  server ")]
        lines[at:at] = [re.sub(r"server \S+", f"server {each}", server) for each in addresses]
        super().__init__(folder, port, "\n".join(lines))


class NginxTier(Nginx):
    """A folder behind nginx by WebDAV."""

    options = ()

    def __init__(self, folder):
        port = free_port()
        self.url = f"http://127.0.0.1:{port}"
        super().__init__(folder, port, f"""
  client_max_body_size 0; keepalive_requests 100000;
  server {{
    listen 127.0.0.1:{port};
    location / {{
      root {folder}/objects; dav_methods PUT DELETE; create_full_put_path on;
      autoindex on; autoindex_format json;
    }}
  }}""")
        self._objects = self._folder / "objects"
        self._objects.mkdir()

    def list(self):
        return {str(path.relative_to(self._objects)): hashlib.sha256(path.read_bytes()).hexdigest()
                for path in self._objects.rglob("*") if path.is_file()}

    def get(self, key):
        return (self._objects / key).read_bytes()

    def put(self, key, body):
        (self._objects / key).write_bytes(body)

    def clear(self):
        for entry in self._objects.iterdir():
            shutil.rmtree(entry)


TIERS = {"faulty": FaultyTier, "nginx": NginxTier, "swift": SwiftTier}


def add_tier_option(parser, *names):
    """--tier, of some of TIERS, the first by default."""
    parser.add_argument("--tier", choices=names, default=names[0],
                        help="swift: Debian's, by its S3 interface (default: %(default)s)")


class Replica:
    """One daemon with a store of its own; started again it has the address that it had."""

    def __init__(self, program, folder, options, metrics=False, address="", within=()):
        """address: default: a free port of loopback. within: what the command is to begin with."""
        self._program, self._folder, self._options = program, Path(folder), options
        self.metrics_address = f"127.0.0.1:{free_port()}" if metrics else ""
        if metrics:
            self._options = [*options, "--metrics", self.metrics_address]
        self._folder.mkdir(parents=True)
        self.address, self._within = address or f"127.0.0.1:{free_port()}", within
        self.process = None
        self.start()

    def start(self):
        port_file = self._folder / "port"
        port_file.unlink(missing_ok=True)
        self.process = subprocess.Popen(
            [*self._within, self._program, "--listen", self.address, "--store",
             self._folder / "store", "--port-file", port_file, "--log-file", self._folder / "log",
             *self._options])
        for _ in range(6000):
            if port_file.exists() and port_file.read_text().strip():
                break
            if self.process.poll() is not None:
                raise RuntimeError((self._folder / "log").read_text())
            time.sleep(.01)
        self.address = port_file.read_text().split()[0]

    def revisions_from(self):
        """How often a revision came from where, since it was started: `computed`, `tier`, ..."""
        with urllib.request.urlopen(f"http://{self.metrics_address}/metrics") as page:
            text = page.read().decode()
        return collections.Counter({result: float(count) for result, count in re.findall(
            r'remeshd_cache_requests_total\{result="(\w+)"\} (\S+)', text)})

    def kill(self):
        self.process.kill()
        self.process.wait()

    def stop(self):
        if self.process.poll() is None:
            self.process.send_signal(signal.SIGTERM)
            self.process.wait()

    def log(self):
        return (self._folder / "log").read_text()

    def lose_store(self):
        """As a machine that is replaced. Pre: it does not run."""
        shutil.rmtree(self._folder / "store")


class Bed:
    """Replicas over a tier; a context manager.

    tier: makes one, given a folder that is not there yet. It has `url`, `options` of the daemon, `list`
    of keys with digests, `get`, `put`, `clear`, `stop`; some have a `mode`.
    """

    def __init__(self, program, tier, replicas=3, acknowledge="tier", options=(),
                 metrics=False):
        self.folder = Path(tempfile.mkdtemp(prefix="remesh-farm-"))
        key = self.folder / "key"
        key.write_text(secrets.token_hex(16))
        key.chmod(0o600)
        self.tier = tier(self.folder / "tier")
        self.options = ["--tier", self.tier.url, *self.tier.options, "--tier-key-file", key, "--tier-ack",
                         acknowledge, "--workers", "1", "--grace", "2", *options]
        self._program, self._metrics = program, metrics
        self.replicas, self._balancer = [], None
        for _ in range(replicas):
            self.add()

    def add(self, address="", options=()):
        self.replicas.append(Replica(self._program, self.folder / f"replica{len(self.replicas)}",
                                     [*self.options, *options], self._metrics, address))
        return self.replicas[-1]

    @property
    def addresses(self):
        return [replica.address for replica in self.replicas]

    def balance(self):
        """A balancer before the replicas that there are."""
        self._balancer = Balancer(self.folder / "balancer", self.addresses)
        return self._balancer

    def __enter__(self):
        return self

    def __exit__(self, *_):
        if self._balancer is not None:
            self._balancer.stop()
        for replica in self.replicas:
            replica.stop()
        self.tier.stop()
        shutil.rmtree(self.folder, ignore_errors=True)
