#!/usr/bin/env python3
"""Copies the tree and makes faults in the copy, each behind a number in the environment.

mutate.py COPY [--number 200] [--seed 1] [--folders engine server client] [--check BUILD]
mutate.py COPY --without 17 23            # takes back what a build finds not to compile
mutate.py --list [--folders ...]          # how many places each operator finds

COPY is a folder outside of the tree: a new one, or one this program made before, whose files are
written again only where they change. `--check` takes a build of this tree and leaves out what does
not compile, with others in its place. `COPY/mutants.tsv` tells what was made.
"""
import argparse
import collections
import random
import subprocess
import sys
from dataclasses import dataclass
from pathlib import Path

import operators
import score
from compile_check import Compiler, mutated
from cpp_source import Source

ROOT = Path(__file__).resolve().parents[2]
TABLE = "mutants.tsv"
# What programs of others include, and what no test program is made of.
LEFT_OUT = ("client/include/", "client/examples/", "client/python/")
ROUNDS = 4  # of picking others for what does not compile


@dataclass(frozen=True)
class Mutant:
    number: int
    file: str
    place: operators.Place


def tracked(root, *folders):
    """The tree's files, but those that git ignores."""
    listed = subprocess.run(["git", "ls-files", "-co", "--exclude-standard", "-z", "--", *folders],
                            cwd=root, check=True, capture_output=True, text=True).stdout
    return sorted(f for f in set(listed.split("\0")) if f and (root / f).is_file())


def sources(root, folders):
    return [f for f in tracked(root, *folders)
            if f.endswith((".cpp", ".h")) and not f.startswith(LEFT_OUT)]


def all_places(root, files):
    return {f: operators.places(Source((root / f).read_text())) for f in files}


def shares(number, lines):
    """The number spread over folders by their lines, to the nearest by largest remainder."""
    total = sum(lines.values())
    exact = {f: number * n / total for f, n in lines.items()}
    given = {f: int(x) for f, x in exact.items()}
    for f in sorted(exact, key=lambda f: (given[f] - exact[f], f))[:number - sum(given.values())]:
        given[f] += 1
    return given


def pick(root, places, number, seed, refused=frozenset()):
    """Mutants of places that do not overlap: in each folder an operator at random of those that
    have places left, then one of its places at random, so that rare operators are tried too."""
    lines = collections.Counter()
    for file in places:
        lines[score.folder_of(file)] += (root / file).read_text().count("\n")
    picked = []
    for folder, share in sorted(shares(number, lines).items()):
        chance = random.Random(f"{seed} {folder}")
        left = collections.defaultdict(list)
        for file in sorted(places):
            if score.folder_of(file) == folder:
                for place in places[file]:
                    left[place.operator].append((file, place))
        for found in left.values():
            chance.shuffle(found)
        taken = []
        while len(taken) < share and any(left.values()):
            operator = chance.choice(sorted(o for o, found in left.items() if found))
            file, place = left[operator].pop()
            overlaps = any(file == f and place.begin < p.end and p.begin < place.end
                           for f, p in taken)
            if not overlaps and (file, place) not in refused:
                taken.append((file, place))
        picked += taken
    return picked


def numbered(picked):
    return [Mutant(k, file, place) for k, (file, place) in enumerate(picked)]


def checked(picked_without, compiler, jobs):
    """Picks until all compile: (mutants, how many of each operator were tried, were refused)."""
    refused, known = set(), set()
    tried, failed = collections.Counter(), collections.Counter()
    for round_ in range(ROUNDS):
        mutants = numbered(picked_without(frozenset(refused)))
        fresh = [m for m in mutants if (m.file, m.place) not in known]
        tried.update(m.place.operator for m in fresh)
        changed = {m.file for m in fresh}
        left_out, broken = compiler.check([m for m in mutants if m.file in changed], jobs,
                                          lambda line: print(line, file=sys.stderr, flush=True))
        for unit in broken:
            print(f"{unit} does not compile as it is", file=sys.stderr)
        failed.update(m.place.operator for m in mutants if m.number in left_out)
        refused |= {(m.file, m.place) for m in mutants if m.number in left_out}
        known |= {(m.file, m.place) for m in mutants}
        if not left_out:
            break
    kept = [(m.file, m.place) for m in mutants if m.number not in left_out]
    return numbered(kept), tried, failed


def made_before(copy, places):
    """The mutants of a copy's table, of the same tree."""
    found = {(f, p.line, p.operator, p.before, p.after): p
             for f, inside in places.items() for p in inside}
    rows = score.read_mutants(Path(copy) / TABLE)
    keys = [(r.file, r.line, r.operator, r.before, r.after) for r in rows]
    if lost := [key[:2] for key in keys if key not in found]:
        sys.exit(f"the tree has changed since the copy was made: {lost}")
    return [Mutant(r.number, r.file, found[key]) for r, key in zip(rows, keys)]


def write_if_other(file, content):
    if not file.is_file() or file.read_bytes() != content:
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_bytes(content)


def write_copy(root, copy, mutants):
    copy = Path(copy).resolve()
    if copy.is_relative_to(root):
        sys.exit(f"{copy} lies in the tree; give a folder outside of it")
    if copy.exists() and any(copy.iterdir()) and not (copy / TABLE).is_file():
        sys.exit(f"{copy} is not empty and was not made by this program")
    inside = collections.defaultdict(list)
    for mutant in mutants:
        inside[mutant.file].append(mutant)
    files = tracked(root)
    for top in {f.split("/")[0] for f in files if "/" in f}:
        for old in (copy / top).rglob("*"):
            if old.is_file() and not (root / old.relative_to(copy)).is_file():
                old.unlink()
    for file in files:
        content = (root / file).read_bytes()
        if file in inside:
            content = mutated(content.decode(), inside[file]).encode()
        write_if_other(copy / file, content)
        (copy / file).chmod((root / file).stat().st_mode)
    rows = ["number\tfile\tline\toperator\tbefore\tafter"]
    rows += [f"{m.number}\t{m.file}\t{m.place.line}\t{m.place.operator}\t{m.place.before}\t"
             f"{m.place.after}" for m in mutants]
    write_if_other(copy / TABLE, ("\n".join(rows) + "\n").encode())


def count(places):
    found = collections.Counter(p.operator for inside in places.values() for p in inside)
    for operator in operators.OPERATORS:
        print(f"{operator.__name__:20}{found[operator.__name__]:7}  {operator.__doc__}")
    print(f"{'all':20}{found.total():7}")


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("copy", nargs="?", metavar="COPY")
    parser.add_argument("--number", type=int, default=200, help="of faults (200)")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--folders", nargs="+", default=["engine", "server", "client"])
    parser.add_argument("--check", metavar="BUILD", help="a build of this tree, for its commands")
    parser.add_argument("--without", nargs="+", type=int, help="of the copy's faults", metavar="N")
    parser.add_argument("--jobs", type=int, default=1, help="compilers at a time (1)")
    parser.add_argument("--list", action="store_true", help="count the places and make nothing")
    chosen = parser.parse_args()

    places = all_places(ROOT, sources(ROOT, chosen.folders))
    if chosen.list:
        return count(places)
    if not chosen.copy:
        parser.error("give a folder for the copy")
    if chosen.without:
        kept = [m for m in made_before(chosen.copy, places) if m.number not in chosen.without]
        return write_copy(ROOT, chosen.copy, kept)
    known = score.read_equivalents(Path(__file__).with_name("equivalent.tsv"))
    places = {f: [p for p in inside if (f, p.before, p.after) not in known]
              for f, inside in places.items()}

    def picked_without(refused):
        return pick(ROOT, places, chosen.number, chosen.seed, refused)

    if chosen.check:
        compiler = Compiler(ROOT, Path(chosen.check) / "compile_commands.json")
        mutants, tried, failed = checked(picked_without, compiler, chosen.jobs)
        for operator in sorted(tried):
            print(f"{operator:20}{tried[operator]:5} tried{failed[operator]:5} do not compile")
    else:
        mutants = numbered(picked_without(frozenset()))
    write_copy(ROOT, chosen.copy, mutants)
    files = {m.file for m in mutants}
    print(f"{len(mutants)} mutants in {len(files)} files, {chosen.copy}/{TABLE}")


if __name__ == "__main__":
    main()
