# SPDX-License-Identifier: LGPL-2.1-or-later
"""What `check` passes runs: examples, public files and recipes drawn at random."""

from __future__ import annotations

import json
import os
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

import sheetmorph
from plates import plate
from sheetmorph.cli import main, parser
from sheetmorph.recipe.reading import read_json

EXAMPLES = Path(__file__).resolve().parents[2] / "resources/examples"
# `SHEETMORPH_DRAWN=200` draws so many.
DRAWN = int(os.environ.get("SHEETMORPH_DRAWN", "12"))


def verdict(action: Any) -> str:
    """What kind of refusal it ends with, empty if it passes."""
    try:
        action()
    except (ValueError, RuntimeError) as error:
        return type(error).__name__
    return ""


def require_agreement(path: Path, out: Path) -> str:
    """Both refuse, or none does, with the same warnings; returns the kind of the refusal."""
    told: dict[str, list[str]] = {}

    def ran() -> None:
        told["run"] = sheetmorph.run(path, out)["warnings"]

    def checked() -> None:
        told["check"] = sheetmorph.check(path)

    kinds = [verdict(ran), verdict(checked)]
    assert kinds[0] == kinds[1]
    assert told.get("run") == told.get("check")
    return kinds[0]


def example_recipes() -> list[str]:
    """All of them, by their paths below the examples."""
    found = [*EXAMPLES.glob("*/recipe.json"), *EXAMPLES.glob("in_words/*.json")]
    return sorted(str(path.relative_to(EXAMPLES)) for path in found)


@pytest.mark.parametrize("name", example_recipes())
def test_examples_pass_both(name: str, tmp_path: Path):
    recipe = read_json(EXAMPLES / name)
    files = [(EXAMPLES / name).parent / part["file"] for part in recipe["parts"]]
    if not all(file.is_file() for file in files):
        pytest.skip("its parts are public data that is not at hand")
    assert require_agreement(EXAMPLES / name, tmp_path / "out") == ""
    assert sheetmorph.check(EXAMPLES / name, strict=True) == []


def test_check_knows_every_option_of_run():
    commands = parser()._subparsers._group_actions[0].choices
    options = {
        name: {option for action in commands[name]._actions for option in action.option_strings}
        for name in ("run", "check")
    }
    assert options["run"] == options["check"]


def test_check_does_what_every_option_of_run_asks_for(folder: Path):
    pose = folder / "pose.json"
    pose.write_text(json.dumps({"tip": {"translation": [0, 0, "x"]}}))
    recipe = str(folder / "recipe.json")
    assert main(["check", recipe, "--quiet"]) == 0
    for wrong in (
        ["--pose", str(pose)], ["--step"], ["--repair"], ["-o", str(folder)],
        ["--report", str(folder)], ["--report", str(folder / "none" / "report.json")],
        ["--certify", "--criteria", str(folder / "none.json")],
    ):  # fmt: skip
        assert main(["check", recipe, "--quiet", *wrong]) == 2, wrong
        out = wrong if "-o" in wrong else ["-o", str(folder / "out"), *wrong]
        assert main(["run", recipe, "--quiet", *out]) == 2, wrong
    assert main(["check", recipe, "--certify", "--pictures", "--wide", "--json"]) == 0
    names = sorted(path.name for path in folder.iterdir())
    assert names == ["plate.obj", "pose.json", "recipe.json"]


def written(folder: Path, parts: int) -> list[dict[str, Any]]:
    made = plate()
    entries = []
    for k in range(parts):
        lines = [f"v {x!r} {y!r} {1.0 * k!r}" for x, y, _ in made.points.tolist()]
        lines += [f"f {a} {b} {c}" for a, b, c in (made.triangles + 1).tolist()]
        (folder / f"part{k}.obj").write_text("\n".join(lines) + "\n")
        entries.append({"name": f"part{k}", "file": f"part{k}.obj"})
    return entries


def around(made: Any, place: tuple[float, float], radius: float) -> list[int]:
    away = np.linalg.norm(made.points[:, :2] - place, axis=1)
    return np.flatnonzero(away <= max(radius, away.min())).tolist()


_PLACES = st.tuples(st.floats(-10.0, 50.0), st.floats(-10.0, 10.0))


@st.composite
def recipes(draw: Any) -> dict[str, Any]:
    """A few plates one above the other with regions anywhere, contacts, sizes, motions."""
    made = plate()
    parts = draw(st.integers(1, 4))
    some_part = st.integers(0, parts - 1).map(lambda k: f"part{k}")

    def region(radius: float) -> dict[str, Any]:
        return {"part": draw(some_part), "vertices": around(made, draw(_PLACES), radius)}

    features = []
    for k in range(draw(st.integers(0, 4))):
        entry = {"name": f"f{k}", **region(draw(st.floats(0.5, 8.0)))}
        kind = draw(st.sampled_from(["free", "interpolated", "rim", "fixed"]))
        if kind == "rim":
            entry["vertices"] = made.rims[draw(st.integers(0, 2))]
            entry["size"] = draw(st.floats(4.0, 12.0))
        elif kind == "fixed":
            entry["motion"] = {"type": "fixed"}
        else:
            entry["rotation"] = kind
        features.append(entry)
    contacts = []
    for _ in range(draw(st.integers(0, 5)) if parts > 1 else 0):
        a, b = draw(st.lists(some_part, min_size=2, max_size=2, unique=True))
        vertices = around(made, draw(_PLACES), draw(st.floats(0.5, 8.0)))
        kind = draw(st.sampled_from(["rigid", "tied", "control mesh"]))
        sides = {side: {"part": part, "vertices": vertices} for side, part in zip("ab", (a, b))}
        contacts.append({"type": kind, **sides})
    return {
        "parts": parts,
        "primary": draw(some_part),
        "fixed": [region(draw(st.floats(1.0, 6.0))) for _ in range(draw(st.integers(0, 2)))],
        "handles": [{"name": "tip", **region(draw(st.floats(1.0, 6.0)))}],
        "features": features,
        "contacts": contacts,
        "energy": draw(st.sampled_from(["neumann", "natural", "paper", "steel"])),
        "refine": draw(st.booleans()),
        "propagation": {"type": draw(st.sampled_from(["local", "local", "whole"]))},
        "pose": {"tip": {"translation": list(draw(st.tuples(*[st.floats(-5.0, 5.0)] * 3)))}},
    }


@settings(
    max_examples=DRAWN, derandomize=True,
    suppress_health_check=[HealthCheck.too_slow, HealthCheck.function_scoped_fixture],
)  # fmt: skip
@given(recipe=recipes())
def test_recipes_drawn_at_random_are_refused_by_both_or_by_none(
    recipe: dict[str, Any], tmp_path: Path
):
    whole = {"sheetmorph": 1, **recipe, "parts": written(tmp_path, recipe["parts"])}
    path = tmp_path / "recipe.json"
    path.write_text(json.dumps(whole))
    # What contradicts itself is bad input; what a pose tears does not settle, and both say so.
    verdicts = ("", "RecipeError", "CertificateError")
    assert require_agreement(path, tmp_path / "out") in verdicts
