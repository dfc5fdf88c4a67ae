"""Debian's Slurm on this machine: munged, slurmctld and slurmds, from files in a scratch folder."""
import os
import pwd
import secrets
import socket
import subprocess
import time
from pathlib import Path

from ports import free_port, wait_for_port

KILL_WAIT = 15  # s between SIGTERM and SIGKILL


class Slurm:
    """A cluster of pretended nodes, each with so many processors; a context manager."""

    def __init__(self, folder, nodes=2, processors=2):
        self._folder, self._processes = Path(folder), []
        self.environment = {**{name: value for name, value in os.environ.items()
                               if not name.startswith("SLURM_")},
                            "SLURM_CONF": str(self._folder / "slurm.conf")}
        self._write(nodes, processors)
        try:
            self._start("munged", "--foreground", "--force", "--key-file", self._folder / "munge.key",
                        "--socket", self._folder / "munge.socket", "--log-file",
                        self._folder / "munge.log", "--pid-file", self._folder / "munge.pid",
                        "--seed-file", self._folder / "munge.seed")
            self._wait(lambda: (self._folder / "munge.socket").exists(), "munged")
            self._start("slurmctld", "-D", "-i")
            wait_for_port(self._port)
            for node in range(nodes):
                self._start("slurmd", "-D", "-N", f"n{node + 1}")
            self._wait(lambda: self.run("sinfo", "-h", "-o", "%T %D") == f"idle {nodes}", "slurmd")
        except BaseException:
            self.stop()
            raise

    def _write(self, nodes, processors):
        self._folder.mkdir(parents=True, exist_ok=True)
        key = self._folder / "munge.key"
        key.write_bytes(secrets.token_bytes(128))
        key.chmod(0o400)
        for name in ("state", *(f"spool-n{node + 1}" for node in range(nodes))):
            (self._folder / name).mkdir()
        self._port, host = free_port(), socket.gethostname()
        user = pwd.getpwuid(os.geteuid()).pw_name
        lines = [f"NodeName=n{node + 1} NodeHostname={host} NodeAddr=127.0.0.1 Port={free_port()} "
                 f"CPUs={processors} State=UNKNOWN" for node in range(nodes)]
        (self._folder / "slurm.conf").write_text("\n".join([
            "ClusterName=scratch", f"SlurmctldHost={host}(127.0.0.1)", f"SlurmctldPort={self._port}",
            f"SlurmUser={user}", f"SlurmdUser={user}",
            # One that is put back into the queue waits until its credential has expired.
            f"AuthType=auth/munge\nAuthInfo=socket={self._folder}/munge.socket,cred_expire=5",
            f"StateSaveLocation={self._folder}/state",
            f"SlurmdSpoolDir={self._folder}/spool-%n", f"SlurmdPidFile={self._folder}/slurmd-%n.pid",
            f"SlurmctldPidFile={self._folder}/slurmctld.pid",
            f"SlurmctldLogFile={self._folder}/slurmctld.log",
            f"SlurmdLogFile={self._folder}/slurmd-%n.log",
            "ProctrackType=proctrack/linuxproc", "TaskPlugin=task/none", "SwitchType=switch/none",
            "SelectType=select/cons_tres", "SelectTypeParameters=CR_CPU", "MpiDefault=none",
            "JobAcctGatherType=jobacct_gather/none", "AccountingStorageType=accounting_storage/none",
            "CommunicationParameters=NoInAddrAny,NoCtldInAddrAny", "ReturnToService=2",
            "SlurmdParameters=config_overrides", "SchedulerType=sched/builtin", f"KillWait={KILL_WAIT}",
            *lines, "PartitionName=all Nodes=ALL Default=YES MaxTime=INFINITE State=UP", ""]))

    def _start(self, program, *options):
        with open(self._folder / "out", "ab") as out:
            self._processes.append(subprocess.Popen(
                [program, *options], env=self.environment, cwd=self._folder, stdout=out, stderr=out))

    def _wait(self, what, name):
        for _ in range(600):
            if what():
                return
            for process in self._processes:
                if process.poll() is not None:
                    raise RuntimeError(f"{process.args[0]} has ended:\n{self._said()}")
            time.sleep(.1)
        raise TimeoutError(f"{name} is not ready:\n{self._said()}")

    def _said(self):
        return "\n".join(f"{path.name}: {path.read_text(errors='replace')[-2000:]}"
                         for path in [self._folder / "out", *self._folder.glob("*.log")]
                         if path.exists())

    def run(self, *line, **environment):
        """What a command says. Raises CalledProcessError."""
        return subprocess.run(line, env={**self.environment, **environment}, check=True, text=True,
                              stdout=subprocess.PIPE).stdout.strip()

    def jobs(self, *states):
        """Of each that is not over, or in these states: its id, node, name and task of the array."""
        told = self.run("squeue", "-h", "-r", "-o", "%A %N %j %K",
                        *(["-t", ",".join(states)] if states else []))
        return [tuple(line.split(" ")) for line in told.splitlines()]

    def details(self, job):
        """Its fields, as scontrol tells them."""
        told = self.run("scontrol", "-o", "show", "job", str(job))
        return dict(word.partition("=")[::2] for word in told.split() if "=" in word)

    def stop(self):
        if any(process.args[0] == "slurmctld" for process in self._processes):
            subprocess.run(["scancel", "--full", "--user", str(os.geteuid())], env=self.environment,
                           check=False, stderr=subprocess.DEVNULL)
            for _ in range(10 * KILL_WAIT):
                if not self.jobs():
                    break
                time.sleep(.2)
        for process in reversed(self._processes):
            process.terminate()
            try:
                process.wait(20)
            except subprocess.TimeoutExpired:
                process.kill()
                process.wait()
        self._processes = []

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.stop()
