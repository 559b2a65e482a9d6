// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/surface/operators/unknowns.h"

namespace sheetmorph::surface
{

numerics::SparseMatrix Unknowns::basis() const
{
    std::vector<Eigen::Triplet<double>> entries;
    for (std::size_t i = 0; i < of_vertex.size(); ++i)
        if (of_vertex[i] != known)
            entries.emplace_back(static_cast<int>(i), of_vertex[i], 1.0);
    numerics::SparseMatrix matrix(static_cast<Eigen::Index>(of_vertex.size()), count);
    matrix.setFromTriplets(entries.begin(), entries.end());
    return matrix;
}

Eigen::MatrixXd Unknowns::sums(const Eigen::MatrixXd& rows) const
{
    Eigen::MatrixXd sums = Eigen::MatrixXd::Zero(count, rows.cols());
    for (Eigen::Index column = 0; column < rows.cols(); ++column)
        for (Eigen::Index row = 0; row < rows.rows(); ++row)
            if (const int unknown = of_vertex[static_cast<std::size_t>(row)]; unknown != known)
                sums(unknown, column) += rows(row, column);
    return sums;
}

}  // namespace sheetmorph::surface
