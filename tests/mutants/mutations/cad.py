# SPDX-License-Identifier: LGPL-2.1-or-later
"""Mistakes in splines and in what carries CAD shapes along."""
from mutation import Mutation

BASIS = "cad/splines/cubic_basis.cpp"
KEPT = "cad/carry/kept_motion.cpp"

MUTATIONS = [
    Mutation(BASIS, "degree * (degree - 1)", "degree * degree", "CubicBasis*"),
    Mutation(BASIS, "saved + right[r + 1] * part", "saved + left[r + 1] * part", "CubicBasis*"),
    Mutation(
        "cad/splines/arc_length.cpp",
        "0.5688888888888889, 0.4786286704993665",
        "0.5688888888888889, 0.4768286704993665",
        "ArcLength.*",
    ),
    Mutation(
        KEPT,
        "gp_Quaternion(turn.x(), turn.y(), turn.z(), turn.w())",
        "gp_Quaternion(turn.w(), turn.x(), turn.y(), turn.z())",
        "KeptMotion*",
    ),
    Mutation(
        KEPT,
        "on_axis + scale * (point - on_axis)",
        "on_axis + (point - on_axis) / scale",
        "KeptMotion*",
    ),
    Mutation("cad/splines/face_spline.cpp", "[k + 3 - i]", "[i + 3 - k]", "FaceSpline.*"),
    Mutation(
        "cad/splines/parameter_curve.cpp",
        "vv * u.Dot(way) - mixed * v.Dot(way)",
        "vv * u.Dot(way) + mixed * v.Dot(way)",
        "CurveBeneath.*",
    ),
    Mutation(
        "cad/splines/grid_cholesky.cpp",
        "if (tie.row() != tie.col())",
        "if (tie.row() == tie.col())",
        "GridCholesky.*",
    ),
]
