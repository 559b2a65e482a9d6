// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/assembly/thin/thin_sizes.h"

#include "sheetmorph/assembly/links/control_box.h"
#include "sheetmorph/assembly/plan/feature_sizes.h"

#include <algorithm>

namespace sheetmorph::assembly
{

void ThinSizes::add(const mesh::TriangleMesh& mesh, const PartFeature& feature)
{
    vertices_.push_back(feature.vertices);
    shapes_.push_back(is_sized(feature) ? forms::feature_shape(mesh, feature.vertices)
                                        : std::nullopt);
}

Points ThinSizes::laid(Points rest, const std::vector<std::optional<double>>& sizes) const
{
    for (std::size_t k = 0; k < std::min(shapes_.size(), sizes.size()); ++k)
        if (shapes_[k] && sizes[k])
        {
            const Points sized = shapes_[k]->resized(rows_of(rest, vertices_[k]), *sizes[k]);
            for (std::size_t i = 0; i < vertices_[k].size(); ++i)
                rest.row(vertices_[k][i]) = sized.row(static_cast<Eigen::Index>(i));
        }
    return rest;
}

}  // namespace sheetmorph::assembly
