# SPDX-License-Identifier: LGPL-2.1-or-later
"""Mistakes in energies, rotation fields, bodies, shells, flat sheets and live answers."""
from mutation import Mutation

NATURAL = "surface/operators/natural_rows.cpp"
OPERATORS = "surface/operators/surface_operators.cpp"
FOLLOWERS = "surface/operators/followers.cpp"
ALLOWED = "surface/bodies/allowed_motion.cpp"
MOTIONS = "surface/bodies/body_motions.cpp"
ELEMENT = "surface/steel/shell_element.cpp"
INVARIANTS = "Invariants.*:SurfaceDeformer.*"
RELATIONS = "AllowedMotion.*"
SHELLS = "ShellElement.*"
CONSTRAINT_CHECKS = "surface/constraints/constraint_checks.cpp"
REFUSALS = "ConstraintChecks.*"
FLAT = "surface/flat/flat_system.cpp"
FLATTENING = "Flattening.*:FlatSystem.*"
LIVE = "*ResponseCases.*:Response.*"
EXPANSIONS = "*TurnExpansions.*:FreeFeatures.*"

MUTATIONS = [
    Mutation(
        "surface/surface_deformer.cpp",
        "solve_pose(*data_, targets, exactness, progress)",
        "solve_pose(*data_, targets, Exactness::live, progress)",
        "SteelAnswer.RollsUpAsAnExactCircle:SteelAnswer.CanBeCancelled",
    ),
    Mutation(
        NATURAL,
        "gradients.area / mass * gradients",
        "gradients.area * gradients",
        "NaturalEnergy.*",
    ),
    Mutation(NATURAL, "share * 0.25 * 3.0 /", "share * 0.25 /", "NaturalEnergy.*"),
    Mutation(NATURAL, "from(side), c03 + c04);", "from(side), c01 + c02);", "NaturalEnergy.*"),
    Mutation(NATURAL, "(own - 1.0 / count)", "(own + 1.0 / count)", "NaturalEnergy.*"),
    Mutation(
        OPERATORS, "area > 0.0 ? 0.5 / area : 0.0", "area > 0.0 ? 0.5 * area : 0.0", INVARIANTS
    ),
    Mutation(
        FOLLOWERS,
        "(shift + rotation_from_log(log) * arm - arm).transpose()",
        "shift.transpose()",
        "Followers.*",
    ),
    Mutation(
        "surface/bodies/clamping.cpp", "(shift + (rotation * arm - arm))", "shift", INVARIANTS
    ),
    Mutation(ALLOWED, "centre + shift - along.dot(shift) * along", "centre + shift", RELATIONS),
    Mutation(
        ALLOWED, "to + rotation * (body.centre - from)", "to + (body.centre - from)", RELATIONS
    ),
    Mutation(
        ALLOWED, "leader.centre + arm.norm() * direction", "leader.centre + wanted_arm", RELATIONS
    ),
    Mutation(
        ALLOWED,
        "(start.centre - leader.centre) + slide * axis",
        "(start.centre - leader.centre)",
        RELATIONS,
    ),
    Mutation(
        MOTIONS,
        "moved.translation = motion.apply(centre) - centre;",
        "moved.translation = motion.translation;",
        INVARIANTS,
    ),
    Mutation(
        "surface/bodies/joints.cpp",
        "rotation_from_log(0.5 * amount)",
        "rotation_from_log(amount)",
        "Joints.*",
    ),
    Mutation(
        "surface/solve/sheet_growth.cpp",
        "sums(column) -= entry.value();",
        "sums(column) += entry.value();",
        "FeatureSizes.*",
    ),
    Mutation(
        "surface/rotation/blended_rotation_field.cpp",
        "return -factor_.solve(pull);",
        "return factor_.solve(pull);",
        "*RotationFields*",
    ),
    Mutation(
        "surface/rotation/smooth_weights.cpp",
        "return w * w * (3.0 - 2.0 * w);",
        "return w;",
        "*RotationFields*:FreeFeatures.*",
    ),
    Mutation(
        "surface/rotation/smooth_weights.cpp",
        "smoothed(1.0 - given(i)",
        "smoothed(given(i)",
        "*RotationFields*:FreeFeatures.*",
    ),
    # The shell element of steel.
    Mutation(ELEMENT, "2.0 * a * b);", "a * b);", SHELLS),
    Mutation(
        ELEMENT,
        "0.5 * (1.0 - poisson);\n    elasticity_ *=",
        "(1.0 - poisson);\n    elasticity_ *=",
        SHELLS,
    ),
    Mutation(
        ELEMENT,
        "a * strain.f.col(1) + b * strain.f.col(0)",
        "a * strain.f.col(1) - b * strain.f.col(0)",
        SHELLS,
    ),
    Mutation(ELEMENT, "rows(k, 9 + k) = 1.0;", "rows(k, 9 + k) = -1.0;", SHELLS),
    Mutation(
        ELEMENT,
        "gradient(i).dot(t) * end(j) * normal_by_inwards",
        "gradient(i).dot(t) * end(i) * normal_by_inwards",
        SHELLS,
    ),
    Mutation(ELEMENT, "pull << s(0), s(2), s(2), s(1);", "pull << s(0), 0.0, 0.0, s(1);", SHELLS),
    # What is refused.
    Mutation(
        CONSTRAINT_CHECKS,
        "point.triangle < 0 || point.triangle",
        "point.triangle < 0 && point.triangle",
        REFUSALS,
    ),
    Mutation(
        CONSTRAINT_CHECKS,
        "std::abs(weights.sum() - 1.0) > 1e-9",
        "weights.sum() - 1.0 > 1e-9",
        REFUSALS,
    ),
    Mutation(
        CONSTRAINT_CHECKS,
        "(rotations != 0 && rotations != count)",
        "(rotations != 0 && rotations == count)",
        REFUSALS,
    ),
    # Laid flat.
    Mutation(FLAT, "(a * f.col(1) + b * f.col(0))", "(a * f.col(1) - b * f.col(0))", FLATTENING),
    Mutation(
        FLAT, "stress << s(0), s(2), s(2), s(1);", "stress << s(1), s(2), s(2), s(0);", FLATTENING
    ),
    Mutation(FLAT, "mirrored.col(0) *= -1.0;", "mirrored.col(0) *= 1.0;", FLATTENING),
    Mutation(
        FLAT,
        "product(0, 1) - product(1, 0), product(0, 0)",
        "product(1, 0) - product(0, 1), product(0, 0)",
        FLATTENING,
    ),
    Mutation(
        "surface/flat/flattening.cpp",
        "emplace_back(row, u + 1, -b)",
        "emplace_back(row, u + 1, b)",
        FLATTENING,
    ),
    Mutation(
        "surface/flat/flattening.cpp",
        "sides += (input.factors(t) - 1.0) * along",
        "sides += input.factors(t) * along",
        FLATTENING,
    ),
    # Live answers, learnt beforehand.
    Mutation(
        "surface/live/span.cpp",
        "direction -= earlier * (earlier.transpose() * direction).eval();",
        "direction += earlier * (earlier.transpose() * direction).eval();",
        "Span.*",
    ),
    Mutation(
        "surface/live/span.cpp",
        "columns.noalias() -= direction * share;",
        "columns.noalias() -= 0.5 * direction * share;",
        "Span.*",
    ),
    Mutation(
        "surface/live/pose_numbers.cpp",
        "(turn - Matrix3::Identity()).transpose();",
        "(turn - Matrix3::Identity());",
        LIVE,
    ),
    Mutation(
        "surface/live/response.cpp",
        "spread.cwiseMax(",
        "spread_.row(k).cwiseMin(",
        LIVE,
    ),
    # The minimum over what features turn.
    Mutation(
        "surface/features/reduced_expansion.cpp",
        "change.rotation = cross_matrix(outer.axis) * first.rotation;",
        "change.rotation = first.rotation * cross_matrix(outer.axis);",
        EXPANSIONS,
    ),
    Mutation(
        "surface/features/reduced_expansion.cpp",
        "2.0 * (m.trace() * Matrix3::Identity() - m.transpose())",
        "2.0 * (m.trace() * Matrix3::Identity() - m)",
        EXPANSIONS,
    ),
    Mutation(
        "surface/features/feature_responses.cpp",
        "mesh_.points()(vertex, b) - centre(b)",
        "mesh_.points()(vertex, b) + centre(b)",
        "FreeFeatures.*",
    ),
    Mutation(
        "surface/solve/placement.cpp",
        "displacements.row(first).transpose() - (motion.apply(start) - start)",
        "displacements.row(first).transpose()",
        "SurfaceDeformer.*:FreeFeatures.*",
    ),
    Mutation(
        "surface/solve/reachable_size.cpp",
        "now.dot(rotation_from_log(log) * before) < 0.0",
        "now.dot(before) < 0.0",
        "FeatureSizes.*",
    ),
    Mutation(
        "surface/solve/reachable_size.cpp",
        "(is_reached(excess, tried) ? reached : refused)",
        "(is_reached(excess, tried) ? refused : reached)",
        "FeatureSizes.*",
    ),
]
