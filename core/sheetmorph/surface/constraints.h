// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/base/rigid_motion.h"

#include <string>

namespace sheetmorph
{

//! Which thin-plate energy bends the sheet.
enum class Energy
{
    paper,   //!< (2.2) and (2.9) as printed: no area weights, biharmonic rotations
    neumann  //!< weighted by area, so that the shape does not depend on how fine the mesh is
};

//! Vertices whose positions are given: a fixed region, a handle, or a propagated region.
struct KnownRegion
{
    std::string name;
    VertexIds vertices;
    std::string kind = "region";  //!< what the user calls it, for messages

    //! "handle 'tip'", "contact 'weld1'".
    std::string label() const { return kind + " '" + name + "'"; }
};

//! A partial shape that keeps its form: it moves as one rigid body (2.4, 2.8).
struct FormFeature
{
    std::string name;
    VertexIds vertices;
    bool is_prescribed = false;    //!< its rotation comes with the pose, not from interpolation
    std::string kind = "feature";  //!< what the user calls it, for messages

    //! "feature 'hole1'", "contact 'weld1'".
    std::string label() const { return kind + " '" + name + "'"; }
};

//! A point in a triangle that the pose puts somewhere (2.3).
struct PointConstraint
{
    std::string name;
    int triangle = 0;
    Vector3 barycentric = Vector3::Zero();  //!< s, t, u >= 0 with s + t + u = 1
    bool is_turned = false;                 //!< its rotation is given too (2.8)
};

//! Everything known about one part before a pose is known.
struct SurfaceConstraints
{
    std::vector<KnownRegion> fixed;
    std::vector<KnownRegion> handles;
    std::vector<FormFeature> features;
    std::vector<PointConstraint> points;
    std::vector<KnownRegion> propagated;  //!< driven by other parts; disjoint from each other
    Energy energy = Energy::neumann;
};

//! Where a pose puts one point, and how it turns it if the point is turned.
struct PointTarget
{
    Vector3 position = Vector3::Zero();      //!< mm
    Vector3 rotation_log = Vector3::Zero();  //!< radians (2.6)
};

//! Where other parts put the vertices of one propagated region.
struct PropagatedTarget
{
    Points positions;      //!< (k, 3) mm
    Points rotation_logs;  //!< (k, 3) radians (2.6)

    //! k rotations where they are more than their logs can tell (log_near()); empty: those of the
    //! logs.
    std::vector<Matrix3> rotations;
};

//! A pose of one part, in the order of its SurfaceConstraints.
struct SurfaceTargets
{
    std::vector<RigidMotion> handles;
    std::vector<Vector3> feature_logs;  //!< read for prescribed features only
    std::vector<PointTarget> points;
    std::vector<PropagatedTarget> propagated;
};

}  // namespace sheetmorph
