# SPDX-License-Identifier: LGPL-2.1-or-later
"""A short summary of a run's report for a terminal."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Any

from ..base.words import counted
from ..reporting.report import rigidity

# Rows of parts and of contacts; the report has the others.
_MOST = 12


def ending_of(report: dict[str, Any], output: str, *, is_quiet: bool) -> list[str]:
    """Return the lines that `run` prints: tables unless quiet, warnings, and feature rigidity."""
    lines = [] if is_quiet else [*_parts(report), *_contacts(report)]
    lines += [f"warning: {text}" for text in report["warnings"]]
    parts = counted(len(report["parts"]), "part", "parts")
    lines.append("; ".join([f"{output}: {parts} written", *_rigid(report)]))
    return [*lines, *_shapes(report)]


def _parts(report: dict[str, Any]) -> list[str]:
    """Return a table of the parts with the largest displacements."""
    parts = sorted(report["parts"], key=lambda part: -float(part["largest_displacement"]))
    features = [feature["part"] for feature in report["features"]]
    rows = [("part", "vertices", "moved, mm", "features", "strain", "thickness")]
    for part in parts[:_MOST]:
        strain, thin = part["quality"]["worst_strain"], part["thin"]
        rows.append(
            (
                part["name"],
                str(part["vertices"]),
                f"{part['largest_displacement']:.3g}",
                str(features.count(part["name"])),
                "" if strain is None else f"{100.0 * strain:.2g} %",
                "" if thin is None else f"+-{100.0 * thin['largest_change']:.2g} %",
            )
        )
    return [*_aligned(rows), *_more(len(parts), "parts")]


def _shapes(report: dict[str, Any]) -> Iterator[str]:
    """Describe each written CAD file in one line."""
    shapes = [part["shape"] for part in report["parts"] if part["shape"] is not None]
    for name in dict.fromkeys(shape["file"] for shape in shapes):
        own = [shape for shape in shapes if shape["file"] == name]
        bodies = {body["name"]: body for shape in own for body in shape["bodies"]}.values()
        kept, fitted = (sum(body[key] for body in bodies) for key in ("kept", "fitted"))
        off = max((body["distance"]["value"] for body in bodies), default=0.0)
        yield (
            f"{name}: {counted(kept, 'face', 'faces')} kept, {fitted} fitted, "
            f"at most {off:.2g} mm from the mesh, "
            f"{own[0]['bytes'] / max(own[0]['bytes_before'], 1):.2g} times the size of the "
            "original file"
        )


def _contacts(report: dict[str, Any]) -> list[str]:
    """List the contacts with the largest gap changes."""
    contacts = sorted(report["contacts"], key=lambda contact: -float(contact["gap_change"]))
    is_whole = report["propagation"] == "whole"
    ways = "{source} and {target} are solved together", "{source} drives {target}"
    lines = [
        f"{contact['name']}: {ways[not is_whole].format(**contact)}, gap change "
        f"{contact['gap_change']:.2g} mm"
        for contact in contacts[:_MOST]
    ]
    return [*lines, *_more(len(contacts), "contacts")]


def _more(number: int, what: str) -> list[str]:
    return [f"and {number - _MOST} more {what}, see the report"] if number > _MOST else []


def _aligned(rows: Sequence[Sequence[str]]) -> list[str]:
    """Return the rows with columns of equal width, numbers aligned to the right."""
    widths = [max(map(len, column)) for column in zip(*rows)]
    return [
        "  ".join(
            cell.rjust(width) if k else cell.ljust(width)
            for k, (cell, width) in enumerate(zip(row, widths))
        ).rstrip()
        for row in rows
    ]


def _rigid(report: dict[str, Any]) -> list[str]:
    """Describe the rigidity of the form features, if there are any, and the proposals left out."""
    features, left_out = report["features"], report.get("found", {}).get("left_out", [])
    worst = max(map(rigidity, features), default=0.0)
    texts = []
    if features:
        number = counted(len(features), "form feature", "form features")
        texts.append(f"{number} rigid to {worst:.2g} mm")
    if left_out:
        number = counted(len(left_out), "proposal", "proposals")
        more = " (all in the report)" if len(left_out) > 1 else ""
        texts.append(f"{number} changed or left out: {left_out[0]}{more}")
    return texts
