// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/recognise/facets/welding.h"

#include "sheetmorph/base/disjoint_sets.h"

#include <algorithm>
#include <cmath>

namespace sheetmorph::recognise
{

// Sorted along a line, points that may coincide are close to each other.
std::vector<int> coincident(const Points& points, double distance)
{
    const int count = static_cast<int>(points.rows());
    std::vector<int> order(static_cast<std::size_t>(count));
    std::iota(order.begin(), order.end(), 0);
    // A generic direction: few points of a regular mesh have the same coordinate along it.
    const Vector3 along = Vector3(0.7368062997280773, 0.5270462766947299, 0.4235992153234789);
    const Eigen::VectorXd place = points * along;
    std::sort(order.begin(), order.end(),
              [&](int a, int b) { return place(a) < place(b) || (place(a) == place(b) && a < b); });
    DisjointSets sets(count);
    for (int i = 0; i < count; ++i)
        for (int j = i + 1; j < count && place(order[j]) - place(order[i]) <= distance; ++j)
            if ((points.row(order[i]) - points.row(order[j])).norm() <= distance)
                sets.join(order[i], order[j]);
    std::vector<int> first(order.size());
    for (int i = 0; i < count; ++i)
        first[i] = sets.root(i);
    return first;
}

}  // namespace sheetmorph::recognise
