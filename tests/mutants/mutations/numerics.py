# SPDX-License-Identifier: LGPL-2.1-or-later
"""Mistakes in factorisations, substitutions, constrained minima and stored products."""
from mutation import Mutation

DENSE = "numerics/cholesky/dense_cholesky.cpp"
BUILDER = "numerics/cholesky/front_builder.cpp"
KERNEL = "numerics/cholesky/front_kernel.cpp"
SPARSE = "numerics/cholesky/sparse_cholesky.cpp"
MINIMISER = "numerics/constrained_minimiser.cpp"
FACTORS = "DenseCholesky.*:FrontalCholesky.*:SparseCholesky.*"
MINIMA = "ConstrainedMinimiser.*"

MUTATIONS = [
    Mutation(
        DENSE,
        "lower_.block(j, 0, wide, j), -1.0",
        "lower_.block(j, 0, wide, j), 1.0",
        "DenseCholesky*",
        "volume",
    ),
    Mutation(DENSE, "panel.block(j, 0, wide, j), -1.0", "panel.block(j, 0, wide, j), 1.0", FACTORS),
    Mutation(
        DENSE,
        "add_product(own, rows.topRows(first), -1.0",
        "add_product(own, rows.topRows(first), 1.0",
        FACTORS,
    ),
    Mutation(
        KERNEL, "sums[r].take_off(row[r][c], x);", "sums[r].take_off(-row[r][c], x);", FACTORS
    ),
    Mutation(
        KERNEL,
        "x[r].take_off(row[d][first + r], x[d]);",
        "x[r].take_off(row[r][first + d], x[d]);",
        FACTORS,
    ),
    Mutation(
        KERNEL, "sum.take_off(row[r][c], known[r]);", "sum.take_off(row[r][c], known[0]);", FACTORS
    ),
    Mutation(BUILDER, "+= product(i, j);", "-= product(i, j);", FACTORS),
    Mutation(BUILDER, "j < std::min(own, i + 1)", "j < std::min(own, i)", FACTORS),
    Mutation(BUILDER, "rank_of(other) >= rank)", "rank_of(other) > rank)", FACTORS),
    Mutation(
        "numerics/cholesky/front_solver.cpp",
        "+= part[g].row(",
        "-= part[g].row(",
        "*LargeFactors*",
    ),
    Mutation(
        "numerics/cholesky/front_pattern.cpp",
        "if (parent >= 0 && !is_unchanged(parent))",
        "if (parent >= 0 && is_unchanged(parent))",
        FACTORS,
    ),
    Mutation(
        "numerics/cholesky/half_solve.cpp",
        "-= reached.product(i, j);",
        "+= reached.product(i, j);",
        FACTORS,
    ),
    Mutation(
        "numerics/cholesky/half_solve.cpp", "+= entry.value();", "= entry.value() / 2.0;", FACTORS
    ),
    Mutation(SPARSE, "front.use_count() > 1", "front.use_count() > 2", FACTORS),
    Mutation(
        "numerics/ordering/vertex_cover.cpp",
        "found.left[at(searched)] = 0;",
        "found.left[at(searched)] = 1;",
        "VertexCover.*",
    ),
    Mutation(
        SPARSE, "rows_scaled(rows, weights.cwiseSqrt())", "rows_scaled(rows, weights)", MINIMA
    ),
    Mutation(SPARSE, "right_sides(row, first + column)", "right_sides(row, column)", FACTORS),
    Mutation(
        "numerics/ordering/nested_dissection.cpp",
        "? 0 : set.parent + before",
        "? 0 : set.parent",
        "NestedDissection.*",
    ),
    Mutation(
        "numerics/ordering/nested_dissection.cpp",
        "tree.lowest.push_back(node)",
        "tree.lowest.push_back(0)",
        FACTORS,
    ),
    Mutation(
        "numerics/ordering/elimination.cpp",
        ": earlier.matrix_.unknown_of[at(row)] < 0",
        ": true",
        FACTORS,
    ),
    Mutation(
        MINIMISER, "gradient -= reduced_constraints_", "gradient += reduced_constraints_", MINIMA
    ),
    Mutation(MINIMISER, "right_side += support_ * (reduced", "right_side += (reduced", MINIMA),
    Mutation(
        MINIMISER, "{start - responses_ * multipliers", "{start + responses_ * multipliers", MINIMA
    ),
    Mutation(MINIMISER, "found += excess.transpose()", "found -= excess.transpose()", MINIMA),
    Mutation(
        MINIMISER, "found += support_ * weighted_squares", "found += weighted_squares", MINIMA
    ),
    Mutation(
        "numerics/products/row_products.cpp",
        "entry.value() * weights_(entry.row()) * of_rows_",
        "entry.value() * of_rows_",
        "RowProducts*",
    ),
    Mutation(
        "numerics/products/panel_rows.cpp",
        "remainder = static_cast<float>(rest)",
        "remainder = 0.0F",
        "PanelRows*",
    ),
    Mutation(
        "numerics/products/panel_rows.cpp",
        "return rest - remainder * unit;",
        "return 0.0;",
        "CompactPanelRows*",
    ),
    Mutation(
        "numerics/products/row_space.cpp",
        "if (length <= least)",
        "if (length <= 1e4 * least)",
        "RowSpace*",
    ),
    Mutation("numerics/products/row_space.cpp", "before && !are_few", "before", "RowSpace*"),
    Mutation(
        "numerics/products/panel_rows.cpp",
        "hn::And(bits, hn::Set(integers, exponent_bits))",
        "bits",
        "*PanelRows*",
    ),
    Mutation(
        "numerics/response/response_basis.cpp",
        "order[at(k)])]));",
        "order[0])]));",
        "*ResponseBasis*",
    ),
    Mutation(
        "numerics/products/dense_products.cpp",
        "sum += row[rest] *",
        "sum = row[rest] *",
        "DenseProducts*",
        "volume",
    ),
    Mutation(
        "numerics/products/dense_products.cpp",
        "right.middleRows(j, wide)",
        "right.topRows(wide)",
        "DenseCholesky.*",
    ),
]
