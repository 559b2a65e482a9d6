# SPDX-License-Identifier: LGPL-2.1-or-later
"""Mistakes in bending energies, rotation fields, bodies and shells."""
from mutation import Mutation

NATURAL = "surface/operators/natural_rows.cpp"
OPERATORS = "surface/operators/surface_operators.cpp"
FOLLOWERS = "surface/operators/followers.cpp"
ALLOWED = "surface/bodies/allowed_motion.cpp"
MOTIONS = "surface/bodies/body_motions.cpp"
BODY_RATES = "surface/rates/body_rates.cpp"
ELEMENT = "surface/steel/shell_element.cpp"
INVARIANTS = "Invariants.*:SurfaceDeformer.*"
RELATIONS = "AllowedMotion.*"
RATES = "WaveRates.*"
SHELLS = "ShellElement.*"

MUTATIONS = [
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
        FOLLOWERS,
        "(place.on(velocities) + spin.cross(rotation_from_log(log) * arm))",
        "(place.on(velocities) + spin.cross(arm))",
        RATES,
        "assembly",
    ),
    Mutation(
        "surface/operators/clamping.cpp", "(shift + (rotation * arm - arm))", "shift", INVARIANTS
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
        BODY_RATES,
        "spin_of_polar(mean, sum, rate)",
        "spin_of_polar(mean, rate, sum)",
        RATES,
        "assembly",
    ),
    Mutation(
        "surface/bodies/joints.cpp",
        "rotation_from_log(0.5 * amount)",
        "rotation_from_log(amount)",
        "Joints.*",
    ),
    Mutation(
        "surface/bodies/sheet_growth.cpp",
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
]
