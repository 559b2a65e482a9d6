// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/assembly/contact.h"
#include "sheetmorph/mesh/triangle_mesh.h"
#include "sheetmorph/surface/constraints.h"

#include <map>
#include <optional>

namespace sheetmorph
{

//! Which vertices of a part other parts decide (section 4.1).
enum class Mode
{
    automatic,  //!< chosen from the propagation type and the part's features
    all,        //!< mode 1: every vertex by the control mesh
    regions,    //!< mode 2: contact sides and followers; the rest by feature-preserving deformation
    boundaries  //!< mode 3: unconstrained boundary vertices; the rest likewise
};

//! One mesh of the assembly.
struct Part
{
    std::string name;
    TriangleMesh mesh;
    std::vector<int> ids;  //!< (n) the file's own vertex ids, for messages; empty: 0..n-1
    Mode mode = Mode::automatic;
};

//! Vertices of one part that a pose moves as one rigid body.
struct PartHandle
{
    std::string name;
    int part = 0;
    VertexIds vertices;
};

//! A form feature of one part; its rotation is interpolated, or the pose prescribes it.
struct PartFeature
{
    std::string name;
    int part = 0;
    VertexIds vertices;
    bool is_prescribed = false;
};

//! A point on a triangle of one part.
struct PartPoint
{
    std::string name;
    int part = 0;
    PointConstraint constraint;
};

//! Everything about a morph but its pose.
struct Assembly
{
    std::vector<Part> parts;
    int primary = 0;
    Energy energy = Energy::neumann;
    std::vector<PartRegion> fixed;
    std::vector<PartHandle> handles;
    std::vector<PartFeature> features;
    std::vector<PartPoint> points;
    std::vector<PartRegion> followers;  //!< regions of modes 2 that no contact names
    std::vector<Contact> contacts;
    Propagation propagation;
};

//! The few numbers that decide every shape: what a document stores and a drag changes.
struct Pose
{
    std::map<std::string, RigidMotion> handles;   //!< no motion where left out
    std::map<std::string, Vector3> feature_logs;  //!< of prescribed features (2.6); none left out
    std::map<std::string, PointTarget> points;    //!< every point needs one
};

}  // namespace sheetmorph
