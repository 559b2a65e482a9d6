# SPDX-License-Identifier: LGPL-2.1-or-later
"""Mistakes in checks, plans, links, sessions, thin solids, seams and symmetry."""
from mutation import Mutation

TIED = "assembly/links/tied_link.cpp"
MIRROR = "assembly/symmetry/mirror.cpp"
FIDELITY = "assembly/session/fidelity.cpp"
CHECKS = "assembly/assembly_checks.cpp"
SYMMETRY = "assembly/symmetry/symmetry_plan.cpp"
ERROR = "assembly/session/feature_error.cpp"
THIN = "assembly/thin/thin_part.cpp"
REDUCTION = "assembly/thin/thin_reduction.cpp"
SOLVER = "assembly/thin/thin_solver.cpp"
REFUSALS = "AssemblyChecks.*"
SOLIDS = "*ThinSolids.*:ThinSolid.*"

MUTATIONS = [
    # What is refused.
    Mutation(
        CHECKS,
        "(side.part < 0 || static_cast<std::size_t>(side.part) >= assembly.parts.size())",
        "(side.part < 0 && static_cast<std::size_t>(side.part) >= assembly.parts.size())",
        REFUSALS,
    ),
    Mutation(
        CHECKS,
        "!(std::abs(motion.direction.norm() - 1.0) < 1e-9)",
        "!(motion.direction.norm() - 1.0 < 1e-9)",
        REFUSALS,
    ),
    Mutation(
        CHECKS, "if (!has_direction(motion.type))", "if (has_direction(motion.type))", REFUSALS
    ),
    Mutation(
        CHECKS,
        "!plane.point.allFinite() || !(std::abs",
        "!plane.point.allFinite() && !(std::abs",
        REFUSALS,
    ),
    # Plans.
    Mutation(
        "assembly/system/loose_pieces.cpp",
        "movers[at(corner)] == movers[at(first)])",
        "movers[at(corner)] != movers[at(first)])",
        "LoosePieces.*",
    ),
    Mutation(
        "assembly/system/sheet_constraints.cpp",
        "else if (weld.is_held)",
        "else if (!weld.is_held)",
        "WeldPlan.*",
    ),
    Mutation(
        "assembly/plan/pair_plan.cpp",
        "(across - across.dot(a.direction) * a.direction).norm()",
        "across.norm()",
        "Relations.*",
    ),
    Mutation(
        "assembly/plan/pair_plan.cpp",
        "found.centre = centre_of(assembly, found.leader);",
        "found.centre = centre_of(assembly, found.follower);",
        "Relations.*",
    ),
    # Sessions and the figures they report.
    Mutation(
        "assembly/session/reuse.cpp",
        "x.leader == y.leader && x.centre == y.centre && x.direction == y.direction",
        "x.leader == y.leader && x.centre == y.centre",
        "Reuse.*",
    ),
    Mutation(
        "assembly/session/drag_samples.cpp",
        "if (!response->is_learnt())",
        "if (response->is_learnt())",
        "LiveDrag.*",
    ),
    Mutation(ERROR, "(after - rotation * before)", "(after - before)", "FeatureError.*"),
    Mutation(ERROR, "worst = std::max(worst", "worst = std::min(worst", "FeatureError.*"),
    Mutation(
        ERROR,
        "(deformed.rowwise() - from) * rotation;",
        "(deformed.rowwise() - from) * rotation.transpose();",
        "FeatureError.*",
    ),
    # Thin solids.
    Mutation(
        THIN,
        "is_own || std::any_of(feet.begin()",
        "is_own && std::any_of(feet.begin()",
        "ThinPart.*",
    ),
    Mutation(THIN, "(0.5 * sign * way.norm() * push)", "(sign * way.norm() * push)", "ThinPart.*"),
    Mutation(
        THIN,
        "const double sign = push.dot(way) < 0.0",
        "const double sign = push.dot(way) > 0.0",
        "ThinPart.*",
    ),
    Mutation(
        REDUCTION,
        "owner_[at(vertex)] == nullptr || owner_[at(vertex)] == &region",
        "owner_[at(vertex)] == nullptr || owner_[at(vertex)] != &region",
        "ThinReduction.*",
    ),
    Mutation(
        REDUCTION,
        "if (side->part == part_ && contact.type == ContactType::rigid)",
        "if (side->part != part_ && contact.type == ContactType::rigid)",
        "ThinReduction.*",
    ),
    Mutation(SOLVER, "(mean * arm - arm) + bulge", "(mean * arm - arm) - bulge", SOLIDS),
    Mutation(SOLVER, "shift + (mean * arm - arm)", "shift + mean * arm", SOLIDS),
    # Links.
    Mutation(TIED, "(rotation * arm - arm)", "(arm - rotation * arm)", "TiedLink.*"),
    Mutation(
        "assembly/plan/link_blending.cpp",
        "1.0 - distance / reach",
        "distance / reach",
        "LinkBlending.*",
    ),
    Mutation(
        "assembly/links/control_box.cpp",
        "box.half_extents).maxCoeff()",
        "box.half_extents).minCoeff()",
        "ControlBox.*",
    ),
    Mutation(
        "assembly/links/control_box.cpp",
        "single_point_share * size",
        "single_point_share",
        "ControlBox.*",
    ),
    Mutation(
        FIDELITY,
        "(now - expected.row(static_cast<Eigen::Index>(k))).norm()",
        "(now - target_rest_.row(static_cast<Eigen::Index>(k))).norm()",
        "DeformationSession.*",
    ),
    # Symmetry and parts solved as a whole.
    Mutation(
        MIRROR, "return -vector(rotation_log);", "return vector(rotation_log);", "SymmetryPlan.*"
    ),
    Mutation(
        MIRROR,
        "position - 2.0 * across(position - plane_.point)",
        "position - 2.0 * across(position)",
        "SymmetryPlan.*",
    ),
    Mutation(
        SYMMETRY,
        "has_direction = feature.motion.type == surface::FeatureMotion::Type::plane",
        "has_direction = feature.motion.type != surface::FeatureMotion::Type::plane",
        "SymmetryPlan.*",
    ),
    Mutation(
        SYMMETRY,
        "|| is_sized(feature)\n",
        "&& is_sized(feature)\n",
        "SymmetryPlan.*",
    ),
    Mutation(
        "assembly/system/system.cpp",
        "vertices += mesh.vertex_count();",
        "vertices = mesh.vertex_count();",
        "Whole*",
    ),
    Mutation(
        "assembly/system/seam_ties.cpp",
        "return std::round((own - place",
        "return -std::round((own - place",
        "Whole*:CutPlates.*:HangingSheets.*",
    ),
]
