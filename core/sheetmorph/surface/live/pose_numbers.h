// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/numerics/products/dense_products.h"
#include "sheetmorph/surface/solve/placement.h"
#include "sheetmorph/surface/solve/prepared_surface.h"

namespace sheetmorph::surface
{

//! A pose and what it tells of the bodies; the targets outlive it.
struct KnownPose
{
    KnownPose(const PreparedSurface& part, const SurfaceTargets& pose);

    const SurfaceTargets& targets;
    BodyMotions bodies;
};

//! The numbers that decide a part in one pose: how its known vertices and points move, and the
//! rotations of the sheet at places all over it. The shape is linear in them, coordinate by
//! coordinate, whatever drives the part: any number of handles, welds, contacts and points.
class PoseNumbers
{
public:
    //! \param samples  poses whose rotations span those of all poses
    PoseNumbers(const PreparedSurface& part, const std::vector<KnownPose>& samples);

    //! The rotations that a pose gives, as numbers of those that the samples have in common.
    struct Turns
    {
        Points logs;   //!< (m, 3) radians (2.6)
        Points tilts;  //!< (m, 3) what logs cannot tell (log_near()); no rows: nothing
        double miss;   //!< radians: by how much they miss a given rotation
    };
    Turns turns(const KnownPose& pose) const;

    //! (r, m): how vertices turn with each of them, by the rotation field: every one, or those
    //! kept.
    const numerics::Weights& field() const { return field_; }

    //! The row of a vertex in field().
    Eigen::Index row_of(int vertex) const;

    //! (e, 3) no unit: a change of 1 turns or stretches by 1. An item after the other.
    Points of(const KnownPose& pose, const Turns& turns) const;

    //! The item of every row of of().
    std::vector<int> items() const;

    //! The items that are no places.
    std::vector<int> movers() const;

    //! Only these items from now on, ascending, and the field at their places and some vertices.
    void keep(const std::vector<int>& items, VertexIds vertices);

    //! Only these items, and the whole field.
    void keep(const std::vector<int>& items);

private:
    //! One row: a vertex that the pose moves by itself, or a point. Three rows: a place.
    struct Item
    {
        enum class Kind : char
        {
            region,
            handle,
            body,
            point,
            place
        };
        Kind kind;
        int index;                //!< of the region, handle, body, point or vertex
        Eigen::Index row = 0;     //!< within the region
        Eigen::RowVector3d rest;  //!< mm
    };
    void span_turns(const std::vector<KnownPose>& samples);
    void find_movers();
    void watch(const VertexIds& vertices, Item item);
    void find_places();
    Eigen::RowVector3d displacement(const Item& item, const KnownPose& pose) const;

    const PreparedSurface& part_;
    double reach_;                  // mm: the size of what has a prescribed motion
    numerics::Weights directions_;  // (m, g) of the given rotations
    numerics::Weights field_;
    VertexIds kept_;  // the vertices of its rows, ascending; empty: all
    std::vector<Item> items_;
};

}  // namespace sheetmorph::surface
