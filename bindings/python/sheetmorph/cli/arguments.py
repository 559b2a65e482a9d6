# SPDX-License-Identifier: LGPL-2.1-or-later
"""The arguments of all commands, in one place."""

from __future__ import annotations

import argparse
import math
import re
import sys
from collections.abc import Mapping, Sequence
from pathlib import Path

from ..base.version import __version__
from ..base.file_unit import UNITS
from .parsing import STDOUT, Parser

_Commands = Mapping[str, argparse.ArgumentParser]
_POSE_HELP = "name of one of the recipe's poses, or a file with a pose (default: the recipe's pose)"
COMMANDS = {
    "Begin": {
        "init": ("write a first recipe for files, to be edited", "cover.step -o recipe.json"),
        "show": ("draw the regions and motions of a recipe", "recipe.json -o recipe.png"),
        "find": ("find the features and contacts of mesh files", "a.obj b.obj -o found.json"),
        "doctor": (
            "describe meshes and their faults; without a file, check the installation",
            "a.stl",
        ),
    },
    "Deform": {
        "check": ("do all that run does, but write nothing", "recipe.json"),
        "run": ("deform the parts of a recipe and write them", "recipe.json -o deformed"),
        "certify": ("certify the folder that a run wrote", "recipe.json deformed"),
        "study": ("compute, certify and tabulate variants of a recipe", "study.json -o variants"),
    },
    "Convert": {
        "resolve": ("print a recipe with vertex ids in place of its selectors", "recipe.json"),
        "flatten": (
            "flatten a bent sheet: blank, bend lines, bend table",
            "angle.step -o blank.dxf",
        ),
        "copy": ("read decks, meshes or joint files and write them unchanged", "a.bdf -o same"),
    },
    "Help": {
        "schema": ("print a JSON Schema", "study"),
        "completion": ("print a script that completes command lines in a shell", "bash"),
    },
}
"""Heading -> command -> what it does, and the arguments of an example."""
SHELLS = ("bash", "zsh", "fish")
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


class Grouped(argparse.HelpFormatter):
    """Lists the commands under the headings of COMMANDS."""

    def _format_action(self, action: argparse.Action) -> str:
        if not isinstance(action, argparse._SubParsersAction):
            return super()._format_action(action)
        entries = {entry.dest: entry for entry in action._get_subactions()}
        lines = []
        room = max(map(len, entries)) + self._current_indent + self._indent_increment
        self._action_max_length = max(self._action_max_length, room)
        for heading, names in COMMANDS.items():
            lines.append(f"{'':{self._current_indent}}{heading}\n")
            self._indent()
            lines += [self._format_action(entries[name]) for name in names]
            self._dedent()
        return "".join(lines)


def parser() -> argparse.ArgumentParser:
    """Return the argument parser, from which manual page and shell completion are generated."""
    started = Path(sys.argv[0]).name
    parser = Parser(
        formatter_class=Grouped,
        prog="python3 -m sheetmorph" if started == "__main__.py" else started,
        description="Deform sheet-metal parts by a recipe; form features stay rigid.",
        epilog="Exit status: 0 done; 2 bad input, nothing written; 3 a certificate fails; "
        "130 interrupted.",
    )
    parser.add_argument("--version", action="version", version=f"sheetmorph {__version__}")
    commands = parser.add_subparsers(
        dest="command", required=True, metavar="COMMAND", title="commands"
    )
    for name, (text, example) in (one for group in COMMANDS.values() for one in group.items()):
        description, epilog = f"{text[0].upper()}{text[1:]}.", f"Example: %(prog)s {example}"
        commands.add_parser(name, help=text, description=description, epilog=epilog)
    run, check = commands.choices["run"], commands.choices["check"]
    for command in (run, check):
        _add_run_arguments(command, is_writing=command is run)
    for add in (_add_begin, _add_find, _add_flatten, _add_study, _add_help):
        add(commands.choices)
    _add_certify(commands.choices, (run, check))
    for command in commands.choices.values():
        _add_common(command)
    return parser


def _add_run_arguments(command: argparse.ArgumentParser, *, is_writing: bool) -> None:
    """Add the arguments of `run` and `check`."""
    command.add_argument("recipe", help="JSON or TOML file; the part files are relative to it")
    text = "folder for the parts"
    command.add_argument("-o", "--output", required=is_writing, metavar="DIR", help=text)
    command.add_argument("--pose", metavar="POSE", help=_POSE_HELP)
    text = "also write the parts of CAD files as STEP"
    command.add_argument("--step", action="store_true", help=text)
    text = "write before.png and after.png next to the parts"
    command.add_argument("--pictures", action="store_true", help=text)
    text = "exit with status 3 on warnings, such as open contacts"
    command.add_argument("--strict", action="store_true", help=text)


def _add_common(command: argparse.ArgumentParser) -> None:
    """Add the options that mean the same in every command."""
    text = "write the result as JSON to FILE, or to stdout in place of the text"
    command.add_argument("--json", nargs="?", const=STDOUT, metavar="FILE", help=text)
    command.add_argument("--report", metavar="FILE", help="another name of --json FILE")
    command.add_argument("--quiet", action="store_true", help="do not print progress to stderr")
    text = "also overwrite files that SheetMorph did not write"
    command.add_argument("--force", action="store_true", help=text)


def _length(text: str) -> float:
    value = float(text)
    if not 0.0 <= value < math.inf:
        raise argparse.ArgumentTypeError(f"{text} is not a length; give a number of 0 or more")
    return value


def _add_find(commands: _Commands) -> None:
    """Add the arguments of `find`."""
    find = commands["find"]
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


def _add_flatten(commands: _Commands) -> None:
    """Add the arguments of `flatten`."""
    flatten = commands["flatten"]
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


def _positive(text: str) -> float:
    value = float(text)
    if not 0.0 < value < math.inf:
        raise argparse.ArgumentTypeError(f"{text} is not a number above 0")
    return value


def _add_certify(commands: _Commands, runs: Sequence[argparse.ArgumentParser]) -> None:
    """Add the arguments of `certify` and `copy`, and the related options of `run` and `check`."""
    text = "a set (standard, crash, static) or a file with criteria (default: standard)"
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
    certify, copy = commands["certify"], commands["copy"]
    certify.add_argument("recipe", help="the recipe of the run")
    certify.add_argument("folder", metavar="DIR", help="the folder that the run wrote")
    certify.add_argument("--criteria", metavar="FILE", help=text)
    certify.add_argument(
        "--page", metavar="FILE", help="where to write the certificate as an HTML page"
    )
    copy.add_argument("files", nargs="+", metavar="FILE", help="deck, mesh or joint file")
    copy.add_argument("-o", "--output", required=True, metavar="DIR", help="folder for the copies")
    for one in (*runs, certify, copy):
        text = "read LS-DYNA decks as if *KEYWORD had this option"
        one.add_argument("--keyword", choices=("long=y", "i10=y"), help=text)


def _add_begin(commands: _Commands) -> None:
    """Add the arguments of `init`, `show`, `resolve` and `doctor`."""
    init, show, resolve = (commands[name] for name in ("init", "show", "resolve"))
    init.add_argument("files", nargs="+", metavar="FILE", help="mesh, deck or CAD file")
    text = "write to FILE instead of printing; TOML if it ends in .toml"
    init.add_argument("-o", "--output", metavar="FILE", help=text)
    for command in (show, resolve):
        command.add_argument("recipe", help="JSON or TOML file; the part files are relative to it")
    resolve.add_argument("-o", "--output", metavar="FILE", help=text)
    show.add_argument("-o", "--output", required=True, metavar="FILE", help="picture (PNG)")
    text = "name of one of the recipe's poses (default: the recipe's pose)"
    show.add_argument("--pose", metavar="NAME", help=text)
    text = "draw the deformed parts, coloured by displacement"
    show.add_argument("--after", action="store_true", help=text)
    text = "view direction, from the centre to the eye (default: 0.55,-1,0.75)"
    show.add_argument("--view", type=_direction, metavar="X,Y,Z", help=text)
    doctor = commands["doctor"]
    doctor.add_argument("files", nargs="*", metavar="FILE", help="mesh file")
    text = "merge distance of vertices, mm (default: a millionth of the size)"
    doctor.add_argument("--tolerance", type=_length, metavar="MM", help=text)
    text = "unit of the mesh files (default: the one that gives usual sizes of sheet-metal parts)"
    for command in (init, doctor):
        command.add_argument("--unit", choices=tuple(UNITS), help=text)


def _add_help(commands: _Commands) -> None:
    """Add the arguments of `schema` and `completion`."""
    text = "which schema (default: recipe)"
    commands["schema"].add_argument("of", nargs="?", choices=_SCHEMAS, default="recipe", help=text)
    commands["completion"].add_argument("shell", choices=SHELLS, help="the shell")


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


def _add_study(commands: _Commands) -> None:
    """Add the arguments of `study`."""
    study = commands["study"]
    text = "JSON or TOML file; its recipe is relative to it"
    study.add_argument("recipe", metavar="STUDY", help=text)
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


def _count(text: str) -> int:
    if not text.isdecimal() or not 0 < int(text) <= 10_000:
        raise argparse.ArgumentTypeError(f"{text} is not a number of workers; give 1 to 10000")
    return int(text)


def _runs(text: str) -> tuple[int, int]:
    found = re.fullmatch(r"(\d{1,7})-(\d{1,7})", text)
    if found is None or int(found[1]) > int(found[2]):
        raise argparse.ArgumentTypeError(f"{text} is not a range of runs; give one such as 0-99")
    return int(found[1]), int(found[2])
