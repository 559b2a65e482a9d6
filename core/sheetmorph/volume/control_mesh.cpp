// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/volume/control_mesh.h"

#include "sheetmorph/base/errors.h"

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <array>
#include <map>
#include <mutex>
#include <utility>
#include <vector>

namespace sheetmorph::volume
{

namespace
{

constexpr int corner_count = 8;  // from geometry: a cube

// Corner k of a quad is followed by corner k + 1; seen from outside, counterclockwise. After the
// first subdivision a quad is (old vertex, edge point, face point, edge point).
using Quad = std::array<int, 4>;

struct Quads
{
    int vertex_count = 0;
    std::vector<Quad> faces;
};

// Corner k of the cube is at x, y, z = -1 or +1 by the bits 1, 2 and 4 of k.
Quads cube()
{
    return {corner_count,
            {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}}};
}

// The connectivity of one Catmull-Clark step. Positions are not needed: the smoothing has uniform
// weights and prescribed corners, so its solution is unique.
Quads subdivide(const Quads& coarse)
{
    std::map<std::pair<int, int>, int> edge_points;
    Quads fine;
    fine.vertex_count = coarse.vertex_count;
    const auto edge_point = [&](int a, int b)
    {
        const auto found = edge_points.try_emplace(std::minmax(a, b), fine.vertex_count);
        fine.vertex_count += found.second ? 1 : 0;
        return found.first->second;
    };
    for (const Quad& face : coarse.faces)
    {
        Quad middle;
        for (int k = 0; k < 4; ++k)
            middle[k] = edge_point(face[k], face[(k + 1) % 4]);
        const int centre = fine.vertex_count++;
        for (int k = 0; k < 4; ++k)
            fine.faces.push_back({face[k], middle[k], centre, middle[(k + 3) % 4]});
    }
    return fine;
}

// The diagonal from the old vertex to the face point preserves every mirror symmetry of the cube.
Triangles split(const Quads& quads)
{
    Triangles triangles(2 * quads.faces.size(), 3);
    int row = 0;
    for (const Quad& face : quads.faces)
    {
        triangles.row(row++) << face[0], face[1], face[2];
        triangles.row(row++) << face[0], face[2], face[3];
    }
    return triangles;
}

Eigen::SparseMatrix<double> uniform_laplacian(const Quads& quads)
{
    std::vector<int> valence(quads.vertex_count, 0);
    for (const Quad& face : quads.faces)
        for (int vertex : face)
            ++valence[vertex];
    std::vector<Eigen::Triplet<double>> entries;
    for (int i = 0; i < quads.vertex_count; ++i)
        entries.emplace_back(i, i, 1.0);
    // Each edge occurs once in each direction, so each neighbour occurs once.
    for (const Quad& face : quads.faces)
        for (int k = 0; k < 4; ++k)
            entries.emplace_back(face[k], face[(k + 1) % 4], -1.0 / valence[face[k]]);
    Eigen::SparseMatrix<double> laplacian(quads.vertex_count, quads.vertex_count);
    laplacian.setFromTriplets(entries.begin(), entries.end());
    return laplacian;
}

// (3.1) with hard constraints at the corners: min sum |L q|^2. As printed, with soft terms for the
// corners, a box of half-size 1 collapses to a point.
Points smooth(const Eigen::SparseMatrix<double>& laplacian)
{
    const int count = static_cast<int>(laplacian.rows()), unknown = count - corner_count;
    Points vertices(count, 3);
    for (int k = 0; k < corner_count; ++k)
        vertices.row(k) << (k & 1 ? 1.0 : -1.0), (k & 2 ? 1.0 : -1.0), (k & 4 ? 1.0 : -1.0);
    const Eigen::SparseMatrix<double> square = laplacian.transpose() * laplacian;
    const Eigen::SparseMatrix<double> matrix = square.bottomRightCorner(unknown, unknown);
    const Eigen::SparseMatrix<double> coupling = square.bottomLeftCorner(unknown, corner_count);
    const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factor(matrix);
    if (factor.info() != Eigen::Success)
        throw SolverError("the control mesh could not be smoothed");
    vertices.bottomRows(unknown) = factor.solve(-(coupling * vertices.topRows(corner_count)));
    return vertices;
}

}  // namespace

ControlShape::ControlShape(int levels)
{
    if (levels < 1 || levels > 5)
        throw InvalidInput("a control mesh has 1 to 5 levels of subdivision, not "
                           + std::to_string(levels));
    Quads quads = cube();
    for (int level = 0; level < levels; ++level)
        quads = subdivide(quads);
    const Eigen::SparseMatrix<double> laplacian = uniform_laplacian(quads);
    arrays_ = std::make_shared<const Arrays>(Arrays{smooth(laplacian), split(quads), laplacian});
}

const ControlShape& ControlShape::shared(int levels)
{
    static std::mutex making;
    static std::map<int, ControlShape> made;
    const std::lock_guard<std::mutex> lock(making);
    return made.try_emplace(levels, levels).first->second;
}

ControlMesh::ControlMesh(const ControlShape& given_shape, const OrientedBox& given_box)
    : shape(given_shape), box(given_box)
{
    const Matrix3 to_world = box.axes * box.half_extents.asDiagonal();
    vertices = (shape.vertices() * to_world.transpose()).rowwise() + box.centre.transpose();
}

}  // namespace sheetmorph::volume
