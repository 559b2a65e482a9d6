# SPDX-License-Identifier: LGPL-2.1-or-later
"""Mistakes in operators, queries, topology and fitted outlines of meshes."""
from mutation import Mutation

OPERATORS = "mesh/geometry/operators.cpp"
FLIPS = "mesh/geometry/delaunay_flips.cpp"
QUERIES = "mesh/search/triangle_queries.cpp"
ORIENTATION = "mesh/topology/orientation.cpp"
PROFILE = "fitting/rim_profile.cpp"
SHAPE = "forms/feature_shape.cpp"
NEAREST = "TriangleQueries.*:Picking.*"
SHAPES = "FeatureShape.*"
FITS = "Circle.*:RimProfile.*:CylinderFit.*"

MUTATIONS = [
    Mutation(OPERATORS, "0.125 * cotangent", "0.25 * cotangent", "Operators.*"),
    Mutation(OPERATORS, "shares(k) = 0.5 * area", "shares(k) = 0.25 * area", "Operators.*"),
    Mutation(
        OPERATORS,
        "0.5 * corners.corner_dot(k) / sine",
        "corners.corner_dot(k) / sine",
        "Operators.*",
    ),
    Mutation(OPERATORS, "result.row(b) -= flow", "result.row(b) += flow", "Operators.*"),
    Mutation(OPERATORS, "-std::max(edge.value(), smallest_weight)", "-edge.value()", "Operators.*"),
    Mutation(
        "mesh/geometry/normals.cpp",
        "+= area.transpose();",
        "+= area.normalized().transpose();",
        "Normals.*",
    ),
    Mutation(
        FLIPS,
        "near.area() * near.inward - far.area() * far.inward",
        "near.area() * near.inward + far.area() * far.inward",
        "DelaunayFlips.*",
    ),
    Mutation(
        FLIPS,
        "{3 * f + 2, 3 * g + 1, 3 * g + 2, 3 * f + 1}",
        "{3 * f + 1, 3 * g + 1, 3 * g + 2, 3 * f + 2}",
        "DelaunayFlips.*",
    ),
    Mutation(FLIPS, ">= -rounding)", "<= -rounding)", "DelaunayFlips.*"),
    Mutation(
        "mesh/geometry/laid_faces.cpp",
        "looking(sides[(i + 1) % sides.size()], false)",
        "looking(sides[i], false)",
        "LaidFaces.*",
    ),
    Mutation(QUERIES, "of_c = a_b * b_c - b_b * a_c", "of_c = a_b * b_c + b_b * a_c", NEAREST),
    Mutation(QUERIES, "along = a_c / (a_c - c_c)", "along = c_c / (a_c - c_c)", NEAREST),
    Mutation(QUERIES, "z[k] = shear_(2) * offset(z_)", "z[k] = offset(z_)", NEAREST),
    Mutation(
        "mesh/regions/growing.cpp",
        "return ids_of(outside, 0);",
        "return ids_of(outside);",
        "Growing.*",
    ),
    Mutation(
        ORIENTATION,
        "(one.from == two.from ? -1 : 1)",
        "(one.from == two.to ? -1 : 1)",
        "Orientation.*",
    ),
    Mutation(
        ORIENTATION,
        "corner(1).cross(corner(2))) / 6.0",
        "corner(1).cross(corner(2))) / 3.0",
        "Orientation.*",
    ),
    Mutation("mesh/quality/quality.cpp", "std::sqrt(0.75) * longest", "longest", "Quality.*"),
    Mutation(
        "mesh/quality/quality.cpp",
        "is_first ? stretch : std::min(",
        "is_first ? stretch : std::max(",
        "Quality.*",
    ),
    Mutation(
        "mesh/quality/quality.cpp",
        "folded_over = 150.0 * degree",
        "folded_over = 100.0 * degree",
        "Quality.*",
    ),
    Mutation(
        "mesh/search/near_vertices.cpp", "is_open_[a] || is_open_[b] || ", "", "NearVertices.*"
    ),
    Mutation(
        "mesh/search/near_vertices.cpp",
        "place.array() - tolerance, place.array() + tolerance",
        "place.array(), place.array() + tolerance",
        "NearVertices.*",
    ),
    # Outlines of holes and slots.
    Mutation(
        "fitting/surface.cpp",
        "slope(3) = -along * out.dot(u);",
        "slope(3) = along * out.dot(u);",
        FITS,
    ),
    Mutation(PROFILE, "radius = outline.radius;", "radius = 1.01 * outline.radius;", FITS),
    Mutation("fitting/stadium.cpp", "rows(i, 4) = -end * out", "rows(i, 4) = end * out", FITS),
    Mutation(
        PROFILE,
        "frame.leftCols<2>() * shape.across()",
        "frame.leftCols<2>() * shape.along()",
        FITS,
    ),
    Mutation(SHAPE, "Kind::hole ? 0.5 : 1.0", "Kind::hole ? 1.0 : 0.5", SHAPES),
    Mutation(SHAPE, "-core.profile.distance(point) *", "core.profile.distance(point) *", SHAPES),
    Mutation(
        SHAPE,
        "return rest + (wanted - size) * growth + rounding;",
        "return rest + (wanted - size) * growth;",
        SHAPES,
    ),
    Mutation(SHAPE, "profile.centre += 0.5 * way;", "profile.centre += way;", SHAPES),
    # Meshes themselves.
    Mutation(
        "mesh/triangle_mesh.cpp",
        "triangles.row(t).minCoeff() < 0 || triangles",
        "triangles.row(t).minCoeff() < 0 && triangles",
        "TriangleMesh.*",
    ),
    Mutation(
        "mesh/triangle_mesh.cpp",
        "(points_.colwise().maxCoeff() - points_.colwise().minCoeff())",
        "points_.colwise().maxCoeff()",
        "TriangleMesh.*",
    ),
    Mutation(
        "mesh/triangle_mesh.cpp", "1e-12 * size + 8.0", "1e-12 * size - 8.0", "TriangleMesh.*"
    ),
]
