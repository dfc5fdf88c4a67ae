#!/usr/bin/python3
"""errors_page.py REMESH [--write]: ../errors.md, of error.proto, of what the sources say, and of what REMESH prints.
With --write it is written; without it the exit code is 0 where it is right. Examples that need a daemon of their own
are run with --write alone, else taken from the page."""
import json
import re
import sys
import tempfile
from pathlib import Path

import error_sources
from error_examples import ERRORS, OF_REMESHD, WARNINGS
from error_notes import NOTES
from page import DOCS, Remesh, replaced, settle

PAGE = DOCS / "errors.md"


def write_files(folder, example):
    folder.mkdir(exist_ok=True)
    for file, content in example.files.items():
        (folder / file).parent.mkdir(exist_ok=True)
        (folder / file).write_text(content if isinstance(content, str) else json.dumps(content))
        (folder / file).chmod(0o600)


class Runner:
    """Runs examples, each in a folder of its own."""

    def __init__(self, program, remesh, page):
        self.program, self.remesh, self.page, self.count = program, remesh, page, 0

    def of_page(self, name):
        """The example that the page has."""
        block = re.search(rf"^### {name}\n(?:(?!^### ).)*?```\n(.*?)```", self.page, re.MULTILINE | re.DOTALL)
        assert block, f"no example of {name} on the page: write it anew"
        return block[1].rstrip("\n")

    def run(self, name, example):
        """(what was printed, exit code) with the command before it; (page's, None) where it is not run."""
        if not example.daemon and not example.environment:
            return self.run_in(self.remesh, name, example)
        if "--write" not in sys.argv:
            return self.of_page(name), None
        with tempfile.TemporaryDirectory() as folder:
            write_files(Path(folder), example)  # the daemon reads some
            with Remesh(self.program, folder, *example.daemon, **example.environment) as remesh:
                return self.run_in(remesh, name, example)

    def run_in(self, remesh, name, example):
        self.count += 1
        folder = remesh.folder / str(self.count)
        write_files(folder, example)
        hidden = ("--json", "report.json") if name in WARNINGS else ()
        for command in example.commands:
            code, _, err = remesh.run("-v", *command, *hidden, within=folder)
        if hidden:
            said = self.warning(name, code, folder)
        else:
            said = [line for line in err.splitlines() if line.startswith("remesh: ")]
            self.check(name, code, err)
        command = " ".join(f'"{word}"' if not word or " " in word else word for word in example.commands[-1])
        return "\n".join([f"$ remesh {command}", *said]).replace(f"{folder}/", ""), code

    def run_remeshd(self, name):
        """(what it printed, exit code) of a daemon that does not start."""
        code, _, err = self.remesh.run(*OF_REMESHD[name], program="remeshd")
        assert code != 0 and err.startswith("remeshd: "), f"{name}: exit {code}\n{err}"
        return "\n".join([f"$ remeshd {' '.join(OF_REMESHD[name])}", err.strip()]), code

    def warning(self, name, code, folder):
        """The line of the first warning of that code."""
        assert code == 0, f"{name}: exit {code}"
        told = json.loads((folder / "report.json").read_text())["warnings"]
        messages = [warning["message"] for warning in told if warning["code"] == name]
        assert messages, f"{name}: instead {told}"
        return ["warning: " + messages[0]]

    def check(self, name, code, err):
        """The error is of that reason, with the status and exit code that the page says."""
        told = re.search(r"^code (\w+), reason (\w+),", err, re.MULTILINE)
        assert told and told[2] == name, f"{name}: exit {code}\n{err}"
        status = self.reasons[name].status
        assert (told[1], code) == (status, self.exit_code(name, status)), f"{name}: {told[0]}, exit {code}"


def check_sources(sections, made):
    """Each reason's status in the proto is the one that it is made with."""
    reasons = {reason.name: reason for section in sections for reason in section.reasons}
    for name, reason in reasons.items():
        assert not made[name] or reason.status in made[name], f"{name}: made with {made[name]}"
    unknown = (set(made) | set(ERRORS) | set(OF_REMESHD) | set(NOTES)) - set(reasons) - {name for name, _ in error_sources.warnings()}
    assert not unknown, f"error.proto has no {unknown}"
    return reasons


def entry(name, meaning, facts, example):
    note = f" {NOTES[name]}" if name in NOTES else ""
    lines = [f"### {name}", "", meaning + note, "", facts]
    if example:
        lines += ["", "```", example, "```"]
    return "\n".join(lines) + "\n"


def reason_entry(reason, made, runner):
    if reason.name in OF_REMESHD:
        example, code = runner.run_remeshd(reason.name)
        facts = f"`{reason.status}`; `remeshd` says it when it starts, and ends with exit {code}."
        return entry(reason.name, reason.meaning, facts, example)
    facts = f"`{reason.status}`, exit {runner.exit_code(reason.name, reason.status)}"
    for other in sorted(made[reason.name] - {reason.status}):
        facts += f"; also `{other}`, exit {runner.exit_code(reason.name, other)}"
    if not made[reason.name]:
        facts += "; nothing makes it today"
    example = runner.run(reason.name, ERRORS[reason.name])[0] if reason.name in ERRORS else None
    return entry(reason.name, reason.meaning, facts + ".", example)


def index(sections):
    links = {section.title: section.reasons for section in sections}
    lines = [f"- {title}: " + " ".join(f"[{r.name}](#{r.name.lower()})" for r in reasons)
             for title, reasons in links.items()]
    names = [f"[{name}](#{name.lower()})" for name, _ in error_sources.warnings()]
    return "\n".join([*lines, "- [Warnings](#warnings): " + " ".join(names)])


def made_page(text, runner):
    sections, made = error_sources.sections(), error_sources.statuses()
    runner.reasons, runner.exit_code = check_sources(sections, made), error_sources.exit_codes()
    parts = []
    for section in sections:
        parts += [f"## {section.title}", ""]
        if section.remark:
            parts += [section.remark[:1].upper() + section.remark[1:], ""]
        parts += [reason_entry(reason, made, runner) for reason in section.reasons]
    text = replaced(text, "reasons", "\n".join(parts))
    entries = [entry(name, meaning, f"`--fail-on {name}` makes it an error.",
                     runner.run(name, WARNINGS[name])[0] if name in WARNINGS else None)
               for name, meaning in error_sources.warnings()]
    return replaced(replaced(text, "warnings", "\n".join(entries)), "index", index(sections))


def main():
    with tempfile.TemporaryDirectory() as folder, Remesh(sys.argv[1], folder) as remesh:
        text = PAGE.read_text()
        settle(PAGE, text, made_page(text, Runner(sys.argv[1], remesh, text)))


if __name__ == "__main__":
    main()
