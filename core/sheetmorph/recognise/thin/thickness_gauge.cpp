// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/recognise/thin/thickness_gauge.h"

#include "sheetmorph/base/errors.h"
#include "sheetmorph/base/index.h"
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
        for (const int vertex : vertices)
        {
            const Vector3 before = mesh_.points().row(vertex).transpose();
            const Vector3 after = positions_.row(vertex).transpose();
            note(vertex, rest.nearest_point(before)->distance, now.nearest_point(after)->distance);
        }
    }

    void note(int vertex, double before, double after)
    {
        if (before > farthest * solid_.thickness || before < nearest * solid_.thickness)
            return;
        change_.rest_least = std::min(change_.rest_least, before);
        change_.rest_most = std::max(change_.rest_most, before);
        change_.least = std::min(change_.least, after);
        change_.most = std::max(change_.most, after);
        double& worst = is_on_wall_[at(vertex)] ? change_.worst_at_walls : change_.worst;
        worst = std::max(worst, std::abs(after / before - 1.0));
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
