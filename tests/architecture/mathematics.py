# SPDX-License-Identifier: LGPL-2.1-or-later
"""The page of mathematics against the sources: what it names and what is there, as faults."""
import re
from dataclasses import dataclass, field
from pathlib import Path

from measures import cpp_functions
from source_tree import KERNEL, ROOT

EQUATIONS = [f"2.{n}" for n in range(1, 15)] + [f"3.{n}" for n in range(1, 4)]
TICKED = re.compile(r"`([^`]+)`")
NAMED = re.compile(r"^\(([23]\.\d+)\)$")
TEST_CASE = re.compile(r"^(?:TYPED_)?TEST(?:_[FP])?\((\w+),\s*(\w+)\)", re.MULTILINE)


@dataclass
class Entry:
    """One equation of the page: its title, and which file has what of it."""

    title: str
    computed: list[tuple[str, str]] = field(default_factory=list)  # file, function or class
    held: list[tuple[str, str]] = field(default_factory=list)  # file, Suite.Name

    def number(self) -> str:
        """Its number in the paper; empty for one of ours."""
        found = NAMED.match(self.title)
        return found.group(1) if found else ""


def pairs(line: str) -> list[tuple[str, str]]:
    """The names of a line, each with the file in front of it: "`a.cpp`: `f`, `g`; `b.cpp`: `h`"."""
    found, path = [], ""
    for word in TICKED.findall(line):
        if word.endswith((".cpp", ".h")):
            path = word
        else:
            found.append((path, word))
    return found


def entries(text: str) -> list[Entry]:
    """The equations of a page, in order."""
    found: list[Entry] = []
    for line in text.splitlines():
        title = re.match(r"- \*\*(.+?)\*\*", line)
        if title:
            found.append(Entry(title.group(1)))
        elif line.startswith("  - computed in "):
            found[-1].computed += pairs(line)
        elif line.startswith("  - held by "):
            found[-1].held += pairs(line)
    return found


def invariants(text: str) -> list[tuple[str, str]]:
    """The tests of the page's last table, each with the file its column is headed by."""
    rows = [line.split("|")[1:-1] for line in text.splitlines() if line.startswith("| ")]
    heads = [cells for cells in rows if any("_test.cpp`" in cell for cell in cells)]
    if not heads:
        return []
    files = [(TICKED.findall(cell) or [""])[0] for cell in heads[0]]
    below = rows[rows.index(heads[0]) + 1 :]
    return [
        (path, name)
        for cells in below
        for path, cell in zip(files, cells)
        for name in TICKED.findall(cell)
    ]


def defines(path: Path, name: str) -> bool:
    """Whether a source defines a function, or a header declares a function or a class, so named."""
    text = path.read_text()
    if path.suffix == ".cpp":
        functions = {function.name for function in cpp_functions(text)}
        return name in functions or (
            "::" not in name and name in {f.rpartition("::")[2] for f in functions}
        )
    return re.search(rf"^(?:class|struct|enum class)\s+{re.escape(name)}\b", text, re.M) is not None


def missing_sources(entry: Entry, kernel: Path = KERNEL) -> list[str]:
    """What of an equation's files and functions is not there."""
    faults = [] if entry.computed else [f"{entry.title}: no function computes it"]
    for path, name in entry.computed:
        if not (kernel / path).is_file():
            faults.append(f"{entry.title}: no file {path}")
        elif not defines(kernel / path, name):
            faults.append(f"{entry.title}: {path} has no {name}")
    return faults


def missing_tests(held: list[tuple[str, str]], root: Path = ROOT) -> list[str]:
    """Which of these tests are not there."""
    faults = []
    for path, name in held:
        if not (root / path).is_file():
            faults.append(f"no file {path}")
        elif name not in map(".".join, TEST_CASE.findall((root / path).read_text())):
            faults.append(f"{path} has no {name}")
    return faults


def is_named_in_the_code(entry: Entry, kernel: Path = KERNEL) -> bool:
    """Whether a source that computes an equation of the paper, or its header, has its number."""
    sources = {kernel / path for path, _ in entry.computed}
    sources |= {source.with_suffix(".h") for source in sources}
    texts = [source.read_text() for source in sorted(sources) if source.is_file()]
    # Alone or among others: (2.9), (2.9, 2.10).
    number = re.compile(rf"\((?:[23]\.\d+, )*{re.escape(entry.number())}(?:, [23]\.\d+)*\)")
    return any(number.search(text) for text in texts)
