# SPDX-License-Identifier: LGPL-2.1-or-later
"""The lightest frame that keeps two gaps, found by OpenTURNS (Debian's python3-openturns).

From a source tree: PYTHONPATH=build/Mod/SheetMorph /usr/bin/python3 least_mass.py
"""

from __future__ import annotations

from pathlib import Path

import openturns

from sheetmorph.study import Evaluator

STUDY = Path(__file__).resolve().parent / "study.json"
FRONT, SEAT = 185.0, 118.0  # mm, as the study's criteria say
EVALUATIONS = 120


def least_mass(study: Path = STUDY) -> tuple[dict[str, float], dict[str, float]]:
    """The best values of the parameters, and the measures there."""
    evaluator = Evaluator(study)
    low, high = evaluator.bounds.T

    def told(shares: list[float]) -> dict[str, float]:
        """The values at shares of the ranges from 0 to 1, which the solver likes better."""
        return dict(zip(evaluator.names, low + (high - low) * list(shares)))

    def mass(shares: list[float]) -> list[float]:
        return [evaluator(told(shares))["mass"]]

    def kept(shares: list[float]) -> list[float]:
        """What must not be negative: the gaps beyond what is asked for, and the constraint."""
        values = told(shares)
        found = evaluator(values)
        sheet = values["sheet"] - 1.2 - 0.01 * values["height"]
        return [found["front gap"] - FRONT, found["seat gap"] - SEAT, 10.0 * sheet]

    count = len(evaluator.names)
    problem = openturns.OptimizationProblem(openturns.PythonFunction(count, 1, mass))
    problem.setBounds(openturns.Interval(count))
    problem.setInequalityConstraint(openturns.PythonFunction(count, 3, kept))
    solver = openturns.Cobyla(problem)
    solver.setStartingPoint([0.5, 0.3, 0.9])
    # The number of evaluations is what ends it.
    if hasattr(solver, "setMaximumCallsNumber"):  # as OpenTURNS 1.24 calls it
        solver.setMaximumCallsNumber(EVALUATIONS)
        solver.setCheckStatus(False)
    else:
        solver.setMaximumEvaluationNumber(EVALUATIONS)
        solver.setIgnoreFailure(True)
    solver.setRhoBeg(0.2)
    solver.run()
    best = told(solver.getResult().getOptimalPoint())
    return best, evaluator(best)


if __name__ == "__main__":
    found, measures = least_mass()
    for name, value in {**found, **measures}.items():
        print(f"{name:>10} {value:10.4f}")
