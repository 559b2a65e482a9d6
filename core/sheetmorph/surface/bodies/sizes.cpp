// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/surface/bodies/sizes.h"

#include "sheetmorph/base/errors.h"
#include "sheetmorph/mesh/quality/noise.h"

#include <cmath>
#include <sstream>

namespace sheetmorph::surface
{

namespace
{

std::string shortest(double value)
{
    std::ostringstream text;
    text << value;
    return text.str();
}

}  // namespace

FeatureShapes resizable_shapes(const mesh::TriangleMesh& mesh,
                               const SurfaceConstraints& constraints)
{
    FeatureShapes shapes(constraints.features.size());
    std::vector<int> owner(static_cast<std::size_t>(mesh.vertex_count()), -1);
    std::optional<double> scatter;
    for (std::size_t k = 0; k < shapes.size(); ++k)
    {
        const FormFeature& feature = constraints.features[k];
        if (!feature.is_resizable)
            continue;
        if (!scatter)
            scatter = mesh::scatter_of(mesh);
        shapes[k] = forms::feature_shape(mesh, feature.vertices, *scatter);
        if (!shapes[k])
            throw InvalidInput(feature.label()
                               + " is neither a hole, a slot nor a cylinder, so its size cannot be "
                                 "set", "pick its rim (with or without washer) or leave size out");
        for (const int vertex : feature.vertices)
        {
            int& other = owner[static_cast<std::size_t>(vertex)];
            if (other >= 0 && other != static_cast<int>(k))
                throw InvalidInput(
                    feature.label() + " and "
                        + constraints.features[static_cast<std::size_t>(other)].label()
                        + " share vertices and both have a size",
                    "remove these vertices from one of them", FaultCode::overlap);
            other = static_cast<int>(k);
        }
    }
    return shapes;
}

SizeChanges size_changes(const SurfaceConstraints& constraints, const FeatureShapes& shapes,
                         const SurfaceTargets& targets)
{
    SizeChanges changes(shapes.size());
    for (std::size_t k = 0; k < targets.sizes.size(); ++k)
    {
        if (!targets.sizes[k])
            continue;
        const double size = *targets.sizes[k];
        const Text what = constraints.features[k].label();
        if (!shapes[k])
            throw InvalidInput(what + " has no size that a pose can set", "give it a size first");
        if (!std::isfinite(size) || size <= shapes[k]->smallest)
            throw InvalidInput(what + ": a " + shapes[k]->measure() + " of " + shortest(size)
                                   + " mm is not possible",
                               "give more than " + shortest(shapes[k]->smallest) + " mm");
        changes[k] = size - shapes[k]->size;
    }
    return changes;
}

}  // namespace sheetmorph::surface
