// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/assembly/system/seams.h"

#include "sheetmorph/base/disjoint_sets.h"
#include "sheetmorph/base/index.h"
#include "sheetmorph/base/vertex_sets.h"
#include "sheetmorph/mesh/search/point_grid.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <tuple>

namespace sheetmorph::assembly
{

namespace
{

constexpr int none = -1;

// Relative to the size: places whose distances differ by less are equally near, so that rounding
// decides nothing. Chosen as in seam_ties.cpp.
constexpr double as_near = 1e-9;

//! Two vertices that may stay together; a < b.
struct Pair
{
    double distance;  // in steps
    int a, b;
    int seam;

    bool operator<(const Pair& other) const
    {
        return std::tie(distance, a, b, seam)
               < std::tie(other.distance, other.a, other.b, other.seam);
    }
};

// About the distance between neighbours of a patch.
double cell_of(const Points& points, const VertexIds& side)
{
    Eigen::RowVector3d low = points.row(side.front()), high = low;
    for (const int vertex : side)
    {
        low = low.cwiseMin(points.row(vertex));
        high = high.cwiseMax(points.row(vertex));
    }
    const double size = (high - low).norm();
    return size > 0.0 ? size / std::sqrt(static_cast<double>(side.size())) : 1.0;
}

double steps_between(const Points& points, int a, int b, double step)
{
    return std::round((points.row(a) - points.row(b)).norm() / step);
}

int nearest(const Points& points, const mesh::PointGrid& grid, int vertex, double step)
{
    const Vector3 place = points.row(vertex).transpose();
    int found = none;
    double shortest = std::numeric_limits<double>::infinity();
    for (double reach = 0.5 * grid.side(); shortest * step > reach;)
    {
        reach *= 2.0;
        const Vector3 corner = Vector3::Constant(reach);
        grid.for_each_in(place - corner, place + corner,
                         [&](int other)
                         {
                             const double distance = steps_between(points, other, vertex, step);
                             if (distance < shortest || (distance == shortest && other < found))
                             {
                                 shortest = distance;
                                 found = other;
                             }
                         });
    }
    return found;
}

// From every vertex to the nearest one of the other side.
std::vector<Pair> pairs_from(const mesh::TriangleMesh& mesh, const VertexIds& from,
                             const VertexIds& to, int seam)
{
    const Points& points = mesh.points();
    const double step = std::max(as_near * mesh.size(), std::numeric_limits<double>::min());
    const mesh::PointGrid grid(points, to, cell_of(points, to));
    std::vector<Pair> pairs;
    for (const int vertex : from)
        if (const int other = nearest(points, grid, vertex, step); other != vertex)
            pairs.push_back({steps_between(points, other, vertex, step), std::min(vertex, other),
                             std::max(vertex, other), seam});
    return pairs;
}

//! Vertices that stay together so far; initially those of rigid shapes.
class Clusters
{
public:
    explicit Clusters(const Sheet& sheet)
        : sheet_(sheet),
          sets_(sheet.mesh.vertex_count()),
          is_rigid_(at(sheet.mesh.vertex_count()), 0)
    {
        const surface::SurfaceConstraints& surface = sheet.surface;
        for (const surface::FormFeature& feature : surface.features)
            make_rigid(feature.vertices);
        for (const std::vector<int>& group : surface.groups)
            for (const int feature : group)
                sets_.join(surface.features[at(group.front())].vertices.front(),
                           surface.features[at(feature)].vertices.front());
        for (const surface::KnownRegion& fixed : surface.fixed)
            make_rigid(fixed.vertices);
        for (const surface::KnownRegion& handle : surface.handles)
            make_rigid(handle.vertices);
        for (std::size_t i = 0; i < is_rigid_.size(); ++i)
            if (is_rigid_[i])
                rigid_[sets_.root(static_cast<int>(i))].insert(part_of(static_cast<int>(i)));
        for (std::size_t k = 0; k < surface.handles.size(); ++k)
            drivers_[sets_.root(surface.handles[k].vertices.front())].insert(static_cast<int>(k));
        for (const surface::KnownRegion& fixed : surface.fixed)
            drivers_[sets_.root(fixed.vertices.front())].insert(none);
    }

    bool is_rigid(int vertex) const { return is_rigid_[at(vertex)] != 0; }

    //! Joins two vertices. Refuses if one already has a partner on that part, or if that would join
    //! two places of one part or differently moving shapes.
    bool join(int a, int b)
    {
        const int root_a = sets_.root(a), root_b = sets_.root(b);
        if (root_a == root_b || !is_allowed(a, b, root_a, root_b))
            return false;
        sets_.join(a, b);
        const int root = sets_.root(a);
        const int gone = root == root_a ? root_b : root_a;
        for (auto* sets : {&rigid_, &loose_, &drivers_})
            (*sets)[root].insert((*sets)[gone].begin(), (*sets)[gone].end());
        for (const int vertex : {a, b})
            if (!is_rigid_[at(vertex)])
                loose_[root].insert(part_of(vertex));
        partners_.insert({a, part_of(b)});
        partners_.insert({b, part_of(a)});
        return true;
    }

private:
    using Sets = std::map<int, std::set<int>>;  // by root

    void make_rigid(const VertexIds& vertices)
    {
        for (const int vertex : vertices)
        {
            is_rigid_[at(vertex)] = 1;
            sets_.join(vertices.front(), vertex);
        }
    }

    int part_of(int vertex) const { return sheet_.part_of(vertex); }

    bool is_alone(int vertex)
    {
        return !is_rigid_[at(vertex)] && loose_[sets_.root(vertex)].empty();
    }

    bool is_allowed(int a, int b, int root_a, int root_b)
    {
        if (partners_.count({a, part_of(b)}) > 0 || partners_.count({b, part_of(a)}) > 0)
            return false;
        std::set<int> drivers = drivers_[root_a];
        drivers.insert(drivers_[root_b].begin(), drivers_[root_b].end());
        if (drivers.size() > 1)
            return false;
        if ((is_rigid_[at(a)] && is_alone(b)) || (is_rigid_[at(b)] && is_alone(a)))
            return true;
        const auto parts_of = [&](int vertex, int root)
        {
            std::set<int> parts = rigid_[root];
            parts.insert(loose_[root].begin(), loose_[root].end());
            parts.insert(part_of(vertex));
            return parts;
        };
        const std::set<int> of_a = parts_of(a, root_a), of_b = parts_of(b, root_b);
        return std::none_of(of_a.begin(), of_a.end(),
                            [&](int part) { return of_b.count(part) > 0; });
    }

    const Sheet& sheet_;
    DisjointSets sets_;
    std::vector<char> is_rigid_;              // by vertex: on a feature, handle or fixed region
    Sets rigid_, loose_;                      // parts of these and other vertices in a cluster
    Sets drivers_;                            // handles that move it; none: the ground
    std::set<std::pair<int, int>> partners_;  // (vertex, part)
};

}  // namespace

std::vector<surface::KnownRegion> stitched(const Sheet& sheet, const std::vector<Seam>& seams)
{
    const mesh::TriangleMesh& mesh = sheet.mesh;
    std::vector<Pair> pairs;
    for (std::size_t k = 0; k < seams.size(); ++k)
    {
        VertexIds a = seams[k].target, b = seams[k].source;
        make_set(a);
        make_set(b);
        for (const auto& [from, to] : {std::pair(&a, &b), std::pair(&b, &a)})
            for (const Pair& pair : pairs_from(mesh, *from, *to, static_cast<int>(k)))
                pairs.push_back(pair);
    }
    std::sort(pairs.begin(), pairs.end());
    Clusters clusters(sheet);
    DisjointSets stitches(mesh.vertex_count());
    std::map<int, std::string> name_of;  // by vertex
    for (const Pair& pair : pairs)
        if ((clusters.is_rigid(pair.a) || clusters.is_rigid(pair.b))
            && clusters.join(pair.a, pair.b))
        {
            stitches.join(pair.a, pair.b);
            for (const int vertex : {pair.a, pair.b})
                name_of.emplace(vertex, seams[at(pair.seam)].name);
        }
    std::map<int, surface::KnownRegion> found;
    for (const auto& [vertex, name] : name_of)
    {
        const surface::KnownRegion stitch{name, {}, "contact", false, {{"contact", name}}};
        found.emplace(stitches.root(vertex), stitch).first->second.vertices.push_back(vertex);
    }
    std::vector<surface::KnownRegion> result;
    for (auto& [root, stitch] : found)
        result.push_back(std::move(stitch));
    return result;
}

}  // namespace sheetmorph::assembly
