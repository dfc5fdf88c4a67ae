"""Which faults a compiler takes: each mutated file alone, syntax and types only.

The mutated files lie in a folder of their own before the tree's in the search for headers, so that
the tree stays as it is.
"""
import json
import os
import re
import shlex
import shutil
import subprocess
import tempfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

INCLUDE = re.compile(r'^\s*#\s*include\s*"([^"]+)"', re.M)
HEADER = "tests/mutation/mutant.h"


def mutated(text, mutants):
    """The text with the mutants' code in place of what stands there; places do not overlap."""
    for mutant in sorted(mutants, key=lambda m: -m.place.begin):
        place = mutant.place
        text = text[:place.begin] + place.replacement(mutant.number) + text[place.end:]
    return f'#include "{HEADER}"\n#line 1\n{text}' if mutants else text


class Compiler:
    """Commands of a build of the tree `root`, from its compile_commands.json."""

    def __init__(self, root, commands):
        self.root = Path(root).resolve()
        self.entries = {}
        for entry in json.loads(Path(commands).read_text()):
            path = Path(entry["directory"], entry["file"]).resolve()
            if path.is_relative_to(self.root):
                self.entries.setdefault(str(path.relative_to(self.root)), entry)
        self._included = {}

    def included(self, path):
        """The tree's files that a file includes, however indirectly, and the file."""
        if path not in self._included:
            found, left = set(), [path]
            while left:
                file = left.pop()
                if file not in found and (self.root / file).is_file():
                    found.add(file)
                    left += INCLUDE.findall((self.root / file).read_text())
            self._included[path] = found
        return self._included[path]

    def unit_of(self, path):
        """The file to compile for a source or header: of those that include a header, its own
        source, another of the product, or a test."""
        if path in self.entries:
            return path
        users = [p for p in self.entries if path in self.included(p)]
        stem = os.path.splitext(path)[0]
        return min(users, default=None, key=lambda p: (os.path.splitext(p)[0] != stem,
                                                       p.startswith("tests/"),
                                                       os.path.dirname(p) != os.path.dirname(path),
                                                       len(self.included(p)), p))

    def accepts(self, unit, mutants):
        entry = self.entries[unit]
        with tempfile.TemporaryDirectory() as folder:
            files = {unit: []}
            for mutant in mutants:
                files.setdefault(mutant.file, []).append(mutant)
            for file, inside in files.items():
                copy = Path(folder) / file
                copy.parent.mkdir(parents=True, exist_ok=True)
                copy.write_text(mutated((self.root / file).read_text(), inside))
            own = Path(folder) / HEADER
            own.parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(Path(__file__).with_name("mutant.h"), own)
            words = shlex.split(entry["command"])
            if os.path.basename(words[0]) == "ccache":
                words = words[1:]
            if "-o" in words:
                at = words.index("-o")
                del words[at:at + 2]
            words = [w for w in words if w not in ("-c", "-Werror", entry["file"])]
            words[1:1] = ["-I", folder, "-iquote", str((self.root / unit).parent)]
            words += ["-w", "-fsyntax-only", str(Path(folder) / unit)]
            done = subprocess.run(words, cwd=entry["directory"], stdout=subprocess.DEVNULL,
                                  stderr=subprocess.DEVNULL)
            return done.returncode == 0

    def refused(self, unit, mutants):
        """Those of the mutants with which a unit does not compile; found by halving."""
        if not mutants or self.accepts(unit, mutants):
            return []
        if len(mutants) == 1:
            return list(mutants)
        half = len(mutants) // 2
        return self.refused(unit, mutants[:half]) + self.refused(unit, mutants[half:])

    def check(self, mutants, jobs, say):
        """(mutants to leave out, files that do not compile without any)."""
        units = {}
        left_out = {m.number for m in mutants if self.unit_of(m.file) is None}
        for file in sorted({m.file for m in mutants}):
            if unit := self.unit_of(file):
                included = self.included(unit)
                units[unit] = [m for m in mutants if m.file in included]

        def one(unit):
            refused = self.refused(unit, units[unit])
            alone = len(refused) < len(units[unit]) or self.accepts(unit, [])
            say(f"{unit}: {len(refused)} of {len(units[unit])} mutants refused")
            return unit, refused, alone

        broken = []
        with ThreadPoolExecutor(jobs) as pool:
            for unit, refused, alone in pool.map(one, units):
                left_out |= {m.number for m in refused}
                broken += [] if alone else [unit]
        return left_out, broken
