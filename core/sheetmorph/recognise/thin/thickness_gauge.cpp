// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/recognise/thin/thickness_gauge.h"

#include "sheetmorph/base/errors.h"
#include "sheetmorph/base/index.h"
#include "sheetmorph/base/threads/parallel.h"
#include "sheetmorph/recognise/thin/across_sheet.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace sheetmorph::recognise
{

namespace
{

// In thicknesses. At rest, a nearest point outside the range up to farthest_skin is not on the
// opposite skin. Chosen: nearer points are on the wall of a hole or on a ledge.
constexpr double nearest = 0.3;

std::vector<char> flags(const mesh::TriangleMesh& mesh, const std::vector<VertexIds>& pieces)
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
    Gauge(const mesh::TriangleMesh& mesh, const ThinSolid& solid, const Points& positions)
        : mesh_(mesh),
          solid_(solid),
          positions_(positions),
          across_(mesh, solid),
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
    // Measures from the vertices of one skin to the other skin.
    void from(SolidSide side, SolidSide other)
    {
        VertexIds vertices;
        for (int v = 0; v < mesh_.vertex_count(); ++v)
            if (solid_.vertices[at(v)] == side && !is_on_lump_[at(v)])
                vertices.push_back(v);
        std::vector<Distances> found(vertices.size());
        parallel_ranges(static_cast<Eigen::Index>(vertices.size()), microsecond_items,
                        [&](auto begin, auto end)
                        {
                            for (auto k = begin; k < end; ++k)
                                found[at(k)] = distances(vertices[at(k)], other);
                        });
        for (std::size_t k = 0; k < found.size(); ++k)
            if (found[k].before > 0.0)
                note(vertices[k], found[k]);
    }

    // From a vertex to the other skin across its sheet, mm; 0 if there is none at rest.
    struct Distances
    {
        double before = 0.0;
        double after = 0.0;
    };

    Distances distances(int vertex, SolidSide other) const
    {
        const std::vector<mesh::Hit> places = across_.places(vertex, other);
        const double thickness = across_.thickness(vertex);
        if (places.empty() || places.front().distance > farthest_skin * thickness
            || places.front().distance < nearest * thickness)
            return {};
        const Vector3 point = positions_.row(vertex).transpose();
        const mesh::Hit now = across_.nearest_around(places.front().triangle, point, positions_);
        return {places.front().distance, now.distance};
    }

    void note(int vertex, const Distances& distance)
    {
        change_.rest_least = std::min(change_.rest_least, distance.before);
        change_.rest_most = std::max(change_.rest_most, distance.before);
        change_.least = std::min(change_.least, distance.after);
        change_.most = std::max(change_.most, distance.after);
        const double change = std::abs(distance.after / distance.before - 1.0);
        if (change_.place.vertex < 0 || change > std::max(change_.worst, change_.worst_at_walls))
            change_.place = {vertex, distance.before, distance.after};
        double& worst = is_on_wall_[at(vertex)] ? change_.worst_at_walls : change_.worst;
        worst = std::max(worst, change);
    }

    const mesh::TriangleMesh& mesh_;
    const ThinSolid& solid_;
    const Points& positions_;
    AcrossSheet across_;
    std::vector<char> is_on_wall_, is_on_lump_;
    ThicknessChange change_;
};

}  // namespace

ThicknessChange thickness_change(const mesh::TriangleMesh& mesh, const ThinSolid& solid,
                                 const Points& positions)
{
    if (solid.facets.size() != at(mesh.triangle_count())
        || solid.vertices.size() != at(mesh.vertex_count()))
        throw InvalidInput("the thin solid was found on another mesh", "recognise it on this one");
    if (positions.rows() != mesh.vertex_count())
        throw InvalidInput("there are " + std::to_string(positions.rows())
                           + " positions, the mesh has " + std::to_string(mesh.vertex_count())
                           + " vertices");
    return Gauge(mesh, solid, positions).measure();
}

}  // namespace sheetmorph::recognise
