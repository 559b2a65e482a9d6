// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/surface/live/drawn_motions.h"

#include "sheetmorph/base/angles.h"
#include "sheetmorph/base/index.h"

#include <cmath>

namespace sheetmorph::surface
{

namespace
{

// Largest shift of a handle in the poses, relative to the part's size. Chosen: a drag seldom moves
// a handle by more than a third of the part. Farther poses are solved exactly; only speed suffers.
constexpr double farthest_shift = 0.35;

// Largest rotation of the handles (radians) and number of poses, by the number of handles. Chosen:
// one handle may turn nearly half a turn, where a log is still unique. More handles combine their
// rotations, so they need more poses and a smaller range.
struct Own
{
    double farthest;
    int poses;
};

Own own(std::size_t turning)
{
    if (turning == 1)
        return {165.0 * degree, 128};
    return turning == 2 ? Own{100.0 * degree, 256} : Own{75.0 * degree, 512};
}

}  // namespace

double DrawnMotions::share()
{
    return 2.0 * static_cast<double>(bits_()) / static_cast<double>(std::mt19937::max()) - 1.0;
}

Vector3 DrawnMotions::within(double radius)
{
    Vector3 point;
    do
    {
        const double x = share(), y = share(), z = share();
        point = Vector3(x, y, z);
    } while (point.squaredNorm() > 1.0);
    return radius * point;
}

RigidMotion DrawnMotions::next(const mesh::TriangleMesh& mesh, const VertexIds& handle,
                               const RigidMotion& start, double farthest)
{
    RigidMotion motion;
    motion.pivot = mesh.points()(handle, Eigen::indexing::all).colwise().mean().transpose();
    motion.rotation_log = start.rotation_log + within(0.5 * farthest);  // (2.6)
    motion.translation =
        start.apply(motion.pivot) - motion.pivot + within(farthest_shift * mesh.size());
    return motion;
}

std::vector<SurfaceTargets> own_poses(const mesh::TriangleMesh& mesh,
                                      const SurfaceConstraints& constraints,
                                      const SurfaceTargets& start, const std::vector<int>& turning)
{
    std::vector<SurfaceTargets> poses = {start};
    const Own how = own(turning.size());
    DrawnMotions drawn;
    for (int pose = 0; pose < how.poses && !turning.empty(); ++pose)
    {
        poses.push_back(start);
        for (const int k : turning)
        {
            const KnownRegion& handle = constraints.handles[at(k)];
            RigidMotion& motion = poses.back().handles[at(k)];
            motion = drawn.next(mesh, handle.vertices, motion,
                                handle.is_rotation_free ? 0.0 : how.farthest);
        }
    }
    return poses;
}

}  // namespace sheetmorph::surface
