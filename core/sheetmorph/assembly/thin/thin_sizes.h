// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/assembly/assembly.h"
#include "sheetmorph/surface/bodies/sizes.h"

namespace sheetmorph::assembly
{

//! The features of a thin part with a variable size, through both skins and the wall.
class ThinSizes
{
public:
    //! Call once for each feature of the part, in order.
    void add(const mesh::TriangleMesh& mesh, const PartFeature& feature);

    //! The part at rest with the sizes of a pose.
    //! \param rest   (n, 3) mm
    //! \param sizes  mm, by feature; missing ones are those at rest
    Points laid(Points rest, const std::vector<std::optional<double>>& sizes) const;

private:
    std::vector<VertexIds> vertices_;
    surface::FeatureShapes shapes_;  // empty for features of fixed size
};

}  // namespace sheetmorph::assembly
