# SPDX-License-Identifier: LGPL-2.1-or-later
"""Mistakes in CAD files, their meshes and features, splines and shapes that are carried along."""
from mutation import Mutation

BASIS = "cad/splines/cubic_basis.cpp"
KEPT = "cad/carry/kept_motion.cpp"
FEATURES = "AnalyticFeatures.*"
WRITER = "CadWriter.HeldHoles*"

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
    # Features, healing, meshes and files.
    Mutation(
        "cad/analytic_features.cpp",
        "groups_.root(face_of(use.triangle)) == group",
        "groups_.root(face_of(use.triangle)) != group",
        FEATURES,
    ),
    Mutation("cad/analytic_features.cpp", "0.5 * (low + high)", "0.5 * (high - low)", FEATURES),
    Mutation(
        "cad/analytic_features.cpp",
        "found.is_hollow = facing < 0.0;",
        "found.is_hollow = facing > 0.0;",
        FEATURES,
    ),
    Mutation(
        "cad/reading/cad_reader.cpp",
        "motion.Value(r + 1, c + 1)",
        "motion.Value(c + 1, r + 1)",
        "CadReader.*",
    ),
    Mutation(
        "cad/healing/healing.cpp",
        "worst = std::max(worst, BRep_Tool::Tolerance(TopoDS::Vertex",
        "worst = std::min(worst, BRep_Tool::Tolerance(TopoDS::Vertex",
        "Healing.*",
    ),
    Mutation("cad/healing/healing.cpp", "farthest = 0.01;", "farthest = 1.0;", "Healing.*"),
    Mutation(
        "cad/meshing/part_mesher.cpp",
        "if (part.is_closed && signed_volume(part.mesh) < 0)",
        "if (part.is_closed && signed_volume(part.mesh) > 0)",
        "CadReader.*:AnalyticFeatures.*",
    ),
    Mutation(
        "cad/meshing/edge_discretisation.cpp",
        "(target - count[k]) / (count[k + 1] - count[k])",
        "(target - count[k + 1]) / (count[k + 1] - count[k])",
        "CadReader.*:MeshEstimate.*",
    ),
    Mutation(
        "cad/carry/face_motions.cpp",
        "(motion.point(before) - after).norm()",
        "(motion.point(before) + after).norm()",
        WRITER,
    ),
    Mutation(
        "cad/carry/shape_carrier.cpp",
        "0.5 * (a.slope + sign * b.slope)",
        "0.5 * (a.slope - sign * b.slope)",
        WRITER,
    ),
    Mutation(
        "cad/writing/body_measurer.cpp",
        "if (distance > found.distance.value)",
        "if (distance < found.distance.value)",
        WRITER,
    ),
    Mutation(
        "cad/writing/document_copy.cpp",
        "ranges_[product].second = k + 1;",
        "ranges_[product].second = k;",
        "CadWriter.Instances*:CadWriter.AnInstance*",
    ),
]
