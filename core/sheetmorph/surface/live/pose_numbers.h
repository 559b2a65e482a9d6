// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/numerics/products/dense_products.h"
#include "sheetmorph/surface/solve/placement.h"
#include "sheetmorph/surface/solve/prepared_surface.h"

namespace sheetmorph::surface
{

//! A pose and the prescribed motions of its bodies. The targets must outlive it.
struct KnownPose
{
    KnownPose(const PreparedSurface& part, const SurfaceTargets& pose);

    const SurfaceTargets& targets;
    BodyMotions bodies;
};

//! The reduced inputs of a part in one pose: displacements of prescribed vertices and points, and
//! rotations of the sheet at places all over it. The shape is linear in them, coordinate by
//! coordinate, for any number of handles, welds, contacts and points.
class PoseNumbers
{
public:
    //! \param samples  poses whose rotations span those of all poses
    PoseNumbers(const PreparedSurface& part, const std::vector<KnownPose>& samples);

    //! The rotations of a pose in the basis of the samples' rotations.
    struct Turns
    {
        Points logs;   //!< (m, 3) radians (2.6)
        Points tilts;  //!< (m, 3) remainder that logs cannot represent (log_near()); no rows: zero
        double miss;   //!< radians: largest error of a given rotation
    };
    Turns turns(const KnownPose& pose) const;

    //! (r, m): influence of each basis rotation on the vertices, by the rotation field. After
    //! keep() only of the kept vertices.
    const numerics::Weights& field() const { return field_; }

    //! The row of a vertex in field().
    Eigen::Index row_of(int vertex) const;

    //! (e, 3) the inputs, item by item, no unit: a change of 1 is a rotation or a strain of order
    //! 1.
    Points of(const KnownPose& pose, const Turns& turns) const;

    //! The item of every row of of().
    std::vector<int> items() const;

    //! The items that are not places.
    std::vector<int> movers() const;

    //! Keeps only these items (ascending), and the field at their places and some vertices.
    void keep(const std::vector<int>& items, VertexIds vertices);

    //! Keeps only these items, and the whole field.
    void keep(const std::vector<int>& items);

private:
    //! One row for a vertex moved by the pose or for a point; three rows for a place.
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
        Eigen::Index row = 0;     //!< row within the region
        Eigen::RowVector3d rest;  //!< mm
    };
    void span_turns(const std::vector<KnownPose>& samples);
    void find_movers();
    void watch(const VertexIds& vertices, Item item);
    void find_places();
    Eigen::RowVector3d displacement(const Item& item, const KnownPose& pose) const;

    const PreparedSurface& part_;
    double reach_;                  // mm: size of the smallest region with prescribed motion
    numerics::Weights directions_;  // (m, g) basis of the given rotations
    numerics::Weights field_;
    VertexIds kept_;  // vertices of the rows of field_, ascending; empty: all
    std::vector<Item> items_;
};

}  // namespace sheetmorph::surface
