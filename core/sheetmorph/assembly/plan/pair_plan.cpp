// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/assembly/plan/pair_plan.h"

#include "sheetmorph/assembly/labels.h"
#include "sheetmorph/assembly/links/control_box.h"
#include "sheetmorph/base/angles.h"
#include "sheetmorph/base/errors.h"
#include "sheetmorph/base/index.h"
#include "sheetmorph/fitting/circle.h"
#include "sheetmorph/forms/feature_shape.h"

#include <Eigen/Geometry>
#include <cmath>
#include <sstream>

namespace sheetmorph::assembly
{

namespace
{

constexpr double degrees = 1.0 / degree;  // from geometry

// Relative to the smaller radius, and degrees: beyond these, features do not share an axis. Chosen:
// the axis of a circle fitted to a coarse rim may be off by as much although it is the same.
constexpr double most_offset = 0.02;
constexpr double most_angle = 1.0;

//! The axis of a form feature, with how far its vertices are from it in the mean.
struct FeatureAxis
{
    Vector3 point;
    Vector3 direction;
    double radius;
};

const PartFeature& feature_of(const Assembly& assembly, int feature)
{
    return assembly.features[at(feature)];
}

Points points_of(const Assembly& assembly, const PartFeature& feature)
{
    return rows_of(assembly.parts[at(feature.part)].mesh.points(), feature.vertices);
}

Text label_of(const FeaturePair& pair)
{
    const std::string word =
        pair.type == surface::FeatureLinkType::coaxial ? "coaxial pair" : "distance";
    return Text::about(word + " '" + pair.name + "'", subjects_of("pair", pair));
}

Text label(const Assembly& assembly, const PartFeature& feature)
{
    return label_of("feature", feature) + " of part '" + assembly.parts[at(feature.part)].name
           + "'";
}

// Of a hole, slot or cylinder its own; of other vertices the normal of their best plane.
FeatureAxis axis_of(const Assembly& assembly, const PartFeature& feature, const FeaturePair& pair)
{
    const mesh::TriangleMesh& mesh = assembly.parts[at(feature.part)].mesh;
    const Points points = points_of(assembly, feature);
    FeatureAxis axis{points.colwise().mean().transpose(), Vector3::UnitZ(), 0.0};
    if (const std::optional<forms::FeatureShape> shape =
            forms::feature_shape(mesh, feature.vertices))
    {
        axis.point = shape->centre;
        axis.direction = shape->axis;
    }
    else
    {
        try
        {
            axis.direction = fitting::fit_circle(points).axis;
        }
        catch (const InvalidInput&)
        {
            throw InvalidInput(label_of(pair) + ": " + label(assembly, feature)
                                   + " has no axis, since its vertices lie on one line",
                               "pick a rim");
        }
    }
    const Points arms = points.rowwise() - axis.point.transpose();
    axis.radius =
        (arms - arms * axis.direction * axis.direction.transpose()).rowwise().norm().mean();
    return axis;
}

void require_coaxial(const Assembly& assembly, const FeaturePair& pair, const FeatureAxis& a,
                     const FeatureAxis& b)
{
    const Vector3 across = b.point - a.point;
    const double offset = (across - across.dot(a.direction) * a.direction).norm();
    const double angle =
        std::atan2(a.direction.cross(b.direction).norm(), std::abs(a.direction.dot(b.direction)))
        * degrees;
    if (offset <= most_offset * std::min(a.radius, b.radius) && angle <= most_angle)
        return;
    std::ostringstream text;
    text.precision(3);
    text << " do not share an axis at rest, they are " << offset << " mm and " << angle
         << " degrees apart";
    throw InvalidInput(label_of(pair) + ": " + label(assembly, feature_of(assembly, pair.a))
                           + " and " + label(assembly, feature_of(assembly, pair.b)) + text.str(),
                       "choose two that do");
}

void require_distance(const Assembly& assembly, const FeaturePair& pair, const Vector3& a,
                      const Vector3& b)
{
    const Points points = points_of(assembly, feature_of(assembly, pair.a));
    if ((a - b).norm() > mesh::exactness(points, assembly.parts.front().mesh.size()))
        return;
    throw InvalidInput(label_of(pair) + ": " + label(assembly, feature_of(assembly, pair.a))
                           + " and " + label(assembly, feature_of(assembly, pair.b))
                           + " have the same centre",
                       "make them coaxial, or choose others");
}

Vector3 centre_of(const Assembly& assembly, int feature)
{
    return points_of(assembly, feature_of(assembly, feature)).colwise().mean().transpose();
}

PlannedPair planned(const Assembly& assembly, const FeaturePair& pair, bool is_b_first)
{
    PlannedPair found{pair.name, pair.type, is_b_first ? pair.b : pair.a,
                      is_b_first ? pair.a : pair.b};
    found.of = subjects_of("pair", pair);
    if (pair.type == surface::FeatureLinkType::distance)
    {
        require_distance(assembly, pair, centre_of(assembly, pair.a), centre_of(assembly, pair.b));
        found.centre = centre_of(assembly, found.leader);
        return found;
    }
    const FeatureAxis a = axis_of(assembly, feature_of(assembly, pair.a), pair);
    const FeatureAxis b = axis_of(assembly, feature_of(assembly, pair.b), pair);
    require_coaxial(assembly, pair, a, b);
    found.centre = is_b_first ? b.point : a.point;
    found.direction = is_b_first ? b.direction : a.direction;
    return found;
}

}  // namespace

std::vector<PlannedPair> plan_pairs(const Assembly& assembly, const PropagationPlan& plan)
{
    std::vector<int> rank(assembly.parts.size(), -1);
    for (std::size_t k = 0; k < plan.order.size(); ++k)
        rank[at(plan.order[k])] = static_cast<int>(k);
    const bool is_at_once = assembly.propagation.type == PropagationType::whole;
    std::vector<PlannedPair> pairs;
    for (const FeaturePair& pair : assembly.pairs)
    {
        const int rank_a = rank[at(feature_of(assembly, pair.a).part)];
        const int rank_b = rank[at(feature_of(assembly, pair.b).part)];
        const PlannedPair found = planned(assembly, pair, !is_at_once && rank_b < rank_a);
        if (rank_a >= 0 && rank_b >= 0)
            pairs.push_back(found);
    }
    return pairs;
}

}  // namespace sheetmorph::assembly
