// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/assembly/contact.h"
#include "sheetmorph/assembly/pose.h"
#include "sheetmorph/assembly/relations.h"
#include "sheetmorph/mesh/triangle_mesh.h"
#include "sheetmorph/surface/constraints/constraints.h"

#include <optional>

namespace sheetmorph::assembly
{

//! Which vertices of a part other parts decide (section 4.1).
enum class Mode
{
    automatic,  //!< chosen from the propagation type and the part's features
    all,        //!< mode 1: every vertex by the control mesh
    regions,    //!< mode 2: contact sides and followers; the rest by feature-preserving deformation
    boundaries  //!< mode 3: unconstrained boundary vertices; the rest likewise
};

//! Whether a closed mesh is treated as a thin solid: solved on one skin, the rest follows.
enum class Thin
{
    no,
    automatic,  //!< if it is recognised as one
    yes         //!< an error if it is none
};

//! What becomes of pieces of a part that nothing holds, while other pieces of it move.
enum class Unheld
{
    rest,   //!< they stay where they are
    along,  //!< each goes rigidly along with the nearest place of what is held
    refuse  //!< an error that names them
};

//! One mesh of the assembly.
struct Part
{
    std::string name;
    mesh::TriangleMesh mesh;
    std::vector<int> ids;  //!< (n) the file's own vertex ids, for messages; empty: 0..n-1
    Mode mode = Mode::automatic;
    Thin thin = Thin::no;
    double thickness = 0.0;  //!< mm, of a thin solid; 0: found out

    //! mm, of the sheet as `steel`; 0: that of the thin solid, or a hundredth of the size.
    double sheet_thickness = 0.0;
    double poisson = 0.3;  //!< Poisson's ratio, read for `steel`
};

//! Vertices of one part that a pose moves as one rigid body.
struct PartHandle
{
    std::string name;
    int part = 0;
    VertexIds vertices;
    bool is_rotation_free = false;  //!< the pose shifts it, the energy turns it
    std::vector<Subject> of = {};   //!< the entries that it was made of; empty: itself
};

//! A form feature of one part.
struct PartFeature
{
    std::string name;
    int part = 0;
    VertexIds vertices;
    surface::FeatureRotation rotation = surface::FeatureRotation::free;
    surface::FeatureMotion motion;
    std::optional<double> size;  //!< mm: diameter of a hole, length of a slot, radius of a cylinder
    bool is_resizable = false;   //!< a pose may set its size too
    std::vector<Subject> of = {};  //!< the entries that it was made of; empty: itself
};

//! A point on a triangle of one part.
struct PartPoint
{
    std::string name;
    int part = 0;
    surface::PointConstraint constraint;
    std::vector<Subject> of = {};  //!< the entries that it was made of; empty: itself
};

//! Everything about a morph but its pose.
struct Assembly
{
    std::vector<Part> parts;
    int primary = 0;
    surface::Energy energy = surface::Energy::neumann;
    surface::Laplacian laplacian = surface::Laplacian::cotangent;
    std::vector<PartRegion> fixed;
    std::vector<PartHandle> handles;
    std::vector<PartFeature> features;
    std::vector<PartPoint> points;
    std::vector<PartRegion> followers;  //!< regions of modes 2 that no contact names
    std::vector<Contact> contacts;
    std::vector<FeatureGroup> groups;
    std::vector<FeaturePair> pairs;
    std::optional<SymmetryPlane> symmetry;
    bool is_refined = false;  //!< exact answers are refined for large rotations
    Propagation propagation;
    Unheld unheld = Unheld::rest;
};

}  // namespace sheetmorph::assembly
