# SPDX-License-Identifier: LGPL-2.1-or-later
"""Blanks as DXF (R12, mm), SVG, OBJ and JSON."""

from __future__ import annotations

import json
import math
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np

from ..base.arrays import Floats
from ..base.errors import InputError
from ..files.atomic import FileSet
from .bends import Bend
from .pattern import FlatPattern

_LAYERS = (("OUTLINE", 7), ("HOLES", 1), ("BEND_UP", 5), ("BEND_DOWN", 3))
_MARGIN = 10.0  # mm around the drawing
_LETTER = 0.62  # width over height of a character
_FULL_COLOUR = 0.01  # stretches of 1 % and more have the strongest colour
_TABLE = ("bend", "angle", "radius", "inner radius", "K", "allowance")


def write_patterns(patterns: list[FlatPattern], output: Path, files: FileSet) -> list[Path]:
    """Write every blank and return the paths.

    output is a file .dxf, .svg, .obj or .json for a single blank, or a folder for all. Raises
    InputError for any other output, FileError, OSError.
    """
    ways = {".dxf": dxf_of, ".svg": svg_of, ".obj": obj_of, ".json": json_of}
    one_way = ways.get(output.suffix.lower())
    if one_way is not None and len(patterns) > 1:
        what = f"one file cannot hold {len(patterns)} pieces"
        raise InputError(what, "give a folder")
    if one_way is None and output.suffix and not output.is_dir():
        what = f'unknown format "{output.suffix}"'
        raise InputError(what, "use .dxf, .svg, .obj or .json, or a name without a suffix")
    wanted = (
        {output: one_way(patterns[0])}
        if one_way is not None
        else {
            output / f"{pattern.name}{suffix}": way(pattern)
            for pattern in patterns
            for suffix, way in ways.items()
        }
    )
    if one_way is None:
        output.mkdir(parents=True, exist_ok=True)
    with files:
        for path, text in wanted.items():
            files.temporary_for(path).write_text(text, "utf-8")
        files.commit()
    return list(wanted)


def table_of(pattern: FlatPattern, unit: str = "mm") -> list[str]:
    """Return the bend table as lines of text; unit is that of the lengths in the file."""
    largest, most = pattern.residual()
    width, height = pattern.size
    metal = "" if pattern.thickness is None else f", {pattern.thickness:.4g} {unit} thick"
    lines = [
        f"{pattern.name}: {width:.3f} x {height:.3f} {unit}{metal}, "
        f"{len(pattern.holes)} hole(s), {len(pattern.bends)} bend(s); residual "
        f"strain: largest {100 * largest:.3f} %, 99 % of the area below "
        f"{100 * most:.3f} %"
    ]
    if pattern.bends:
        lines.append("  ".join(f"{word:>12}" for word in _TABLE))
    for number, bend in enumerate(pattern.bends, 1):
        cells = [f"{number} {_side(bend)}", f"{math.degrees(bend.angle):.2f}", f"{bend.radius:.3f}"]
        cells += [_told(bend.inner), _told(bend.k_factor), _told(bend.allowance)]
        lines.append("  ".join(f"{cell:>12}" for cell in cells))
    return [*lines, *(f"note: {note}" for note in pattern.notes)]


def dxf_of(pattern: FlatPattern) -> str:
    """Return outline, holes and bend lines as DXF, each on its own layer."""
    pairs: list[tuple[int, Any]] = [(0, "SECTION"), (2, "HEADER"), (9, "$ACADVER"), (1, "AC1009")]
    pairs += [(9, "$INSUNITS"), (70, 4), (0, "ENDSEC"), (0, "SECTION"), (2, "TABLES")]
    pairs += [(0, "TABLE"), (2, "LAYER"), (70, len(_LAYERS))]
    for name, colour in _LAYERS:
        pairs += [(0, "LAYER"), (2, name), (70, 0), (62, colour), (6, "CONTINUOUS")]
    pairs += [(0, "ENDTAB"), (0, "ENDSEC"), (0, "SECTION"), (2, "ENTITIES")]
    pairs += _polyline("OUTLINE", pattern.flat[pattern.corners(pattern.outline)])
    for rim, circle in zip(pattern.holes, pattern.circles):
        if circle is None:
            pairs += _polyline("HOLES", pattern.flat[pattern.corners(rim)])
        else:
            pairs += [(0, "CIRCLE"), (8, "HOLES"), *_place(circle[0]), (40, circle[1])]
    for bend, line in zip(pattern.bends, pattern.lines):
        layer = "BEND_UP" if bend.is_up else "BEND_DOWN"
        pairs += [(0, "LINE"), (8, layer), *_place(line[0]), *_place(line[1], 1)]
    pairs += [(0, "ENDSEC"), (0, "EOF")]
    return "".join(f"{code}\n{_number(value)}\n" for code, value in pairs)


def _polyline(layer: str, places: Floats) -> Iterator[tuple[int, Any]]:
    yield from ((0, "POLYLINE"), (8, layer), (66, 1), (70, 1), *_place(np.zeros(3)))
    for place in places:
        yield from ((0, "VERTEX"), (8, layer), *_place(place))
    yield from ((0, "SEQEND"), (8, layer))


def _place(place: Floats, number: int = 0) -> list[tuple[int, float]]:
    return [(10 * (axis + 1) + number, float(place[axis])) for axis in range(3)]


def _number(value: Any) -> str:
    return f"{value:.9g}" if isinstance(value, float) else str(value)


def svg_of(pattern: FlatPattern) -> str:
    """Return the blank in mm as SVG, coloured by residual stretch, with the bend table."""
    width, height = pattern.size
    rows = table_of(pattern)
    letter = width / (_LETTER * max(map(len, rows)))
    whole = height + 2 * _MARGIN + letter * 1.6 * (len(rows) + 1)
    box = f"{width + 2 * _MARGIN:.3f} {whole:.3f}"
    across, down = box.split()
    lines = [
        f'<svg xmlns="http://www.w3.org/2000/svg" width="{across}mm" height="{down}mm" '
        f'viewBox="0 0 {box}">',
        f'<g transform="translate({_MARGIN} {_MARGIN + height:.6f}) scale(1 -1)" fill="none" '
        f'stroke-width="{0.002 * max(width, height):.4f}">',
        '<g class="stretch">',
    ]
    strain = np.abs(pattern.stretches - 1.0).max(axis=1)
    for triangle, value in zip(pattern.triangles, strain):
        lines.append(f'<path d="{_path(pattern.flat[triangle])}" fill="{_colour(value)}"/>')
    lines += ["</g>", f'<path class="outline" stroke="#000" d="{_loops(pattern)}"/>']
    for bend, (start, end) in zip(pattern.bends, pattern.lines):
        dash = "" if bend.is_up else ' stroke-dasharray="4 2"'
        ends = f'x1="{start[0]:.4f}" y1="{start[1]:.4f}" x2="{end[0]:.4f}" y2="{end[1]:.4f}"'
        lines.append(f'<line class="bend" stroke="#06c"{dash} {ends}/>')
    lines.append("</g>")
    for number, row in enumerate(rows):
        y = height + 2 * _MARGIN + letter * 1.6 * (number + 0.5)
        text = row.replace("&", "&amp;").replace("<", "&lt;")
        lines.append(
            f'<text xml:space="preserve" x="{_MARGIN}" y="{y:.3f}" font-size="{letter:.2f}" '
            f'font-family="monospace">{text}</text>'
        )
    return "\n".join([*lines, "</svg>", ""])


def _path(places: Floats) -> str:
    return "M" + "L".join(f"{x:.4f} {y:.4f}" for x, y in places[:, :2]) + "Z"


def _loops(pattern: FlatPattern) -> str:
    loops = [pattern.outline, *pattern.holes]
    return " ".join(_path(pattern.flat[loop]) for loop in loops)


def _colour(strain: float) -> str:
    """Return a colour from white through yellow to red."""
    share = min(float(strain) / _FULL_COLOUR, 1.0)
    green = 255 - int(255 * max(0.0, 2.0 * share - 1.0))
    return f"#ff{green:02x}{255 - int(255 * min(1.0, 2.0 * share)):02x}"


def obj_of(pattern: FlatPattern) -> str:
    """Return the blank as an OBJ mesh with z = 0."""
    lines = [f"o {pattern.name.replace(chr(10), ' ')}"]
    lines += ["v {!r} {!r} {!r}".format(*row) for row in pattern.flat.tolist()]
    lines += ["f {} {} {}".format(*row) for row in (pattern.triangles + 1).tolist()]
    return "\n".join([*lines, ""])


def json_of(pattern: FlatPattern) -> str:
    """Return all figures of a blank as JSON."""
    return json.dumps(data_of(pattern), indent=2, ensure_ascii=False, allow_nan=False) + "\n"


def data_of(pattern: FlatPattern) -> dict[str, Any]:
    """Return all figures of a blank."""
    largest, most = pattern.residual()
    return {
        "name": pattern.name,
        "size": pattern.size,
        "thickness": pattern.thickness,
        "stretch": {"largest": largest, "percentile_99": most},
        "holes": [
            {
                "vertices": len(rim),
                "keeps_its_form": bool(rigid),
                "centre": None if circle is None else circle[0].tolist(),
                "radius": None if circle is None else circle[1],
            }
            for rim, rigid, circle in zip(pattern.holes, pattern.rigid, pattern.circles)
        ],
        "bends": [
            {
                "angle_degrees": math.degrees(bend.angle),
                "radius": bend.radius,
                "side": _side(bend),
                "inner_radius": bend.inner,
                "k_factor": bend.k_factor,
                "allowance": bend.allowance,
                "line": line.tolist(),
            }
            for bend, line in zip(pattern.bends, pattern.lines)
        ],
        "notes": pattern.notes,
    }


def _side(bend: Bend) -> str:
    return "up" if bend.is_up else "down"


def _told(value: float | None) -> str:
    return "-" if value is None else f"{value:.3f}"
