# SPDX-License-Identifier: LGPL-2.1-or-later
"""Mistakes in links between parts, welds, seams and symmetry."""
from mutation import Mutation

TIED = "assembly/links/tied_link.cpp"
MIRROR = "assembly/symmetry/mirror.cpp"
FIDELITY = "assembly/links/fidelity.cpp"

MUTATIONS = [
    Mutation(TIED, "(rotation * arm - arm)", "(arm - rotation * arm)", "TiedLink.*"),
    Mutation(
        TIED, "(moved + spin.cross(rotation * arm))", "(moved + spin.cross(arm))", "WaveRates.*"
    ),
    Mutation(
        "assembly/links/link_blending.cpp",
        "1.0 - distance / reach",
        "distance / reach",
        "LinkBlending.*",
    ),
    Mutation(
        "assembly/links/control_box.cpp",
        "box.half_extents).maxCoeff()",
        "box.half_extents).minCoeff()",
        "DeformationSession.*:AssemblyInvariants.*",
    ),
    Mutation(
        FIDELITY,
        "(now - expected.row(static_cast<Eigen::Index>(k))).norm()",
        "(now - target_rest_.row(static_cast<Eigen::Index>(k))).norm()",
        "DeformationSession.*:AssemblyInvariants.*",
    ),
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
        "assembly/whole/seam_ties.cpp",
        "return std::round((own - place",
        "return -std::round((own - place",
        "Whole*:CutPlates.*:HangingSheets.*",
    ),
]
