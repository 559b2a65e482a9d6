// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/surface/operators/ties.h"

#include "sheetmorph/base/index.h"
#include "sheetmorph/mesh/topology/boundary.h"

#include <numeric>
#include <unordered_map>

namespace sheetmorph::surface
{

namespace
{

// Relative to the mesh's size, and to a weight of 1: distance of points that coincide up to
// rounding. Chosen: far above the rounding of a place in a triangle (1e-15) and far below the gaps
// of files with seven digits (1e-7).
constexpr double rounding = 1e-9;

template <typename Rows>
void fill(const std::vector<Tie>& ties, Rows& rows)
{
    for (const auto& [vertex, place] : ties)
    {
        rows.row(vertex).setZero();
        for (std::size_t k = 0; k < 3; ++k)
            rows.row(vertex) +=
                place.weights(static_cast<Eigen::Index>(k)) * rows.row(place.corners[k]);
    }
}

std::vector<char> border_vertices(const mesh::TriangleMesh& mesh)
{
    std::vector<char> is_border(at(mesh.vertex_count()), 0);
    for (const mesh::BoundaryEdge& edge : mesh::boundary_edges(mesh))
        is_border[at(edge.from)] = is_border[at(edge.to)] = 1;
    return is_border;
}

}  // namespace

numerics::SparseMatrix tie_basis(Eigen::Index vertex_count, const std::vector<Tie>& ties)
{
    using Entries = std::vector<std::pair<int, double>>;
    std::unordered_map<int, Entries> of_tied;
    for (const auto& [vertex, place] : ties)
    {
        Entries entries;
        for (std::size_t k = 0; k < 3; ++k)
        {
            const double weight = place.weights(static_cast<Eigen::Index>(k));
            const auto below = of_tied.find(place.corners[k]);
            if (weight == 0.0)
                continue;
            if (below == of_tied.end())
                entries.emplace_back(place.corners[k], weight);
            else
                for (const auto& [corner, share] : below->second)
                    entries.emplace_back(corner, weight * share);
        }
        of_tied[vertex] = std::move(entries);
    }
    std::vector<Eigen::Triplet<double>> entries;
    for (int i = 0; i < static_cast<int>(vertex_count); ++i)
        if (const auto tied = of_tied.find(i); tied == of_tied.end())
            entries.emplace_back(i, i, 1.0);
        else
            for (const auto& [corner, weight] : tied->second)
                entries.emplace_back(i, corner, weight);
    numerics::SparseMatrix basis(vertex_count, vertex_count);
    basis.setFromTriplets(entries.begin(), entries.end());
    return basis;
}

void fill_tied(const std::vector<Tie>& ties, Eigen::MatrixXd& rows)
{
    fill(ties, rows);
}

void fill_tied(const std::vector<Tie>& ties, Points& rows)
{
    fill(ties, rows);
}

std::vector<Tie> glued_ties(const mesh::TriangleMesh& mesh, const std::vector<Tie>& ties)
{
    std::vector<Tie> found;
    if (ties.empty())
        return found;
    const std::vector<char> is_border = border_vertices(mesh);
    const double as_one = rounding * mesh.size();
    for (const Tie& tie : ties)
    {
        const Vector3 own = mesh.points().row(tie.vertex).transpose();
        if (is_border[at(tie.vertex)] && is_border[at(tie.place.heaviest())]
            && tie.place.weights.maxCoeff() > 1.0 - rounding
            && (own - tie.place.on(mesh.points())).norm() <= as_one)
            found.push_back(tie);
    }
    return found;
}

mesh::TriangleMesh glued(const mesh::TriangleMesh& mesh, const std::vector<Tie>& ties)
{
    std::vector<int> now(at(mesh.vertex_count()));
    std::iota(now.begin(), now.end(), 0);
    for (const Tie& tie : ties)
        now[at(tie.vertex)] = now[at(tie.place.heaviest())];
    Triangles triangles = mesh.triangles();
    for (Eigen::Index t = 0; t < triangles.rows(); ++t)
        for (Eigen::Index k = 0; k < 3; ++k)
            triangles(t, k) = now[at(triangles(t, k))];
    return {mesh.points(), std::move(triangles)};
}

}  // namespace sheetmorph::surface
