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
from ..base.file_unit import UNITS
from .parsing import STDOUT, Parser

_POSE_HELP = (
    "name of one of the recipe's poses, or a JSON file with a pose (default: the recipe's pose)"
)
_ENGINES = ("local", "processes", "dask", "slurm", "snakemake")
_SCHEMAS = ("recipe", "report", "find", "doctor", "certificate", "study")
# Command-line option, name in FindOptions, type, help.
SEARCH_NUMBERS = (
    ("--gap", "gap", float, "largest distance of parts in contact, mm (default: proposed)"),
    ("--rings", "rings", int, "rings of vertices around a hole (default: 1)"),
    ("--smallest-radius", "smallest_radius", float, "of holes, mm"),
    ("--largest-radius", "largest_radius", float, "of holes, mm"),
    (
        "--roundness",
        "roundness",
        float,
        "roundness tolerance of a rim, over its radius (default: 0.12)",
    ),
    (
        "--surface",
        "surface",
        float,
        "tolerance of a curved surface, over its radius (default: 0.01)",
    ),
    ("--plane-angle", "plane_angle", float, "largest bend inside a plane, degrees (default: 6)"),
    (
        "--smallest-area",
        "smallest_area",
        float,
        "smallest area of a surface, over the area of its part (default: 0.004)",
    ),
    (
        "--crease-angle",
        "crease_angle",
        float,
        "edge angle: a sharper bend is an edge, degrees (default: 35)",
    ),
    (
        "--scatter",
        "scatter",
        float,
        "standard deviation of measured vertices, mm (default: estimated)",
    ),
    (
        "--facing-angle",
        "facing_angle",
        float,
        "largest angle between surfaces in contact, degrees (default: 35)",
    ),
)
# Mesh sizes for CAD files, as in the key `mesh` of a recipe.
MESH_SIZES = (
    ("--edge", "edge", "maximum edge length for meshing CAD files, mm"),
    ("--deflection", "deflection", "maximum deviation of these meshes from the CAD surfaces, mm"),
    ("--angle", "angle", "maximum bend of these meshes from edge to edge, degrees"),
)


def parser() -> argparse.ArgumentParser:
    """Return the argument parser, from which manual page and shell completion are generated."""
    started = Path(sys.argv[0]).name
    parser = Parser(
        prog="python3 -m sheetmorph" if started == "__main__.py" else started,
        description="Deform sheet-metal parts by a recipe; form features stay rigid.",
        epilog="Exit status: 0 done; 2 bad input, nothing written; 3 a certificate fails; "
        "130 interrupted.",
    )
    parser.add_argument("--version", action="version", version=f"sheetmorph {__version__}")
    commands = parser.add_subparsers(dest="command", required=True, metavar="COMMAND")
    run = commands.add_parser("run", help="deform the parts of a recipe and write them")
    check = commands.add_parser("check", help="do all that run does, but write nothing")
    _add_resolve_arguments(commands)
    for command in (run, check):
        command.add_argument("recipe", help="JSON or TOML file; the part files are relative to it")
        text = "folder for the parts"
        command.add_argument("-o", "--output", required=command is run, metavar="DIR", help=text)
        command.add_argument("--pose", metavar="POSE", help=_POSE_HELP)
        text = "also write the parts of CAD files as STEP"
        command.add_argument("--step", action="store_true", help=text)
        command.add_argument("--report", metavar="FILE", help="where to write the report (JSON)")
        text = "write before.png and after.png next to the parts"
        command.add_argument("--pictures", action="store_true", help=text)
        text = "exit with status 3 on warnings, such as open contacts"
        command.add_argument("--strict", action="store_true", help=text)
        command.add_argument("--quiet", action="store_true", help="do not print progress to stderr")
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
    doctor = commands.add_parser("doctor", help="describe meshes and their faults")
    doctor.add_argument("files", nargs="+", metavar="FILE", help="mesh file")
    text = "merge distance of vertices, mm (default: a millionth of the size)"
    doctor.add_argument("--tolerance", type=_length, metavar="MM", help=text)
    _add_unit_argument(doctor)


def _add_force(commands: Any) -> None:
    text = "also overwrite files that SheetMorph did not write"
    for name in ("run", "check", "resolve", "find", "flatten", "copy", "certify", "show", "study"):
        commands.choices[name].add_argument("--force", action="store_true", help=text)


def _length(text: str) -> float:
    value = float(text)
    if not 0.0 <= value < math.inf:
        raise argparse.ArgumentTypeError(f"{text} is not a length; give a number of 0 or more")
    return value


def _add_resolve_arguments(commands: Any) -> None:
    """Add `resolve` to the commands of a parser."""
    text = "print a recipe with vertex ids in place of its selectors"
    resolve = commands.add_parser("resolve", help=text)
    resolve.add_argument("recipe", help="JSON file; the part files are relative to it")
    resolve.add_argument("-o", "--output", metavar="FILE", help="write to FILE instead of printing")
    resolve.add_argument("--quiet", action="store_true", help="do not print progress to stderr")


def _add_find_arguments(commands: Any) -> None:
    """Add `find` to the commands of a parser."""
    find = commands.add_parser("find", help="print the features and contacts of mesh files as JSON")
    find.add_argument("files", nargs="+", metavar="FILE", help="mesh files of one assembly")
    ways = ("auto", "components", "property", "none")
    find.add_argument(
        "--split", choices=ways, default="auto", help="how to split a file into parts"
    )
    find.add_argument(
        "--kind",
        action="append",
        metavar="KIND",
        help="find this kind of feature only (hole: all holes); can be repeated",
    )
    find.add_argument("--one-per-pair", action="store_true", help="one contact per pair of parts")
    for option, name, kind, text in SEARCH_NUMBERS:
        find.add_argument(option, dest=name, type=kind, metavar="N", help=text)
    for option, name, text in MESH_SIZES:
        find.add_argument(option, dest=name, type=float, metavar="N", help=text)
    find.add_argument("-o", "--output", metavar="FILE", help="write to FILE instead of printing")


def _add_flatten_arguments(commands: Any) -> None:
    """Add `flatten` to the commands of a parser."""
    text = "flatten a bent sheet: blank, bend lines, bend table (kinematic, no forming simulation)"
    flatten = commands.add_parser("flatten", help=text)
    flatten.add_argument("file", metavar="FILE", help="mesh of an open sheet or a thin solid")
    text = "folder for DXF, SVG, OBJ and JSON, or one file .dxf, .svg, .obj or .json"
    flatten.add_argument("-o", "--output", metavar="OUT", help=text)
    text = "thickness of an open sheet, which is the mid-surface, mm"
    flatten.add_argument("--thickness", type=_positive, metavar="MM", help=text)
    text = "text file with one R/T ratio and K-factor per line (default: usual values)"
    flatten.add_argument("--k-table", metavar="TABLE", help=text)
    text = "largest stretch allowed in 99 %% of the area, percent (default: 1)"
    flatten.add_argument("--limit", type=_positive, default=1.0, metavar="PERCENT", help=text)
    text = "merge vertices closer than this first, for files that are cut along faces"
    flatten.add_argument("--weld", type=_positive, metavar="MM", help=text)
    flatten.add_argument("--quiet", action="store_true", help="do not print progress to stderr")


def _positive(text: str) -> float:
    value = float(text)
    if not 0.0 < value < math.inf:
        raise argparse.ArgumentTypeError(f"{text} is not a number above 0")
    return value


def _add_certify_arguments(commands: Any, runs: Sequence[argparse.ArgumentParser]) -> None:
    """Add `certify` and `copy` to a parser, and the related options to `run` and `check`."""
    text = "a set (standard, crash, static) or a JSON file with criteria (default: standard)"
    _add_copy_arguments(commands)
    for run in runs:
        run.add_argument(
            "--wide", action="store_true", help="write GRID cards of moved nodes in large fields"
        )
        run.add_argument(
            "--repair", metavar="FILE", nargs="?", const="standard",
            help=f"repair deck elements by sliding nodes until they meet criteria, {text}",
        )  # fmt: skip
        run.add_argument("--certify", action="store_true", help="certify the written parts")
        run.add_argument("--criteria", metavar="FILE", help=f"for --certify, {text}")
    command = commands.add_parser("certify", help="certify the folder that a run wrote")
    command.add_argument("recipe", help="the recipe of the run")
    command.add_argument("folder", metavar="DIR", help="the folder that the run wrote")
    command.add_argument("--criteria", metavar="FILE", help=text)
    command.add_argument(
        "--page", metavar="FILE", help="where to write the certificate as an HTML page"
    )
    for one in (*runs, command, commands.choices["copy"]):
        text = "read LS-DYNA decks as if *KEYWORD had this option"
        one.add_argument("--keyword", choices=("long=y", "i10=y"), help=text)


def _add_copy_arguments(commands: Any) -> None:
    """Add `copy` to the commands of a parser."""
    copy = commands.add_parser(
        "copy", help="read decks, meshes or joint files and write them unchanged"
    )
    copy.add_argument("files", nargs="+", metavar="FILE", help="deck, mesh or joint file")
    copy.add_argument("-o", "--output", required=True, metavar="DIR", help="folder for the copies")


def _add_recipe_commands(commands: Any) -> None:
    """Add `init`, `show` and `schema` to the commands of a parser."""
    init = commands.add_parser("init", help="write a first recipe for files, to be edited")
    init.add_argument("files", nargs="+", metavar="FILE", help="mesh, deck or CAD file")
    init.add_argument("-o", "--output", metavar="FILE", help="write to FILE instead of printing")
    _add_unit_argument(init)
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


def _add_unit_argument(command: argparse.ArgumentParser) -> None:
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


def _add_study_arguments(commands: Any) -> None:
    """Add `study` to the commands of a parser."""
    study = commands.add_parser("study", help="compute, certify and tabulate variants of a recipe")
    study.add_argument("recipe", metavar="STUDY", help="JSON file; its recipe is relative to it")
    study.add_argument("-o", "--output", metavar="DIR", help="folder for the variants")
    text = "where to compute the variants (default: local, in this process)"
    study.add_argument("--engine", choices=_ENGINES, default="local", help=text)
    text = "number of processes, Dask workers or array jobs (default: number of cores; 16 jobs)"
    study.add_argument("--workers", type=_count, default=0, metavar="N", help=text)
    text = (
        "address of a Dask scheduler, such as tcp://host:8786 (default: a "
        "local cluster for this study)"
    )
    study.add_argument("--scheduler", metavar="ADDRESS", help=text)
    text = "compute only these runs and no table, for jobs of a batch system"
    study.add_argument("--runs", type=_runs, metavar="FIRST-LAST", help=text)
    text = "find the admissible range of every parameter instead of computing variants"
    study.add_argument("--range", action="store_true", help=text)
    text = (
        "compute one evaluation instead of variants; parameters and results "
        "are Dakota files or JSON"
    )
    study.add_argument("--evaluate", nargs=2, metavar=("IN", "OUT"), help=text)
    study.add_argument("--quiet", action="store_true", help="do not print progress to stderr")


def _count(text: str) -> int:
    if not text.isdecimal() or not 0 < int(text) <= 10_000:
        raise argparse.ArgumentTypeError(f"{text} is not a number of workers; give 1 to 10000")
    return int(text)


def _runs(text: str) -> tuple[int, int]:
    found = re.fullmatch(r"(\d{1,7})-(\d{1,7})", text)
    if found is None or int(found[1]) > int(found[2]):
        raise argparse.ArgumentTypeError(f"{text} is not a range of runs; give one such as 0-99")
    return int(found[1]), int(found[2])


def _add_json_argument(commands: Sequence[argparse.ArgumentParser]) -> None:
    """Add `--json` to commands, with the same meaning in each."""
    text = "write the result as JSON to FILE, or to stdout in place of the text"
    for command in commands:
        command.add_argument("--json", nargs="?", const=STDOUT, metavar="FILE", help=text)
