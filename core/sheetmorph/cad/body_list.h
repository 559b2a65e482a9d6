// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/cad/cad_shapes.h"

#include <functional>
#include <set>

namespace sheetmorph
{

//! Collects the bodies of a file under names that are unique.
class BodyList
{
public:
    //! The name of one body of a product with several, for example from its solid's entity.
    using BodyName = std::function<std::string(const TopoDS_Shape&)>;

    //! Adds the solids of a shape, its shells outside of solids and, sewn to shells, its faces
    //! outside of shells.
    //! \param name  of the product; several bodies become name.body or name.1, name.2
    void add(const TopoDS_Shape& shape, const std::string& name, const BodyName& body_name);

    const std::vector<NamedShape>& bodies() const { return bodies_; }

private:
    std::string unique(const std::string& name);

    std::vector<NamedShape> bodies_;
    std::set<std::string> used_;
};

}  // namespace sheetmorph
