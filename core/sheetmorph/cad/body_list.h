// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <TopLoc_Location.hxx>
#include <TopoDS_Shape.hxx>
#include <functional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace sheetmorph::cad
{

//! What a file says of a face besides its surface; empty where it says nothing.
struct FaceTag
{
    std::string name;
    std::string colour;  //!< "#rrggbb"
};

//! A solid, or a shell that belongs to none, placed by its location.
struct NamedShape
{
    std::string name;  //!< unique among those of a file
    TopoDS_Shape shape;
    std::vector<FaceTag> faces = {};  //!< in the order of TopExp::MapShapes, or none
    TopLoc_Location placement;        //!< of its product in the assembly
    int product = 0;                  //!< the place of its product in the order of the assembly
    std::string own_name;             //!< that its own entity has; empty if none
    std::vector<std::pair<TopoDS_Shape, TopoDS_Shape>> sewn;  //!< faces outside of shells, and here
    std::vector<std::string> faults = {};                     //!< why it is no valid shape
    std::vector<std::string> healed = {};  //!< why it was none before it was healed
    double healed_within = 0.0;            //!< how far healing moved anything, mm
};

//! Collects the bodies of a file under names that are unique.
class BodyList
{
public:
    //! The name of one body of a product with several, for example from its solid's entity.
    using BodyName = std::function<std::string(const TopoDS_Shape&)>;

    //! Adds the solids of a shape, its shells outside of solids and, sewn to shells, its faces
    //! outside of shells.
    //! \param shape      of a product
    //! \param placement  of the product
    //! \param name       of the product; several bodies become name.body or name.1, name.2
    void add(const TopoDS_Shape& shape, const TopLoc_Location& placement, const std::string& name,
             const BodyName& body_name);

    const std::vector<NamedShape>& bodies() const { return bodies_; }

private:
    std::string unique(const std::string& name);

    std::vector<NamedShape> bodies_;
    int products_ = 0;
    std::set<std::string> used_;
};

}  // namespace sheetmorph::cad
