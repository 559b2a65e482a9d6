// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "shapes/thin.h"

#include <cmath>

namespace sheetmorph::shapes
{

//! A folded sheet with two skins, and the part of the fold that each of its vertices is in.
struct FoldedSheet
{
    mesh::TriangleMesh mesh;
    std::vector<int> leg;       //!< (n) by vertex
    std::vector<double> along;  //!< (n) mm: the arc length in the middle of the sheet
    double thickness = 0.0;
};

//! Draws the middle line of a folded sheet in the plane y = 0 and extrudes it along y.
class Folding
{
public:
    Folding(double thickness, double edge) : thickness_(thickness), edge_(edge) { add(0.0); }

    //! A flat leg, mm.
    Folding& straight(double length, int leg)
    {
        begin(leg);
        const Vector3 start = place_;
        const int steps = std::max(2, static_cast<int>(std::lround(length / edge_)));
        for (int k = 1; k <= steps; ++k)
        {
            place_ = start + length * k / steps * heading();
            add(length / steps);
        }
        return *this;
    }

    //! A bend, degrees, to the left if positive. \\param inner  radius of the inner skin, mm
    Folding& bend(double degrees, double inner, int leg)
    {
        begin(leg);
        const double angle = degrees * pi / 180.0, radius = inner + 0.5 * thickness_;
        const double side = angle > 0.0 ? 1.0 : -1.0;
        const Vector3 centre = place_ + side * radius * normal();
        const int steps = std::max(4, static_cast<int>(std::lround(std::abs(degrees) / 15.0)));
        const double from = turn_;
        for (int k = 1; k <= steps; ++k)
        {
            turn_ = from + angle * k / steps;
            place_ = centre - side * radius * normal();
            add(radius * std::abs(angle) / steps);
        }
        return *this;
    }

    //! The solid, `width` mm along y.
    FoldedSheet extruded(double width) const
    {
        const int across = std::max(3, static_cast<int>(std::lround(width / edge_)));
        const int stations = static_cast<int>(places_.size());
        // A grid of the same order: station by station is x, across is y.
        const mesh::TriangleMesh flat = grid(stations - 1, across, stations - 1.0, width);
        Points points(flat.vertex_count(), 3), normals(flat.vertex_count(), 3);
        std::vector<int> station;
        for (int v = 0; v < flat.vertex_count(); ++v)
        {
            const auto k = static_cast<std::size_t>(std::lround(flat.points()(v, 0)));
            station.push_back(static_cast<int>(k));
            normals.row(v) = normals_[k].transpose();
            points.row(v) = (places_[k] + 0.5 * thickness_ * normals_[k]).transpose();
            points(v, 1) = flat.points()(v, 1);
        }
        FoldedSheet found{
            two_skinned(mesh::TriangleMesh(points, flat.triangles()), normals, thickness_),
            {},
            {},
            thickness_};
        // Of a vertex of the wall: that of the nearest one above it.
        const Points& whole = found.mesh.points();
        for (int v = 0; v < found.mesh.vertex_count(); ++v)
        {
            int nearest = v % flat.vertex_count();
            if (v >= 2 * flat.vertex_count())
                (whole.topRows(flat.vertex_count()).rowwise() - whole.row(v))
                    .rowwise()
                    .squaredNorm()
                    .minCoeff(&nearest);
            const auto k = static_cast<std::size_t>(station[static_cast<std::size_t>(nearest)]);
            found.leg.push_back(legs_[k]);
            found.along.push_back(lengths_[k]);
        }
        return found;
    }

private:
    Vector3 heading() const { return {std::cos(turn_), 0.0, std::sin(turn_)}; }
    Vector3 normal() const { return {-std::sin(turn_), 0.0, std::cos(turn_)}; }

    // The first station is on the first leg.
    void begin(int leg)
    {
        if (places_.size() == 1)
            legs_.front() = leg;
        leg_ = leg;
    }

    void add(double step)
    {
        places_.push_back(place_);
        normals_.push_back(normal());
        legs_.push_back(leg_);
        lengths_.push_back(lengths_.empty() ? 0.0 : lengths_.back() + step);
    }

    double thickness_, edge_, turn_ = 0.0;
    int leg_ = 0;
    Vector3 place_ = Vector3::Zero();
    std::vector<Vector3> places_, normals_;
    std::vector<int> legs_;
    std::vector<double> lengths_;
};

}  // namespace sheetmorph::shapes
