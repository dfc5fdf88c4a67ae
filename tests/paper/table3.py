#!/usr/bin/python3
"""Runs the seven cases through the daemon and writes the project's own Table 3.

    tests/paper/table3.py [--seeds 1 2 3 4 5] [--cases NAME...] [--raw FILE] build/bin

puts the table and the checks beside it into README.md between its two marks, --raw all Reports into
a JSON file. Exit 0 if every check holds, 1 if one does not. Takes a quarter of an hour.
"""
import argparse
import json
import statistics
import sys
from pathlib import Path

from cases import CASES
from comparison import compare
from daemon import Daemon

README = Path(__file__).with_name("README.md")
BEGIN, END = "<!-- table3.py begin -->", "<!-- table3.py end -->"

REGULAR = ("setup", "optimise", "extract", "total")                        # t1 t2 t3 total1
REMESH = ("difference", "copy", "setup", "optimise", "extract", "total")   # t4 t5 t6 t7 t8 total2


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("binaries", help="folder of remeshd and remesh")
    parser.add_argument("--seeds", nargs="+", type=int, default=[1, 2, 3, 4, 5])
    parser.add_argument("--cases", nargs="+", choices=[c.name for c in CASES])
    parser.add_argument("--raw", help="file for all Reports")
    options = parser.parse_args()

    rows = []
    for case in CASES:
        if options.cases and case.name not in options.cases:
            continue
        with Daemon(options.binaries) as daemon:
            for nodes in (15000, 30000):
                for iterations in (5, 10):
                    # A seed of its own for every repeat: nothing comes from the cache, and regular
                    # run and remesh alternate on a machine that may be busy elsewhere.
                    rows.append(Row([compare(daemon, case, nodes, iterations, s) for s in options.seeds]))
                    print(rows[-1].markdown(), *rows[-1].runs_with_faults(), sep="\n  ", flush=True)
    if options.raw:
        Path(options.raw).write_text(json.dumps([run.record() for row in rows for run in row.runs], indent=1))
    checks = list(check(rows))
    text = table(rows, options.seeds) + "\n" + checklist(checks)
    if not options.cases:
        readme = README.read_text()
        before, after = readme.split(BEGIN)[0], readme.split(END)[1]
        README.write_text(before + BEGIN + "\n" + text + END + after)
    print(text)
    return 0 if all(holds for _, holds, _ in checks) else 1


class Row:
    """The runs of one row of Table 3, one a seed. Times are medians over them."""

    def __init__(self, runs):
        self.runs = runs
        self.case, self.nodes, self.iterations = runs[0].case, runs[0].nodes, runs[0].iterations
        self.name = f"{self.case.name} {self.nodes // 1000}k {self.iterations}"

    def seconds(self, which, phase):
        return statistics.median(getattr(r, which)["seconds"][phase] for r in self.runs)

    @property
    def percent(self):
        return statistics.median(r.ratio for r in self.runs)

    def worst(self, f, largest=True):
        return (max if largest else min)(f(r) for r in self.runs)

    def nodes_kept(self):
        return self.worst(lambda r: r.remesh["nodes_kept"] / r.remesh["nodes"], largest=False)

    def tets_kept(self):
        return self.worst(lambda r: r.remesh["tets_kept"] / r.remesh["tets"], largest=False)

    def dihedral_min(self, which):
        return self.worst(lambda r: getattr(r, which)["quality"]["dihedral_min"], largest=False)

    def runs_with_faults(self):
        return [f"{self.name} seed {r.seed}: {fault}" for r in self.runs for fault in r.faults]

    def markdown(self):
        r = self.runs[0]
        paper = self.case.paper.get((self.nodes, self.iterations))
        cells = [self.case.name, f"{r.regular['diagnostics']['samples']:,}", f"{r.regular['nodes']:,}–{r.remesh['nodes']:,}",
                 self.iterations]
        cells += [f"{self.seconds('regular', p):.3f}" for p in REGULAR]
        cells += [f"{self.seconds('remesh', p):.3f}" for p in REMESH]
        cells += [f"**{self.percent:.1f}**", f"{paper:.1f}" if paper else "–",
                  f"{100 * statistics.mean(x.remesh['free_share'] for x in self.runs):.0f}",
                  f"{100 * self.nodes_kept():.1f}", f"{100 * self.tets_kept():.1f}",
                  f"{self.worst(lambda x: x.quality_gap('quality_before')):.3f}",
                  f"{self.worst(lambda x: x.quality_gap('quality')):.3f}",
                  f"{self.dihedral_min('regular'):.1f}", f"{self.dihedral_min('remesh'):.1f}"]
        return "| " + " | ".join(map(str, cells)) + " |"


def table(rows, seeds):
    names = ["model", "#samples", "#nodes", "#iter", "t1", "t2", "t3", "total1", "t4", "t5", "t6", "t7",
             "t8", "total2", "% time", "paper's %", "free %", "nodes kept %", "tets kept %", "gap before",
             "gap after", "min angle regular", "min angle remesh"]
    head = ["| " + " | ".join(names) + " |", "|" + "---|" * len(names)]
    return (f"Seeds {' '.join(map(str, seeds))}, one thread; seconds and % time are medians over them, counts "
            "those of the first, kept shares, gaps and angles the worst.\n\n"
            + "\n".join(head + [r.markdown() for r in rows]) + "\n")


def check(rows):
    """(statement, whether it holds, figures) for all that is asked of the table."""
    def every(statement, bad, figure):
        yield statement, not bad, "; ".join(bad) if bad else figure

    of = {(r.case.name, r.nodes, r.iterations): r for r in rows}
    runs = [(row, run) for row in rows for run in row.runs]
    faults = [f for row in rows for f in row.runs_with_faults()]
    yield from every("Every mesh is valid: no inverted tet, closed manifold boundary, every model edge and "
                     "vertex present, volume within 0.2 %, kept counts as reported", faults,
                     f"{len(runs)} remeshes and {len(runs)} regular meshes")
    yield from every("A regular run comes within 3 % of the node count asked for",
                     [f"{row.name}: {100 * e:.1f} %" for row, run in runs if (e := run.count_error()) > .03],
                     f"worst {100 * max(run.count_error() for _, run in runs):.2f} %")
    slower = [f"{row.name} seed {run.seed}: {run.ratio:.0f} %" for row, run in runs if run.ratio >= 100]
    yield from every("The remesh is faster than the regular run, in every run", slower,
                     f"worst {max(run.ratio for _, run in runs):.0f} %")
    for when, words in (("quality_before", "before"), ("quality", "after")):
        yield from every(f"The remesh's cumulative histogram of volume-length is nowhere more than 0.03 "
                         f"worse, {words} clean-up",
                         [f"{row.name} seed {run.seed}: {g:.3f}" for row, run in runs
                          if (g := run.quality_gap(when)) > .03],
                         f"worst {max(run.quality_gap(when) for _, run in runs):.3f}")
    at = [row for row in rows if (row.nodes, row.iterations) == (15000, 10)]
    yield from every("Nodes kept at 15,000 nodes, 10 iterations: at least the share asked for",
                     [f"{r.case.name}: {100 * r.nodes_kept():.1f} of {100 * r.case.nodes_kept:.0f} %"
                      for r in at if r.nodes_kept() < r.case.nodes_kept],
                     ", ".join(f"{r.case.name} {100 * r.nodes_kept():.1f} of {100 * r.case.nodes_kept:.0f} %"
                               for r in at))
    below = {row.name: max(run.remesh["nodes_kept"] / run.remesh["nodes"]
                           - run.remesh["tets_kept"] / run.remesh["tets"] for run in row.runs) for row in at}
    yield from every("There, tets kept lie at most 8 points below",
                     [f"{k}: {100 * v:.1f}" for k, v in below.items() if v > .08],
                     f"worst {100 * max(below.values()):.1f} points")
    yield from every("No tet below 20 degrees of dihedral angle at 15,000 nodes",
                     [f"{r.name}: {d:.1f}" for r in rows if r.nodes == 15000
                      and (d := min(r.dihedral_min("regular"), r.dihedral_min("remesh"))) < 20],
                     f"least {min(min(r.dihedral_min('regular'), r.dihedral_min('remesh')) for r in rows):.1f} "
                     "over all rows")
    yield from every("Paper: analysing the models and copying (t4 + t5) is cheaper than the regular set-up (t1)",
                     [f"{r.name}: {t:.3f} against {u:.3f} s" for r in rows
                      if (t := r.seconds("remesh", "difference") + r.seconds("remesh", "copy"))
                      >= (u := r.seconds("regular", "setup"))], "every row")
    yield from every("The remesh's set-up with the difference (t4 + t6) is cheaper than the regular set-up (t1)",
                     [f"{r.name}: {t:.3f} against {u:.3f} s" for r in rows
                      if (t := r.seconds("remesh", "difference") + r.seconds("remesh", "setup"))
                      >= (u := r.seconds("regular", "setup"))], "every row")
    pairs = [(of[n, 15000, i], of[n, 30000, i]) for n, k, i in of if k == 15000]
    yield from every("Paper: the ratio falls from 15,000 to 30,000 nodes",
                     [f"{a.name}: {a.percent:.1f} to {b.percent:.1f} %" for a, b in pairs if b.percent >= a.percent],
                     "every pair")
    pairs = [(of[n, k, 5], of[n, k, 10]) for n, k, i in of if i == 5]
    yield from every("Paper: the loop takes longer with more iterations (t2 and t7)",
                     [f"{a.name} {which}: {a.seconds(which, 'optimise'):.3f} to {b.seconds(which, 'optimise'):.3f} s"
                      for a, b in pairs for which in ("regular", "remesh")
                      if b.seconds(which, "optimise") <= a.seconds(which, "optimise")], "every pair")


def checklist(checks):
    return "\n".join(f"- {'holds' if holds else '**fails**'}: {statement}. {figures}."
                     for statement, holds, figures in checks) + "\n"


if __name__ == "__main__":
    sys.exit(main())
