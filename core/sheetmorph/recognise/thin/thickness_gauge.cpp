// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/recognise/thin/thickness_gauge.h"

#include "sheetmorph/base/errors.h"
#include "sheetmorph/base/index.h"
#include "sheetmorph/base/parallel.h"
#include "sheetmorph/mesh/search/picking.h"
#include "sheetmorph/mesh/topology/submesh.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <string>

namespace sheetmorph
{

namespace
{

// Outside these many thicknesses, what is nearest at rest is not the skin opposite.
constexpr double nearest = 0.3;
constexpr double farthest = 1.8;

std::vector<char> flags(const TriangleMesh& mesh, const std::vector<VertexIds>& pieces)
{
    std::vector<char> found(at(mesh.vertex_count()), 0);
    for (const VertexIds& piece : pieces)
        for (const int vertex : piece)
            found[at(vertex)] = 1;
    return found;
}

class Gauge
{
public:
    Gauge(const TriangleMesh& mesh, const ThinSolid& solid, const Points& positions)
        : mesh_(mesh),
          solid_(solid),
          positions_(positions),
          is_on_wall_(flags(mesh, solid.walls)),
          is_on_lump_(flags(mesh, solid.lumps))
    {
        change_.rest_least = change_.least = std::numeric_limits<double>::infinity();
    }

    ThicknessChange measure()
    {
        from(SolidSide::main, SolidSide::opposite);
        from(SolidSide::opposite, SolidSide::main);
        return std::isinf(change_.least) ? ThicknessChange{} : change_;
    }

private:
    // From the vertices of one skin to the other skin of the same component.
    void from(SolidSide side, SolidSide other)
    {
        std::map<int, std::vector<int>> facets;
        for (std::size_t t = 0; t < solid_.facets.size(); ++t)
            if (solid_.facets[t] == other)
                facets[solid_.component[t]].push_back(static_cast<int>(t));
        for (const auto& [component, skin] : facets)
            to_skin(vertices_on(component, side), submesh(mesh_, skin));
    }

    VertexIds vertices_on(int component, SolidSide side) const
    {
        VertexIds found;
        for (int t = 0; t < mesh_.triangle_count(); ++t)
            for (int k = 0; k < 3 && solid_.component[at(t)] == component; ++k)
            {
                const int vertex = mesh_.triangles()(t, k);
                if (solid_.vertices[at(vertex)] == side && !is_on_lump_[at(vertex)])
                    found.push_back(vertex);
            }
        std::sort(found.begin(), found.end());
        found.erase(std::unique(found.begin(), found.end()), found.end());
        return found;
    }

    void to_skin(const VertexIds& vertices, const Submesh& skin)
    {
        const PickingTree rest(skin.mesh);
        PickingTree now = rest;
        now.refit(positions_(skin.vertices, Eigen::indexing::all));
        std::vector<Distances> found(vertices.size());
        parallel_ranges(static_cast<Eigen::Index>(vertices.size()), microsecond_items,
                        [&](auto begin, auto end)
                        {
                            for (auto k = begin; k < end; ++k)
                                found[at(k)] = distances(vertices[at(k)], rest, now);
                        });
        for (std::size_t k = 0; k < found.size(); ++k)
            if (found[k].before > 0.0)
                note(vertices[k], found[k]);
    }

    // From a vertex to the skin opposite, mm; 0 where there is none at rest.
    struct Distances
    {
        double before = 0.0;
        double after = 0.0;
    };

    Distances distances(int vertex, const PickingTree& rest, const PickingTree& now) const
    {
        const Vector3 point = positions_.row(vertex).transpose();
        const auto hit =
            rest.nearest_point(mesh_.points().row(vertex).transpose(), farthest * solid_.thickness);
        if (!hit || hit->distance < nearest * solid_.thickness)
            return {};
        // What was nearest at rest is about as near now: the search need not look farther.
        const auto corners = now.points()(now.triangles().row(hit->triangle), Eigen::indexing::all);
        const double reach = (corners.transpose() * hit->barycentric - point).norm();
        const auto nearer = now.nearest_point(point, reach);
        return {hit->distance, nearer ? nearer->distance : reach};
    }

    void note(int vertex, const Distances& distance)
    {
        change_.rest_least = std::min(change_.rest_least, distance.before);
        change_.rest_most = std::max(change_.rest_most, distance.before);
        change_.least = std::min(change_.least, distance.after);
        change_.most = std::max(change_.most, distance.after);
        double& worst = is_on_wall_[at(vertex)] ? change_.worst_at_walls : change_.worst;
        worst = std::max(worst, std::abs(distance.after / distance.before - 1.0));
    }

    const TriangleMesh& mesh_;
    const ThinSolid& solid_;
    const Points& positions_;
    std::vector<char> is_on_wall_, is_on_lump_;
    ThicknessChange change_;
};

}  // namespace

ThicknessChange thickness_change(const TriangleMesh& mesh, const ThinSolid& solid,
                                 const Points& positions)
{
    if (solid.facets.size() != at(mesh.triangle_count())
        || solid.vertices.size() != at(mesh.vertex_count()))
        throw InvalidInput("the thin solid was found on another mesh; find it on this one");
    if (positions.rows() != mesh.vertex_count())
        throw InvalidInput("there are " + std::to_string(positions.rows())
                           + " positions, the mesh has " + std::to_string(mesh.vertex_count())
                           + " vertices");
    return Gauge(mesh, solid, positions).measure();
}

}  // namespace sheetmorph
