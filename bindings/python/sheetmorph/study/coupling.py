# SPDX-License-Identifier: LGPL-2.1-or-later
"""One evaluation for another program, with Dakota's params.in and results.out, or JSON."""

from __future__ import annotations

import json
import math
import re
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from ..base.errors import FileError, RecipeError
from ..files.atomic import FileSet
from ..files.reading import read_text
from .evaluating import Evaluator

_VALUE, _GRADIENT, _HESSIAN = 1, 2, 4
_STANDARD = re.compile(r"^\s*(\S+)\s+(.+?)\s*$")
_APREPRO = re.compile(r"^\s*\{\s*(\S+?)\s*=\s*(.+?)\s*\}\s*$")


@dataclass(frozen=True)
class Request:
    """A request of another program.

    values has the parameters. wanted maps a measure to its bits: 1 value, 2 gradient. along lists
    the parameters of the gradient in order. is_json states whether request and answer are JSON.
    """

    values: dict[str, float]
    wanted: dict[str, int] = field(default_factory=dict)
    along: list[str] = field(default_factory=list)
    is_json: bool = False


def evaluate_files(
    study: str | Path, asked: str | Path, answer: str | Path, *, files: FileSet | None = None
) -> list[str]:
    """Answer a request of another program and return the lines to print.

    A failed computation is answered with a failure that Dakota captures. files is a new FileSet.
    Raises RecipeError, FileError, KernelError.
    """
    evaluator = Evaluator(study)
    files = files or FileSet("study")
    files.reads += [Path(study), Path(asked), *evaluator.files_read]
    files.require_ours(Path(answer))
    request = read_request(Path(asked), evaluator.columns)
    try:
        text = _answered(evaluator, request)
        told = f"{answer}: {len(request.wanted)} measure(s)"
    except RecipeError as error:
        why = "; ".join(map(str, error.faults))
        text = _json({"status": "refused", "why": why}) if request.is_json else f"FAIL\n{why}\n"
        told = f"{answer}: not computed: {why}"
    with files:
        files.temporary_for(Path(answer)).write_text(text, "utf-8")
        files.commit()
    return [told]


def read_request(path: Path, columns: list[str]) -> Request:
    """Read a request; columns are the available measures. Raises FileError."""
    try:
        text = read_text(path)
    except (OSError, UnicodeDecodeError) as error:
        raise FileError(path, f"cannot be read ({error})", "check the path") from None
    request = _from_json(path, text) if text.lstrip().startswith(("{\n", '{"', "{}")) else None
    request = request or _from_dakota(path, text)
    unknown = [name for name in request.wanted if name not in columns]
    if unknown and len(request.wanted) == len(columns) and not request.is_json:
        # Dakota names unlabelled responses response_fn_1 and so on, so their order counts.
        bits = list(request.wanted.values())
        return Request(request.values, dict(zip(columns, bits)), request.along)
    if unknown:
        what = f'there is no measure "{unknown[0]}"'
        raise FileError(path, what, f"measures are {', '.join(columns) or 'none'}")
    return request if request.wanted else _all_wanted(request, columns)


def _all_wanted(request: Request, columns: list[str]) -> Request:
    wanted = dict.fromkeys(columns, _VALUE)
    return Request(request.values, wanted, request.along, request.is_json)


def _from_json(path: Path, text: str) -> Request | None:
    try:
        data = json.loads(text)
    except ValueError:
        return None
    values = data.get("parameters", data) if isinstance(data, dict) else None
    is_sound = isinstance(values, dict) and all(
        isinstance(value, (int, float)) for value in values.values()
    )
    if not is_sound:
        raise FileError(
            path, "has no numbers under the names of the parameters", 'give {"lift": 1.5}'
        )
    is_whole = "parameters" in data
    measures = data.get("measures", []) if is_whole else []
    bits = _VALUE | (_GRADIENT if is_whole and data.get("gradients") else 0)
    return Request(
        {name: float(value) for name, value in values.items()},
        {str(name): bits for name in measures},
        list(values),
        True,
    )


def _from_dakota(path: Path, text: str) -> Request:
    rows = _rows(path, text)
    count = _count(path, rows, "variables", "DAKOTA_VARS")
    start = next(k for k, (_, tag) in enumerate(rows) if tag in ("variables", "DAKOTA_VARS"))
    values = {}
    for value, tag in rows[start + 1 : start + 1 + count]:
        values[tag] = _number(path, value, tag)
    names = list(values)
    asked = [(value, tag) for value, tag in rows if re.match(r"ASV_\d+(:|$)", tag)]
    wanted = {
        tag.partition(":")[2] or f"response_fn_{k + 1}": int(value)
        for k, (value, tag) in enumerate(asked)
    }
    order = [int(value) for value, tag in rows if re.match(r"DVV_\d+(:|$)", tag)]
    if any(place < 1 or place > len(names) for place in order):
        raise FileError(path, "a derivative names no variable", "let Dakota write the file again")
    if any(bits & _HESSIAN for bits in wanted.values()):
        todo = "let Dakota compute Hessians (numerical_hessians or quasi_hessians)"
        raise FileError(path, "second derivatives are requested", todo)
    return Request(values, wanted, [names[place - 1] for place in order])


def _rows(path: Path, text: str) -> list[tuple[str, str]]:
    """Return (value, tag) of every line, in the standard form or in that of APREPRO."""
    rows = []
    for number, line in enumerate(text.splitlines(), 1):
        found = _APREPRO.match(line)
        if found:
            rows.append((found[2].strip('"'), found[1]))
            continue
        found = _STANDARD.match(line)
        if found:
            rows.append((found[1], found[2]))
        elif line.strip():
            todo = "give the file that Dakota writes"
            raise FileError(path, "is not a line of a parameters file", todo, number)
    return rows


def _count(path: Path, rows: list[tuple[str, str]], *tags: str) -> int:
    found = [value for value, tag in rows if tag in tags]
    if not found or not found[0].isdecimal():
        raise FileError(path, "does not say how many variables there are", "give Dakota's file")
    return int(found[0])


def _number(path: Path, text: str, name: str) -> float:
    try:
        value = float(text)
    except ValueError:
        value = math.nan
    if not math.isfinite(value):
        raise FileError(path, f'"{text}" of {name} is not a number', "use continuous variables")
    return value


def _answered(evaluator: Evaluator, request: Request) -> str:
    measures: dict[str, Any] = evaluator(request.values)
    slopes = None
    if any(bits & _GRADIENT for bits in request.wanted.values()):
        slopes = evaluator.gradient(request.values)
    along = request.along or evaluator.names
    places = [evaluator.names.index(name) for name in along]
    gradients = {
        name: [float(slopes[evaluator.columns.index(name), k]) for k in places]
        for name, bits in request.wanted.items()
        if slopes is not None and bits & _GRADIENT
    }
    if request.is_json:
        told = {name: dict(zip(along, slope)) for name, slope in gradients.items()}
        picked = {name: measures[name] for name in request.wanted}
        return _json({"status": "computed", "measures": picked, "gradients": told})
    lines = [
        f"{_written(measures[name])} {name}"
        for name, bits in request.wanted.items()
        if bits & _VALUE
    ]
    lines += [f"[ {' '.join(map(_written, slope))} ]" for slope in gradients.values()]
    return "\n".join(lines) + "\n"


def _written(value: float | None) -> str:
    return f"{math.nan if value is None else value:.17g}"


def _json(data: dict[str, Any]) -> str:
    return json.dumps(data, indent=1, ensure_ascii=False, allow_nan=False) + "\n"
