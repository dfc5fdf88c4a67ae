#!/usr/bin/env python3
"""check_completion.py REMESH SHELL PROGRAM: what a shell offers for words of `remesh`.

Exit 0 where all is well. SHELL is bash, zsh or fish, PROGRAM its executable.
"""
import subprocess
import sys
import tempfile
from pathlib import Path

CLI, SHELL, PROGRAM = sys.argv[1:4]

# Words so far, of which the last is to be completed, and what is offered among others.
CASES = [
    (["me"], {"mesh"}),
    (["--local", "me"], {"mesh"}),
    (["cache", ""], {"ls", "stat", "gc", "verify", "pin"}),
    (["cache", "ver"], {"verify"}),
    (["cache", "verify", "--rep"], {"--repair"}),
    (["mesh", "part.json", "--form"], {"--format"}),
    (["mesh", "part.json", "--format", ""], {"vtu", "msh", "inp", "step"}),
    (["cache", "ls", "--by", ""], {"used", "bytes", "created"}),
    (["log", "part", "--add"], {"--address"}),
    (["schema", ""], {"model", "edit"}),
    (["example", "br"], {"bracket", "bracket.edit"}),
    (["completion", ""], {"bash", "zsh", "fish"}),
]

# Each prints what is offered for the words "$@", one a line. zsh's own functions are replaced by
# ones that print, for they work in its line editor alone; there a prefix is compared by zsh itself.
ASK = {
    "bash": 'source {script}; COMP_WORDS=("$@"); COMP_CWORD=$(($# - 1)); _remesh; '
            'printf "%s\\n" "${{COMPREPLY[@]}}"',
    "zsh": 'compdef() {{ }}; compadd() {{ print -l -- ${{@[2,-1]}} }}; _files() {{ print FILES }}; '
           'source {script}; words=("$@"); CURRENT=$#; _remesh',
    "fish": 'source {script}; complete -C (string join " " -- $argv)',
}
FLAGS = {"bash": ["--norc", "--noprofile", "-c"], "zsh": ["-f", "-c"], "fish": ["--no-config", "-c"]}
FILES = ["mesh", "part.json", "-o", ""]


def offered(script, words):
    ask = ASK[SHELL].format(script=script)
    arguments = ["remesh", *words]
    if SHELL != "fish":
        arguments.insert(0, SHELL)  # "$0"
    done = subprocess.run([PROGRAM, *FLAGS[SHELL], ask, *arguments], capture_output=True, text=True,
                          cwd=script.parent, check=True)
    assert not done.stderr, done.stderr
    return {line.split("\t")[0] for line in done.stdout.splitlines() if line}


def main():
    with tempfile.TemporaryDirectory() as name:
        script = Path(name) / "remesh-completion"
        script.write_text(subprocess.run([CLI, "completion", SHELL], capture_output=True, text=True,
                                         check=True).stdout)
        (script.parent / "part.vtu").write_text("")
        for words, wanted in CASES:
            found = offered(script, words)
            assert wanted <= found, f"{words}: {sorted(found)}"
            if SHELL == "bash":  # which leaves the comparing to us
                assert all(word.startswith(words[-1]) for word in found), f"{words}: {sorted(found)}"
        files = offered(script, FILES)
        wanted = {"bash": set(), "zsh": {"FILES"}, "fish": {"part.vtu"}}[SHELL]
        assert wanted <= files and "mesh" not in files, files


main()
