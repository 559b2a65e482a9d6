// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/numerics/response/response_basis.h"

#include "sheetmorph/base/index.h"

#include "sheetmorph/base/threads/parallel.h"

#include <algorithm>
#include <cmath>

namespace sheetmorph::numerics
{

namespace
{

constexpr Eigen::Index block_rows = ResponseRows::count;
constexpr float largest_narrow = 32767.0F;  // from the format: the largest std::int16_t

// Largest error of a field in steps of 16 bits, in units of the tolerances. Chosen: a quarter of
// the tolerance, so that the error of the fields themselves, up to one, still dominates.
constexpr double narrow_miss = 0.25;

// Rows of a range. Chosen: they take about 30 microseconds, as long as waking a thread.
constexpr Eigen::Index least_rows = 8000;

// Step of a field in 16 bits, or 0 if it would be too coarse for the columns.
float narrow_step(const ResponseFields::Patch& patch, Eigen::Index field,
                  const Eigen::VectorXd& tolerances)
{
    const double step = patch.fields.col(field).cwiseAbs().maxCoeff() / largest_narrow;
    const Eigen::VectorXd shares = patch.shares.row(field);
    const double needed = shares.cwiseAbs().cwiseQuotient(tolerances).maxCoeff();
    return 0.5 * step * needed <= narrow_miss ? static_cast<float>(step) : 0.0F;
}

std::vector<Eigen::Index> wide_first(const std::vector<float>& steps)
{
    std::vector<Eigen::Index> order;
    for (const bool is_narrow : {false, true})
        for (std::size_t field = 0; field < steps.size(); ++field)
            if ((steps[field] != 0.0F) == is_narrow)
                order.push_back(static_cast<Eigen::Index>(field));
    return order;
}

}  // namespace

ResponseBasis::ResponseBasis(const ResponseFields& fields)
    : rows_(fields.rows()), columns_(fields.columns()), rows_a_patch_(fields.rows_a_patch())
{
    for (std::size_t k = 0; k < fields.patches().size(); ++k)
    {
        pack(fields.patches()[k], fields.tolerances());
        find_runs(fields.rows_of(k));
    }
}

void ResponseBasis::find_runs(const VertexIds& rows)
{
    places_.back().runs = runs_.size();
    for (std::size_t k = 0; k < rows.size(); ++k)
        if (k > 0 && rows[k] == rows[k - 1] + 1)
            ++runs_.back().count;
        else
            runs_.push_back({rows[k], 1});
    places_.back().run_count = static_cast<int>(runs_.size() - places_.back().runs);
}

void ResponseBasis::pack(const ResponseFields::Patch& patch, const Eigen::VectorXd& tolerances)
{
    const Eigen::Index count = patch.fields.cols();
    std::vector<float> steps;
    for (Eigen::Index field = 0; field < count; ++field)
        steps.push_back(narrow_step(patch, field, tolerances));
    const std::vector<Eigen::Index> order = wide_first(steps);
    const auto wide = std::count(steps.begin(), steps.end(), 0.0F);
    places_.push_back({wide_.size(), narrow_.size(), shares_.size(), felt_.size(), 0,
                       static_cast<int>(wide), static_cast<int>(count - wide), 0, 0});
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
    {
        if (patch.shares.col(column).isZero(0.0))
            continue;
        felt_.push_back(static_cast<int>(column));
        for (Eigen::Index k = 0; k < filled; ++k)
            shares_.push_back(k < count ? static_cast<float>(shares(k, column)) : 0.0F);
    }
    places_.back().felt_count = static_cast<int>(felt_.size() - places_.back().felt);
}

// Uses a buffer that stays in the first cache, because the rows of a patch are anywhere in the
// mesh.
void ResponseBasis::add_patch(std::size_t patch, const Points& start,
                              const Coefficients& coefficients, Points& result) const
{
    alignas(64) double moved[3 * ResponseProduct::most_blocks * block_rows];
    const Place& place = places_[patch];
    thread_local std::vector<double> felt;
    felt.clear();
    for (int k = 0; k < place.felt_count; ++k)
        for (int axis = 0; axis < 3; ++axis)
            felt.push_back(coefficients(felt_[place.felt + at(k)], axis));
    ResponseProduct work{};
    work.wide = wide_.data() + place.wide;
    work.wide_count = place.wide_count;
    work.narrow = narrow_.data() + place.narrow;
    work.narrow_count = place.narrow_count;
    work.blocks = static_cast<int>(rows_a_patch_ / block_rows);
    work.shares = shares_.data() + place.shares;
    work.columns = place.felt_count;
    work.coefficients = felt.data();
    work.result = moved;
    run_response_kernel(work);
    const double* from = moved;
    for (const Run *run = &runs_[place.runs], *end = run + place.run_count; run != end; ++run)
    {
        const Eigen::Index offset = 3 * static_cast<Eigen::Index>(run->first);
        for (Eigen::Index k = 0; k < 3 * run->count; ++k)
            result.data()[offset + k] = start.data()[offset + k] + from[k];
        from += 3 * run->count;
    }
}

void ResponseBasis::add_to(const Points& start, const Coefficients& coefficients,
                           Points& result) const
{
    result.resize(rows(), 3);
    const auto add_some = [&](Eigen::Index begin, Eigen::Index end)
    {
        for (Eigen::Index k = begin; k < end; ++k)
            add_patch(at(k), start, coefficients, result);
    };
    parallel_ranges(static_cast<Eigen::Index>(places_.size()), least_rows / rows_a_patch_,
                    add_some);
}

double ResponseBasis::bytes() const
{
    return static_cast<double>(runs_.size() * sizeof(Run) + places_.size() * sizeof(Place)
                               + wide_.size() * sizeof(ResponseRows)
                               + narrow_.size() * sizeof(NarrowRows)
                               + shares_.size() * sizeof(float) + felt_.size() * sizeof(int));
}

}  // namespace sheetmorph::numerics
