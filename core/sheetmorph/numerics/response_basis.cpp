// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/numerics/response_basis.h"

#include <algorithm>
#include <atomic>
#include <thread>

namespace sheetmorph
{

namespace
{

constexpr Eigen::Index block_rows = ResponseRows::count;

// Work handed to a thread at a time, and the least for which a second thread is started (its
// start costs some 50 microseconds), in entries of the basis.
constexpr Eigen::Index entries_at_once = 1 << 17;
constexpr Eigen::Index entries_for_two_threads = 1 << 23;

// The last block where it is not full: through copies of its rows.
void run_partly(ResponseBlocks work, Eigen::Index rows)
{
    Points start = Points::Zero(block_rows, 3);
    Points result(block_rows, 3);
    start.topRows(rows) = Eigen::Map<const Points>(work.start, rows, 3);
    double* wanted = work.result;
    work.start = start.data();
    work.result = result.data();
    run_response_kernel(work);
    Eigen::Map<Points>(wanted, rows, 3) = result.topRows(rows);
}

}  // namespace

ResponseBasis::ResponseBasis(Eigen::Index rows, Eigen::Index columns)
    : rows_(rows),
      columns_(columns),
      blocks_(static_cast<std::size_t>((rows + block_rows - 1) / block_rows * columns))
{
}

void ResponseBasis::set_columns(Eigen::Index first, const Eigen::MatrixXd& block)
{
    for (Eigen::Index column = 0; column < block.cols(); ++column)
        for (Eigen::Index row = 0; row < rows_; ++row)
            blocks_[static_cast<std::size_t>(row / block_rows * columns_ + first + column)]
                .at[row % block_rows] = static_cast<float>(block(row, column));
}

Vector3 ResponseBasis::row(Eigen::Index row, const Coefficients& coefficients) const
{
    Vector3 sum = Vector3::Zero();
    const ResponseRows* columns = &blocks_[static_cast<std::size_t>(row / block_rows * columns_)];
    for (Eigen::Index k = 0; k < columns_; ++k)
        sum += static_cast<double>(columns[k].at[row % block_rows])
               * coefficients.row(k).cast<double>().transpose();
    return sum;
}

void ResponseBasis::add_to(const Points& start, const Coefficients& coefficients,
                           Points& result) const
{
    result.resize(rows_, 3);
    if (columns_ == 0)
        result = start;
    if (rows_ == 0 || columns_ == 0)
        return;
    const auto run = [&](Eigen::Index first, Eigen::Index end)
    {
        ResponseBlocks work{};
        work.basis = blocks_.data() + first * columns_;
        work.columns = static_cast<int>(columns_);
        work.blocks = static_cast<int>(end - first);
        work.coefficients = coefficients.data();
        work.start = start.data() + 3 * block_rows * first;
        work.result = result.data() + 3 * block_rows * first;
        if (end * block_rows <= rows_)
            run_response_kernel(work);
        else
            run_partly(work, rows_ - first * block_rows);
    };
    const Eigen::Index whole = rows_ / block_rows;
    const Eigen::Index step = std::max<Eigen::Index>(1, entries_at_once / block_rows / columns_);
    std::atomic<Eigen::Index> next{0};
    const auto take = [&]
    {
        for (Eigen::Index first = next.fetch_add(step); first < whole; first = next.fetch_add(step))
            run(first, std::min(first + step, whole));
    };
    std::thread other;
    if (rows_ * columns_ >= entries_for_two_threads && std::thread::hardware_concurrency() > 1)
        other = std::thread(take);
    take();
    if (whole * block_rows < rows_)
        run(whole, whole + 1);
    if (other.joinable())
        other.join();
}

}  // namespace sheetmorph
