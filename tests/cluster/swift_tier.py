"""Debian's OpenStack Swift as tier: its S3 interface, by processes of this user on loopback.

A proxy with tempauth and s3api, and an account, a container and an object server, with one copy of
everything on one device, a folder of a file system that has extended attributes. Takes Debian's
python3-swift, python3-boto3 (an S3 client that is not ours) and memcached.
"""
import os
import pwd
import secrets
import signal
import subprocess
from pathlib import Path

import ports

REGION, BUCKET, USER = "us-east-1", "remesh", "farm:daemon"
PYTHON = "/usr/bin/python3"  # the one that has Debian's packages
SERVER = """
import os, sys
from swift.common import utils, wsgi
utils.set_swift_dir(os.getcwd())
sys.exit(wsgi.run_wsgi(*sys.argv[1:]))
"""
RING = """
import os, sys
from swift.common import utils
utils.set_swift_dir(sys.argv[1])
from swift.common.ring import RingBuilder
for kind, port in zip(("account", "container", "object"), sys.argv[2:]):
    builder = RingBuilder(part_power=1, replicas=1, min_part_hours=0)
    builder.add_dev({"region": 1, "zone": 1, "weight": 1.0, "device": "disk", "meta": "",
                     "ip": "127.0.0.1", "port": int(port), "replication_ip": "127.0.0.1",
                     "replication_port": int(port)})
    builder.rebalance()
    builder.get_ring().save(f"{sys.argv[1]}/{kind}.ring.gz")
"""
PROXY = """
[pipeline:main]
pipeline = catch_errors cache s3api tempauth bulk slo proxy-server
[app:proxy-server]
use = egg:swift#proxy
account_autocreate = true
[filter:catch_errors]
use = egg:swift#catch_errors
[filter:cache]
use = egg:swift#memcache
memcache_servers = 127.0.0.1:{memcached}
[filter:s3api]
use = egg:swift#s3api
location = {region}
[filter:tempauth]
use = egg:swift#tempauth
user_{user} = {secret} .admin
[filter:bulk]
use = egg:swift#bulk
[filter:slo]
use = egg:swift#slo
"""
STORE = """
[pipeline:main]
pipeline = {kind}-server
[app:{kind}-server]
use = egg:swift#{kind}
# The list of a bucket has an object when its PUT is answered, however busy the machine is.
container_update_timeout = 30
"""


class SwiftTier:
    """A bucket of its own. mode: `well`; `silent`: all its processes are stopped; `down`: killed."""

    def __init__(self, folder):
        self._folder = Path(folder)
        (self._folder / "devices/disk").mkdir(parents=True)
        os.setxattr(self._folder / "devices", "user.remesh", b"there are extended attributes")
        self._secret, self._mode, self._processes = secrets.token_hex(16), "well", []
        self._ports = {each: ports.free_port()
                       for each in ("proxy", "account", "container", "object", "memcached")}
        self.url = f"http://127.0.0.1:{self._ports['proxy']}/{BUCKET}"
        self._write_configuration()
        credentials = self._folder / "credentials"
        credentials.write_text(f"{USER} {self._secret}\n")
        credentials.chmod(0o600)
        self.options = ["--tier-s3-region", REGION, "--tier-s3-credentials-file", credentials]
        try:
            self._start()
            self._client = self._connect()
            self._client.create_bucket(Bucket=BUCKET)
        except BaseException:
            self.stop()
            raise

    def _write_configuration(self):
        (self._folder / "swift.conf").write_text(
            f"[swift-hash]\nswift_hash_path_suffix = {secrets.token_hex(8)}\n")
        subprocess.run([PYTHON, "-c", RING, self._folder,
                        *(str(self._ports[each]) for each in ("account", "container", "object"))],
                       check=True)
        for kind in ("proxy", "account", "container", "object"):
            special = PROXY.format(memcached=self._ports["memcached"], region=REGION,
                                   user=USER.replace(":", "_"), secret=self._secret)
            (self._folder / f"{kind}.conf").write_text(f"""[DEFAULT]
bind_ip = 127.0.0.1
bind_port = {self._ports[kind]}
user = {pwd.getpwuid(os.geteuid()).pw_name}
swift_dir = {self._folder}
devices = {self._folder}/devices
mount_check = false
disable_fallocate = true
workers = 0
{special if kind == "proxy" else STORE.format(kind=kind)}""")

    def _start(self):
        lines = [["memcached", "-l", "127.0.0.1", "-p", str(self._ports["memcached"]), "-U", "0",
                  "-m", "64", *(["-u", "root"] if os.geteuid() == 0 else [])]]
        lines += [[PYTHON, "-c", SERVER, self._folder / f"{kind}.conf", f"{kind}-server"]
                  for kind in ("account", "container", "object", "proxy")]
        with open(self._folder / "log", "ab") as log:
            self._processes = [
                subprocess.Popen(line, cwd=self._folder, stdout=log, stderr=log) for line in lines]
        for port in self._ports.values():
            ports.wait_for_port(port)

    def _connect(self):
        import boto3  # pylint: disable=import-outside-toplevel
        from botocore.config import Config  # pylint: disable=import-outside-toplevel
        return boto3.client(
            "s3", endpoint_url=self.url.rpartition("/")[0], region_name=REGION,
            aws_access_key_id=USER, aws_secret_access_key=self._secret,
            config=Config(s3={"addressing_style": "path"}))

    @property
    def mode(self):
        return self._mode

    @mode.setter
    def mode(self, mode):
        before, self._mode = self._mode, mode
        if before == "silent":
            self._signal(signal.SIGCONT)
        if mode == "silent":
            self._signal(signal.SIGSTOP)
        elif mode == "down":
            self._end()
        elif before == "down":
            self._start()

    def _signal(self, number):
        for process in self._processes:
            process.send_signal(number)

    def _end(self):
        self._signal(signal.SIGKILL)
        for process in self._processes:
            process.wait()
        self._processes = []

    def list(self):
        pages = self._client.get_paginator("list_objects_v2").paginate(Bucket=BUCKET)
        return {each["Key"]: each["ETag"] for page in pages for each in page.get("Contents", [])}

    def get(self, key):
        return self._client.get_object(Bucket=BUCKET, Key=key)["Body"].read()

    def put(self, key, body):
        self._client.put_object(Bucket=BUCKET, Key=key, Body=body)

    def clear(self):
        for key in self.list():
            self._client.delete_object(Bucket=BUCKET, Key=key)

    def stop(self):
        self._end()
