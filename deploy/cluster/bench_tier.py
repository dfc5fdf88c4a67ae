"""nginx as shared tier, which tells each request, and as balancer; what processes take."""
import os
import re
import shutil
import socket
import subprocess
import time
from pathlib import Path

_LINE = re.compile(r"(\w+) (\d+) (\d+) (\d+) ([\d.]+) /(?:tenants/[^/]+/)?(\w+)/\w+/(\w+)")
_TICK = os.sysconf("SC_CLK_TCK")


class Nginx:
    """nginx with one worker process on a free port of this machine."""

    def __init__(self, folder, http, server):
        """folder: goes with it. http, server: what stands in these blocks of its configuration."""
        self.folder = Path(folder)
        (self.folder / "temp").mkdir(parents=True)
        with socket.socket() as free:
            free.bind(("127.0.0.1", 0))
            self.port = free.getsockname()[1]
        (self.folder / "nginx.conf").write_text(f"""
worker_processes 1; daemon off; pid {self.folder}/pid; error_log {self.folder}/error.log;
{"user root;" if os.geteuid() == 0 else ""}
events {{}}
http {{
  client_max_body_size 0; client_body_temp_path {self.folder}/temp; keepalive_requests 100000;
  {http}
  server {{ {server.replace("PORT", str(self.port))} }}
}}""")
        self._process = subprocess.Popen(["nginx", "-p", self.folder, "-c",
                                          self.folder / "nginx.conf"], stderr=subprocess.DEVNULL)
        for _ in range(500):
            with socket.socket() as probe:
                if probe.connect_ex(("127.0.0.1", self.port)) == 0:
                    break
            time.sleep(.02)

    def cpu_seconds(self):
        """Of its worker process."""
        children = subprocess.run(["pgrep", "-P", str(self._process.pid)], check=True,
                                  capture_output=True, text=True).stdout.split()
        # ns, of a process with one thread
        return sum(int(Path(f"/proc/{child}/schedstat").read_text().split()[0])
                   for child in children) / 1e9

    def stop(self):
        self._process.terminate()
        self._process.wait()
        shutil.rmtree(self.folder, ignore_errors=True)


class Balancer(Nginx):
    """Before one replica, as clients without the library use it."""

    def __init__(self, folder, address):
        super().__init__(folder, "access_log off;", f"""
    listen 127.0.0.1:PORT http2;
    location / {{ grpc_pass grpc://{address}; grpc_read_timeout 1h; grpc_send_timeout 1h; }}""")
        self.address = f"127.0.0.1:{self.port}"


class LoggedTier(Nginx):
    """Objects in a folder behind nginx by WebDAV, with a line in a log for each request."""

    def __init__(self, folder):
        super().__init__(folder, f"""
  log_format one '$request_method $status $request_length $body_bytes_sent $request_time $uri';
  access_log {folder}/access.log one;""", f"""
    listen 127.0.0.1:PORT;
    location / {{ root {folder}/objects; dav_methods PUT; create_full_put_path on; }}""")
        (self.folder / "objects").mkdir()
        self.url = f"http://127.0.0.1:{self.port}"
        self._read = 0

    def requests(self):
        """Those that were answered since this was last asked: (method, status, bytes of the
        object, s, kind, revision)."""
        lines = (self.folder / "access.log").read_text().splitlines()
        fresh, self._read = lines[self._read:], len(lines)
        found = []
        for line in fresh:
            if parts := _LINE.match(line):
                method, status, received, sent, seconds, kind, revision = parts.groups()
                size = int(received if method == "PUT" else sent)
                found.append((method, int(status), size, float(seconds), kind, revision))
        return found

    def sizes(self, kind):
        """Bytes of the objects of a kind, by revision."""
        return {path.name: path.stat().st_size
                for path in (self.folder / "objects" / kind).glob("*/*")}

    def remove(self, kind, revisions):
        for path in (self.folder / "objects" / kind).glob("*/*"):
            if path.name in revisions:
                path.unlink()


def cpu_seconds(pid):
    """That a process and its ended children took; to a hundredth."""
    fields = Path(f"/proc/{pid}/stat").read_text().rsplit(")", 1)[1].split()
    return sum(int(fields[n]) for n in (11, 12, 13, 14)) / _TICK


def resident_bytes(pid):
    return int(Path(f"/proc/{pid}/statm").read_text().split()[1]) * os.sysconf("SC_PAGE_SIZE")


def bytes_received(address):
    """By this machine's connections to an address so far."""
    told = subprocess.run(["ss", "-tinHO", f"dst {address}"], check=True, capture_output=True,
                          text=True).stdout
    return sum(int(each) for each in re.findall(r"bytes_received:(\d+)", told))
