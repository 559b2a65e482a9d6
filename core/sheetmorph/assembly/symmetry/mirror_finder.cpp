// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/assembly/symmetry/mirror_finder.h"

#include "sheetmorph/base/index.h"

#include <Eigen/Geometry>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <limits>

namespace sheetmorph
{

namespace
{

// Of the assembly's size: how far apart a vertex and its mirrored counterpart may be.
constexpr double relative_tolerance = 1e-6;

long long key_of(const std::array<long long, 3>& cell)
{
    const auto mixed = static_cast<unsigned long long>(cell[0]) * 73856093ULL
                       ^ static_cast<unsigned long long>(cell[1]) * 19349663ULL
                       ^ static_cast<unsigned long long>(cell[2]) * 83492791ULL;
    return static_cast<long long>(mixed);
}

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

// Barycentric coordinates of the point of a triangle's plane nearest to a position.
Vector3 barycentric(const TriangleMesh& mesh, int triangle, const Vector3& position)
{
    const auto corner = [&](int k)
    { return Vector3(mesh.points().row(mesh.triangles()(triangle, k)).transpose()); };
    Eigen::Matrix<double, 3, 2> sides;
    sides << corner(1) - corner(0), corner(2) - corner(0);
    const Eigen::Vector2d tu = sides.colPivHouseholderQr().solve(position - corner(0));
    return {1.0 - tu.sum(), tu(0), tu(1)};
}

// Whether a position is in the box around a triangle.
bool is_around(const TriangleMesh& mesh, int triangle, const Vector3& position, double margin)
{
    for (int axis = 0; axis < 3; ++axis)
    {
        const auto corner = [&](int k)
        { return mesh.points()(mesh.triangles()(triangle, k), axis); };
        if (position(axis) < std::min({corner(0), corner(1), corner(2)}) - margin
            || position(axis) > std::max({corner(0), corner(1), corner(2)}) + margin)
            return false;
    }
    return true;
}

}  // namespace

MirrorFinder::MirrorFinder(const Assembly& assembly)
    : assembly_(assembly),
      mirror_(*assembly.symmetry),
      tolerance_(relative_tolerance * size_of(assembly))
{
}

MirrorFinder::Cell MirrorFinder::cell_at(const Vector3& position) const
{
    const Vector3 offset = (position - assembly_.symmetry->point) / (2.0 * tolerance_);
    return {std::llround(offset(0)), std::llround(offset(1)), std::llround(offset(2))};
}

const MirrorFinder::Cells& MirrorFinder::cells_of(int part)
{
    const auto [found, is_new] = cells_.try_emplace(part);
    if (is_new)
    {
        const Points& points = assembly_.parts[at(part)].mesh.points();
        for (int i = 0; i < static_cast<int>(points.rows()); ++i)
            found->second.emplace(key_of(cell_at(points.row(i).transpose())), i);
    }
    return found->second;
}

VertexIds MirrorFinder::vertices_at(int part, const Vector3& position)
{
    const Points& points = assembly_.parts[at(part)].mesh.points();
    const Cells& cells = cells_of(part);
    const Cell middle = cell_at(position);
    VertexIds found;
    for (int k = 0; k < 27; ++k)
    {
        const Cell cell = {middle[0] + k % 3 - 1, middle[1] + k / 3 % 3 - 1, middle[2] + k / 9 - 1};
        const auto [first, last] = cells.equal_range(key_of(cell));
        for (auto entry = first; entry != last; ++entry)
            if (is_near(points.row(entry->second).transpose(), position)
                && std::find(found.begin(), found.end(), entry->second) == found.end())
                found.push_back(entry->second);
    }
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
    const TriangleMesh& mesh = assembly_.parts[at(point.part)].mesh;
    Vector3 position = Vector3::Zero();
    for (int k = 0; k < 3; ++k)
        position += point.constraint.barycentric(k)
                    * mesh.points().row(mesh.triangles()(point.constraint.triangle, k)).transpose();
    return position;
}

std::optional<PartPoint> MirrorFinder::on_part(int part, const Vector3& position) const
{
    const TriangleMesh& mesh = assembly_.parts[at(part)].mesh;
    PartPoint found;
    found.part = part;
    for (int t = 0; t < mesh.triangle_count(); ++t)
    {
        if (!is_around(mesh, t, position, tolerance_))
            continue;
        found.constraint.triangle = t;
        Vector3 weights = barycentric(mesh, t, position).cwiseMax(0.0);
        if (!weights.allFinite())
            continue;
        found.constraint.barycentric = weights / weights.sum();
        if (is_near(this->position(found), position))
            return found;
    }
    return std::nullopt;
}

std::optional<PartPoint> MirrorFinder::point(const PartPoint& given) const
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

}  // namespace sheetmorph
