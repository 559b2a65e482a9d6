// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/recognise/facets/facet_graph.h"

#include "sheetmorph/base/angles.h"
#include "sheetmorph/base/disjoint_sets.h"
#include "sheetmorph/base/vertex_sets.h"
#include "sheetmorph/mesh/geometry/thinness.h"
#include "sheetmorph/mesh/quality/noise.h"
#include "sheetmorph/recognise/facets/welding.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>
#include <utility>

namespace sheetmorph::recognise
{

namespace
{

constexpr int none = -1;

// At an edge with more sheets, none continues across it. Two sheets continue into each other if
// they bend by at most straight_on, radians. Chosen: 10 degrees, so that a sheet welded to a bend
// leaves it whole; 12 sheets are 66 pairs to compare, and real edges have four.
constexpr int most_sheets = 12;
constexpr double straight_on = 0.17;

bool is_balanced(const mesh::EdgeUses& uses)
{
    int sum = 0;
    for (const mesh::EdgeUse& use : uses)
        sum += use.from < use.to ? 1 : -1;
    return sum == 0;
}

struct Welded
{
    mesh::TriangleMesh mesh;
    std::vector<int> representative;
    std::vector<int> starts;
    std::vector<int> members;
};

Welded weld_vertices(const mesh::TriangleMesh& mesh, double weld)
{
    const std::vector<int> first = coincident(mesh.points(), weld * mesh.size());
    Welded welded;
    std::vector<int> number(first.size(), none);
    for (int i = 0; i < mesh.vertex_count(); ++i)
        if (first[i] == i)
        {
            number[i] = static_cast<int>(welded.representative.size());
            welded.representative.push_back(i);
        }
    welded.starts.assign(welded.representative.size() + 1, 0);
    for (const int root : first)
        ++welded.starts[number[root] + 1];
    for (std::size_t i = 1; i < welded.starts.size(); ++i)
        welded.starts[i] += welded.starts[i - 1];
    std::vector<int> next = welded.starts;
    welded.members.resize(first.size());
    for (int i = 0; i < mesh.vertex_count(); ++i)
        welded.members[next[number[first[i]]]++] = i;
    Points points(welded.representative.size(), 3);
    for (std::size_t i = 0; i < welded.representative.size(); ++i)
        points.row(static_cast<Eigen::Index>(i)) = mesh.points().row(welded.representative[i]);
    Triangles triangles = mesh.triangles().unaryExpr([&](int v) { return number[first[v]]; });
    welded.mesh = mesh::TriangleMesh(std::move(points), std::move(triangles));
    return welded;
}

// Flood fill over smooth edges; a degenerate triangle inherits the plane of the triangle before it.
class SmoothFlood
{
public:
    SmoothFlood(const FacetGraph& graph, double max_angle)
        : graph_(graph),
          max_angle_(max_angle),
          label_(static_cast<std::size_t>(graph.triangle_count()), none),
          plane_(label_)
    {
    }

    std::vector<int> labels()
    {
        int count = 0;
        for (const bool thin : {false, true})
            for (int t = 0; t < graph_.triangle_count(); ++t)
                if (label_[t] == none && graph_.is_thin(t) == thin)
                    flood(t, count++);
        return std::move(label_);
    }

private:
    void flood(int seed, int label)
    {
        reach(seed, seed, label);
        while (!front_.empty())
        {
            const int triangle = front_.back();
            front_.pop_back();
            for (int k = 0; k < 3; ++k)
            {
                const int other = graph_.across(triangle, k);
                if (other != none && label_[other] == none && bend(triangle, k) < max_angle_)
                    reach(other, graph_.is_thin(other) ? plane_[triangle] : other, label);
            }
        }
    }

    void reach(int triangle, int plane, int label)
    {
        label_[triangle] = label;
        plane_[triangle] = plane;
        front_.push_back(triangle);
    }

    double bend(int triangle, int k) const
    {
        const int other = graph_.across(triangle, k);
        if (plane_[triangle] == triangle && !graph_.is_thin(other) && !graph_.is_thin(triangle))
            return graph_.bend(triangle, k);
        if (graph_.is_thin(other) || graph_.is_thin(plane_[triangle]))
            return 0.0;
        const double cosine = graph_.normal(plane_[triangle]).dot(graph_.normal(other));
        return std::acos(std::min(1.0, std::abs(cosine)));
    }

    const FacetGraph& graph_;
    double max_angle_;
    std::vector<int> label_;
    std::vector<int> plane_;
    std::vector<int> front_;
};

}  // namespace

FacetGraph::FacetGraph(const mesh::TriangleMesh& mesh, double weld, double scatter)
    : edges_(mesh::TriangleMesh()), scatter_(scatter)
{
    Welded welded = weld_vertices(mesh, weld);
    welded_ = std::move(welded.mesh);
    representative_ = std::move(welded.representative);
    member_starts_ = std::move(welded.starts);
    members_ = std::move(welded.members);
    edges_ = mesh::EdgeTable(welded_);
    measure_triangles();
    measure_bends(false);
    look_whether_solid();
    find_components();
}

FacetGraph::FacetGraph(const mesh::TriangleMesh& mesh, double scatter, bool is_oriented)
    : welded_(mesh),
      representative_(static_cast<std::size_t>(mesh.vertex_count())),
      edges_(mesh),
      scatter_(scatter)
{
    std::iota(representative_.begin(), representative_.end(), 0);
    members_ = representative_;
    member_starts_ = representative_;
    member_starts_.push_back(mesh.vertex_count());
    measure_triangles();
    measure_bends(is_oriented);
    look_whether_solid();
    find_components();
}

FacetGraph FacetGraph::of_solids(const mesh::TriangleMesh& mesh)
{
    FacetGraph graph(mesh, 0.0, true);
    graph.turn_outwards();
    return graph;
}

int FacetGraph::side_of(const mesh::EdgeUse& use) const
{
    for (int k = 0; k < 2; ++k)
        if (welded_.triangles()(use.triangle, k) == use.from)
            return k;
    return 2;
}

void FacetGraph::measure_triangles()
{
    normals_ = Points::Zero(triangle_count(), 3);
    areas_.assign(static_cast<std::size_t>(triangle_count()), 0.0);
    for (int t = 0; t < triangle_count(); ++t)
    {
        if (mesh::is_thin(welded_.points(), welded_.triangles(), t))
            continue;
        const Eigen::RowVector3i corners = welded_.triangles().row(t);
        const Vector3 doubled =
            (point(corners(1)) - point(corners(0))).cross(point(corners(2)) - point(corners(0)));
        areas_[t] = 0.5 * doubled.norm();
        normals_.row(t) = doubled.normalized().transpose();
        total_area_ += areas_[t];
    }
    if (scatter_ < 0.0)
        scatter_ = mesh::scatter_of(welded_, edges_, normals_);
    if (scatter_ <= 0.0)
        return;
    unsure_ = mesh::unsure_normals(welded_, areas_, scatter_);
    normals_ = mesh::calmed_normals(edges_, normals_, areas_, unsure_);
}

double FacetGraph::bend_between(const mesh::EdgeUse& one, const mesh::EdgeUse& other) const
{
    if (scatter_ <= 0.0 || is_thin(one.triangle) || is_thin(other.triangle))
        return mesh::bend_angle(welded_.points(), one, other);
    const double cosine = normal(one.triangle).dot(normal(other.triangle));
    return std::acos(std::clamp(one.from != other.from ? cosine : -cosine, -1.0, 1.0));
}

void FacetGraph::measure_bends(bool is_oriented)
{
    across_.assign(3 * static_cast<std::size_t>(triangle_count()), none);
    bends_.assign(across_.size(), pi);
    for (int edge = 0; edge < edges_.count(); ++edge)
    {
        const mesh::EdgeUses uses = edges_.uses(edge);
        if (is_oriented && !is_balanced(uses))
            continue;
        if (uses.count() == 2)
            join(uses.begin()[0], uses.begin()[1]);
        else if (!is_oriented && uses.count() > 2 && uses.count() <= most_sheets)
            join_straightest(edge);
    }
}

void FacetGraph::join(const mesh::EdgeUse& one, const mesh::EdgeUse& other)
{
    const double bend = bend_between(one, other);
    for (const auto& [here, there] : {std::pair(&one, &other), std::pair(&other, &one)})
    {
        const int side = side_of(*here);
        across_[3 * here->triangle + side] = there->triangle;
        bends_[3 * here->triangle + side] = bend;
    }
}

// At an edge of more than two sheets, the straightest pairs continue into each other. A wall merged
// with a plate in one mesh does not cut the plate, and two plates that touch along a line do not
// end there.
void FacetGraph::join_straightest(int edge)
{
    const mesh::EdgeUses uses = edges_.uses(edge);
    std::vector<std::tuple<double, int, int>> pairs;
    for (int a = 0; a < uses.count(); ++a)
        for (int b = a + 1; b < uses.count(); ++b)
            pairs.emplace_back(bend_between(uses.begin()[a], uses.begin()[b]), a, b);
    std::sort(pairs.begin(), pairs.end());
    std::vector<char> is_joined(static_cast<std::size_t>(uses.count()), 0);
    for (const auto& [bend, a, b] : pairs)
        if (bend < straight_on && !is_joined[a] && !is_joined[b])
        {
            join(uses.begin()[a], uses.begin()[b]);
            is_joined[a] = is_joined[b] = 1;
        }
}

std::vector<FacetJoint> FacetGraph::joints() const
{
    std::vector<FacetJoint> found;
    for (int edge = 0; edge < edges_.count(); ++edge)
    {
        const mesh::EdgeUses uses = edges_.uses(edge);
        if (uses.count() != 2)
            continue;
        const mesh::EdgeUse &one = uses.begin()[0], &other = uses.begin()[1];
        if (const int side = side_of(one); across(one.triangle, side) == other.triangle)
            found.push_back({one.triangle, other.triangle, bend(one.triangle, side),
                             (point(one.from) - point(one.to)).norm()});
    }
    return found;
}

void FacetGraph::find_components()
{
    DisjointSets sets(triangle_count());
    for (int t = 0; t < triangle_count(); ++t)
        for (int k = 0; k < 3; ++k)
            if (across(t, k) != none)
                sets.join(t, across(t, k));
    component_.resize(static_cast<std::size_t>(triangle_count()));
    for (int t = 0; t < triangle_count(); ++t)
    {
        component_[t] = sets.root(t) == t ? component_count() : component_[sets.root(t)];
        if (sets.root(t) == t)
            is_closed_.push_back(1);
    }
    for (int edge = 0; edge < edges_.count(); ++edge)
        if (const mesh::EdgeUses uses = edges_.uses(edge); !is_balanced(uses))
            for (const mesh::EdgeUse& use : uses)
                is_closed_[component_[use.triangle]] = 0;
}

// The sign of the enclosed volume distinguishes inside from outside. Degenerate facets need a
// normal as well, because rays start from every facet of a solid.
void FacetGraph::turn_outwards()
{
    std::vector<double> volume(is_closed_.size(), 0.0);
    std::vector<int> first(is_closed_.size(), none);
    for (int t = 0; t < triangle_count(); ++t)
    {
        int& start = first[component_[t]];
        start = start == none ? t : start;
        const Eigen::RowVector3i corners = welded_.triangles().row(t);
        const Vector3 origin = point(welded_.triangles()(start, 0));
        const Vector3 a = point(corners(0)) - origin, b = point(corners(1)) - origin;
        const Vector3 c = point(corners(2)) - origin;
        volume[component_[t]] += a.dot(b.cross(c));
        if (is_thin(t))
            normals_.row(t) = (b - a).cross(c - a).stableNormalized().transpose();
    }
    for (int t = 0; t < triangle_count(); ++t)
        if (volume[component_[t]] < 0.0)
            normals_.row(t) *= -1.0;
}

void FacetGraph::look_whether_solid()
{
    double open = 0.0;
    double volume = 0.0;
    for (int edge = 0; edge < edges_.count(); ++edge)
    {
        const mesh::EdgeUses uses = edges_.uses(edge);
        if (uses.count() != 2 || uses.begin()[0].from == uses.begin()[1].from)
            open += (point(uses.begin()->from) - point(uses.begin()->to)).norm();
    }
    const Vector3 origin = welded_.vertex_count() ? point(0) : Vector3::Zero();
    for (int t = 0; t < triangle_count(); ++t)
        volume += areas_[t] * normal(t).dot(centroid(t) - origin) / 3.0;
    // The border of an open sheet is at least 2 sqrt(pi) times the root of its area (isoperimetric
    // inequality). A solid with a few import faults stays far below that.
    is_solid_ = triangle_count() > 0 && open * open <= 0.25 * total_area_ && volume > 0.0;
}

Vector3 FacetGraph::centroid(int triangle) const
{
    const Eigen::RowVector3i corners = welded_.triangles().row(triangle);
    return (point(corners(0)) + point(corners(1)) + point(corners(2))) / 3.0;
}

VertexIds FacetGraph::originals(const VertexIds& vertices) const
{
    VertexIds found;
    for (const int v : vertices)
        found.insert(found.end(), members_.begin() + member_starts_[v],
                     members_.begin() + member_starts_[v + 1]);
    make_set(found);
    return found;
}

VertexIds FacetGraph::representatives(const VertexIds& vertices) const
{
    VertexIds found;
    for (const int v : vertices)
        found.push_back(representative_[v]);
    return found;
}

std::vector<int> smooth_regions(const FacetGraph& graph, double max_angle)
{
    return SmoothFlood(graph, max_angle).labels();
}

}  // namespace sheetmorph::recognise
