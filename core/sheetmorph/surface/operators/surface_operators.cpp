// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/surface/operators/surface_operators.h"

#include "sheetmorph/base/index.h"
#include "sheetmorph/base/threads/parallel.h"
#include "sheetmorph/base/threads/stopping.h"
#include "sheetmorph/base/vertex_sets.h"
#include "sheetmorph/mesh/geometry/delaunay_flips.h"
#include "sheetmorph/mesh/geometry/fans.h"
#include "sheetmorph/mesh/geometry/operators.h"
#include "sheetmorph/surface/bodies/clamping.h"
#include "sheetmorph/surface/operators/hinged_sheets.h"
#include "sheetmorph/surface/operators/natural_rows.h"
#include "sheetmorph/surface/operators/ties.h"

#include <algorithm>
#include <numeric>

namespace sheetmorph::surface
{

using mesh::TriangleMesh;
using numerics::SparseMatrix;

namespace
{

// If the two cotangents opposite an edge add up to less, `natural` switches to intrinsic triangles.
// From geometry: a corner of 168 degrees has the cotangent -4.7, a well-shaped one opposite adds
// 0.6.
constexpr double failing_cotangents = -4.0;

// Fewest rows for a thread. Chosen, not measured.
constexpr Eigen::Index least_turned = 1000;

//! The faces on which the operators are assembled.
struct MeasuredFaces
{
    mesh::LaidFaces faces;
    Convergence convergence;
};

MeasuredFaces faces_of(const TriangleMesh& mesh, const SurfaceConstraints& constraints)
{
    const bool is_natural = constraints.energy == Energy::natural;
    MeasuredFaces found{is_natural ? mesh::laid_faces(mesh) : mesh::covered_faces(mesh), {}};
    if (constraints.laplacian == Laplacian::intrinsic
        || mesh::worst_cotangent_sum(found.faces) < failing_cotangents)
        found.convergence = mesh::flip_to_delaunay(found.faces);
    return found;
}

// Cotangents and areas of the given triangles.
SurfaceOperators measured(const TriangleMesh& mesh)
{
    SurfaceOperators operators;
    operators.half_cotangents = mesh::half_cotangents(mesh);
    operators.vertex_areas = mesh::voronoi_areas(mesh);
    return operators;
}

SurfaceOperators measured(const mesh::LaidFaces& faces, int vertex_count)
{
    SurfaceOperators operators;
    operators.half_cotangents.resize(faces.count(), 3);
    operators.vertex_areas = Eigen::VectorXd::Zero(vertex_count);
    for (int f = 0; f < faces.count(); ++f)
    {
        const mesh::LaidFaces::Corners& corners = faces.corners[static_cast<std::size_t>(f)];
        const Vector3 shares = faces.share * mesh::mixed_voronoi_shares(corners);
        for (int k = 0; k < 3; ++k)
        {
            operators.half_cotangents(f, k) =
                0.5 * faces.share * mesh::corner_cotangent(corners, k);
            operators.vertex_areas(faces.triangles(f, k)) += shares(k);
        }
    }
    for (double& area : operators.vertex_areas)
        area = area > 0.0 ? area : 1.0;
    return operators;
}

// Moves the rows of tied vertices to the vertices to which they are attached. Tied vertices have no
// rows of their own, so that bending passes through a seam as through an inner edge.
struct OfVertices
{
    SparseMatrix harmonic, sums;
    Points rest;
    Eigen::VectorXd areas;

    void stand(const TriangleMesh& faces, const Points& half_cotangents,
               const std::vector<Tie>& ties)
    {
        if (ties.empty())
            return;
        const SparseMatrix basis = tie_basis(areas.size(), ties);
        const SparseMatrix across = basis.transpose();
        Points laid = faces.points();
        fill_tied(ties, laid);
        harmonic = across * SparseMatrix(harmonic * basis);
        sums = across * SparseMatrix(sums * basis);
        rest = across * mesh::apply_stiffness(faces, half_cotangents, laid);
        areas = across * areas;
    }
};

// L of (2.1) and its rest rows. `faces` contains the triangles on which the operators were
// assembled.
void add_laplacian(SurfaceOperators& operators, const TriangleMesh& faces, Energy energy,
                   const VertexRoles& roles)
{
    const Points& cotangents = operators.half_cotangents;
    OfVertices found{mesh::non_negative_stiffness(faces, cotangents),
                     mesh::cotangent_stiffness(faces, cotangents),
                     mesh::apply_stiffness(faces, cotangents, faces.points()),
                     operators.vertex_areas};
    found.stand(faces, cotangents, roles.ties);
    auto& [harmonic, sums, rest, areas] = found;
    operators.harmonic = std::make_shared<const SparseMatrix>(std::move(harmonic));
    const Eigen::VectorXd per_area =
        areas.unaryExpr([](double area) { return area > 0.0 ? 0.5 / area : 0.0; });
    operators.rows = numerics::rows_scaled(std::move(sums), per_area);
    operators.rest_rows = per_area.asDiagonal() * rest;
    operators.row_vertices.resize(static_cast<std::size_t>(faces.vertex_count()));
    std::iota(operators.row_vertices.begin(), operators.row_vertices.end(), 0);
    operators.weights = energy == Energy::paper
                            ? Eigen::VectorXd(Eigen::VectorXd::Ones(faces.vertex_count()))
                            : areas;
}

// Whether the points on a component suffice to support it: three or more, not collinear.
bool is_held_by_points(const TriangleMesh& mesh, const SurfaceConstraints& constraints,
                       const mesh::Components& components, int component)
{
    Points held(0, 3);
    for (const PointConstraint& point : constraints.points)
    {
        const Eigen::RowVector3i corners = mesh.triangles().row(point.triangle);
        if (components.label[static_cast<std::size_t>(corners(0))] != component)
            continue;
        held.conservativeResize(held.rows() + 1, 3);
        held.bottomRows(1).setZero();
        for (int k = 0; k < 3; ++k)
            held.bottomRows(1) += point.barycentric(k) * mesh.points().row(corners(k));
    }
    return held.rows() > 2 && !are_in_line(held);
}

// Vertices at seams where both sheets end; without glued vertices, which have no face.
VertexIds seam_vertices(const VertexRoles& roles, const mesh::LaidFaces& faces,
                        const std::vector<char>& is_interior)
{
    std::vector<char> has_face(is_interior.size(), 0);
    for (int f = 0; f < faces.count(); ++f)
        for (int k = 0; k < 3; ++k)
            has_face[at(faces.triangles(f, k))] = 1;
    VertexIds found;
    for (const auto& [vertex, place] : roles.ties)
    {
        if (is_interior[at(vertex)] || !has_face[at(vertex)])
            continue;
        for (std::size_t k = 0; k < 3; ++k)
            if (place.weights(static_cast<Eigen::Index>(k)) > 0.0
                && !is_interior[at(place.corners[k])]
                && roles.role[at(place.corners[k])] != Role::tied)
                found.push_back(place.corners[k]);
    }
    return found;
}

// Vertices at which `natural` also needs the rows of L: at free edges, to keep a component or a
// sheet from tilting, and on seams of sheets that end there, which would otherwise be hinges.
VertexIds straightened_vertices(const TriangleMesh& mesh, const SurfaceConstraints& constraints,
                                const VertexRoles& roles, const mesh::LaidFaces& faces)
{
    const std::vector<char> clamps = holding_vertices(constraints, roles);
    const std::vector<char> is_interior = mesh::fans_of(faces, mesh.vertex_count()).is_interior;
    VertexIds vertices = hinged_vertices({mesh, roles, clamps, is_interior});
    for (const int component : roles.held_by_points)
        if (!is_held_by_points(mesh, constraints, roles.components, component))
        {
            const VertexIds all = roles.components.vertices(component);
            vertices.insert(vertices.end(), all.begin(), all.end());
        }
    const auto has_none = [&](int vertex)
    { return is_interior[at(vertex)] != 0 || roles.role[at(vertex)] == Role::tied; };
    vertices.erase(std::remove_if(vertices.begin(), vertices.end(), has_none), vertices.end());
    const VertexIds seams = seam_vertices(roles, faces, is_interior);
    vertices.insert(vertices.end(), seams.begin(), seams.end());
    make_set(vertices);
    return vertices;
}

// Replaces tied vertices in the rows by the vertices to which they are attached. Removes the rows
// that contain only tied vertices.
void stand(BendingRows& bending, const VertexRoles& roles)
{
    if (roles.ties.empty())
        return;
    std::vector<char> is_needed(at(bending.rows.rows()), 0);
    for (int column = 0; column < bending.rows.outerSize(); ++column)
        for (SparseMatrix::InnerIterator entry(bending.rows, column); entry; ++entry)
            if (roles.role[at(column)] != Role::tied)
                is_needed[at(entry.row())] = 1;
    const SparseMatrix rows = bending.rows * tie_basis(bending.rows.cols(), roles.ties);
    std::vector<int> row_of(is_needed.size(), -1);
    int count = 0;
    for (std::size_t row = 0; row < is_needed.size(); ++row)
        if (is_needed[row])
        {
            bending.weights(count) = bending.weights(static_cast<Eigen::Index>(row));
            bending.row_vertices[at(count)] = bending.row_vertices[row];
            row_of[row] = count++;
        }
    std::vector<Eigen::Triplet<double>> entries;
    for (int column = 0; column < rows.outerSize(); ++column)
        for (SparseMatrix::InnerIterator entry(rows, column); entry; ++entry)
            if (const int row = row_of[at(entry.row())]; row >= 0)
                entries.emplace_back(row, column, entry.value());
    bending.rows.resize(count, rows.cols());
    bending.rows.setFromTriplets(entries.begin(), entries.end());
    bending.weights.conservativeResize(count);
    bending.row_vertices.resize(at(count));
}

// D p_hat, each row relative to its own vertex to keep precision far from the origin.
Points rest_rows(const BendingRows& bending, const Points& points)
{
    Points rest = Points::Zero(bending.rows.rows(), 3);
    for (int column = 0; column < bending.rows.outerSize(); ++column)
        for (SparseMatrix::InnerIterator entry(bending.rows, column); entry; ++entry)
        {
            const int vertex = bending.row_vertices[static_cast<std::size_t>(entry.row())];
            rest.row(entry.row()) += entry.value() * (points.row(column) - points.row(vertex));
        }
    return rest;
}

// Appends some rows of L to those of `natural`.
void append_rows(BendingRows& bending, const SurfaceOperators& laplacian, const VertexIds& vertices)
{
    std::vector<Eigen::Triplet<double>> entries;
    for (int column = 0; column < bending.rows.outerSize(); ++column)
        for (SparseMatrix::InnerIterator entry(bending.rows, column); entry; ++entry)
            entries.emplace_back(static_cast<int>(entry.row()), column, entry.value());
    std::vector<int> row_of(laplacian.row_vertices.size(), -1);
    for (const int vertex : vertices)
    {
        row_of[static_cast<std::size_t>(vertex)] = static_cast<int>(bending.row_vertices.size());
        bending.row_vertices.push_back(vertex);
    }
    for (int column = 0; column < laplacian.rows.outerSize(); ++column)
        for (SparseMatrix::InnerIterator entry(laplacian.rows, column); entry; ++entry)
            if (row_of[static_cast<std::size_t>(entry.row())] >= 0)
                entries.emplace_back(row_of[static_cast<std::size_t>(entry.row())], column,
                                     entry.value());
    const auto count = static_cast<Eigen::Index>(bending.row_vertices.size());
    bending.rows.resize(count, laplacian.rows.cols());
    bending.rows.setFromTriplets(entries.begin(), entries.end());
    const Eigen::Index before = bending.weights.size();
    bending.weights.conservativeResize(count);
    for (Eigen::Index row = before; row < count; ++row)
        bending.weights(row) =
            laplacian.weights(bending.row_vertices[static_cast<std::size_t>(row)]);
}

void add_stiffness(SurfaceOperators& operators, const Points& points)
{
    look_for_stop();
    operators.stiffness = std::make_shared<const SparseMatrix>(
        numerics::own_product(operators.rows, operators.weights));
    const auto tree_of = [&](const SparseMatrix& matrix)
    {
        return std::make_shared<const numerics::SeparatorTree>(
            numerics::nested_dissection(matrix, points));
    };
    operators.tree = tree_of(*operators.stiffness);
    operators.harmonic_tree = tree_of(*operators.harmonic);
}

SurfaceOperators bending_operators(const TriangleMesh& mesh, const SurfaceConstraints& constraints,
                                   const VertexRoles& roles)
{
    if (constraints.energy != Energy::natural && constraints.laplacian == Laplacian::cotangent)
    {
        SurfaceOperators operators = measured(mesh);
        add_laplacian(operators, mesh, constraints.energy, roles);
        return operators;
    }
    const auto [faces, convergence] = faces_of(mesh, constraints);
    SurfaceOperators operators = measured(faces, mesh.vertex_count());
    operators.convergence = convergence;
    add_laplacian(operators, TriangleMesh(mesh.points(), faces.triangles), constraints.energy,
                  roles);
    if (constraints.energy != Energy::natural)
        return operators;
    const std::vector<Tie> as_one = glued_ties(mesh, roles.ties);
    const TriangleMesh one = as_one.empty() ? mesh : glued(mesh, as_one);
    const mesh::LaidFaces laid = as_one.empty() ? faces : faces_of(one, constraints).faces;
    BendingRows bending = natural_rows(laid, holding_vertices(constraints, roles));
    stand(bending, roles);
    look_for_stop();
    const VertexIds straightened = straightened_vertices(one, constraints, roles, laid);
    if (!straightened.empty())
        append_rows(bending, operators, straightened);
    look_for_stop();
    operators.rest_rows = rest_rows(bending, mesh.points());
    operators.rows = std::move(bending.rows);
    operators.weights = std::move(bending.weights);
    operators.row_vertices = std::move(bending.row_vertices);
    return operators;
}

}  // namespace

Points turned_rows(const SurfaceOperators& operators, const std::vector<Matrix3>& change)
{
    Points rows(operators.rest_rows.rows(), 3);
    parallel_ranges(rows.rows(), least_turned,
                    [&](Eigen::Index begin, Eigen::Index end)
                    {
                        for (Eigen::Index row = begin; row < end; ++row)
                            rows.row(row) = (change[at(operators.row_vertices[at(row)])]
                                             * operators.rest_rows.row(row).transpose())
                                                .transpose();
                    });
    return rows;
}

SurfaceOperators surface_operators(const TriangleMesh& mesh, const SurfaceConstraints& constraints,
                                   const VertexRoles& roles)
{
    SurfaceOperators operators = bending_operators(mesh, constraints, roles);
    add_stiffness(operators, mesh.points());
    return operators;
}

}  // namespace sheetmorph::surface
