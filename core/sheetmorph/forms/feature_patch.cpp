// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/forms/feature_patch.h"

#include "sheetmorph/base/index.h"
#include "sheetmorph/mesh/regions/crease_loops.h"
#include "sheetmorph/mesh/topology/boundary.h"

#include <algorithm>
#include <set>
#include <unordered_map>

namespace sheetmorph::forms
{

namespace
{

//! Maps vertices of a large mesh to indices in a small one.
class Renumbering
{
public:
    int number(int vertex)
    {
        const auto [found, is_new] = numbers_.emplace(vertex, static_cast<int>(vertices_.size()));
        if (is_new)
            vertices_.push_back(vertex);
        return found->second;
    }

    const VertexIds& vertices() const { return vertices_; }

private:
    std::unordered_map<int, int> numbers_;
    VertexIds vertices_;
};

Triangles stacked(const std::vector<Eigen::RowVector3i>& rows)
{
    Triangles triangles(static_cast<Eigen::Index>(rows.size()), 3);
    for (std::size_t t = 0; t < rows.size(); ++t)
        triangles.row(static_cast<Eigen::Index>(t)) = rows[t];
    return triangles;
}

}  // namespace

FeaturePatch::FeaturePatch(const mesh::TriangleMesh& mesh, const VertexIds& vertices,
                           double scatter)
    : scatter_(scatter)
{
    std::vector<char> is_inside(at(mesh.vertex_count()), 0);
    Renumbering numbers;
    for (const int vertex : vertices)
    {
        is_inside[at(vertex)] = 1;
        rows_.push_back(numbers.number(vertex));
    }
    for (int k = 0; k < static_cast<int>(numbers.vertices().size()); ++k)
        feature_.push_back(k);
    std::vector<Eigen::RowVector3i> touching;
    for (int t = 0; t < mesh.triangle_count(); ++t)
    {
        const Eigen::RowVector3i corners = mesh.triangles().row(t);
        if (is_inside[at(corners(0))] || is_inside[at(corners(1))] || is_inside[at(corners(2))])
            touching.emplace_back(numbers.number(corners(0)), numbers.number(corners(1)),
                                  numbers.number(corners(2)));
    }
    mesh_ = mesh::TriangleMesh(mesh.points()(numbers.vertices(), Eigen::indexing::all),
                               stacked(touching));
    loops_ = border_loops();
    is_free_ = !loops_.empty();
    if (loops_.empty() && has_triangles(feature_))
    {
        loops_ = loops_of(feature_);
        is_disk_ = loops_.size() == 1;
        if (!is_disk_)
            add_sharp_loops();
    }
    else if (loops_.empty())
        loops_ = edge_loop();
    std::stable_sort(loops_.begin(), loops_.end(),
                     [&](const VertexIds& a, const VertexIds& b)
                     { return length_of(a) < length_of(b); });
}

std::vector<char> FeaturePatch::marked(const VertexIds& vertices) const
{
    std::vector<char> marks(at(mesh_.vertex_count()), 0);
    for (const int vertex : vertices)
        marks[at(vertex)] = 1;
    return marks;
}

Triangles FeaturePatch::triangles_among(const VertexIds& vertices) const
{
    const std::vector<char> is_inside = marked(vertices);
    std::vector<Eigen::RowVector3i> found;
    for (int t = 0; t < mesh_.triangle_count(); ++t)
    {
        const Eigen::RowVector3i corners = mesh_.triangles().row(t);
        if (is_inside[at(corners(0))] && is_inside[at(corners(1))] && is_inside[at(corners(2))])
            found.push_back(corners);
    }
    return stacked(found);
}

// All triangles at the feature are in the patch, so these loops are borders of the whole sheet.
std::vector<VertexIds> FeaturePatch::border_loops() const
{
    const std::vector<char> is_inside = marked(feature_);
    std::vector<VertexIds> found;
    for (const VertexIds& loop : mesh::boundary_loops(mesh_))
        if (std::all_of(loop.begin(), loop.end(), [&](int v) { return is_inside[at(v)] != 0; }))
            found.push_back(loop);
    return found;
}

// The rims of a hole through a solid lie inside the rings of washer around it.
void FeaturePatch::add_sharp_loops()
{
    constexpr double sharp = 0.6;  // radians, from FeatureTolerances::crease_angle
    const std::vector<char> is_inside = marked(feature_);
    const std::vector<VertexIds> known = loops_;
    for (const VertexIds& loop : mesh::crease_loops(mesh_, mesh::EdgeTable(mesh_), sharp))
    {
        const bool is_new = std::none_of(
            known.begin(), known.end(),
            [&](const VertexIds& other)
            { return std::is_permutation(loop.begin(), loop.end(), other.begin(), other.end()); });
        if (is_new
            && std::all_of(loop.begin(), loop.end(), [&](int v) { return is_inside[at(v)] != 0; }))
            loops_.push_back(loop);
    }
}

// The feature's edges, if they form one closed loop.
std::vector<VertexIds> FeaturePatch::edge_loop() const
{
    const std::vector<char> is_inside = marked(feature_);
    std::vector<std::set<int>> next(at(mesh_.vertex_count()));
    for (int t = 0; t < mesh_.triangle_count(); ++t)
        for (int k = 0; k < 3; ++k)
        {
            const int a = mesh_.triangles()(t, k);
            const int b = mesh_.triangles()(t, (k + 1) % 3);
            if (a != b && is_inside[at(a)] && is_inside[at(b)])
            {
                next[at(a)].insert(b);
                next[at(b)].insert(a);
            }
        }
    if (feature_.empty())
        return {};
    for (const int vertex : feature_)
        if (next[at(vertex)].size() != 2)
            return {};
    VertexIds loop = {feature_.front()};
    int before = -1;
    while (true)
    {
        const std::set<int>& ways = next[at(loop.back())];
        const int onwards = *ways.begin() == before ? *ways.rbegin() : *ways.begin();
        if (onwards == loop.front())
            break;
        before = loop.back();
        loop.push_back(onwards);
    }
    return loop.size() == feature_.size() ? std::vector<VertexIds>{loop} : std::vector<VertexIds>{};
}

double FeaturePatch::length_of(const VertexIds& loop) const
{
    double length = 0.0;
    for (std::size_t k = 0; k < loop.size(); ++k)
        length +=
            (mesh_.points().row(loop[k]) - mesh_.points().row(loop[(k + 1) % loop.size()])).norm();
    return length;
}

std::vector<VertexIds> FeaturePatch::loops_of(const VertexIds& vertices) const
{
    return mesh::boundary_loops(mesh::TriangleMesh(mesh_.points(), triangles_among(vertices)));
}

bool FeaturePatch::has_triangles(const VertexIds& vertices) const
{
    return triangles_among(vertices).rows() > 0;
}

VertexIds FeaturePatch::neighbours_of(const VertexIds& vertices) const
{
    const std::vector<char> is_inside = marked(vertices);
    std::set<int> found;
    for (int t = 0; t < mesh_.triangle_count(); ++t)
        for (int k = 0; k < 3; ++k)
            if (is_inside[at(mesh_.triangles()(t, k))])
                for (int other = 0; other < 3; ++other)
                    found.insert(mesh_.triangles()(t, other));
    for (const int vertex : vertices)
        found.erase(vertex);
    return {found.begin(), found.end()};
}

Points FeaturePatch::points_of(const VertexIds& vertices) const
{
    return mesh_.points()(vertices, Eigen::indexing::all);
}

mesh::TriangleMesh FeaturePatch::covered_mesh() const
{
    Renumbering numbers;
    Triangles triangles = triangles_among(feature_);
    for (Eigen::Index t = 0; t < triangles.rows(); ++t)
        for (int k = 0; k < 3; ++k)
            triangles(t, k) = numbers.number(triangles(t, k));
    return mesh::TriangleMesh(mesh_.points()(numbers.vertices(), Eigen::indexing::all), triangles);
}

}  // namespace sheetmorph::forms
