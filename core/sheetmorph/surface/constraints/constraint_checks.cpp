// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/surface/constraints/constraint_checks.h"

#include "sheetmorph/base/errors.h"

#include <cmath>

namespace sheetmorph::surface
{

namespace
{

void check_ids(const Text& what, const VertexIds& vertices, int vertex_count)
{
    if (vertices.empty())
        throw InvalidInput(what + " has no vertices", "pick at least one or delete it");
    VertexIds outside;
    for (const int vertex : vertices)
        if (vertex < 0 || vertex >= vertex_count)
            outside.push_back(vertex);
    if (!outside.empty())
        throw InvalidInput(what
                               + " names vertices that the mesh does not have: " + list_ids(outside)
                               + " (it has 0 to " + std::to_string(vertex_count - 1) + ")",
                           "pick it again");
}

void check_point(const PointConstraint& point, int triangle_count)
{
    const Text what = point.label();
    if (point.triangle < 0 || point.triangle >= triangle_count)
        throw InvalidInput(what + " lies on triangle " + std::to_string(point.triangle)
                               + ", which the mesh does not have (it has 0 to "
                               + std::to_string(triangle_count - 1) + ")",
                           "pick it again");
    const Vector3& weights = point.barycentric;
    // From recipes with ten digits: weights that users write add up to 1 within 1e-9.
    if (!weights.allFinite() || std::abs(weights.sum() - 1.0) > 1e-9 || weights.minCoeff() < -1e-9)
        throw InvalidInput(what + ": its barycentric coordinates must be three numbers from 0 to 1 "
                                  "with the sum 1");
}

[[noreturn]] void refuse_count(const std::string& what, std::size_t given, std::size_t wanted)
{
    throw InvalidInput("the pose gives " + std::to_string(given) + " " + what + ", the part has "
                       + std::to_string(wanted));
}

void check_motion(const KnownRegion& handle, const RigidMotion& motion)
{
    if (!motion.translation.allFinite() || !motion.rotation_log.allFinite()
        || !motion.pivot.allFinite())
        throw InvalidInput(handle.label() + ": its motion has numbers that are not finite");
}

void check_propagated(const SurfaceConstraints& constraints, const SurfaceTargets& targets)
{
    if (targets.propagated.size() != constraints.propagated.size())
        refuse_count("propagated regions", targets.propagated.size(),
                     constraints.propagated.size());
    for (std::size_t k = 0; k < targets.propagated.size(); ++k)
    {
        const auto count = static_cast<Eigen::Index>(constraints.propagated[k].vertices.size());
        const PropagatedTarget& target = targets.propagated[k];
        const Text what = constraints.propagated[k].label();
        const auto rotations = static_cast<Eigen::Index>(target.rotations.size());
        if (target.positions.rows() != count || target.rotation_logs.rows() != count
            || (rotations != 0 && rotations != count))
            throw InvalidInput(what + " needs " + std::to_string(count)
                               + " positions and rotations");
        if (!target.positions.allFinite() || !target.rotation_logs.allFinite())
            throw InvalidInput(what + " has targets that are not finite numbers");
    }
}

}  // namespace

void check_constraints(const mesh::TriangleMesh& mesh, const SurfaceConstraints& constraints)
{
    if (mesh.triangle_count() == 0)
        throw InvalidInput("the mesh has no triangles", "there is no sheet to bend");
    const int count = mesh.vertex_count();
    for (const KnownRegion& region : constraints.fixed)
        check_ids(region.label(), region.vertices, count);
    for (const KnownRegion& region : constraints.handles)
        check_ids(region.label(), region.vertices, count);
    for (const FormFeature& feature : constraints.features)
        check_ids(feature.label(), feature.vertices, count);
    for (const KnownRegion& region : constraints.propagated)
        check_ids(region.label(), region.vertices, count);
    for (const KnownRegion& stitch : constraints.stitches)
        check_ids(stitch.label(), stitch.vertices, count);
    for (const PointConstraint& point : constraints.points)
        check_point(point, mesh.triangle_count());
}

void check_targets(const SurfaceConstraints& constraints, const SurfaceTargets& targets)
{
    if (targets.handles.size() != constraints.handles.size())
        refuse_count("handle motions", targets.handles.size(), constraints.handles.size());
    if (targets.feature_logs.size() != constraints.features.size())
        refuse_count("feature rotations", targets.feature_logs.size(), constraints.features.size());
    if (targets.points.size() != constraints.points.size())
        refuse_count("point targets", targets.points.size(), constraints.points.size());
    for (std::size_t k = 0; k < targets.handles.size(); ++k)
        check_motion(constraints.handles[k], targets.handles[k]);
    for (std::size_t k = 0; k < targets.feature_logs.size(); ++k)
        if (!targets.feature_logs[k].allFinite())
            throw InvalidInput(constraints.features[k].label()
                               + ": its rotation has numbers that are not finite");
    for (std::size_t k = 0; k < targets.points.size(); ++k)
        if (!targets.points[k].position.allFinite() || !targets.points[k].rotation_log.allFinite())
            throw InvalidInput(constraints.points[k].label()
                               + ": its target has numbers that are not finite");
    check_propagated(constraints, targets);
}

}  // namespace sheetmorph::surface
