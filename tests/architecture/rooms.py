# SPDX-License-Identifier: LGPL-2.1-or-later
"""The folders of the kernel: how full they are, what is called what in them, where tests lie."""
import re
from collections import defaultdict
from collections.abc import Iterable
from pathlib import Path

from measures import DECORATION, NOT_CODE, PREPROCESSOR, blank

# What one looks through at a glance; beyond it a folder has rooms in it that want walls.
FULLEST_FOLDER = 20
NAMESPACE = re.compile(r"\bnamespace\s*([\w:]*)\s*$")
CLASS = re.compile(r"\b(?:class|struct|union|enum(?:\s+class)?)\s+(?:alignas\([^)]*\)\s*)?([\w:]+)")


def fullness_faults(sources: Iterable[Path]) -> dict[str, int]:
    """The folders that hold too many sources, with how many."""
    count: dict[str, int] = defaultdict(int)
    for path in sources:
        count[path.parent.as_posix()] += 1
    return {folder: files for folder, files in count.items() if files > FULLEST_FOLDER}


def classes_of(text: str, unnamed: str) -> list[str]:
    """The full names of the classes that a source defines at namespace scope.

    :param unnamed: what an unnamed namespace is called: nobody else's
    """
    code = DECORATION.sub(blank, PREPROCESSOR.sub(blank, NOT_CODE.sub(blank, text)))
    found, scopes, head = [], [], 0
    for mark in re.finditer(r"[{};]", code):
        words = code[head : mark.start()].strip()
        head = mark.end()
        if mark.group() == "}":
            scopes = scopes[:-1]
        elif mark.group() == "{":
            space, name = NAMESPACE.search(words), CLASS.search(words)
            if name and not space and "(" not in words[: name.start()] and None not in scopes:
                found.append("::".join([*scopes, name.group(1)]))
            scopes.append((space.group(1) or unnamed) if space else None)
    return found


def names_twice(sources: Iterable[Path]) -> dict[str, list[str]]:
    """Classes of one name in one namespace, with the files that define them: linked together,
    one silently stands for the other."""
    found: dict[str, list[str]] = defaultdict(list)
    for path in sources:
        for name in set(classes_of(path.read_text(), path.as_posix())):
            found[name].append(path.as_posix())
    return {name: files for name, files in found.items() if len(files) > 1}


def is_misplaced(test: Path, tests: Path, kernel: Path) -> bool:
    """Whether a test lies elsewhere than what it is named after (or than any folder there is)."""
    folder = test.relative_to(tests).parent
    layer, name = folder.parts[0], test.name.removesuffix("_test.cpp")
    tested = [path.parent for path in (kernel / layer).rglob(f"{name}.h")]
    return kernel / folder not in tested if tested else not (kernel / folder).is_dir()


def rooms_on_disk(kernel: Path) -> dict[str, set[str]]:
    """The layers of the kernel with the names of their rooms."""
    layers = [path for path in kernel.iterdir() if path.is_dir()]
    return {layer.name: {p.name for p in layer.iterdir() if p.is_dir()} for layer in layers}


def rooms_told(text: str) -> dict[str, set[str]]:
    """The same as a page tells them: a table of layers whose last column names the rooms."""
    told, is_inside = {}, False
    for line in text.splitlines():
        cells = [cell.strip() for cell in line.split("|")[1:-1]]
        if cells and cells[-1] == "its rooms":
            is_inside = True
        elif not cells:
            is_inside = False
        elif is_inside and not set(cells[0]) <= set("-"):
            told[cells[0].strip("`")] = set(re.findall(r"`(\w+)`", cells[-1]))
    return told
