// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/mesh/triangle_mesh.h"
#include "sheetmorph/surface/constraints/constraints.h"

#include <optional>
#include <set>

namespace sheetmorph::surface
{

//! A link as one of its two bodies keeps it.
struct Following
{
    int link = 0;                      //!< index of the FeatureLink
    int feature = 0;                   //!< the feature that follows
    int leader = -1;                   //!< the body that leads; -1: in another part
    Vector3 centre = Vector3::Zero();  //!< of the leading feature at rest, mm
};

//! Form features that share vertices or a group, a handle whose rotation is free, and stitches that
//! these or known vertices touch: they move as one rigid body.
struct Body
{
    //! What decides its motion. Fixed, handle and propagated vertices carry the features they
    //! touch along with them.
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
    std::vector<int> stitches;  //!< that it carries along
    VertexIds vertices;
    Vector3 centre = Vector3::Zero();
    Motion motion = Motion::free;
    int driver = -1;      //!< the handle, or the feature whose rotation is prescribed
    int handle = -1;      //!< the handle with a free rotation that it is
    int restricted = -1;  //!< the feature whose FeatureMotion it keeps
    std::optional<Following> following;
    bool is_bound = false;  //!< it keeps a motion or a link: its translation is not the sheet's own

    //! Its motion is known before the energy is minimised.
    bool is_known() const
    {
        return motion == Motion::fixed || motion == Motion::handle || motion == Motion::propagated;
    }

    //! The sheet alone decides its translation.
    bool is_open() const { return !is_known() && !is_bound; }
};

//! Everything that wants to move one body.
struct Drivers
{
    bool fixed = false;
    bool propagated = false;
    bool turned = false;  //!< by points of its own triangles
    std::set<int> handles;
};

//! Features joined to bodies where they share vertices or a group, handles with a free rotation,
//! and stitches that are carried along; what moves them is still open.
std::vector<Body> merge_bodies(const mesh::TriangleMesh& mesh,
                               const SurfaceConstraints& constraints);

//! Decides what moves a body: what drives it, and what its features ask for.
//! \throws InvalidInput naming features and what would tear them apart
void decide_motion(Body& body, const Drivers& drivers, const SurfaceConstraints& constraints);

//! Settles who follows in every link. Bodies that are driven lead, as do those that keep a motion.
//! \throws InvalidInput naming links and features: nothing left to give, or a link that closes a
//! loop
void decide_links(const mesh::TriangleMesh& mesh, const SurfaceConstraints& constraints,
                  std::vector<Body>& bodies);

//! Body indices in an order in which leaders come before their followers.
std::vector<int> leaders_first(const std::vector<Body>& bodies);

//! Mean of a feature's vertices at rest.
Vector3 centre_of(const mesh::TriangleMesh& mesh, const VertexIds& vertices);

//! "feature 'hole1', feature 'hole2' (one body, since they share vertices)".
Text names_of(const Body& body, const SurfaceConstraints& constraints);

}  // namespace sheetmorph::surface
