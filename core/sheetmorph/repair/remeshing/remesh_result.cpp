// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/repair/remeshing/remesh_result.h"

#include "sheetmorph/base/threads/parallel.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace sheetmorph::repair
{

namespace
{

// value(k) for 0 .. count - 1 in parallel; each value takes at least one tree search.
template <typename Value>
Eigen::VectorXd measured(int count, const Value& value)
{
    Eigen::VectorXd values(count);
    parallel_ranges(count, microsecond_items,
                    [&](Eigen::Index begin, Eigen::Index end)
                    {
                        for (Eigen::Index k = begin; k < end; ++k)
                            values(k) = value(static_cast<int>(k));
                    });
    return values;
}

class ResultBuilder
{
public:
    ResultBuilder(const WorkingMesh& work, const RemeshSource& source)
        : work_(work), source_(source), old_count_(source.mesh.vertex_count())
    {
    }

    RemeshedMesh build()
    {
        number_vertices();
        collect_triangles();
        place_vertices();
        measure();
        follow_old_vertices();
        found_.circles = source_.circles;
        found_.flats = static_cast<int>(
            std::count(source_.patches.is_flat.begin(), source_.patches.is_flat.end(), 1));
        return std::move(found_);
    }

private:
    // A vertex of the result. A frozen one is identified by its vertex in the cut mesh.
    struct Placed
    {
        Vector3 point;
        int origin;  // in the cut mesh; -1 if it is free
        int patch;   // of a free vertex
    };

    bool is_old(const Placed& vertex) const
    {
        return vertex.origin >= 0 && vertex.origin < old_count_;
    }

    int patch_at(int v) const { return work_.patch[work_.triangle_at(v)]; }

    void number_vertices()
    {
        std::vector<int> old;
        std::vector<int> others;
        for (int v = 0; v < work_.vertex_count(); ++v)
            if (work_.triangle_at(v) < 0)
                continue;
            else if (work_.is_frozen[v] && work_.origin[v] < old_count_)
                old.push_back(work_.origin[v]);
            else
                others.push_back(v);
        for (const TwinFlats& pair : source_.twins)
            for (const auto& [vertex, twin] : pair.vertex_of)
                if (twin < old_count_)
                    old.push_back(twin);
        std::sort(old.begin(), old.end());
        for (const int vertex : old)
            number_of_cut(vertex);
        for (const int v : others)
            number_of(v);
    }

    // Assigns a number on first use.
    int number_of_cut(int vertex)
    {
        const auto [found, is_new] = of_cut_.emplace(vertex, static_cast<int>(vertices_.size()));
        if (is_new)
            vertices_.push_back({source_.cut.mesh.points().row(vertex).transpose(), vertex, -1});
        return found->second;
    }

    int number_of(int v)
    {
        if (work_.is_frozen[v])
            return number_of_cut(work_.origin[v]);
        const auto [found, is_new] = of_free_.emplace(v, static_cast<int>(vertices_.size()));
        if (is_new)
            vertices_.push_back({work_.point[v], -1, patch_at(v)});
        return found->second;
    }

    // The copy of a flat's vertex on its twin.
    int number_on_twin(int v, const TwinFlats& pair)
    {
        const auto on_outline = pair.vertex_of.find(work_.origin[v]);
        if (work_.is_frozen[v] && on_outline != pair.vertex_of.end())
            return number_of_cut(on_outline->second);
        const auto [found, is_new] =
            of_twin_.emplace(std::pair(v, pair.twin), static_cast<int>(vertices_.size()));
        if (is_new)
        {
            const mesh::Hit hit = source_.trees.nearest(pair.twin, work_.point[v] + pair.way);
            vertices_.push_back({hit.point, -1, pair.twin});
        }
        return found->second;
    }

    void collect_triangles()
    {
        std::vector<std::array<int, 3>> triangles;
        std::map<int, const TwinFlats*> pair_of;
        for (const TwinFlats& pair : source_.twins)
            pair_of[pair.flat] = &pair;
        const auto add = [&](const std::array<int, 3>& triangle, int patch)
        {
            triangles.push_back(triangle);
            found_.patch.push_back(patch);
        };
        for (int t = 0; t < work_.count(); ++t)
            if (work_.triangle(t).is_alive())
            {
                const auto [a, b, c] = work_.triangle(t).corner;
                add({number_of(a), number_of(b), number_of(c)}, work_.patch[t]);
            }
        for (int t = 0; t < work_.count(); ++t)
        {
            const auto pair = pair_of.find(work_.patch[t]);
            if (pair == pair_of.end() || !work_.triangle(t).is_alive())
                continue;
            const auto [a, b, c] = work_.triangle(t).corner;
            const TwinFlats& twins = *pair->second;
            add({number_on_twin(c, twins), number_on_twin(b, twins), number_on_twin(a, twins)},
                twins.twin);
        }
        Points points(vertices_.size(), 3);
        for (std::size_t i = 0; i < vertices_.size(); ++i)
            points.row(static_cast<Eigen::Index>(i)) = vertices_[i].point.transpose();
        Triangles rows(triangles.size(), 3);
        for (std::size_t t = 0; t < triangles.size(); ++t)
            rows.row(static_cast<Eigen::Index>(t)) << triangles[t][0], triangles[t][1],
                triangles[t][2];
        found_.mesh = mesh::TriangleMesh(std::move(points), std::move(rows));
    }

    // Locates every vertex on a triangle of the input.
    void place_vertices()
    {
        const Triangles& triangles = source_.mesh.triangles();
        std::vector<int> triangle_at(static_cast<std::size_t>(old_count_), -1);
        for (Eigen::Index k = triangles.size() - 1; k >= 0; --k)
            triangle_at[triangles.data()[k]] = static_cast<int>(k / 3);
        std::map<std::pair<int, int>, int> triangle_along;
        for (int edge = 0; edge < source_.table.count(); ++edge)
            if (source_.patches.is_ridge[edge])
            {
                const mesh::EdgeUse& use = *source_.table.uses(edge).begin();
                triangle_along[std::minmax(use.from, use.to)] = use.triangle;
            }
        found_.barycentric = Points::Zero(vertices_.size(), 3);
        for (std::size_t i = 0; i < vertices_.size(); ++i)
        {
            const int row = static_cast<int>(i), origin = vertices_[i].origin;
            if (is_old(vertices_[i]))
                put(row, triangle_at[origin], {origin, origin, 0.0});
            else if (origin >= 0)
            {
                const EdgePlace& place = source_.cut.places[origin - old_count_];
                put(row, triangle_along.at(std::minmax(place.from, place.to)), place);
            }
            else
                put_inside(row, vertices_[i]);
        }
    }

    void put(int row, int triangle, const EdgePlace& place)
    {
        found_.triangle.push_back(triangle);
        for (int k = 0; k < 3; ++k)
        {
            const int corner = source_.mesh.triangles()(triangle, k);
            if (corner == place.to)
                found_.barycentric(row, k) = place.from == place.to ? 1.0 : place.share;
            else if (corner == place.from)
                found_.barycentric(row, k) = 1.0 - place.share;
        }
    }

    void put_inside(int row, const Placed& vertex)
    {
        const mesh::Hit hit = source_.trees.nearest(vertex.patch, vertex.point);
        found_.triangle.push_back(hit.triangle);
        found_.barycentric.row(row) = hit.barycentric.transpose();
    }

    // Measures the distance of the new triangles from the facets of their patch.
    void measure()
    {
        const Eigen::VectorXd distances =
            measured(found_.mesh.triangle_count(), [this](int t) { return distance_of(t); });
        for (int t = 0; t < found_.mesh.triangle_count(); ++t)
        {
            found_.deviation = std::max(found_.deviation, distances(t));
            if (source_.patches.is_flat[found_.patch[t]])
                found_.flat_deviation = std::max(found_.flat_deviation, distances(t));
        }
    }

    double distance_of(int t) const
    {
        const auto corner = [&](int k) -> Vector3
        { return found_.mesh.points().row(found_.mesh.triangles()(t, k % 3)).transpose(); };
        const Vector3 middle = (corner(0) + corner(1) + corner(2)) / 3.0;
        double most = source_.trees.nearest(found_.patch[t], middle).distance;
        for (int k = 0; k < 3; ++k)
        {
            const Vector3 half = 0.5 * (corner(k) + corner(k + 1));
            most = std::max({most, source_.trees.nearest(found_.patch[t], half).distance,
                             source_.trees.nearest(found_.patch[t], corner(k)).distance});
        }
        return most;
    }

    // Input vertices off the ridges no longer exist. Each maps to the nearest new vertex of its own
    // patch, however near other sheets are.
    void follow_old_vertices()
    {
        found_.vertex_of.assign(static_cast<std::size_t>(old_count_), -1);
        found_.is_kept.assign(static_cast<std::size_t>(old_count_), 0);
        for (std::size_t i = 0; i < vertices_.size(); ++i)
            if (is_old(vertices_[i]))
            {
                const int origin = vertices_[i].origin;
                found_.vertex_of[origin] = static_cast<int>(i);
                found_.is_kept[origin] = 1;
            }
        const PatchTrees trees(found_.mesh, found_.patch);
        const std::vector<int> patches = patches_of_gone_vertices();
        const auto follow = [&](int i)
        {
            if (patches[i] < 0)
                return 0.0;
            const mesh::Hit hit =
                trees.nearest(patches[i], source_.mesh.points().row(i).transpose());
            int nearest = 0;
            hit.barycentric.maxCoeff(&nearest);
            found_.vertex_of[i] = found_.mesh.triangles()(hit.triangle, nearest);
            return hit.distance;
        };
        const Eigen::VectorXd distances = measured(old_count_, follow);
        found_.deviation = distances.size() > 0 ? std::max(found_.deviation, distances.maxCoeff())
                                                : found_.deviation;
    }

    // By input vertex: a surviving patch around it; -1 if the vertex is kept or unused.
    std::vector<int> patches_of_gone_vertices() const
    {
        std::vector<char> is_there(source_.patches.is_flat.size(), 0);
        for (const int patch : found_.patch)
            is_there[patch] = 1;
        std::vector<int> patches(static_cast<std::size_t>(old_count_), -1);
        const Triangles& triangles = source_.mesh.triangles();
        for (Eigen::Index k = 0; k < triangles.size(); ++k)
            if (!found_.is_kept[triangles.data()[k]] && is_there[source_.patches.patch[k / 3]])
                patches[triangles.data()[k]] = source_.patches.patch[k / 3];
        return patches;
    }

    const WorkingMesh& work_;
    const RemeshSource& source_;
    int old_count_;
    std::vector<Placed> vertices_;
    std::map<int, int> of_cut_;   // by vertex of the cut mesh
    std::map<int, int> of_free_;  // by vertex of the working mesh
    std::map<std::pair<int, int>, int> of_twin_;
    RemeshedMesh found_;
};

}  // namespace

RemeshedMesh result_of(const WorkingMesh& work, const RemeshSource& source)
{
    return ResultBuilder(work, source).build();
}

}  // namespace sheetmorph::repair
