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

//! Name and colour of a face in the file; empty if it has none.
struct FaceTag
{
    std::string name;
    std::string colour;  //!< "#rrggbb"
};

//! A solid, or a shell outside of solids, placed by its location.
struct NamedShape
{
    std::string name;  //!< unique within a file
    TopoDS_Shape shape;
    std::vector<FaceTag> faces = {};  //!< in the order of TopExp::MapShapes; may be empty
    TopLoc_Location placement;        //!< of its product in the assembly
    int product = 0;                  //!< index of its product in the order of the assembly
    std::string own_name;             //!< name of its own entity; empty if none
    std::vector<std::pair<TopoDS_Shape, TopoDS_Shape>> sewn;  //!< free faces; sewn
    std::vector<std::string> faults = {};                     //!< reasons why the shape is invalid
    std::vector<std::string> healed = {};  //!< reasons why it was invalid before healing
    double healed_within = 0.0;            //!< largest displacement by healing, mm
};

//! Collects the bodies of a file under unique names.
class BodyList
{
public:
    //! Returns the name of one body of a product with several bodies, such as the name of its
    //! solid.
    using BodyName = std::function<std::string(const TopoDS_Shape&)>;

    //! Adds the solids of a shape, its shells outside of solids, and its faces outside of shells,
    //! sewn to shells.
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
