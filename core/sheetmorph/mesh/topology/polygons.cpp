// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/mesh/topology/polygons.h"

#include "sheetmorph/base/errors.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <string>

namespace sheetmorph::mesh
{

namespace
{

// Radians. Sums of angles that differ by less count as equal, so that rounding does not choose the
// diagonal of a rectangle. Chosen far above the rounding of an angle (1e-15).
constexpr double equal_angles = 1e-9;

using Quad = Eigen::RowVector4i;

double angle(const Points& points, int at, int from, int to)
{
    const Vector3 a = points.row(from) - points.row(at);
    const Vector3 b = points.row(to) - points.row(at);
    return std::atan2(a.cross(b).norm(), a.dot(b));
}

Vector3 area_vector(const Points& points, int a, int b, int c)
{
    const Vector3 u = points.row(b) - points.row(a);
    const Vector3 v = points.row(c) - points.row(a);
    return u.cross(v);
}

// A diagonal of a quad: from its first corner to its third.
struct Split
{
    double opposite_angles;
    bool is_folded;  // its two triangles have opposite normals: it runs outside the quad

    Split(const Points& points, const Quad& quad)
        : opposite_angles(angle(points, quad(1), quad(0), quad(2))
                          + angle(points, quad(3), quad(2), quad(0))),
          is_folded(area_vector(points, quad(0), quad(1), quad(2))
                        .dot(area_vector(points, quad(0), quad(2), quad(3)))
                    < 0.0)
    {
    }
};

// The quad, rotated to start at its diagonal.
Quad from_diagonal(const Points& points, const Quad& quad)
{
    const Quad turned(quad(1), quad(2), quad(3), quad(0));
    const Split here(points, quad);
    const Split there(points, turned);
    if (here.is_folded != there.is_folded)
        return here.is_folded ? turned : quad;
    return there.opposite_angles < here.opposite_angles - equal_angles ? turned : quad;
}

// A polygon from which ears are cut one by one.
class EarCutter
{
public:
    EarCutter(const Points& points, const VertexIds& corners) : points_(points), left_(corners)
    {
        for (std::size_t k = 2; k < corners.size(); ++k)
            normal_ += area_vector(points, corners[0], corners[k - 1], corners[k]);
        score_all();
    }

    Eigen::RowVector3i cut()
    {
        // A blocked ear may have become free since its score was computed.
        if (*std::max_element(scores_.begin(), scores_.end()) < 0.0)
            score_all();
        const auto best = std::max_element(scores_.begin(), scores_.end()) - scores_.begin();
        const int tip = static_cast<int>(best);
        const Eigen::RowVector3i ear(corner(tip - 1), corner(tip), corner(tip + 1));
        left_.erase(left_.begin() + best);
        scores_.erase(scores_.begin() + best);
        scores_[(tip + count() - 1) % count()] = score(tip - 1);
        scores_[tip % count()] = score(tip);
        return ear;
    }

    const VertexIds& left() const { return left_; }

private:
    int count() const { return static_cast<int>(left_.size()); }
    void score_all()
    {
        scores_.clear();
        for (int k = 0; k < count(); ++k)
            scores_.push_back(score(k));
    }

    int corner(int k) const { return left_[(k + count()) % count()]; }

    bool is_inside(int vertex, const int ear[3]) const
    {
        for (int k = 0; k < 3; ++k)
            if (vertex == ear[k]
                || area_vector(points_, ear[k], ear[(k + 1) % 3], vertex).dot(normal_) < 0.0)
                return false;
        return true;
    }

    // The smallest angle of an ear, radians; negative if the corner is not an ear.
    double score(int k) const
    {
        const int ear[3] = {corner(k - 1), corner(k), corner(k + 1)};
        if (area_vector(points_, ear[0], ear[1], ear[2]).dot(normal_) <= 0.0)
            return -2.0;
        for (const int vertex : left_)
            if (is_inside(vertex, ear))
                return -1.0;
        return std::min({angle(points_, ear[0], ear[1], ear[2]),
                         angle(points_, ear[1], ear[2], ear[0]),
                         angle(points_, ear[2], ear[0], ear[1])});
    }

    const Points& points_;
    VertexIds left_;
    std::vector<double> scores_;  // by remaining corner
    Vector3 normal_ = Vector3::Zero();
};

}  // namespace

Triangles split_quads(const Points& points, const Quads& quads)
{
    std::vector<int> bad;
    for (int k = 0; k < quads.rows(); ++k)
        if (quads.row(k).minCoeff() < 0 || quads.row(k).maxCoeff() >= points.rows())
            bad.push_back(k);
    if (!bad.empty())
        throw InvalidInput("quads that name vertices outside 0.."
                           + std::to_string(points.rows() - 1) + ": " + list_ids(bad));
    Triangles triangles(2 * quads.rows(), 3);
    for (int k = 0; k < quads.rows(); ++k)
    {
        const Quad quad = from_diagonal(points, quads.row(k));
        triangles.middleRows(2 * k, 2) << quad(0), quad(1), quad(2), quad(0), quad(2), quad(3);
    }
    return triangles;
}

Triangles split_polygon(const Points& points, const VertexIds& corners)
{
    if (corners.size() < 3)
        throw InvalidInput("a polygon of " + std::to_string(corners.size()) + " corners",
                           "it needs at least 3");
    for (const int corner : corners)
        if (corner < 0 || corner >= points.rows())
            throw InvalidInput("a polygon names vertex " + std::to_string(corner) + ", outside 0.."
                               + std::to_string(points.rows() - 1));
    const int count = static_cast<int>(corners.size()) - 2;
    Triangles triangles(count, 3);
    EarCutter cutter(points, corners);
    for (int t = 0; t < count - 2; ++t)
        triangles.row(t) = cutter.cut();
    if (corners.size() == 3)
        triangles << corners[0], corners[1], corners[2];
    else
        triangles.bottomRows(2) = split_quads(points, Eigen::Map<const Quad>(cutter.left().data()));
    return triangles;
}

}  // namespace sheetmorph::mesh
