// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/repair/remesh_result.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>

namespace sheetmorph
{

namespace
{

using Vertex = WorkingMesh::Vertex;
using Face = WorkingMesh::Face;
using Halfedge = WorkingMesh::Halfedge;

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
    // A frozen vertex is known by its place in the cut mesh; its copies are one again.
    bool is_old(Vertex v) const { return work_.is_frozen[v] && work_.origin[v] < old_count_; }

    void number_vertices()
    {
        number_.assign(work_.surface.num_vertices(), -1);
        std::map<int, int> of_cut;
        const auto give = [&](Vertex v)
        {
            int next = static_cast<int>(representative_.size());
            if (work_.is_frozen[v])
                next = of_cut.emplace(work_.origin[v], next).first->second;
            if (next == static_cast<int>(representative_.size()))
                representative_.push_back(v);
            number_[v] = next;
        };
        std::vector<std::pair<int, Vertex>> old;
        for (const Vertex v : work_.surface.vertices())
            if (is_old(v) && !work_.surface.is_isolated(v))
                old.emplace_back(work_.origin[v], v);
        std::sort(old.begin(), old.end());
        for (const auto& entry : old)
            give(entry.second);
        for (const Vertex v : work_.surface.vertices())
            if (!is_old(v) && !work_.surface.is_isolated(v))
                give(v);
    }

    void collect_triangles()
    {
        Points points(representative_.size(), 3);
        for (std::size_t i = 0; i < representative_.size(); ++i)
            points.row(i) = work_.point(representative_[i]).transpose();
        Triangles triangles(work_.surface.number_of_faces(), 3);
        int t = 0;
        for (const Face face : work_.surface.faces())
        {
            Halfedge h = work_.surface.halfedge(face);
            for (int k = 0; k < 3; ++k, h = work_.surface.next(h))
                triangles(t, k) = number_[work_.surface.source(h)];
            found_.patch.push_back(work_.patch[face]);
            ++t;
        }
        found_.mesh = TriangleMesh(std::move(points), std::move(triangles));
    }

    // A triangle given at every vertex given, and at every edge.
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
                const EdgeUse& use = *source_.table.uses(edge).begin();
                triangle_along[std::minmax(use.from, use.to)] = use.triangle;
            }
        found_.barycentric = Points::Zero(representative_.size(), 3);
        for (std::size_t i = 0; i < representative_.size(); ++i)
        {
            const Vertex v = representative_[i];
            const int row = static_cast<int>(i), origin = work_.origin[v];
            if (is_old(v))
                put(row, triangle_at[origin], {origin, origin, 0.0});
            else if (work_.is_frozen[v])
            {
                const EdgePlace& place = source_.cut.places[origin - old_count_];
                put(row, triangle_along.at(std::minmax(place.from, place.to)), place);
            }
            else
                put_inside(row, v);
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

    void put_inside(int row, Vertex v)
    {
        const int patch = work_.patch[work_.surface.face(work_.surface.halfedge(v))];
        const Hit hit = source_.trees.nearest(patch, work_.point(v));
        found_.triangle.push_back(hit.triangle);
        found_.barycentric.row(row) = hit.barycentric.transpose();
    }

    // How far the new triangles are from the facets of their patch.
    void measure()
    {
        double all = 0.0, flat = 0.0;
        const int count = found_.mesh.triangle_count();
#pragma omp parallel for reduction(max : all, flat) schedule(dynamic, 256)
        for (int t = 0; t < count; ++t)
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
            all = std::max(all, most);
            if (source_.patches.is_flat[found_.patch[t]])
                flat = std::max(flat, most);
        }
        found_.deviation = all;
        found_.flat_deviation = flat;
    }

    // Old vertices off the ridges are gone: the nearest new one stands for each.
    void follow_old_vertices()
    {
        found_.vertex_of.assign(static_cast<std::size_t>(old_count_), -1);
        found_.is_kept.assign(static_cast<std::size_t>(old_count_), 0);
        for (std::size_t i = 0; i < representative_.size(); ++i)
            if (is_old(representative_[i]))
            {
                const int origin = work_.origin[representative_[i]];
                found_.vertex_of[origin] = static_cast<int>(i);
                found_.is_kept[origin] = 1;
            }
        std::vector<char> is_used(static_cast<std::size_t>(old_count_), 0);
        for (Eigen::Index k = 0; k < source_.mesh.triangles().size(); ++k)
            is_used[source_.mesh.triangles().data()[k]] = 1;
        const PickingTree tree(found_.mesh);
        for (int i = 0; i < old_count_; ++i)
        {
            if (found_.is_kept[i] || !is_used[i])
                continue;
            const Hit hit = *tree.nearest_point(source_.mesh.points().row(i).transpose());
            int nearest = 0;
            hit.barycentric.maxCoeff(&nearest);
            found_.vertex_of[i] = found_.mesh.triangles()(hit.triangle, nearest);
            found_.deviation = std::max(found_.deviation, hit.distance);
        }
    }

    const WorkingMesh& work_;
    const RemeshSource& source_;
    int old_count_;
    std::vector<int> number_;  // of every vertex of the working mesh
    std::vector<Vertex> representative_;
    RemeshedMesh found_;
};

}  // namespace

RemeshedMesh result_of(const WorkingMesh& work, const RemeshSource& source)
{
    return ResultBuilder(work, source).build();
}

}  // namespace sheetmorph
