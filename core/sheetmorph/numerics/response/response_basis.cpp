// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/numerics/response/response_basis.h"

#include "sheetmorph/base/index.h"

#include "sheetmorph/base/parallel.h"

#include <algorithm>
#include <cmath>

namespace sheetmorph
{

namespace
{

constexpr Eigen::Index block_rows = ResponseRows::count;
constexpr float largest_narrow = 32767.0F;

// By how much the steps of a narrow field may miss, in units of the tolerances.
constexpr double narrow_miss = 0.25;

// Rows whose patches are worth a range of their own: some 30 microseconds.
constexpr Eigen::Index least_rows = 8000;

// Steps of 16 bits for a field, or 0 if they are too coarse for the columns that it is blended to.
float narrow_step(const ResponseFields::Patch& patch, Eigen::Index field,
                  const Eigen::VectorXd& tolerances)
{
    const double step = patch.fields.col(field).cwiseAbs().maxCoeff() / largest_narrow;
    const Eigen::VectorXd shares = patch.shares.row(field);
    const double needed = shares.cwiseAbs().cwiseQuotient(tolerances).maxCoeff();
    return 0.5 * step * needed <= narrow_miss ? static_cast<float>(step) : 0.0F;
}

}  // namespace

ResponseBasis::ResponseBasis(const ResponseFields& fields)
    : rows_(fields.rows()), columns_(fields.columns()), rows_a_patch_(fields.rows_a_patch())
{
    for (const ResponseFields::Patch& patch : fields.patches())
        pack(patch, fields.tolerances());
}

void ResponseBasis::pack(const ResponseFields::Patch& patch, const Eigen::VectorXd& tolerances)
{
    const Eigen::Index count = patch.fields.cols();
    std::vector<Eigen::Index> order;  // wide ones first
    std::vector<float> steps;
    for (Eigen::Index field = 0; field < count; ++field)
        steps.push_back(narrow_step(patch, field, tolerances));
    for (const bool is_narrow : {false, true})
        for (Eigen::Index field = 0; field < count; ++field)
            if ((steps[at(field)] != 0.0F) == is_narrow)
                order.push_back(field);
    const auto wide = std::count(steps.begin(), steps.end(), 0.0F);
    places_.push_back({wide_.size(), narrow_.size(), shares_.size(), static_cast<int>(wide),
                       static_cast<int>(count - wide)});
    const Eigen::Index blocks = rows_a_patch_ / block_rows;
    const std::size_t first_wide = wide_.size(), first_narrow = narrow_.size();
    wide_.resize(first_wide + at(blocks * wide), ResponseRows{});
    narrow_.resize(first_narrow + at(blocks * (count - wide)), NarrowRows{});
    for (Eigen::Index k = 0; k < count; ++k)
        for (Eigen::Index row = 0; row < patch.fields.rows(); ++row)
        {
            const Eigen::Index block = row / block_rows, within = row % block_rows;
            const float value = patch.fields(row, order[at(k)]);
            if (k < wide)
                wide_[first_wide + at(block * wide + k)].at[within] = value;
            else
                narrow_[first_narrow + at(block * (count - wide) + k - wide)].at[within] =
                    static_cast<std::int16_t>(std::lround(value / steps[at(order[at(k)])]));
        }
    Eigen::MatrixXd shares(count, columns_);
    for (Eigen::Index k = 0; k < count; ++k)
        shares.row(k) = (k < wide ? 1.0 : steps[at(order[at(k)])]) * patch.shares.row(order[at(k)]);
    constexpr int lanes = ResponseProduct::lanes;
    const Eigen::Index filled = (count + lanes - 1) / lanes * lanes;
    for (Eigen::Index column = 0; column < columns_; ++column)
        for (Eigen::Index k = 0; k < filled; ++k)
            shares_.push_back(k < count ? static_cast<float>(shares(k, column)) : 0.0F);
}

ResponseProduct ResponseBasis::product(std::size_t patch, const Coefficients& coefficients) const
{
    const Place& place = places_[patch];
    ResponseProduct work{};
    work.wide = wide_.data() + place.wide;
    work.wide_count = place.wide_count;
    work.narrow = narrow_.data() + place.narrow;
    work.narrow_count = place.narrow_count;
    work.blocks = static_cast<int>(rows_a_patch_ / block_rows);
    work.shares = shares_.data() + place.shares;
    work.columns = static_cast<int>(columns_);
    work.coefficients = coefficients.data();
    return work;
}

Vector3 ResponseBasis::row(Eigen::Index row, const Coefficients& coefficients) const
{
    // The block of the row alone.
    ResponseProduct work = product(at(row / rows_a_patch_), coefficients);
    const Eigen::Index block = row % rows_a_patch_ / block_rows;
    work.wide += block * work.wide_count;
    work.narrow += block * work.narrow_count;
    work.blocks = 1;
    const Points start = Points::Zero(block_rows, 3);
    Points result(block_rows, 3);
    work.start = start.data();
    work.result = result.data();
    run_response_kernel(work);
    return result.row(row % block_rows).transpose();
}

void ResponseBasis::add_to(const Points& start, const Coefficients& coefficients,
                           Points& result) const
{
    result.resize(rows_, 3);
    const std::size_t whole = at(rows_ / rows_a_patch_);
    const auto add_some = [&](Eigen::Index begin, Eigen::Index end)
    {
        for (Eigen::Index k = begin; k < end; ++k)
        {
            ResponseProduct work = product(at(k), coefficients);
            work.start = start.data() + 3 * k * rows_a_patch_;
            work.result = result.data() + 3 * k * rows_a_patch_;
            run_response_kernel(work);
        }
    };
    parallel_ranges(static_cast<Eigen::Index>(whole), least_rows / rows_a_patch_, add_some);
    if (whole < places_.size())
    {
        // The last patch is not full: through copies of its rows.
        const Eigen::Index rows = rows_ - static_cast<Eigen::Index>(whole) * rows_a_patch_;
        Points from = Points::Zero(rows_a_patch_, 3), to(rows_a_patch_, 3);
        from.topRows(rows) = start.bottomRows(rows);
        ResponseProduct work = product(whole, coefficients);
        work.start = from.data();
        work.result = to.data();
        run_response_kernel(work);
        result.bottomRows(rows) = to.topRows(rows);
    }
}

double ResponseBasis::bytes() const
{
    return static_cast<double>(places_.size() * sizeof(Place) + wide_.size() * sizeof(ResponseRows)
                               + narrow_.size() * sizeof(NarrowRows)
                               + shares_.size() * sizeof(float));
}

}  // namespace sheetmorph
