// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/recognise/contacts/part_pairs.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace sheetmorph::recognise
{

namespace
{

// Smallest cosine of the angle between the axes of two holes of one bolt, 8 degrees. Chosen: the
// axis of a coarse rim is exact to a few degrees; sheets with a larger angle cannot be bolted.
constexpr double parallel = 0.99;

struct Hole
{
    int part;
    int feature;
    Vector3 center;
    Vector3 axis;
    double radius;
    double low;  // extent of the hole along its axis, from its centre, mm
    double high;
};

Hole hole_of(const ContactPart& part, int part_index, int feature_index)
{
    const Feature& feature = part.features[feature_index];
    Hole hole{part_index, feature_index, feature.center, feature.axis, feature.radius, 0.0, 0.0};
    for (const int vertex : feature.vertices)
    {
        const double along =
            (part.mesh.points().row(vertex).transpose() - feature.center).dot(feature.axis);
        hole.low = std::min(hole.low, along);
        hole.high = std::max(hole.high, along);
    }
    return hole;
}

// Distance between two holes along the axis of the first: 0 if they overlap, negative if they are
// not coaxial.
double axial_distance(const Hole& a, const Hole& b, const ContactTolerances& tolerances)
{
    const double smaller = std::min(a.radius, b.radius);
    if (std::max(a.radius, b.radius) > tolerances.bolt_ratio * smaller)
        return -1.0;
    const double turn = a.axis.dot(b.axis);
    if (std::abs(turn) < parallel)
        return -1.0;
    const Vector3 off = b.center - a.center;
    const double along = off.dot(a.axis);
    if ((off - along * a.axis).norm() > tolerances.coaxial * smaller)
        return -1.0;
    const double low = along + (turn > 0.0 ? b.low : -b.high);
    const double high = along + (turn > 0.0 ? b.high : -b.low);
    return std::max({0.0, low - a.high, a.low - high});
}

}  // namespace

std::vector<std::pair<int, int>> near_pairs(const std::vector<PartShape>& shapes, double reach)
{
    std::vector<int> order(shapes.size());
    std::iota(order.begin(), order.end(), 0);
    std::sort(order.begin(), order.end(),
              [&](int a, int b)
              {
                  const double x = shapes[a].low().x();
                  const double y = shapes[b].low().x();
                  return x < y || (x == y && a < b);
              });
    double thickest = 0.0;
    for (const PartShape& shape : shapes)
        thickest = std::max(thickest, shape.thickness());
    std::vector<std::pair<int, int>> pairs;
    for (std::size_t i = 0; i < order.size(); ++i)
        for (std::size_t j = i + 1; j < order.size(); ++j)
        {
            const PartShape& a = shapes[order[i]];
            const PartShape& b = shapes[order[j]];
            if (b.low().x() > a.high().x() + reach + thickest)
                break;
            const double away = reach + 0.5 * (a.thickness() + b.thickness());
            if ((a.low().array() <= b.high().array() + away).all()
                && (b.low().array() <= a.high().array() + away).all())
                pairs.push_back(std::minmax(order[i], order[j]));
        }
    std::sort(pairs.begin(), pairs.end());
    return pairs;
}

std::vector<Bolt> find_bolts(const std::vector<ContactPart>& parts, double reach,
                             const ContactTolerances& tolerances)
{
    std::vector<Hole> holes;
    double farthest = 0.0;
    for (int p = 0; p < static_cast<int>(parts.size()); ++p)
        for (int f = 0; f < static_cast<int>(parts[p].features.size()); ++f)
            if (parts[p].features[f].kind == FeatureKind::round_hole)
            {
                holes.push_back(hole_of(parts[p], p, f));
                const Hole& hole = holes.back();
                farthest =
                    std::max({farthest, hole.radius + hole.high - hole.low, parts[p].thickness});
            }
    std::sort(holes.begin(), holes.end(),
              [](const Hole& a, const Hole& b) { return a.center.x() < b.center.x(); });
    std::vector<Bolt> bolts;
    for (std::size_t i = 0; i < holes.size(); ++i)
        for (std::size_t j = i + 1; j < holes.size(); ++j)
        {
            const Hole& a = holes[holes[i].part < holes[j].part ? i : j];
            const Hole& b = holes[holes[i].part < holes[j].part ? j : i];
            if (holes[j].center.x() - holes[i].center.x() > 2.0 * farthest + reach)
                break;
            const double away = axial_distance(a, b, tolerances);
            const double limit = reach + 0.5 * (parts[a.part].thickness + parts[b.part].thickness);
            if (a.part != b.part && away >= 0.0 && away <= limit)
                bolts.push_back({a.part, a.feature, b.part, b.feature, away});
        }
    std::sort(bolts.begin(), bolts.end(),
              [](const Bolt& a, const Bolt& b)
              {
                  return std::tie(a.part_a, a.part_b, a.feature_a, a.feature_b)
                         < std::tie(b.part_a, b.part_b, b.feature_a, b.feature_b);
              });
    return bolts;
}

}  // namespace sheetmorph::recognise
