# SPDX-License-Identifier: LGPL-2.1-or-later
"""The arguments of all commands, in one place."""

from __future__ import annotations

import argparse
import math
import re
import sys
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from ..base.version import __version__
from ..starting.file_unit import UNITS
from .parsing import STDOUT, Parser

_POSE_HELP = "name of one of the recipe's poses, or JSON file with a pose, instead of its own"
_ENGINES = ("local", "processes", "dask", "slurm", "snakemake")
_SCHEMAS = ("recipe", "report", "find", "doctor", "certificate", "study")
# Command-line option, name in FindOptions, type, help.
SEARCH_NUMBERS = (
    ("--gap", "gap", float, "largest distance of parts in contact, mm (default: proposed)"),
    ("--rings", "rings", int, "washer rings around a hole (default: 1)"),
    ("--smallest-radius", "smallest_radius", float, "of holes, mm"),
    ("--largest-radius", "largest_radius", float, "of holes, mm"),
    ("--roundness", "roundness", float, "residual of a round rim over its radius (default: 0.12)"),
    ("--surface", "surface", float, "residual of a curved surface over its radius (default: 0.01)"),
    ("--plane-angle", "plane_angle", float, "bend inside a plane, degrees (default: 6)"),
    ("--smallest-area", "smallest_area", float, "of a surface over its part's (default: 0.004)"),
    ("--crease-angle", "crease_angle", float, "a sharper bend is an edge, degrees (default: 35)"),
    ("--scatter", "scatter", float, "standard deviation of measured vertices, mm (default: told)"),
    ("--facing-angle", "facing_angle", float, "between surfaces in contact, degrees (default: 35)"),
)
# Mesh sizes for CAD files, as in the key `mesh` of a recipe.
MESH_SIZES = (
    ("--edge", "edge", "longest edges of the meshes of CAD files, mm"),
    ("--deflection", "deflection", "how far those meshes may be off their surfaces, mm"),
    ("--angle", "angle", "how far those meshes may bend from edge to edge, degrees"),
)


def parser() -> argparse.ArgumentParser:
    """Return the argument parser, from which manual page and shell completion are generated."""
    started = Path(sys.argv[0]).name
    parser = Parser(
        prog="python3 -m sheetmorph" if started == "__main__.py" else started,
        description="Deform sheet-metal parts as a recipe says; form features stay rigid.",
        epilog="Exit status: 0 done; 2 bad input, nothing written; 3 a certificate fails; "
        "130 interrupted.",
    )
    parser.add_argument("--version", action="version", version=f"sheetmorph {__version__}")
    commands = parser.add_subparsers(dest="command", required=True, metavar="COMMAND")
    run = commands.add_parser("run", help="deform the parts of a recipe and write them")
    check = commands.add_parser("check", help="do what run does, and write nothing")
    _add_resolve_arguments(commands)
    for command in (run, check):
        command.add_argument("recipe", help="JSON or TOML file; the part files are relative to it")
        text = "folder for the parts"
        command.add_argument("-o", "--output", required=command is run, metavar="DIR", help=text)
        command.add_argument("--pose", metavar="POSE", help=_POSE_HELP)
        text = "write the parts of CAD files as STEP, too"
        command.add_argument("--step", action="store_true", help=text)
        command.add_argument("--report", metavar="FILE", help="where to write the report (JSON)")
        text = "write before.png and after.png beside the parts"
        command.add_argument("--pictures", action="store_true", help=text)
        text = "warnings (badly opened contacts and others) end with exit status 3"
        command.add_argument("--strict", action="store_true", help=text)
        command.add_argument("--quiet", action="store_true", help="no progress on stderr")
    _add_doctor(commands)
    _add_find_arguments(commands)
    _add_flatten_arguments(commands)
    _add_certify_arguments(commands, (run, check))
    _add_recipe_commands(commands)
    _add_study_arguments(commands)
    _add_json_argument([commands.choices[name] for name in ("run", "check", "certify")])
    _add_force(commands)
    return parser


def _add_doctor(commands: Any) -> None:
    doctor = commands.add_parser("doctor", help="say what meshes are and what is wrong with them")
    doctor.add_argument("files", nargs="+", metavar="FILE", help="mesh file")
    text = "vertices nearer than this are one place (mm; a millionth of the size)"
    doctor.add_argument("--tolerance", type=_length, metavar="MM", help=text)
    _add_unit_argument(doctor)


def _add_force(commands: Any) -> None:
    text = "write over files that SheetMorph did not write, too"
    for name in ("run", "check", "resolve", "find", "flatten", "copy", "certify", "show", "study"):
        commands.choices[name].add_argument("--force", action="store_true", help=text)


def _length(text: str) -> float:
    value = float(text)
    if not 0.0 <= value < math.inf:
        raise argparse.ArgumentTypeError(f"{text} is no length; give a number of 0 or more")
    return value


def _add_resolve_arguments(commands: Any) -> None:
    """Add `resolve` to the commands of a parser."""
    text = "print a recipe with the vertex ids its selectors stand for"
    resolve = commands.add_parser("resolve", help=text)
    resolve.add_argument("recipe", help="JSON file; the part files are relative to it")
    resolve.add_argument("-o", "--output", metavar="FILE", help="write there instead of printing")
    resolve.add_argument("--quiet", action="store_true", help="no progress on stderr")


def _add_find_arguments(commands: Any) -> None:
    """Add `find` to the commands of a parser."""
    find = commands.add_parser("find", help="print the features and contacts of mesh files as JSON")
    find.add_argument("files", nargs="+", metavar="FILE", help="mesh files of one assembly")
    ways = ("auto", "components", "property", "none")
    find.add_argument("--split", choices=ways, default="auto", help="parts in one file")
    find.add_argument("--kind", action="append", metavar="KIND", help="only this kind of features")
    find.add_argument("--one-per-pair", action="store_true", help="one contact for two parts")
    for option, name, kind, text in SEARCH_NUMBERS:
        find.add_argument(option, dest=name, type=kind, metavar="N", help=text)
    for option, name, text in MESH_SIZES:
        find.add_argument(option, dest=name, type=float, metavar="N", help=text)
    find.add_argument("-o", "--output", metavar="FILE", help="write there instead of printing")


def _add_flatten_arguments(commands: Any) -> None:
    """Add `flatten` to the commands of a parser."""
    text = "lay a bent sheet flat: blank, bend lines, bend table (kinematic, no forming)"
    flatten = commands.add_parser("flatten", help=text)
    flatten.add_argument("file", metavar="FILE", help="mesh of an open sheet or a thin solid")
    text = "folder for DXF, SVG, OBJ and JSON, or one file .dxf, .svg, .obj or .json"
    flatten.add_argument("-o", "--output", metavar="OUT", help=text)
    text = "thickness of an open sheet, which is the middle of the metal"
    flatten.add_argument("--thickness", type=_positive, metavar="MM", help=text)
    text = "text file with a ratio R/T and a K-factor a line, instead of the usual ones"
    flatten.add_argument("--k-table", metavar="TABLE", help=text)
    text = "how much 99 %% of the area may be stretched, percent (default: 1)"
    flatten.add_argument("--limit", type=_positive, default=1.0, metavar="PERCENT", help=text)
    text = "weld vertices nearer than this first, where a file is cut along faces"
    flatten.add_argument("--weld", type=_positive, metavar="MM", help=text)
    flatten.add_argument("--quiet", action="store_true", help="no progress on stderr")


def _positive(text: str) -> float:
    value = float(text)
    if not 0.0 < value < math.inf:
        raise argparse.ArgumentTypeError(f"{text} is no number above 0")
    return value


def _add_certify_arguments(commands: Any, runs: Sequence[argparse.ArgumentParser]) -> None:
    """Add `certify` and `copy` to a parser, and the related options to `run` and `check`."""
    text = "a set (standard, crash, static) or a JSON file with criteria (default: standard)"
    _add_copy_arguments(commands)
    for run in runs:
        run.add_argument("--wide", action="store_true", help="GRID of moved nodes in large fields")
        run.add_argument(
            "--repair", metavar="FILE", nargs="?", const="standard",
            help=f"let nodes of decks slide in the sheet until elements meet criteria, {text}",
        )  # fmt: skip
        run.add_argument("--certify", action="store_true", help="certify what was written, in DIR")
        run.add_argument("--criteria", metavar="FILE", help=f"for --certify, {text}")
    command = commands.add_parser("certify", help="measure and judge what a run wrote")
    command.add_argument("recipe", help="the recipe of the run")
    command.add_argument("folder", metavar="DIR", help="the folder that the run wrote")
    command.add_argument("--criteria", metavar="FILE", help=text)
    command.add_argument("--page", metavar="FILE", help="where to write it as a page (HTML)")
    for one in (*runs, command, commands.choices["copy"]):
        text = "LS-DYNA decks as if their *KEYWORD said so"
        one.add_argument("--keyword", choices=("long=y", "i10=y"), help=text)


def _add_copy_arguments(commands: Any) -> None:
    """Add `copy` to the commands of a parser."""
    copy = commands.add_parser(
        "copy", help="read decks, meshes, files of welds and write them as they are"
    )
    copy.add_argument("files", nargs="+", metavar="FILE", help="deck, mesh or file of welds")
    copy.add_argument("-o", "--output", required=True, metavar="DIR", help="folder for them")


def _add_recipe_commands(commands: Any) -> None:
    """Add `init`, `show` and `schema` to the commands of a parser."""
    init = commands.add_parser("init", help="write a first recipe of some files, to be edited")
    init.add_argument("files", nargs="+", metavar="FILE", help="mesh, deck or CAD file")
    init.add_argument("-o", "--output", metavar="FILE", help="write there instead of printing")
    _add_unit_argument(init)
    init.add_argument("--quiet", action="store_true", help="no progress on stderr")
    show = commands.add_parser("show", help="draw what a recipe means")
    show.add_argument("recipe", help="JSON or TOML file")
    show.add_argument("-o", "--output", required=True, metavar="FILE", help="picture (PNG)")
    show.add_argument("--pose", metavar="NAME", help="one of its poses instead of its own")
    show.add_argument("--after", action="store_true", help="the parts in the pose, how far moved")
    text = "from the middle to the eye (default: 0.55,-1,0.75)"
    show.add_argument("--view", type=_direction, metavar="X,Y,Z", help=text)
    show.add_argument("--quiet", action="store_true", help="no progress on stderr")
    schema = commands.add_parser("schema", help="print the JSON Schema of recipes")
    text = "of what (default: recipe)"
    schema.add_argument("of", nargs="?", choices=_SCHEMAS, default="recipe", help=text)


def _add_unit_argument(command: argparse.ArgumentParser) -> None:
    """Add the option `--unit`, the unit of mesh files."""
    text = "the unit of mesh files (default: the one that makes them usual sheet-metal parts)"
    command.add_argument("--unit", choices=tuple(UNITS), help=text)


def _direction(text: str) -> tuple[float, float, float]:
    try:
        values = [float(part) for part in text.split(",")]
    except ValueError:
        values = []
    if len(values) != 3 or not 0.0 < math.hypot(*values) < math.inf:
        raise argparse.ArgumentTypeError(f"{text} is no direction; give three numbers, 1,0,0")
    return values[0], values[1], values[2]


def _add_study_arguments(commands: Any) -> None:
    """Add `study` to the commands of a parser."""
    study = commands.add_parser("study", help="compute, certify and table variants of a recipe")
    study.add_argument("recipe", metavar="STUDY", help="JSON file; its recipe is relative to it")
    study.add_argument("-o", "--output", metavar="DIR", help="folder for the variants")
    text = "where variants are computed (default: local, in this process)"
    study.add_argument("--engine", choices=_ENGINES, default="local", help=text)
    text = "processes, workers of Dask, jobs of an array (default: the cores; 16 jobs)"
    study.add_argument("--workers", type=_count, default=0, metavar="N", help=text)
    text = "of Dask, such as tcp://host:8786 (default: a cluster on this machine for this study)"
    study.add_argument("--scheduler", metavar="ADDRESS", help=text)
    text = "only these runs, and no table: for jobs of a batch system"
    study.add_argument("--runs", type=_runs, metavar="FIRST-LAST", help=text)
    text = "instead of variants: how far every parameter may go until a criterion breaks"
    study.add_argument("--range", action="store_true", help=text)
    text = "instead of variants: one evaluation, parameters and results as Dakota's files or JSON"
    study.add_argument("--evaluate", nargs=2, metavar=("IN", "OUT"), help=text)
    study.add_argument("--quiet", action="store_true", help="no progress on stderr")


def _count(text: str) -> int:
    if not text.isdecimal() or not 0 < int(text) <= 10_000:
        raise argparse.ArgumentTypeError(f"{text} is no number of workers; give 1 to 10000")
    return int(text)


def _runs(text: str) -> tuple[int, int]:
    found = re.fullmatch(r"(\d{1,7})-(\d{1,7})", text)
    if found is None or int(found[1]) > int(found[2]):
        raise argparse.ArgumentTypeError(f"{text} is no range of runs; give two such as 0-99")
    return int(found[1]), int(found[2])


def _add_json_argument(commands: Sequence[argparse.ArgumentParser]) -> None:
    """Add `--json` to commands, with the same meaning in each."""
    text = "the result as JSON: in FILE, or on stdout in place of the text"
    for command in commands:
        command.add_argument("--json", nargs="?", const=STDOUT, metavar="FILE", help=text)
