"""What the runs of mutants come to: a table by folder and by operator, and the survivors."""
import csv
from collections import Counter, defaultdict
from dataclasses import dataclass
from pathlib import Path

SEEN, UNSEEN, UNREACHED = "seen", "unseen", "unreached"  # outcomes of a mutant


def folder_of(file):
    """Where a file counts: engine/kernel, server/store; server, of a file right below it."""
    return "/".join(file.split("/")[:-1][:2])


@dataclass(frozen=True)
class Row:
    """A line of mutants.tsv."""

    number: int
    file: str
    line: int
    operator: str
    before: str
    after: str

    @property
    def folder(self):
        return folder_of(self.file)


def table_rows(path):
    with Path(path).open(newline="") as file:
        return list(csv.DictReader(file, delimiter="\t", quoting=csv.QUOTE_NONE))


def read_mutants(path):
    return [Row(int(r["number"]), r["file"], int(r["line"]), r["operator"], r["before"], r["after"])
            for r in table_rows(path)]


def read_equivalents(path):
    """{(file, before, after): reason} of the faults that are argued to change nothing."""
    return {(r["file"], r["before"], r["after"]): r["reason"] for r in table_rows(path)}


def short(text, most=90):
    return text if len(text) <= most else text[:most - 3] + "..."


def cell(text):
    return "`" + text.replace("`", "'").replace("|", "\\|") + "`"


def difference(before, after, around=24):
    """before and after without most of what they have in common, at word boundaries."""
    first = 0
    while first < min(len(before), len(after)) and before[first] == after[first]:
        first += 1
    last = 0
    while last < min(len(before), len(after)) - first and before[-1 - last] == after[-1 - last]:
        last += 1
    begin = before.rfind(" ", 0, max(first - around, 0)) + 1
    end = before.find(" ", len(before) - max(last - around, 0))
    kept = 0 if end < 0 else len(before) - end
    cut = [text[begin:len(text) - kept] for text in (before, after)]
    return [short(("... " if begin else "") + c + (" ..." if kept else "")) for c in cut]


def tally(mutants, outcomes, equivalents, key):
    """{key of mutant: Counter of seen, unseen, unreached, equivalent} of those that have run."""
    counts = defaultdict(Counter)
    for m in mutants:
        if (m.file, m.before, m.after) in equivalents:
            counts[key(m)]["equivalent"] += 1
        elif m.number in outcomes:
            counts[key(m)][outcomes[m.number]] += 1
    return counts


def score_table(title, counts):
    """Of those that are not equivalent, how many a test saw."""
    lines = [f"| {title} | seen | unseen | not reached | equivalent | all | score |",
             "|---|---|---|---|---|---|---|"]
    rows = sorted(counts.items()) + [("all", sum(counts.values(), Counter()))]
    for name, n in rows:
        counted = n[SEEN] + n[UNSEEN] + n[UNREACHED]
        score = f"{100 * n[SEEN] / counted:.0f} %" if counted else ""
        lines.append(f"| {name} | {n[SEEN]} | {n[UNSEEN]} | {n[UNREACHED]} | {n['equivalent']} | "
                     f"{n.total()} | {score} |")
    return "\n".join(lines)


def survivors(mutants, outcomes, equivalents):
    lines = ["| place | operator | before | after | reached |", "|---|---|---|---|---|"]
    for m in sorted(mutants, key=lambda m: (m.file, m.line)):
        outcome = outcomes.get(m.number)
        if outcome in (UNSEEN, UNREACHED) and (m.file, m.before, m.after) not in equivalents:
            before, after = difference(m.before, m.after)
            reached = "no" if outcome == UNREACHED else "yes"
            lines.append(f"| {m.file}:{m.line} (mutant {m.number}) | {m.operator} | "
                         f"{cell(before)} | {cell(after)} | {reached} |")
    return "\n".join(lines)


def report(mutants, outcomes, equivalents):
    parts = [score_table("folder", tally(mutants, outcomes, equivalents, lambda m: m.folder)),
             score_table("operator", tally(mutants, outcomes, equivalents, lambda m: m.operator)),
             "Survivors:\n\n" + survivors(mutants, outcomes, equivalents)]
    return "\n\n".join(parts) + "\n"
