// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/surface/unknowns.h"

namespace sheetmorph
{

SparseMatrix Unknowns::basis() const
{
    std::vector<Eigen::Triplet<double>> entries;
    for (std::size_t i = 0; i < of_vertex.size(); ++i)
        if (of_vertex[i] != known)
            entries.emplace_back(static_cast<int>(i), of_vertex[i], 1.0);
    SparseMatrix matrix(static_cast<Eigen::Index>(of_vertex.size()), count);
    matrix.setFromTriplets(entries.begin(), entries.end());
    return matrix;
}

Points Unknowns::places(const Points& vertices) const
{
    Points sums = Points::Zero(count, 3);
    Eigen::VectorXd counts = Eigen::VectorXd::Zero(count);
    for (std::size_t i = 0; i < of_vertex.size(); ++i)
        if (of_vertex[i] != known)
        {
            sums.row(of_vertex[i]) += vertices.row(static_cast<Eigen::Index>(i));
            counts(of_vertex[i]) += 1.0;
        }
    return counts.cwiseMax(1.0).cwiseInverse().asDiagonal() * sums;
}

}  // namespace sheetmorph
