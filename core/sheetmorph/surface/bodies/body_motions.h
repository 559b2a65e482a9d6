// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/mesh/triangle_mesh.h"
#include "sheetmorph/surface/bodies/vertex_roles.h"
#include "sheetmorph/surface/constraints/targets.h"

#include <utility>

namespace sheetmorph::surface
{

//! What is known of the bodies in one pose, before the energy is minimised.
struct BodyMotions
{
    std::vector<RigidMotion> motions;  //!< whole motion of known bodies, about the body's centre
    Points logs;                       //!< (b, 3) rotations, zero where interpolated
    Points tilts;                      //!< (b, 3) what the logs cannot tell: R = exp(tilt) exp(log)
};

//! The rotations a pose knows, all as logarithms (2.6).
struct KnownRotations
{
    Points vertices;  //!< (n, 3) rows read at vertices whose rotation is known
    Points handles;   //!< (h, 3)
    Points bodies;    //!< (b, 3) rows read at bodies whose rotation is known
    Points regions;   //!< (p, 3) mean logarithm of every propagated region
    Points points;    //!< (k, 3) rows read at turned points
};

//! What the rotation field is given. Near whole turns the logarithm of a rotation leaps; there the
//! logs follow smoothly and the rest is a tilt of its own: R = exp(tilt) exp(log), all (2.6).
struct GivenRotations
{
    KnownRotations logs;
    KnownRotations tilts;
    bool is_tilted = false;  //!< false: every tilt is zero
};

//! A part and what decides its vertices.
struct PlacementInput
{
    const mesh::TriangleMesh& rest;
    const SurfaceConstraints& constraints;
    const VertexRoles& roles;
};

//! Where a body is: x -> centre + rotation (x - centre at rest).
struct BodyState
{
    Matrix3 rotation = Matrix3::Identity();
    Vector3 centre = Vector3::Zero();  //!< of the body, mm
};

//! The propagated vertices that lie on one body.
struct Carriers
{
    int body = 0;
    std::vector<std::pair<std::size_t, std::size_t>> places;  //!< (region, place in it)
    Points rest;
    Points targets;
    Points logs;
    std::vector<Matrix3> rotations;
};

Carriers carriers_of(const PlacementInput& part, int body, const SurfaceTargets& targets);

//! The same as a motion about the body's centre; the log is the branch nearest to `reference`.
RigidMotion motion_of(const Body& body, const BodyState& state, const Vector3& reference);

//! Motions of bodies that fixed regions, handles or propagated vertices carry, and the rotations
//! of prescribed ones.
BodyMotions known_body_motions(const PlacementInput& part, const SurfaceTargets& targets);

//! Every rotation the pose gives, for the rotation field.
GivenRotations given_rotations(const PlacementInput& part, const SurfaceTargets& targets,
                               const BodyMotions& bodies);

//! Gives bodies whose translation is open the rotation the field has on them.
//! \param logs, tilts  (n, 3)
void turn_open_bodies(const PlacementInput& part, const Points& logs, const Points& tilts,
                      BodyMotions& bodies);

}  // namespace sheetmorph::surface
