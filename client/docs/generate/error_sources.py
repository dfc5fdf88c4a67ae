"""What the sources say of reasons: meaning and status in error.proto, the status with which each is made, the exit
code that `remesh` ends with."""
import re
from collections import defaultdict
from dataclasses import dataclass, field

from page import ROOT

PROTO = ROOT / "proto/remesh/v1/error.proto"
EXIT = ROOT / "client/cli/exit_code"


@dataclass
class Reason:
    name: str
    meaning: str
    status: str  # of gRPC


@dataclass
class Section:
    title: str
    remark: str  # what holds for all of them
    reasons: list = field(default_factory=list)


def entries(message, enum):
    """(comment, name or None) in the order of the proto; without a name the comment is a heading."""
    text = PROTO.read_text().split(f"\nmessage {message} {{")[1]
    body = re.search(r"enum %s \{\n(.*?)\n  \}" % enum, text, re.DOTALL)[1]
    comment = []
    for line in [*map(str.strip, body.splitlines()), ""]:
        if line.startswith("//"):
            comment.append(line[2:].strip())
        elif match := re.match(r"([A-Z_]+) = \d+;(?:\s*// (.*))?", line):
            yield " ".join(comment) or match[2] or "", match[1]
            comment = []
        elif comment:
            yield " ".join(comment), None
            comment = []


def sections():
    """Of reasons, in the order of the proto; without REASON_UNSPECIFIED."""
    found = []
    for comment, name in entries("Error", "Reason"):
        if name is None:
            title, rest = re.split(r"[:;] ", comment, maxsplit=1)
            status = re.match(r"([A-Z_]{6,})\. ?(.*)", rest)
            found.append((Section(title, status[2] if status else rest), status and status[1]))
        elif found:
            section, status = found[-1]
            own = re.match(r"\[([A-Z_]+)\] (.*)", comment)
            section.reasons.append(Reason(name, own[2] if own else comment, own[1] if own else status))
    return [section for section, _ in found]


def warnings():
    """(name, meaning) of each code."""
    return [(name, comment) for comment, name in entries("Warning", "Code") if name != "CODE_UNSPECIFIED"]


def exit_codes():
    """A function from reason and status to the exit code."""
    numbers = dict(re.findall(r"(k\w+) = (\d+),", EXIT.with_suffix(".h").read_text()))
    source = EXIT.with_suffix(".cpp").read_text()
    special = dict(re.findall(r"ReasonExit\{Error::(\w+), (k\w+)\}", source))
    body = re.search(r"switch \(error\.code\(\)\) \{\n(.*?)\n  \}", source, re.DOTALL)[1]
    by_status, waiting, default = {}, [], None
    for line in body.splitlines():
        if match := re.search(r"case Error::CODE_(\w+):", line):
            waiting.append(match[1])
        elif "default:" in line:
            waiting.append(None)
        elif match := re.search(r"return (k\w+);", line):
            by_status.update((status, match[1]) for status in waiting)
            waiting = []
    default = by_status.pop(None)
    return lambda reason, status: int(numbers[special.get(reason, by_status.get(status, default))])


def upper(kind):
    return re.sub(r"(?<!^)(?=[A-Z])", "_", kind).upper()


def functions(pattern, *folders):
    """Texts of the top-level functions of sources, each with a file's other ones."""
    for folder in folders:
        for file in sorted((ROOT / folder).rglob(pattern)):
            yield re.split(r"\n\}\n", re.sub(r"//.*", "", file.read_text()))


def helpers(texts):
    """Status by name of the functions that make errors."""
    found = {"internal": "INTERNAL"}
    for text in texts:
        name = re.search(r"^(?:Document)?Error(?:Info)? (\w+)\(", text, re.MULTILINE)
        kind = re.search(r"ErrorKind::(\w+)", text)
        if name and kind:
            found[name[1]] = upper(kind[1])
    return found


def made_in(text, known):
    """(reason, status) of the errors that a function makes. `known`: statuses of the file's helpers."""
    either = (re.search(r'\? "([A-Z_]+)" : "([A-Z_]+)"', text),
              re.search(r"\? ErrorKind::(\w+) : ErrorKind::(\w+)", text))
    if all(either):
        return [(either[0][k], upper(either[1][k])) for k in (1, 2)]
    names = re.findall(r'\breason = "([A-Z_]{4,})"', text)
    calls = re.findall(r'(\w+)\(\s*(?:place, )?"([A-Z_]{4,})"', text)
    kinds = re.findall(r"ErrorKind::(\w+)", text)
    made = [(name, upper(kinds[-1])) for name in names if kinds]
    made += [(name, status) for name in names if not kinds
             for call, status in known.items() if f"error::{call}(" in text]
    made += [(name, upper(kinds[-1]) if kinds else known[call]) for call, name in calls if call in known]
    if "DocumentErrorInfo" in text:
        made += [(name, "INVALID_ARGUMENT") for name in re.findall(r'"([A-Z_]{4,})"', text)]
    return made + [(name, code) for code, name in re.findall(
        r"set_code\([\w:]*Error::CODE_(\w+)\);\s*\w+\.set_reason\([\w:]*Error::(\w+)\)", text)]


def statuses():
    """Statuses with which the sources make an error of each reason; of one that none makes there is no entry."""
    found = defaultdict(set)
    for texts in functions("*.cpp", "engine", "server", "client/library", "client/cli", "proto"):
        known = helpers(texts)
        for text in texts:
            for name, status in made_in(text, known):
                found[name].add(status)
    for texts in functions("*.py", "client/python/remesh_client"):
        for code, name in re.findall(r"code=Error\.CODE_(\w+), reason=Error\.(\w+)", "".join(texts)):
            found[name].add(code)
    return found
