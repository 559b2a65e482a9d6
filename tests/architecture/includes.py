# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which folder of the kernel includes which, at every depth."""
from collections.abc import Mapping
from pathlib import Path

from imports import Graph
from layers import INCLUDE


def kernel_includes(sources: list[Path], kernel: Path) -> dict[str, set[str]]:
    """By source, relative to the kernel: the headers of the kernel that it includes."""
    return {
        path.relative_to(kernel).as_posix(): {
            header.removeprefix("sheetmorph/")
            for header in INCLUDE.findall(path.read_text())
            if header.startswith("sheetmorph/")
        }
        for path in sources
    }


def folder_at(path: str, depth: int) -> str:
    """`surface/live` for `surface/live/span.h` at depth 2, `surface` at depth 1.

    A source that lies above that depth belongs to the folder it lies in.
    """
    return "/".join(path.split("/")[:-1][:depth])


def folders_at(includes: Mapping[str, set[str]], depth: int) -> Graph:
    """What the folders of one depth include of each other."""
    graph: Graph = {}
    for path, headers in includes.items():
        found = graph.setdefault(folder_at(path, depth), set())
        found |= {folder_at(header, depth) for header in headers}
    return {folder: (found & set(graph)) - {folder} for folder, found in graph.items()}


def depths(includes: Mapping[str, set[str]]) -> range:
    """1 for the layers, 2 for their rooms, and so on as deep as there are folders."""
    return range(1, max(path.count("/") for path in includes) + 1)


def mutual_pairs(graph: Graph) -> list[tuple[str, str]]:
    """Folders that include each other."""
    pairs = ((a, b) for a in sorted(graph) for b in sorted(graph[a]))
    return [(a, b) for a, b in pairs if a < b and a in graph[b]]
