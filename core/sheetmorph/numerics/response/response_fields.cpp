// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/numerics/response/response_fields.h"

#include "sheetmorph/base/index.h"
#include "sheetmorph/base/threads/parallel.h"
#include "sheetmorph/numerics/ordering/halving.h"
#include "sheetmorph/numerics/response/response_kernel.h"

#include <algorithm>
#include <numeric>

namespace sheetmorph::numerics
{

namespace
{

// Size of patches. Chosen so that their shares take less than about a quarter of the memory of
// their fields.
constexpr Eigen::Index columns_a_block = 12;
constexpr Eigen::Index fewest_blocks = 2;

// Up to few_columns, rows are read faster in the order of the numbering if that goes from neighbour
// to neighbour: mean step, in mean spacings, at most near_steps. A random order has steps of about
// half the size, hundreds of spacings; a mesh numbered row by row has one. Chosen between the two.
constexpr Eigen::Index few_columns = 48;
constexpr double near_steps = 4.0;

// Relative to a column's largest entry. From float32, whose rounding is 6e-8.
constexpr double rounding = 1e-7;

// In units of the tolerances. Chosen: a column that moves a patch by a tenth of its tolerance does
// not need a field there.
constexpr double unfelt = 0.1;

// Rows of a range. Chosen, not measured.
constexpr Eigen::Index least_rows = 2000;

bool goes_by_neighbours(const Points& places)
{
    const Eigen::Index steps = places.rows() - 1;
    if (steps < 1)
        return true;
    const double size = (places.colwise().maxCoeff() - places.colwise().minCoeff()).norm();
    const double length = (places.bottomRows(steps) - places.topRows(steps)).rowwise().norm().sum();
    return length <= near_steps * size * std::sqrt(static_cast<double>(steps));
}

// Subtracts from `wanted` its projection on the fields (rows, f), twice, because in float32 they
// are not quite orthonormal. Adds the coefficients to the first rows of `shares`.
void take_off(const Eigen::MatrixXd& fields, Eigen::MatrixXd& wanted, Eigen::MatrixXd& shares)
{
    for (int pass = 0; pass < 2 && fields.cols() > 0; ++pass)
    {
        const Eigen::MatrixXd share = fields.transpose() * wanted;
        wanted.noalias() -= fields * share;
        shares.topRows(fields.cols()) += share;
    }
}

// Adds fields until no column has an error above one (columns are in units of their tolerances) or
// above its rounding in float32. Each time, the column with the largest error becomes a field. As
// many fields as rows leave no error.
void extend(ResponseFields::Patch& patch, const Eigen::MatrixXd& columns,
            const Eigen::VectorXd& units)
{
    std::vector<Eigen::Index> felt;
    for (Eigen::Index k = 0; k < columns.cols(); ++k)
        if (columns.col(k).cwiseAbs().maxCoeff() > unfelt)
            felt.push_back(k);
    const Eigen::Index before = patch.shares.cols();
    patch.shares.conservativeResizeLike(
        Eigen::MatrixXd::Zero(patch.fields.cols(), before + columns.cols()));
    if (felt.empty())
        return;
    Eigen::MatrixXd wanted = columns(Eigen::indexing::all, felt);
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
    patch.shares.conservativeResizeLike(Eigen::MatrixXd::Zero(fields.cols(), patch.shares.cols()));
    for (std::size_t k = 0; k < felt.size(); ++k)
        patch.shares.col(before + felt[k]) =
            shares.col(static_cast<Eigen::Index>(k)).head(fields.cols()) * units(felt[k]);
}

}  // namespace

ResponseFields::ResponseFields(const Points& places, Eigen::Index columns)
    : rows_a_patch_(ResponseRows::count
                    * std::clamp<Eigen::Index>(columns / columns_a_block, fewest_blocks,
                                               ResponseProduct::most_blocks)),
      patches_(at((places.rows() + rows_a_patch_ - 1) / rows_a_patch_))
{
    order_.resize(at(places.rows()));
    std::iota(order_.begin(), order_.end(), 0);
    if (columns > few_columns || !goes_by_neighbours(places))
        group_by_place(order_, places, rows_a_patch_);
    place_.resize(order_.size());
    for (std::size_t k = 0; k < order_.size(); ++k)
        place_[at(order_[k])] = static_cast<int>(k);
    for (std::size_t k = 0; k < patches_.size(); ++k)
        patches_[k].fields.resize(static_cast<Eigen::Index>(rows_of(k).size()), 0);
}

VertexIds ResponseFields::rows_of(std::size_t patch) const
{
    const std::size_t first = patch * at(rows_a_patch_);
    const std::size_t end = std::min(first + at(rows_a_patch_), order_.size());
    return {order_.begin() + static_cast<std::ptrdiff_t>(first),
            order_.begin() + static_cast<std::ptrdiff_t>(end)};
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
                   columns(rows_of(at(k)), Eigen::indexing::all)
                       * tolerances.cwiseInverse().asDiagonal(),
                   tolerances);
        }
    };
    parallel_ranges(static_cast<Eigen::Index>(patches_.size()), least_rows / rows_a_patch_,
                    extend_some);
}

Eigen::RowVectorXd ResponseFields::row(Eigen::Index row) const
{
    const int place = place_[at(row)];
    const Patch& patch = patches_[at(place / rows_a_patch_)];
    return patch.fields.row(place % rows_a_patch_).cast<double>() * patch.shares;
}

Points ResponseFields::times(const Coefficients& coefficients) const
{
    Points product(rows(), 3);
    for (std::size_t k = 0; k < patches_.size(); ++k)
    {
        const Eigen::MatrixXf blended = (patches_[k].shares * coefficients).cast<float>();
        product(rows_of(k), Eigen::indexing::all) = (patches_[k].fields * blended).cast<double>();
    }
    return product;
}

double ResponseFields::bytes() const
{
    Eigen::Index bytes = 2 * 4 * rows();
    for (const Patch& patch : patches_)
        bytes += 4 * patch.fields.size() + 8 * patch.shares.size();
    return static_cast<double>(bytes);
}

}  // namespace sheetmorph::numerics
