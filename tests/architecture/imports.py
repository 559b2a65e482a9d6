# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which source of a Python package imports which, and the circles in that.

Imports inside functions and those for types alone count: a circle of either kind means that neither
file can be read, tested or moved without the other.
"""
import ast
from pathlib import Path

Graph = dict[str, set[str]]
COMPILED = {"_core", "_coin"}  # they import nothing of the package


def module_name(path: Path, root: Path) -> str:
    """`panels.base` for ROOT/panels/base.py; a folder's `__init__.py` is the folder."""
    parts = path.relative_to(root).with_suffix("").parts
    return ".".join(parts[:-1] if parts[-1] == "__init__" else parts)


def imported(node: ast.AST, package: list[str], name: str) -> list[tuple[str, str]]:
    """(module, name taken from it) of an import within the package `name`, as seen in `package`."""
    if isinstance(node, ast.Import):
        found = [(alias.name, "") for alias in node.names]
    elif isinstance(node, ast.ImportFrom) and node.level:
        above = [name, *package][: len(package) + 2 - node.level]
        start = ".".join([*above, *([node.module] if node.module else [])])
        found = [(start, alias.name) for alias in node.names]
    elif isinstance(node, ast.ImportFrom):
        found = [(node.module or "", alias.name) for alias in node.names]
    else:
        found = []
    inside = [(module, taken) for module, taken in found if f"{module}.".startswith(f"{name}.")]
    return [(module[len(name) + 1 :], taken) for module, taken in inside]


def import_graph(root: Path, name: str) -> Graph:
    """By source below `root`, the folder of the package `name`: the sources it imports."""
    paths = {module_name(path, root): path for path in sorted(root.rglob("*.py"))}
    graph: Graph = {module: set() for module in paths}
    for module, path in paths.items():
        package = module.split(".") if module else []
        package = package if path.name == "__init__.py" else package[:-1]
        for node in ast.walk(ast.parse(path.read_text())):
            for start, taken in imported(node, package, name):
                if taken in COMPILED:
                    continue
                whole = f"{start}.{taken}".lstrip(".")
                graph[module].add(whole if whole in paths else start)
    return {module: (found & set(paths)) - {module} for module, found in graph.items()}


def reached(graph: Graph, start: str) -> set[str]:
    """Everything `start` imports, directly or not."""
    seen: set[str] = set()
    waiting = [start]
    while waiting:
        new = graph[waiting.pop()] - seen
        seen |= new
        waiting += new
    return seen


def circles(graph: Graph) -> list[list[str]]:
    """Groups of sources each of which reaches all others of its group, the largest first."""
    reach = {module: reached(graph, module) for module in graph}
    groups = {
        tuple(sorted(other for other in reach[module] if module in reach[other]))
        for module in graph
        if module in reach[module]
    }
    return sorted((list(group) for group in groups), key=len, reverse=True)


def folder_graph(graph: Graph) -> Graph:
    """The same between the folders (or single files) at the top of the package."""
    rooms: Graph = {}
    for module, found in graph.items():
        room = module.split(".")[0]
        rooms.setdefault(room, set()).update(other.split(".")[0] for other in found)
    inner = set(rooms) - {""}
    return {room: (rooms[room] & inner) - {room} for room in inner}
