# SPDX-License-Identifier: LGPL-2.1-or-later
"""Mistakes in fitted surfaces, contacts, holes, bends and thin solids."""
from mutation import Mutation

FIT = "fitting/surface.cpp"
CONTACTS = "recognise/contacts/found_contacts.cpp"
PATCHES = "recognise/contacts/contact_patches.cpp"
HOLES = "recognise/features/holes.cpp"
BENDS = "recognise/features/bends.cpp"

MUTATIONS = [
    Mutation(
        FIT,
        "square = solved(3) + center.squaredNorm()",
        "square = solved(3)",
        "Surfaces.*:Features.*",
        layer="recognise",
    ),
    Mutation(
        FIT,
        "surface.angle = std::asin(sine)",
        "surface.angle = std::acos(sine)",
        "Surfaces.*:Features.*",
        layer="recognise",
    ),
    Mutation(
        FIT,
        "away * std::cos(angle) - along * std::sin(angle)",
        "away * std::sin(angle) - along * std::cos(angle)",
        "Surfaces.*:Features.*",
        layer="recognise",
    ),
    Mutation(
        "recognise/surfaces/surfaces.cpp",
        ": extent.x();",
        ": extent.y();",
        "Surfaces.*:Features.*",
    ),
    Mutation(
        CONTACTS,
        "reach = tolerances_.gap + 0.5 * (one",
        "reach = tolerances_.gap + 0.05 * (one",
        "Contacts.*",
    ),
    Mutation(
        CONTACTS,
        "contact.size = (high - low).norm()",
        "contact.size = 0.5 * (high - low).norm()",
        "Contacts.*",
    ),
    Mutation(CONTACTS, "if (away > longest &&", "if (away < longest &&", "Contacts.*"),
    Mutation(
        PATCHES, "if (vertices.size() < fewest)", "if (vertices.size() > fewest)", "Contacts.*"
    ),
    Mutation(
        PATCHES,
        "(i + (side == 0 ? 0 : touches_[0].size()))",
        "(i)",
        "Contacts.*",
    ),
    Mutation(
        HOLES,
        "0.5 * (feature.kind == FeatureKind::round_hole ? 2.0 * feature.radius",
        "0.5 * (feature.kind == FeatureKind::round_hole ? feature.radius",
        "Features.*",
    ),
    Mutation(
        HOLES, "loop.normal.dot(outside) < 0.0", "loop.normal.dot(outside) > 0.0", "Features.*"
    ),
    Mutation(
        HOLES, "first.depth = before == 1 ? depth", "first.depth = before == 1 ? 0.0", "Features.*"
    ),
    Mutation(BENDS, "strip.turn = high - low", "strip.turn = high", "Features.*"),
    Mutation(
        BENDS,
        "whole.depth = outer.radius - inner.radius",
        "whole.depth = outer.radius",
        "Features.*",
    ),
    Mutation(
        "recognise/facets/facet_graph.cpp",
        "volume[component_[t]] < 0.0",
        "volume[component_[t]] > 0.0",
        "FacetGraph.*:ThinSolid.*",
    ),
    Mutation(
        "recognise/thin/inward_probes.cpp",
        "dot(normal) < facing",
        "dot(normal) > facing",
        "ThinSolid.*",
    ),
    Mutation(
        "recognise/thin/thickness_gauge.cpp",
        "distance.after / distance.before - 1.0",
        "distance.before / distance.after - 1.0",
        "ThicknessGauge.*",
    ),
    Mutation(
        "recognise/sheet_diagnosis.cpp",
        "if (piece.area - areas[0.0] < least_share * piece.area",
        "if (piece.area - areas[0.0] > least_share * piece.area",
        "SheetDiagnosis.*",
    ),
    Mutation(
        "recognise/sheet_diagnosis.cpp",
        "whole += sample.second;",
        "whole = sample.second;",
        "SheetDiagnosis.*",
    ),
]
