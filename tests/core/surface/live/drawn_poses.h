// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "shapes/draw.h"
#include "surface/cases.h"

namespace sheetmorph::surface::cases
{

//! Poses drawn at random, the same ones every time.
class DrawnPoses : public shapes::Draw
{
public:
    explicit DrawnPoses(unsigned seed = 1) : Draw(seed) {}

    //! The pose of a case with some handles turned by up to `degrees` and moved by up to a third of
    //! the part, the others as they are.
    SurfaceTargets of(const Case& one, const std::vector<int>& handles, double degrees)
    {
        SurfaceTargets targets = one.targets;
        for (const int handle : handles)
        {
            RigidMotion& motion = targets.handles[static_cast<std::size_t>(handle)];
            const VertexIds& vertices =
                one.constraints.handles[static_cast<std::size_t>(handle)].vertices;
            motion.pivot = one.mesh.points().row(vertices.front()).transpose();
            if (!one.constraints.handles[static_cast<std::size_t>(handle)].is_rotation_free)
                motion.rotation_log = within(degrees * shapes::pi / 360.0);
            motion.translation = within(0.3 * one.mesh.size());
        }
        for (PointTarget& point : targets.points)
            point.position += within(0.02 * one.mesh.size());
        return targets;
    }

    std::vector<SurfaceTargets> many(int count, const Case& one, const std::vector<int>& handles,
                                     double degrees)
    {
        std::vector<SurfaceTargets> poses = {one.targets};
        for (int k = 0; k < count; ++k)
            poses.push_back(of(one, handles, degrees));
        return poses;
    }
};

}  // namespace sheetmorph::surface::cases
