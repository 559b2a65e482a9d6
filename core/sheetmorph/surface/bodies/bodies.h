// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/mesh/triangle_mesh.h"
#include "sheetmorph/surface/constraints/constraints.h"

#include <optional>
#include <set>

namespace sheetmorph::surface
{

//! A link, as seen from the body that follows.
struct Following
{
    int link = 0;                      //!< index of the FeatureLink
    int feature = 0;                   //!< the feature that follows
    int leader = -1;                   //!< index of the leading body; -1: in another part
    Vector3 centre = Vector3::Zero();  //!< of the leading feature at rest, mm
};

//! One rigid body: form features that share vertices or a group, a handle with a free rotation, and
//! stitches that touch these or prescribed vertices.
struct Body
{
    //! How its motion is determined. Fixed, handle and propagated vertices carry the features they
    //! touch.
    enum class Motion
    {
        fixed,
        handle,
        propagated,  //!< best rigid motion of its propagated vertices; a prescribed rotation stays
        prescribed,  //!< rotation from the pose, translation from the energy
        interpolated,  //!< rotation from the field, translation from the energy
        free           //!< both from the energy
    };

    std::vector<int> features;
    std::vector<int> stitches;  //!< stitches carried along
    VertexIds vertices;
    Vector3 centre = Vector3::Zero();
    Motion motion = Motion::free;
    int driver = -1;      //!< the handle, or the feature with a prescribed rotation
    int handle = -1;      //!< the handle with a free rotation that is part of it
    int restricted = -1;  //!< the feature with the FeatureMotion that restricts it
    std::optional<Following> following;
    bool is_bound = false;  //!< a motion or link restricts its translation

    //! Whether its motion is determined before the energy is minimised.
    bool is_known() const
    {
        return motion == Motion::fixed || motion == Motion::handle || motion == Motion::propagated;
    }

    //! Whether its translation depends on the sheet alone.
    bool is_open() const { return !is_known() && !is_bound; }
};

//! All constraints that drive one body.
struct Drivers
{
    bool fixed = false;
    bool propagated = false;
    bool turned = false;  //!< points of its own triangles determine its rotation
    std::set<int> handles;
};

//! Merges features that share vertices or a group, handles with a free rotation, and carried
//! stitches into bodies. decide_motion() determines their motions afterwards.
std::vector<Body> merge_bodies(const mesh::TriangleMesh& mesh,
                               const SurfaceConstraints& constraints);

//! Determines the motion of a body from its drivers and the requests of its features.
//! \throws InvalidInput naming features and contradicting drivers
void decide_motion(Body& body, const Drivers& drivers, const SurfaceConstraints& constraints);

//! Chooses leader and follower of every link. Driven bodies and bodies with a restricted motion
//! lead.
//! \throws InvalidInput naming links and features, if neither side can follow or a link closes a
//!                      loop
void decide_links(const mesh::TriangleMesh& mesh, const SurfaceConstraints& constraints,
                  std::vector<Body>& bodies);

//! Body indices, leaders before their followers.
std::vector<int> leaders_first(const std::vector<Body>& bodies);

//! Mean of a feature's vertices at rest, mm.
Vector3 centre_of(const mesh::TriangleMesh& mesh, const VertexIds& vertices);

//! For messages: "feature 'hole1', feature 'hole2' (one body, since they share vertices)".
Text names_of(const Body& body, const SurfaceConstraints& constraints);

}  // namespace sheetmorph::surface
