# SPDX-License-Identifier: LGPL-2.1-or-later
"""A study as a function that other programs call: Dakota, JSON, optimisers in Python."""

from __future__ import annotations

import importlib.util
import json
from pathlib import Path

import numpy as np
import pytest

from sheetmorph.cli import main
from sheetmorph.study import Evaluator
from study_samples import write_recipe, write_study

PARAMETERS = {
    "lift": {"path": "pose.tip.translation[2]", "range": [0, 30]},
    "turn": {"path": "pose.tip.rotation.degrees", "range": [-40, 0]},
    "wide": {"path": "features.hole1.size", "range": [7, 9]},
    "sheet": {"range": [1, 2]},
}
MEASURE = {
    "tip": {"position": "tip", "axis": "z"},
    "hole": {"position": "hole2"},
    "mass": {"mass": ["plate"], "thickness": "sheet"},
}
AT = {"lift": 10.0, "turn": -20.0, "wide": 8.2, "sheet": 1.5}


@pytest.fixture
def study(tmp_path: Path) -> Path:
    return write_study(tmp_path, parameters=PARAMETERS, measure=MEASURE)


def test_slopes_of_positions_are_those_of_finite_differences(study: Path):
    evaluator = Evaluator(study)
    slopes = evaluator.position_gradients(AT)["plate"]
    assert slopes.shape == (len(evaluator.positions(AT)["plate"]), 3, 4)
    for k, (name, step) in enumerate(zip(evaluator.names, (1e-2, 1e-2, 1e-3, 1e-2))):
        beyond = evaluator.positions({**AT, name: AT[name] + step})["plate"]
        before = evaluator.positions({**AT, name: AT[name] - step})["plate"]
        difference = (beyond - before) / (2.0 * step)
        scale = max(1.0, np.abs(difference).max())
        assert np.abs(slopes[:, :, k] - difference).max() <= 1e-6 * scale
    assert np.abs(slopes[:, :, 3]).max() == 0.0


def test_slopes_of_a_handle_are_those_of_its_rigid_motion(study: Path):
    evaluator = Evaluator(study)
    recipe = json.loads((study.parent / "recipe.json").read_text())
    tip = recipe["handles"][0]["vertices"]
    positions = evaluator.positions(AT)["plate"][tip]
    slopes = evaluator.position_gradients(AT)["plate"][tip]
    centre = positions.mean(axis=0)
    turned = np.radians(1.0) * np.cross([0.0, 1.0, 0.0], positions - centre)
    assert np.allclose(slopes[:, :, 0], [0.0, 0.0, 1.0], atol=1e-9)
    assert np.allclose(slopes[:, :, 1], turned, atol=1e-9)


def test_slopes_of_measures_are_those_of_the_formula(study: Path):
    evaluator = Evaluator(study)
    slopes = evaluator.gradient(AT)
    assert evaluator.columns == ["tip", "hole.x", "hole.y", "hole.z", "mass"]
    assert slopes.shape == (5, 4)
    assert slopes[0] == pytest.approx([1, 0, 0, 0], abs=1e-9)
    assert slopes[4, 3] == pytest.approx(evaluator(AT)["mass"] / 1.5, rel=1e-9)


DAKOTA = """                     4 variables
 1.000000000000000e+01 lift
-2.000000000000000e+01 turn
 8.200000000000000e+00 wide
 1.500000000000000e+00 sheet
                     2 functions
                     3 ASV_1:tip
                     1 ASV_2:mass
                     2 derivative_variables
                     1 DVV_1:lift
                     4 DVV_2:sheet
                     0 analysis_components
                     1 eval_id
"""


def test_dakota_is_answered_in_its_own_form(study: Path, tmp_path: Path):
    (tmp_path / "params.in").write_text(DAKOTA)
    files = [str(tmp_path / name) for name in ("params.in", "results.out")]
    assert main(["study", str(study), "--evaluate", *files]) == 0
    tip, mass, slope = (tmp_path / "results.out").read_text().splitlines()
    measures = Evaluator(study)(AT)
    assert tip.split() == [f"{measures['tip']:.17g}", "tip"]
    assert float(mass.split()[0]) == measures["mass"] and mass.split()[1] == "mass"
    assert slope.split()[0] == "[" and slope.split()[-1] == "]"
    assert [float(x) for x in slope.split()[1:-1]] == pytest.approx([1, 0], abs=1e-9)


def test_apreprocessed_parameters_mean_the_same(study: Path, tmp_path: Path):
    lines = DAKOTA.replace("variables", "DAKOTA_VARS", 1).splitlines()[:8]
    lines = [line.split() for line in lines if line.split()[1] != "functions"]
    text = "\n".join(f"{{ {tag} = {value} }}" for value, tag in lines)
    answers = []
    for name, asked in (("std", DAKOTA.replace("3 ASV", "1 ASV")), ("apr", text)):
        (tmp_path / name).write_text(asked.replace("3 ASV_1", "1 ASV_1").replace("= 3", "= 1"))
        files = [str(tmp_path / name), str(tmp_path / f"{name}.out")]
        assert main(["study", str(study), "--evaluate", *files]) == 0
        answers.append((tmp_path / f"{name}.out").read_text())
    assert answers[0] == answers[1]


def test_json_is_answered_in_json(study: Path, tmp_path: Path):
    asked = {"parameters": AT, "measures": ["tip"], "gradients": True}
    (tmp_path / "in.json").write_text(json.dumps(asked))
    files = [str(tmp_path / name) for name in ("in.json", "out.json")]
    assert main(["study", str(study), "--evaluate", *files]) == 0
    answer = json.loads((tmp_path / "out.json").read_text())
    assert answer["status"] == "computed"
    assert answer["measures"]["tip"] == pytest.approx(10.0)
    assert answer["gradients"]["tip"]["lift"] == pytest.approx(1.0)


def test_what_cannot_be_computed_is_answered_as_a_failure(study: Path, tmp_path: Path):
    for name, text in (
        ("in.json", json.dumps({**AT, "wide": 19.9})),
        ("params.in", DAKOTA.replace("8.2000", "19.900")),
    ):
        (tmp_path / name).write_text(text)
        assert (
            main(["study", str(study), "--evaluate", str(tmp_path / name), str(tmp_path / "o")])
            == 0
        )
        answer = (tmp_path / "o").read_text()
        assert answer.startswith("FAIL") or json.loads(answer)["status"] == "refused"
        assert "hole1" in answer


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("", "how many variables"),
        ("nonsense\n", "is not a line of a parameters file"),
        (DAKOTA.replace("3 ASV_1:tip", "4 ASV_1:tip"), "second derivatives are requested"),
        (DAKOTA.replace("ASV_1:tip", "ASV_1:nose"), 'no measure "nose"'),
        (DAKOTA.replace("-2.000000000000000e+01", "high"), "is not a number"),
        ('{"lift": "high"}', "has no numbers"),
    ],
)
def test_requests_that_mean_nothing_are_told(study: Path, tmp_path: Path, capsys, text, said):
    (tmp_path / "params.in").write_text(text)
    words = [str(tmp_path / "params.in"), str(tmp_path / "results.out")]
    assert main(["study", str(study), "--evaluate", *words]) == 2
    assert said in capsys.readouterr().err
    assert not (tmp_path / "results.out").exists()


def test_an_optimiser_finds_the_lift_that_a_measure_asks_for(tmp_path: Path):
    optimize = pytest.importorskip("scipy.optimize")
    write_recipe(tmp_path)
    measure = {"z": {"position": "hole2", "axis": "z"}}
    parameters = {"lift": PARAMETERS["lift"]}
    evaluator = Evaluator(write_study(tmp_path, parameters=parameters, measure=measure))
    found = optimize.minimize(
        lambda x: (evaluator.array(x)[0] - 7.0) ** 2,
        [3.0],
        jac=lambda x: 2.0 * (evaluator.array(x)[0] - 7.0) * evaluator.gradient(x)[0],
        bounds=evaluator.bounds,
    )
    assert evaluator(found.x)["z"] == pytest.approx(7.0, abs=1e-5)


def test_the_example_finds_a_light_frame_that_keeps_both_gaps():
    pytest.importorskip("openturns", reason="python3-openturns is not installed")
    folder = Path(__file__).resolve().parents[2] / "resources" / "examples" / "least_mass"
    spec = importlib.util.spec_from_file_location("least_mass", folder / "least_mass.py")
    example = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(example)
    best, measures = example.least_mass()
    assert measures["front gap"] >= example.FRONT - 0.01
    assert measures["seat gap"] >= example.SEAT - 0.01
    evaluator = Evaluator(folder / "study.json")
    start = evaluator({"length": 0, "height": 16.5, "sheet": 1.92})
    assert measures["mass"] < 0.7 * start["mass"]
    # Shorter is lighter, and breaks a gap.
    shorter = evaluator({**best, "length": best["length"] - 0.5})
    assert shorter["mass"] < measures["mass"]
    assert shorter["seat gap"] < example.SEAT
