// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/base/rigid_motion.h"
#include "sheetmorph/base/text.h"
#include "sheetmorph/mesh/search/anchor.h"
#include "sheetmorph/surface/constraints/feature_motion.h"

#include <string>

namespace sheetmorph::surface
{

//! The thin-plate energy of the sheet.
enum class Energy
{
    paper,    //!< (2.2) and (2.9) as printed: no area weights, biharmonic rotations
    neumann,  //!< weighted by area: the shape does not depend on the fineness of the mesh
    natural,  //!< natural boundary conditions: only affine functions cost nothing on a flat sheet
    steel     //!< a nearly inextensible thin shell (steel/); live frames use `neumann`
};

//! The triangles of the discrete operators.
enum class Laplacian
{
    cotangent,  //!< the given ones; `natural` switches to intrinsic ones if these fail
    intrinsic   //!< intrinsic Delaunay triangles, of the double cover where sheets meet
};

//! A region of prescribed vertices: fixed, handle or propagated.
struct KnownRegion
{
    std::string name;
    VertexIds vertices;
    std::string kind = "region";  //!< the user's term, for messages

    //! Only for handles: the pose gives the displacement of the pivot, the energy determines the
    //! rotation.
    bool is_rotation_free = false;

    std::vector<Subject> of = {};  //!< entries of the assembly that it represents

    //! For messages: "handle 'tip'", "contact 'weld1'".
    Text label() const { return Text::about(kind + " '" + name + "'", of); }
};

//! A partial shape that keeps its form: it moves as one rigid body (2.4, 2.8).
struct FormFeature
{
    std::string name;
    VertexIds vertices;
    FeatureRotation rotation = FeatureRotation::free;
    std::string kind = "feature";  //!< the user's term, for messages
    FeatureMotion motion = {};
    bool is_resizable = false;     //!< a pose may set its size (FeatureShape)
    std::vector<Subject> of = {};  //!< entries of the assembly that it represents

    //! For messages: "feature 'hole1'", "contact 'weld1'".
    Text label() const { return Text::about(kind + " '" + name + "'", of); }
};

//! A point of a triangle with a target position (2.3).
struct PointConstraint
{
    std::string name;
    int triangle = 0;
    Vector3 barycentric = Vector3::Zero();  //!< s, t, u >= 0 with s + t + u = 1
    bool is_turned = false;                 //!< the pose also gives its rotation (2.8)
    bool is_rotation_free = false;          //!< the energy determines the rotation there
    std::vector<Subject> of = {};           //!< entries of the assembly that it represents

    //! For messages: "point 'p1'".
    Text label() const { return Text::about("point '" + name + "'", of); }
};

//! Two form features with a common axis or a constant distance. The leader's motion may come from
//! another part.
struct FeatureLink
{
    std::string name;
    FeatureLinkType type = FeatureLinkType::coaxial;
    int follower = 0;                      //!< index of the form feature
    int leader = -1;                       //!< index of the form feature; -1: in another part
    Vector3 centre = Vector3::Zero();      //!< of the leader at rest, for `coaxial` on its axis, mm
    Vector3 direction = Vector3::UnitZ();  //!< of the leader's axis at rest, for `coaxial`
    std::vector<Subject> of = {};          //!< entries of the assembly that it represents
};

//! A vertex attached to another sheet, with which it rotates: p = q + R (p_hat - q_hat), where q is
//! its position there.
struct Tie
{
    int vertex = 0;
    mesh::Anchor place;
};

//! All constraints of one part that are independent of the pose.
struct SurfaceConstraints
{
    std::vector<KnownRegion> fixed;
    std::vector<KnownRegion> handles;
    std::vector<FormFeature> features;
    std::vector<PointConstraint> points;
    std::vector<KnownRegion> propagated;   //!< driven by other parts; disjoint
    std::vector<std::vector<int>> groups;  //!< form features that move as one rigid body
    std::vector<FeatureLink> links;

    //! Rigid connections of points on different sheets; a body that carries one of them carries
    //! all.
    std::vector<KnownRegion> stitches;

    //! Seams, vertex by vertex. The ties of a tie's corners come before it. A tie is ignored if
    //! another constraint determines its vertex.
    std::vector<Tie> ties;
    Energy energy = Energy::neumann;
    bool is_refined = false;  //!< exact results use a thick shell (steel_answer.h)
    Laplacian laplacian = Laplacian::cotangent;
    double thickness = 0.0;  //!< mm, only for `steel`; 0: a hundredth of the size
    double poisson = 0.3;    //!< Poisson's ratio, only for `steel`

    //! Whether live frames are only previews, because the exact result uses another model.
    bool has_previews() const { return is_refined || energy == Energy::steel; }
};

}  // namespace sheetmorph::surface
