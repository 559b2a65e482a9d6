// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/mesh/triangle_mesh.h"
#include "sheetmorph/surface/bodies/vertex_roles.h"
#include "sheetmorph/surface/constraints/targets.h"

#include <utility>

namespace sheetmorph::surface
{

//! Data on the bodies in one pose that are determined before the energy is minimised.
struct BodyMotions
{
    std::vector<RigidMotion> motions;  //!< of prescribed bodies, about their centres
    Points logs;                       //!< (b, 3) rotations; zero if interpolated
    Points tilts;                      //!< (b, 3) remainder of the rotation: R = exp(tilt) exp(log)
};

//! The prescribed rotations of a pose as logarithms (2.6).
struct KnownRotations
{
    Points vertices;  //!< (n, 3) valid at vertices with a prescribed rotation
    Points handles;   //!< (h, 3)
    Points bodies;    //!< (b, 3) valid at bodies with a prescribed rotation
    Points regions;   //!< (p, 3) mean logarithm of every propagated region
    Points points;    //!< (k, 3) valid at points with a prescribed rotation
};

//! Input of the rotation field. Near full turns the logarithm of a rotation jumps. The logs here
//! stay continuous, and a separate tilt contains the remainder: R = exp(tilt) exp(log), both as
//! (2.6).
struct GivenRotations
{
    KnownRotations logs;
    KnownRotations tilts;
    bool is_tilted = false;  //!< false: all tilts are zero
};

//! A part with its constraints and the roles of its vertices.
struct PlacementInput
{
    const mesh::TriangleMesh& rest;
    const SurfaceConstraints& constraints;
    const VertexRoles& roles;
};

//! State of a body: x -> centre + rotation (x - centre at rest).
struct BodyState
{
    Matrix3 rotation = Matrix3::Identity();
    Vector3 centre = Vector3::Zero();  //!< centre of the body, mm
};

//! The propagated vertices on one body.
struct Carriers
{
    int body = 0;
    std::vector<std::pair<std::size_t, std::size_t>> places;  //!< (region, index in it)
    Points rest;
    Points targets;
    Points logs;
    std::vector<Matrix3> rotations;
};

Carriers carriers_of(const PlacementInput& part, int body, const SurfaceTargets& targets);

//! Converts a state to a motion about the body's centre. The log is the branch nearest to
//! `reference`.
RigidMotion motion_of(const Body& body, const BodyState& state, const Vector3& reference);

//! Motions of bodies that fixed regions, handles or propagated vertices carry, and the rotations of
//! prescribed ones.
BodyMotions known_body_motions(const PlacementInput& part, const SurfaceTargets& targets);

//! All rotations that the pose gives to the rotation field (2.8).
GivenRotations given_rotations(const PlacementInput& part, const SurfaceTargets& targets,
                               const BodyMotions& bodies);

//! Assigns the rotation of the field to bodies with an undetermined motion.
//! \param logs, tilts  (n, 3)
void turn_open_bodies(const PlacementInput& part, const Points& logs, const Points& tilts,
                      BodyMotions& bodies);

}  // namespace sheetmorph::surface
