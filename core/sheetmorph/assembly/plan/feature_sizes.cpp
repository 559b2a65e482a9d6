// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/assembly/plan/feature_sizes.h"

#include "sheetmorph/assembly/labels.h"
#include "sheetmorph/base/errors.h"
#include "sheetmorph/mesh/quality/noise.h"

#include <cmath>
#include <map>
#include <sstream>

namespace sheetmorph::assembly
{

namespace
{

std::string in_mm(double length)
{
    std::ostringstream text;
    text << length << " mm";
    return text.str();
}

void check_size(const Assembly& assembly, const PartFeature& feature,
                const forms::FeatureShape& shape, double size)
{
    if (std::isfinite(size) && size > shape.smallest)
        return;
    const Part& part = assembly.parts[static_cast<std::size_t>(feature.part)];
    const std::string limit =
        shape.smallest > 0.0 ? "the slot's width, " + in_mm(shape.smallest) : std::string("0 mm");
    throw in_part(
        {label_of("feature", feature) + " cannot have a " + shape.measure() + " of " + in_mm(size),
         "give more than " + limit},
        part);
}

}  // namespace

bool is_sized(const PartFeature& feature)
{
    return feature.is_resizable || feature.size.has_value();
}

std::vector<std::optional<forms::FeatureShape>> shapes_of_sized(const Assembly& assembly)
{
    std::vector<std::optional<forms::FeatureShape>> shapes;
    std::map<int, double> scatters;  // by part
    for (const PartFeature& feature : assembly.features)
    {
        shapes.emplace_back();
        if (!is_sized(feature))
            continue;
        const Part& part = assembly.parts[static_cast<std::size_t>(feature.part)];
        if (scatters.count(feature.part) == 0)
            scatters[feature.part] = mesh::scatter_of(part.mesh);
        shapes.back() = forms::feature_shape(part.mesh, feature.vertices, scatters[feature.part]);
        if (!shapes.back())
            throw in_part({label_of("feature", feature)
                               + " has a size, but its vertices are not a hole, slot or cylinder",
                           "pick a whole rim or wall, or leave the size out"},
                          part);
        if (feature.size)
            check_size(assembly, feature, *shapes.back(), *feature.size);
    }
    return shapes;
}

std::optional<double> size_in_pose(const PartFeature& feature, const Pose& pose)
{
    const auto found = pose.sizes.find(feature.name);
    return found == pose.sizes.end() ? feature.size : std::optional<double>(found->second);
}

void check_sizes(const Assembly& assembly,
                 const std::vector<std::optional<forms::FeatureShape>>& shapes, const Pose& pose)
{
    for (std::size_t k = 0; k < shapes.size(); ++k)
    {
        const auto found = pose.sizes.find(assembly.features[k].name);
        if (shapes[k] && found != pose.sizes.end())
            check_size(assembly, assembly.features[k], *shapes[k], found->second);
    }
}

}  // namespace sheetmorph::assembly
