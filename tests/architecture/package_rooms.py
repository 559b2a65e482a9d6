# SPDX-License-Identifier: LGPL-2.1-or-later
"""The rooms of the Python package, and the imports that break their order."""
import ast
from pathlib import Path

from imports import Graph, imported, module_name

ROOMS = (
    "base",
    "cad",
    "measuring",
    "decks",
    "files",
    "recipe",
    "finding",
    "selecting",
    "joint_files",
    "checking",
    "solving",
    "pictures",
    "reporting",
    "certifying",
    "morph",
    "study",
    "flat",
    "starting",
    "cli",
)
"""From the bottom up: a room imports itself and rooms before it."""
OUTSIDE = {"", "__main__", "old_names"}
"""Modules beside the rooms: the public face, the entry, and the table of old names."""
LAZY = {
    "": "modules under their old names",
    "old_names": "modules under their old names",
    "base.kernel": "the compiled kernel, which may be missing",
    "cli.entry": "the module of a command, so that --help answers at once",
    "starting.installation": "modules of other packages, which may be missing",
}
"""Modules that import others while they run, and what these are."""


def room_of(module: str) -> str:
    """Return the room of a module; "" for the public face."""
    return module.split(".")[0]


def upward_imports(graph: Graph) -> list[str]:
    """Return the imports from a room to a later one, to the public face or to an unknown room."""
    height = {room: number for number, room in enumerate(ROOMS)}
    return [
        f"{module} imports {other or 'the public face'}"
        for module, found in sorted(graph.items())
        if module not in OUTSIDE
        for other in sorted(found)
        if height.get(room_of(other), len(ROOMS)) > height.get(room_of(module), -1)
    ]


def lazy_imports(root: Path, name: str) -> list[str]:
    """Return the modules below `root` that import others of the package `name` in a function."""
    found = []
    for path in sorted(root.rglob("*.py")):
        module = module_name(path, root)
        package = module.split(".") if path.name == "__init__.py" else module.split(".")[:-1]
        if any(is_lazy(node, package, name) for node in functions_of(path.read_text())):
            found.append(module)
    return found


def functions_of(text: str) -> list[ast.AST]:
    """Return all functions of a source."""
    kinds = (ast.FunctionDef, ast.AsyncFunctionDef, ast.Lambda)
    return [node for node in ast.walk(ast.parse(text)) if isinstance(node, kinds)]


def is_lazy(function: ast.AST, package: list[str], name: str) -> bool:
    """Return whether a function imports a module of the package, by a statement or by name."""
    return any(
        imported(node, package, name)
        or (isinstance(node, ast.Attribute) and node.attr == "import_module")
        for node in ast.walk(function)
    )
