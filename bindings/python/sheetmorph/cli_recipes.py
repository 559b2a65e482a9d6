# SPDX-License-Identifier: LGPL-2.1-or-later
"""The commands that help to write a recipe: `init`, `show`, `schema`."""

from __future__ import annotations

import argparse
import math
import sys
from importlib import resources
from pathlib import Path
from typing import Any

from .cli_find import write_text
from .cli_progress import progress_on
from .errors import Fault, RecipeError
from .file_unit import UNITS
from .files.atomic import FileSet

_SCHEMAS = ("recipe", "report", "find", "doctor", "certificate", "study")


def add_recipe_commands(commands: Any) -> None:
    """Add `init`, `show` and `schema` to the commands of a parser."""
    init = commands.add_parser("init", help="write a first recipe for files, to be edited")
    init.add_argument("files", nargs="+", metavar="FILE", help="mesh, deck or CAD file")
    init.add_argument("-o", "--output", metavar="FILE", help="write to FILE instead of printing")
    add_unit_argument(init)
    init.add_argument("--quiet", action="store_true", help="do not print progress to stderr")
    show = commands.add_parser("show", help="draw the regions and motions of a recipe")
    show.add_argument("recipe", help="JSON or TOML file")
    show.add_argument("-o", "--output", required=True, metavar="FILE", help="picture (PNG)")
    show.add_argument(
        "--pose",
        metavar="NAME",
        help="name of one of the recipe's poses (default: the recipe's pose)",
    )
    show.add_argument(
        "--after", action="store_true", help="draw the deformed parts, coloured by displacement"
    )
    text = "view direction, from the centre to the eye (default: 0.55,-1,0.75)"
    show.add_argument("--view", type=_direction, metavar="X,Y,Z", help=text)
    show.add_argument("--quiet", action="store_true", help="do not print progress to stderr")
    schema = commands.add_parser("schema", help="print the JSON Schema of recipes")
    text = "which schema (default: recipe)"
    schema.add_argument("of", nargs="?", choices=_SCHEMAS, default="recipe", help=text)


def add_unit_argument(command: argparse.ArgumentParser) -> None:
    """Add the option `--unit`, the unit of mesh files."""
    text = "unit of the mesh files (default: the one that gives usual sizes of sheet-metal parts)"
    command.add_argument("--unit", choices=tuple(UNITS), help=text)


def _direction(text: str) -> tuple[float, float, float]:
    try:
        values = [float(part) for part in text.split(",")]
    except ValueError:
        values = []
    if len(values) != 3 or not 0.0 < math.hypot(*values) < math.inf:
        raise argparse.ArgumentTypeError(
            f"{text} is not a direction; give three numbers, such as 1,0,0"
        )
    return values[0], values[1], values[2]


def _init(wanted: argparse.Namespace, files: FileSet) -> list[str]:
    # Imported here, so that --help answers at once.
    from .starting import starting_recipe

    if wanted.output and Path(wanted.output).exists():
        what = f"{wanted.output} already exists and may have been edited"
        raise RecipeError([Fault("-o", what, "name another file, or remove it first")])
    folder = Path(wanted.output).parent if wanted.output else Path()
    with progress_on(sys.stderr, wanted.quiet) as progress:
        is_toml = bool(wanted.output) and Path(wanted.output).suffix.lower() == ".toml"
        text = starting_recipe(wanted.files, folder, progress, is_toml=is_toml, unit=wanted.unit)
    if not wanted.output:
        return [text.rstrip("\n")]
    path = write_text(wanted, text, files)
    return [f"{path}: written; check it with `show`, edit it, then `run` it"]


def _show(wanted: argparse.Namespace, files: FileSet) -> list[str]:
    from .showing import show

    with progress_on(sys.stderr, wanted.quiet) as progress:
        show(
            wanted.recipe, wanted.output, wanted.pose, after=wanted.after, view=wanted.view,
            files=files, progress=progress,
        )  # fmt: skip
    return [f"{wanted.output}: written"]


def _schema(wanted: argparse.Namespace, _files: FileSet) -> list[str]:
    text = resources.files("sheetmorph").joinpath(f"{wanted.of}.schema.json").read_text("utf-8")
    return text.splitlines()


RECIPE_COMMANDS = {"init": _init, "show": _show, "schema": _schema}
