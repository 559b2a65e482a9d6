# SPDX-License-Identifier: LGPL-2.1-or-later
"""Mistakes in what is seen, hidden and selected on a screen."""
from mutation import Mutation

SCREEN = "pick/screen.cpp"
CELLS = "pick/vertex_cells.cpp"
NEAR = "pick/neighbourhood.cpp"

MUTATIONS = [
    Mutation(SCREEN, "(unit.y() + 1.0) * half_.y()", "(1.0 - unit.y()) * half_.y()", "Screen.*"),
    Mutation(
        SCREEN,
        "const double to = (high(c) + margin) / half_(c) - 1.0;",
        "const double to = (high(c) + margin) / half_(c);",
        "Screen.*",
    ),
    Mutation(SCREEN, "a.x() + (y - a.y())", "a.x() + (y - b.y())", "ScreenOutline.*"),
    Mutation(SCREEN, "turns += a.y() <= y ? 1 : -1;", "turns += 1;", "ScreenOutline.*"),
    Mutation(
        CELLS,
        "(a.x() - place.x()) * (b.y() - place.y()) - (a.y()",
        "(a.x() - place.x()) * (b.y() - place.y()) + (a.y()",
        "Sight.*",
    ),
    Mutation(CELLS, "< place.z() - touching", "< place.z()", "Sight.*"),
    Mutation(CELLS, "weights[k] * corners[k].z()", "weights[k] * corners[0].z()", "Sight.*"),
    Mutation(NEAR, "use) < max_angle)", "use) > max_angle)", "Neighbourhood.*"),
    Mutation(NEAR, "for (; rings > 0 &&", "for (; rings > 1 &&", "Neighbourhood.*"),
]
