"""Runs `remesh` without a daemon, in a folder that is its store too."""
import os
import subprocess
from pathlib import Path


def environment(cli, folder):
    """In which `remesh` is the program under test and works in its own process."""
    path = f"{Path(cli).resolve().parent}:{os.environ['PATH']}"
    return dict(os.environ, PATH=path, REMESH_ADDRESS="local", XDG_CACHE_HOME=str(folder))


def run(cli, folder, *arguments):
    """Output of a command that has to go well."""
    done = subprocess.run(list(map(str, arguments)), cwd=folder, env=environment(cli, folder),
                          capture_output=True, text=True)
    assert done.returncode == 0, f"{arguments}: exit {done.returncode}\n{done.stdout}{done.stderr}"
    return done.stdout


def mesh_bracket(cli, folder, *options):
    run(cli, folder, "remesh", "example", "bracket", "-o", "bracket.json")
    return run(cli, folder, "remesh", "mesh", "bracket.json", *options)
