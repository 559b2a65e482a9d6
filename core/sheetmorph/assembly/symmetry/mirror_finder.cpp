// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/assembly/symmetry/mirror_finder.h"

#include "sheetmorph/base/index.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>

namespace sheetmorph::assembly
{

namespace
{

// How far apart a vertex and its mirrored counterpart may be, relative to the assembly's size. From
// files with seven digits: two coordinates are exact to 1e-7 each.
constexpr double relative_tolerance = 1e-6;

double size_of(const Assembly& assembly)
{
    Vector3 low = Vector3::Constant(std::numeric_limits<double>::infinity());
    Vector3 high = -low;
    for (const Part& part : assembly.parts)
    {
        low = low.cwiseMin(part.mesh.points().colwise().minCoeff().transpose());
        high = high.cwiseMax(part.mesh.points().colwise().maxCoeff().transpose());
    }
    return (high - low).norm();
}

}  // namespace

MirrorFinder::MirrorFinder(const Assembly& assembly)
    : assembly_(assembly),
      mirror_(*assembly.symmetry),
      tolerance_(relative_tolerance * size_of(assembly))
{
}

VertexIds MirrorFinder::vertices_at(int part, const Vector3& position)
{
    const Points& points = assembly_.parts[at(part)].mesh.points();
    const mesh::PointGrid& grid = grids_.try_emplace(part, points, 4.0 * tolerance_).first->second;
    VertexIds found;
    grid.for_each_in(position.array() - tolerance_, position.array() + tolerance_,
                     [&](int vertex)
                     {
                         if (is_near(points.row(vertex).transpose(), position))
                             found.push_back(vertex);
                     });
    return found;
}

std::vector<int> MirrorFinder::parts_from(int part) const
{
    std::vector<int> parts = {part};
    for (int other = 0; other < static_cast<int>(assembly_.parts.size()); ++other)
        if (other != part)
            parts.push_back(other);
    return parts;
}

std::optional<PartRegion> MirrorFinder::region(int part, const VertexIds& vertices)
{
    const Points& points = assembly_.parts[at(part)].mesh.points();
    missing_.clear();
    for (const int candidate : parts_from(part))
    {
        VertexIds found;
        bool is_whole = true;
        for (const int vertex : vertices)
        {
            const VertexIds here =
                vertices_at(candidate, mirror_.point(points.row(vertex).transpose()));
            found.insert(found.end(), here.begin(), here.end());
            is_whole = is_whole && !here.empty();
            if (here.empty() && candidate == part)
                missing_.push_back(vertex);
            if (!is_whole && candidate != part)
                break;
        }
        std::sort(found.begin(), found.end());
        found.erase(std::unique(found.begin(), found.end()), found.end());
        if (is_whole)
            return PartRegion{"", candidate, found};
    }
    return std::nullopt;
}

Vector3 MirrorFinder::position(const PartPoint& point) const
{
    const mesh::TriangleMesh& mesh = assembly_.parts[at(point.part)].mesh;
    Vector3 position = Vector3::Zero();
    for (int k = 0; k < 3; ++k)
        position += point.constraint.barycentric(k)
                    * mesh.points().row(mesh.triangles()(point.constraint.triangle, k)).transpose();
    return position;
}

std::optional<PartPoint> MirrorFinder::on_part(int part, const Vector3& position)
{
    const mesh::TriangleMesh& mesh = assembly_.parts[at(part)].mesh;
    const mesh::PickingTree& tree = trees_.try_emplace(part, mesh).first->second;
    const std::optional<mesh::Hit> hit = tree.nearest_point(position, tolerance_);
    if (!hit)
        return std::nullopt;
    PartPoint found;
    found.part = part;
    found.constraint.triangle = hit->triangle;
    found.constraint.barycentric = hit->barycentric;
    return found;
}

std::optional<PartPoint> MirrorFinder::point(const PartPoint& given)
{
    const Vector3 wanted = mirror_.point(position(given));
    for (const int part : parts_from(given.part))
        if (std::optional<PartPoint> found = on_part(part, wanted))
        {
            found->constraint.is_turned = given.constraint.is_turned;
            found->constraint.is_rotation_free = given.constraint.is_rotation_free;
            return found;
        }
    return std::nullopt;
}

}  // namespace sheetmorph::assembly
