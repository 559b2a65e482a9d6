// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/base/rigid_motion.h"
#include "sheetmorph/base/text.h"
#include "sheetmorph/mesh/search/anchor.h"
#include "sheetmorph/surface/constraints/feature_motion.h"

#include <string>

namespace sheetmorph::surface
{

//! Which thin-plate energy bends the sheet.
enum class Energy
{
    paper,    //!< (2.2) and (2.9) as printed: no area weights, biharmonic rotations
    neumann,  //!< weighted by area, so that the shape does not depend on how fine the mesh is
    natural,  //!< free edges are free: only affine functions cost nothing on a flat sheet
    steel     //!< a thin shell that hardly stretches (steel/); live frames are those of `neumann`
};

//! Which triangles the operators see.
enum class Laplacian
{
    cotangent,  //!< the given ones; `natural` takes intrinsic ones by itself where these fail
    intrinsic   //!< intrinsic Delaunay ones, of the double cover where sheets meet
};

//! Vertices whose positions are given: a fixed region, a handle, or a propagated region.
struct KnownRegion
{
    std::string name;
    VertexIds vertices;
    std::string kind = "region";  //!< what the user calls it, for messages

    //! A handle alone: the pose gives the displacement of its pivot, the energy its rotation.
    bool is_rotation_free = false;

    std::vector<Subject> of = {};  //!< the entries of the assembly that it stands for

    //! "handle 'tip'", "contact 'weld1'".
    Text label() const { return Text::about(kind + " '" + name + "'", of); }
};

//! A partial shape that keeps its form: it moves as one rigid body (2.4, 2.8).
struct FormFeature
{
    std::string name;
    VertexIds vertices;
    FeatureRotation rotation = FeatureRotation::free;
    std::string kind = "feature";  //!< what the user calls it, for messages
    FeatureMotion motion = {};
    bool is_resizable = false;     //!< a pose may set its size (FeatureShape)
    std::vector<Subject> of = {};  //!< the entries of the assembly that it stands for

    //! "feature 'hole1'", "contact 'weld1'".
    Text label() const { return Text::about(kind + " '" + name + "'", of); }
};

//! A point in a triangle that the pose puts somewhere (2.3).
struct PointConstraint
{
    std::string name;
    int triangle = 0;
    Vector3 barycentric = Vector3::Zero();  //!< s, t, u >= 0 with s + t + u = 1
    bool is_turned = false;                 //!< its rotation is given too (2.8)
    bool is_rotation_free = false;          //!< the energy turns the sheet there
    std::vector<Subject> of = {};           //!< the entries of the assembly that it stands for

    //! "point 'p1'".
    Text label() const { return Text::about("point '" + name + "'", of); }
};

//! Two form features that keep an axis or a distance; the leader's motion may come from another
//! part.
struct FeatureLink
{
    std::string name;
    FeatureLinkType type = FeatureLinkType::coaxial;
    int follower = 0;                      //!< index of the form feature
    int leader = -1;                       //!< index of the form feature; -1: of another part
    Vector3 centre = Vector3::Zero();      //!< of the leader at rest, for `coaxial` on its axis; mm
    Vector3 direction = Vector3::UnitZ();  //!< of the leader's axis at rest, for `coaxial`
    std::vector<Subject> of = {};          //!< the entries of the assembly that it stands for
};

//! A vertex that stands on another sheet and turns with it: p = q + R (p_hat - q_hat), q its place
//! there.
struct Tie
{
    int vertex = 0;
    mesh::Anchor place;
};

//! Everything known about one part before a pose is known.
struct SurfaceConstraints
{
    std::vector<KnownRegion> fixed;
    std::vector<KnownRegion> handles;
    std::vector<FormFeature> features;
    std::vector<PointConstraint> points;
    std::vector<KnownRegion> propagated;   //!< driven by other parts; disjoint from each other
    std::vector<std::vector<int>> groups;  //!< form features that move as one rigid body
    std::vector<FeatureLink> links;

    //! Places of different sheets of which one is rigid: what carries it carries all.
    std::vector<KnownRegion> stitches;

    //! Sheets that stand on others: a seam, vertex by vertex; those of its corners come before a
    //! tie. Of vertices that anything else decides they are passed over.
    std::vector<Tie> ties;
    Energy energy = Energy::neumann;
    bool is_refined = false;  //!< exact answers are of a thick shell (steel_answer.h)
    Laplacian laplacian = Laplacian::cotangent;
    double thickness = 0.0;  //!< mm, read for `steel`; 0: a hundredth of the size
    double poisson = 0.3;    //!< Poisson's ratio, read for `steel`

    //! Live frames differ from the exact answer, which goes further.
    bool has_previews() const { return is_refined || energy == Energy::steel; }
};

}  // namespace sheetmorph::surface
