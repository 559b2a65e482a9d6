// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/surface/solve/placement.h"

#include "sheetmorph/base/index.h"
#include "sheetmorph/surface/bodies/clamping.h"

namespace sheetmorph::surface
{

namespace
{

// Motions with precomputed rotation matrices, for many points.
struct Movers
{
    explicit Movers(const std::vector<RigidMotion>& given) : motions(given)
    {
        for (const RigidMotion& motion : motions)
            rotations.push_back(motion.rotation());
    }

    Vector3 moved(int mover, const Vector3& point) const
    {
        const RigidMotion& motion = motions[at(mover)];
        return motion.rotation_log.isZero(0.0)
                   ? Vector3(point + motion.translation)
                   : Vector3(motion.pivot + motion.translation
                             + rotations[at(mover)] * (point - motion.pivot));
    }

    const std::vector<RigidMotion>& motions;
    std::vector<Matrix3> rotations;
};

// Calls place(vertex, position) for every vertex with a prescribed position.
template <typename Place>
void place_known(const PlacementInput& part, const SurfaceTargets& targets,
                 const BodyMotions& bodies, Place place)
{
    for (std::size_t region = 0; region < part.constraints.propagated.size(); ++region)
    {
        const VertexIds& vertices = part.constraints.propagated[region].vertices;
        for (std::size_t k = 0; k < vertices.size(); ++k)
            if (part.roles.role[at(vertices[k])] == Role::propagated)
                place(vertices[k], Vector3(targets.propagated[region].positions.row(
                                       static_cast<Eigen::Index>(k))));
    }
    const Movers of_handles(targets.handles), of_bodies(bodies.motions);
    for (int i = 0; i < part.rest.vertex_count(); ++i)
    {
        const Vector3 point = part.rest.points().row(i).transpose();
        const int owner = part.roles.owner[at(i)];
        if (part.roles.role[at(i)] == Role::handle)
            place(i, of_handles.moved(owner, point));
        else if (part.roles.role[at(i)] == Role::body)
            place(i, of_bodies.moved(owner, point));
    }
}

}  // namespace

Eigen::MatrixXd known_displacements(const PlacementInput& part, const SurfaceTargets& targets,
                                    const BodyMotions& bodies)
{
    Eigen::MatrixXd offset = Eigen::MatrixXd::Zero(part.rest.vertex_count(), 3);
    place_known(part, targets, bodies,
                [&](int vertex, const Vector3& position)
                { offset.row(vertex) = position.transpose() - part.rest.points().row(vertex); });
    if (!part.roles.clamps.empty())
        place_clamped(part, given_rotations(part, targets, bodies), offset);
    return offset;
}

void complete_bodies(const PlacementInput& part, const Eigen::MatrixXd& displacements,
                     BodyMotions& bodies)
{
    for (std::size_t k = 0; k < part.roles.bodies.size(); ++k)
    {
        const Body& body = part.roles.bodies[k];
        if (!body.is_open())
            continue;
        const int first = body.vertices.front();
        const Vector3 start = part.rest.points().row(first).transpose();
        RigidMotion& motion = bodies.motions[k];
        motion.translation.setZero();
        motion.translation = displacements.row(first).transpose() - (motion.apply(start) - start);
    }
}

Points placed_positions(const PlacementInput& part, const SurfaceTargets& targets,
                        const BodyMotions& bodies, const Eigen::MatrixXd& displacements)
{
    Points positions = part.rest.points() + displacements;
    place_known(part, targets, bodies,
                [&](int vertex, const Vector3& position)
                { positions.row(vertex) = position.transpose(); });
    return positions;
}

std::vector<RigidMotion> feature_motions(const PlacementInput& part, const BodyMotions& bodies)
{
    std::vector<RigidMotion> motions(part.constraints.features.size());
    for (std::size_t k = 0; k < part.roles.bodies.size(); ++k)
        for (const int feature : part.roles.bodies[k].features)
        {
            const VertexIds& vertices = part.constraints.features[at(feature)].vertices;
            Vector3 centre = Vector3::Zero();
            for (const int vertex : vertices)
                centre += part.rest.points().row(vertex).transpose();
            centre /= static_cast<double>(vertices.size());
            RigidMotion& motion = motions[at(feature)];
            motion = bodies.motions[k];
            motion.pivot = centre;
            motion.translation = bodies.motions[k].apply(centre) - centre;
        }
    return motions;
}

}  // namespace sheetmorph::surface
