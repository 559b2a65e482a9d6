// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/numerics/response/response_fields.h"

#include "sheetmorph/base/index.h"
#include "sheetmorph/base/parallel.h"
#include "sheetmorph/numerics/response/response_kernel.h"

#include <algorithm>

namespace sheetmorph
{

namespace
{

// Patches are as large as keeps their shares below a quarter of their fields, about.
constexpr Eigen::Index columns_a_block = 12;
constexpr Eigen::Index fewest_blocks = 2;

// Of a column's largest entry: less than float32 can tell.
constexpr double rounding = 1e-7;

// Rows whose patches are worth a range of their own.
constexpr Eigen::Index least_rows = 2000;

// Takes off `wanted` what the fields (rows, f) blend to, twice, since in float32 they are not quite
// orthonormal; adds how to the first rows of `shares`.
void take_off(const Eigen::MatrixXd& fields, Eigen::MatrixXd& wanted, Eigen::MatrixXd& shares)
{
    for (int pass = 0; pass < 2 && fields.cols() > 0; ++pass)
    {
        const Eigen::MatrixXd share = fields.transpose() * wanted;
        wanted.noalias() -= fields * share;
        shares.topRows(fields.cols()) += share;
    }
}

// The column that misses most becomes a field, until none misses by more than one (columns are in
// units of their tolerances) or than their rounding in float32.
void extend(ResponseFields::Patch& patch, Eigen::MatrixXd wanted, const Eigen::VectorXd& units)
{
    const Eigen::Index rows = wanted.rows();
    const Eigen::RowVectorXd allowed =
        (rounding * wanted.cwiseAbs().colwise().maxCoeff()).cwiseMax(1.0);
    Eigen::MatrixXd fields = patch.fields.cast<double>();
    Eigen::MatrixXd shares = Eigen::MatrixXd::Zero(rows, wanted.cols());
    take_off(fields, wanted, shares);
    Eigen::Index worst = 0;
    while (fields.cols() < rows
           && wanted.cwiseAbs().colwise().maxCoeff().cwiseQuotient(allowed).maxCoeff(&worst) > 1.0)
    {
        Eigen::VectorXd field = wanted.col(worst);
        field -= fields * (fields.transpose() * field).eval();
        field = field.normalized().cast<float>().cast<double>();
        const Eigen::RowVectorXd share = field.transpose() * wanted / field.squaredNorm();
        wanted.noalias() -= field * share;
        shares.row(fields.cols()) += share;
        fields.conservativeResize(rows, fields.cols() + 1);
        fields.rightCols(1) = field;
    }
    patch.fields = fields.cast<float>();
    const Eigen::Index columns = patch.shares.cols();
    patch.shares.conservativeResizeLike(
        Eigen::MatrixXd::Zero(fields.cols(), columns + wanted.cols()));
    patch.shares.rightCols(wanted.cols()) = shares.topRows(fields.cols()) * units.asDiagonal();
}

}  // namespace

ResponseFields::ResponseFields(Eigen::Index rows, Eigen::Index columns)
    : rows_(rows),
      rows_a_patch_(ResponseRows::count
                    * std::clamp<Eigen::Index>(columns / columns_a_block, fewest_blocks,
                                               ResponseProduct::most_blocks)),
      patches_(at((rows + rows_a_patch_ - 1) / rows_a_patch_))
{
    for (std::size_t k = 0; k < patches_.size(); ++k)
        patches_[k].fields.resize(
            std::min(rows_a_patch_, rows - static_cast<Eigen::Index>(k) * rows_a_patch_), 0);
}

void ResponseFields::append(const Eigen::MatrixXd& columns, const Eigen::VectorXd& tolerances)
{
    tolerances_.conservativeResize(tolerances_.size() + tolerances.size());
    tolerances_.tail(tolerances.size()) = tolerances;
    const auto extend_some = [&](Eigen::Index first, Eigen::Index end)
    {
        for (Eigen::Index k = first; k < end; ++k)
        {
            Patch& patch = patches_[at(k)];
            extend(patch,
                   columns.middleRows(k * rows_a_patch_, patch.fields.rows())
                       * tolerances.cwiseInverse().asDiagonal(),
                   tolerances);
        }
    };
    parallel_ranges(static_cast<Eigen::Index>(patches_.size()), least_rows / rows_a_patch_,
                    extend_some);
}

Eigen::RowVectorXd ResponseFields::row(Eigen::Index row) const
{
    const Patch& patch = patches_[at(row / rows_a_patch_)];
    return patch.fields.row(row % rows_a_patch_).cast<double>() * patch.shares;
}

Points ResponseFields::times(const Coefficients& coefficients) const
{
    Points product(rows_, 3);
    Eigen::Index first = 0;
    for (const Patch& patch : patches_)
    {
        const Eigen::MatrixXf blended = (patch.shares * coefficients).cast<float>();
        product.middleRows(first, patch.fields.rows()) = (patch.fields * blended).cast<double>();
        first += patch.fields.rows();
    }
    return product;
}

double ResponseFields::bytes() const
{
    Eigen::Index bytes = 0;
    for (const Patch& patch : patches_)
        bytes += 4 * patch.fields.size() + 8 * patch.shares.size();
    return static_cast<double>(bytes);
}

}  // namespace sheetmorph
