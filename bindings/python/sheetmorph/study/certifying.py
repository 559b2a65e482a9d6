# SPDX-License-Identifier: LGPL-2.1-or-later
"""The certificate of a variant: from its files, read again, and the criteria of the study."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

from ..reporting.report import BESIDE

# Default for every study: triangles must not flip.
STANDARD: Mapping[str, Mapping[str, float]] = {"flipped": {"max": 0.0}}
# Report entries that the certificate does not contain.
_TOLD = ("pose", "tolerance", "warnings")

Numbers = Mapping[str, float | None]


def certificate(
    proof: dict[str, Any],
    report: dict[str, Any],
    criteria: list[dict[str, Any]],
    measures: Numbers,
) -> dict[str, Any]:
    """Return the content of a variant's `certificate.json`; it does not depend on the run.

    proof comes from a Certifier, report from Writer.write_parts(), and criteria from judged().
    """
    solved = [one for one in report["certificate"]["failures"] if one.code != BESIDE]
    failures = [*solved, *proof["failures"], *failures_of(criteria)]
    told = {key: report[key] for key in _TOLD}
    return {
        **proof,
        "passed": not failures,
        "failures": failures,
        "study": {**told, "criteria": criteria, "measures": dict(measures)},
    }


def judged(
    criteria: Mapping[str, Mapping[str, float]],
    measures: Numbers,
    figure: Callable[[str], float | None],
) -> list[dict[str, Any]]:
    """Return every criterion with its value and result; a value that cannot be measured fails."""
    found = []
    for name, limits in {**STANDARD, **criteria}.items():
        value = measures[name] if name in measures else figure(name)
        passed = value is not None and _within(value, limits)
        found.append({"name": name, **limits, "value": value, "passed": passed})
    return found


def failures_of(criteria: list[dict[str, Any]]) -> list[str]:
    """Return a sentence for every criterion that failed."""
    return [_sentence(entry) for entry in criteria if not entry["passed"]]


def _within(value: float, limits: Mapping[str, float]) -> bool:
    return limits.get("min", value) <= value <= limits.get("max", value)


def _sentence(entry: dict[str, Any]) -> str:
    name, value = entry["name"], entry["value"]
    if value is None:
        return f"{name} cannot be measured"
    if value < entry.get("min", value):
        return f"{name} is {value:.6g} (at least {entry['min']:.6g} required)"
    return f"{name} is {value:.6g} (at most {entry['max']:.6g} allowed)"
