// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/numerics/dense_products.h"
#include "sheetmorph/surface/live/surface_response.h"

namespace sheetmorph
{

//! The numbers that decide a part in one pose: how its known vertices move, and the rotations of
//! the sheet at places all over it. The shape is linear in them, coordinate by coordinate, however
//! many handles, welds and contacts drive the part.
class DriverNumbers
{
public:
    //! \param wanted  vertices whose rotation logs a pose is asked for too
    DriverNumbers(const ResponseInput& input, const VertexIds& wanted);

    struct Pose
    {
        Points numbers;  //!< (e, 3) no unit: a change of 1 turns or stretches by 1
        Points logs;     //!< of the wanted vertices
        Points tilts;    //!< likewise what logs cannot tell (log_near())
    };

    Pose of(const SurfaceTargets& targets, const BodyMotions& bodies) const;

private:
    //! A vertex that the pose moves by itself, by a region's row, a handle or a body.
    struct Mover
    {
        Eigen::RowVector3d rest;
        int region, row, handle, body;
    };
    void find_movers();
    void watch(const VertexIds& vertices, Mover mover);
    VertexIds places() const;
    void spread_turns(const VertexIds& vertices);
    static Points given_logs(const SurfaceTargets& targets, const BodyMotions& bodies);
    static Points given_tilts(const SurfaceTargets& targets, const BodyMotions& bodies);
    Eigen::RowVector3d position(const Mover& mover, const SurfaceTargets& targets,
                                const BodyMotions& bodies) const;

    ResponseInput input_;
    double reach_;  // mm: the size of what moves as it is told
    std::vector<Mover> movers_;
    Eigen::Index place_count_ = 0;
    Weights turns_;  // (places and wanted, given): logs of the field from those that are given
};

}  // namespace sheetmorph
