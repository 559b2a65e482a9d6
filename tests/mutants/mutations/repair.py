# SPDX-License-Identifier: LGPL-2.1-or-later
"""Mistakes in cures of meshes, self-intersections and remeshing."""
from mutation import Mutation

WALLS = "repair/inner_walls.cpp"
CURES = "repair/cures.cpp"
CROSSINGS = "repair/self_intersections.cpp"
STEPS = "repair/remeshing/working_steps.cpp"
SIZES = "repair/remeshing/sizes.cpp"
RIMS = "repair/remeshing/round_rims.cpp"
TWINS = "repair/remeshing/twin_flats.cpp"
CUTS = "repair/remeshing/ridge_cuts.cpp"

MUTATIONS = [
    Mutation(WALLS, "area += 0.5 * a.cross(b);", "area -= a.cross(b);", "Cures.*"),
    Mutation(WALLS, "(one.area + other.area).norm()", "(one.area - other.area).norm()", "Cures.*"),
    Mutation(CURES, "fan(facet, side - 1, inside)", "fan(facet, side % 3, inside)", "Cures.*"),
    Mutation(
        CURES,
        "pieces.push_back({{before, cut, apex}",
        "pieces.push_back({{cut, before, apex}",
        "Cures.*",
    ),
    Mutation(
        CROSSINGS,
        "CGAL::coplanar_orientation(p[0], p[1], p[2], q[2]) == CGAL::POSITIVE",
        "CGAL::coplanar_orientation(p[0], p[1], p[2], q[2]) == CGAL::NEGATIVE",
        "SelfIntersections.*",
    ),
    Mutation(
        CROSSINGS,
        "do_intersect(Kernel::Segment_3(p[1], p[2]), triangle(q))",
        "do_intersect(Kernel::Segment_3(p[0], p[1]), triangle(q))",
        "SelfIntersections.*",
    ),
    Mutation(
        CROSSINGS,
        "above > room && below < -room",
        "above > room || below < -room",
        "SelfIntersections.*",
    ),
    Mutation(CROSSINGS, "above - below > room", "above + below > room", "SelfIntersections.*"),
    Mutation(
        STEPS,
        "(cotangent_at(c, a, b) + cotangent_at(d, a, b) < -1e-7)",
        "(cotangent_at(c, a, b) + cotangent_at(d, a, b) > 1e-7)",
        "Remeshing.*",
    ),
    Mutation(STEPS, "too_long = 4.0 / 3.0", "too_long = 8.0 / 3.0", "Remeshing.*"),
    Mutation(
        STEPS,
        "work.point[v] + step - normal * normal.dot(step)",
        "work.point[v] + step",
        "Remeshing.*",
    ),
    Mutation(SIZES, "per_radius = 0.35", "per_radius = 3.5", "Remeshing.*"),
    Mutation(
        SIZES, "uses, bend), 0.125 * edge_length", "uses, bend), 2.0 * edge_length", "Remeshing.*"
    ),
    Mutation(
        RIMS,
        "circle.centre + circle.radius * arm",
        "circle.centre + 0.98 * circle.radius * arm",
        "Remeshing.*",
    ),
    Mutation(TWINS, "nearest->twins.twin; }));", "nearest->twins.flat; }));", "Remeshing.*"),
    Mutation(TWINS, "way.dot(normal) >= 0.0)", "way.dot(normal) <= 0.0)", "Remeshing.*"),
    Mutation(
        CUTS,
        "(1.0 - place.share) * mesh_.points().row(place.from)",
        "place.share * mesh_.points().row(place.from)",
        "Remeshing.*",
    ),
]
