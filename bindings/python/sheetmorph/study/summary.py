# SPDX-License-Identifier: LGPL-2.1-or-later
"""All variants of a study in one table: `summary.csv`, `summary.json`, `summary.html`."""

from __future__ import annotations

import csv
import io
import json
from collections import Counter
from collections.abc import Iterable
from pathlib import Path
from typing import Any

from ..files.atomic import FileSet
from .page import page_of
from .plan import Plan
from .rows import STATUSES, Row

CSV, JSON, PAGE = "summary.csv", "summary.json", "summary.html"

Rows = dict[int, Row]


def write_summary(plan: Plan, rows: Rows, out: Path) -> dict[str, Any]:
    """Write the table of the given rows, by run; return the content of summary.json."""
    summary = summary_of(plan, rows)
    texts = {
        CSV: _csv(plan, rows),
        JSON: json.dumps(summary, indent=1, ensure_ascii=False, allow_nan=False) + "\n",
        PAGE: page_of(summary, out),
    }
    with FileSet(is_own=True) as files:
        for name, text in texts.items():
            files.temporary_for(out / name).write_text(text, "utf-8", newline="")
        files.commit()
    return summary


def summary_of(plan: Plan, rows: Rows) -> dict[str, Any]:
    """Return the content of summary.json."""
    study = plan.study
    return {
        "sheetmorph_study_summary": 1,
        "study": study.path.name,
        "recipe": study.recipe.name,
        "parameters": {
            entry.name: list(entry.values) or [entry.low, entry.high] for entry in study.parameters
        },
        "measures": plan.columns,
        "counts": counts_of(rows.values()),
        "runs": [
            {
                "run": run,
                "parameters": row.parameters,
                "measures": {name: row.measures.get(name) for name in plan.columns},
                "status": row.status,
                "why": row.why,
                **({"no_picture": row.no_picture} if row.no_picture else {}),
            }
            for run, row in sorted(rows.items())
        ],
    }


def counts_of(rows: Iterable[Row]) -> dict[str, int]:
    """Return the number of rows by status."""
    counts = Counter(row.status for row in rows)
    return {status: counts[status] for status in STATUSES}


def _csv(plan: Plan, rows: Rows) -> str:
    text = io.StringIO()
    table = csv.writer(text, lineterminator="\n")
    names = plan.study.names
    table.writerow(["run", *names, *plan.columns, "status", "why"])
    for run, row in sorted(rows.items()):
        measured = [row.measures.get(name) for name in plan.columns]
        numbers = [*(row.parameters[name] for name in names), *measured]
        cells = ["" if number is None else repr(number) for number in numbers]
        table.writerow([run, *cells, row.status, row.why])
    return text.getvalue()
