// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/numerics/cholesky/sparse_cholesky.h"

#include "sheetmorph/base/errors.h"
#include "sheetmorph/base/index.h"
#include "sheetmorph/numerics/cholesky/front_solver.h"
#include "sheetmorph/numerics/cholesky/frontal_cholesky.h"

#include <algorithm>
#include <cholmod.h>
#include <omp.h>
#include <optional>

namespace sheetmorph
{

namespace
{

// Below this size a minimum-degree ordering fills no more than METIS does, which takes longer than
// the factorisation.
constexpr Eigen::Index metis_from = 100000;

[[noreturn]] void refuse()
{
    throw SolverError(
        "the energy's matrix is not positive definite; "
        "the part has no unique shape under these constraints");
}

// One CHOLMOD workspace; its own object a call, so that const solves run in parallel.
class Workspace
{
public:
    Workspace()
    {
        cholmod_start(&common);
        common.print = 0;
        common.error_handler = nullptr;
    }
    ~Workspace() { cholmod_finish(&common); }
    Workspace(const Workspace&) = delete;
    Workspace& operator=(const Workspace&) = delete;

    cholmod_common common{};
};

// CHOLMOD's own OpenMP regions oversubscribe small machines (two to three times slower on two
// cores); BLAS threads are not affected.
class SingleOpenMpLevel
{
public:
    SingleOpenMpLevel() : levels_(omp_get_max_active_levels()) { omp_set_max_active_levels(0); }
    ~SingleOpenMpLevel() { omp_set_max_active_levels(levels_); }
    SingleOpenMpLevel(const SingleOpenMpLevel&) = delete;
    SingleOpenMpLevel& operator=(const SingleOpenMpLevel&) = delete;

private:
    int levels_;
};

cholmod_sparse view_of(const SparseMatrix& matrix)
{
    cholmod_sparse view{};
    view.nrow = static_cast<std::size_t>(matrix.rows());
    view.ncol = static_cast<std::size_t>(matrix.cols());
    view.nzmax = static_cast<std::size_t>(matrix.nonZeros());
    view.p = const_cast<int*>(matrix.outerIndexPtr());
    view.i = const_cast<int*>(matrix.innerIndexPtr());
    view.x = const_cast<double*>(matrix.valuePtr());
    view.stype = -1;
    view.itype = CHOLMOD_INT;
    view.xtype = CHOLMOD_REAL;
    view.dtype = CHOLMOD_DOUBLE;
    view.sorted = 1;
    view.packed = 1;
    return view;
}

// The factor's supernodes as fronts; slots are its columns.
FrontList fronts_of(const cholmod_factor& lower)
{
    const auto* first = static_cast<const int*>(lower.super);
    const auto* row_start = static_cast<const int*>(lower.pi);
    const auto* entry_start = static_cast<const int*>(lower.px);
    const auto* rows = static_cast<const int*>(lower.s);
    FrontList list{static_cast<int>(lower.n), {}, {}};
    std::vector<int> front_of_column(lower.n);
    for (std::size_t s = 0; s < lower.nsuper; ++s)
    {
        auto front = std::make_shared<Front>();
        front->columns = first[s + 1] - first[s];
        front->rows.assign(rows + row_start[s], rows + row_start[s + 1]);
        front->entries.reset(new double[front->rows.size() * at(front->columns)]);
        front->panel() = Eigen::Map<const Eigen::MatrixXd>(
            static_cast<const double*>(lower.x) + entry_start[s], front->height(), front->columns);
        std::fill(front_of_column.begin() + first[s], front_of_column.begin() + first[s + 1],
                  static_cast<int>(s));
        list.fronts.push_back(std::move(front));
    }
    for (const auto& front : list.fronts)
        list.parent.push_back(
            front->below() > 0 ? front_of_column[at(front->rows[at(front->columns)])] : -1);
    return list;
}

cholmod_factor* analysed(const SparseMatrix& matrix, cholmod_common& common)
{
    cholmod_sparse view = view_of(matrix);
    common.supernodal = CHOLMOD_SUPERNODAL;
    common.nmethods = 1;
    common.postorder = 1;
    common.method[0].ordering = matrix.rows() < metis_from ? CHOLMOD_AMD : CHOLMOD_METIS;
    return cholmod_analyze(&view, &common);
}

}  // namespace

struct SparseCholesky::Factor
{
    std::vector<int> slot_of;                // of every unknown
    std::optional<Elimination> elimination;  // along a tree
    FrontSolver solver;
};

SparseCholesky::SparseCholesky(const SparseMatrix& matrix)
{
    if (matrix.rows() == 0)
    {
        factor_.reset(new Factor{{}, {}, FrontSolver({})});
        return;
    }
    SparseMatrix packed = matrix;
    packed.makeCompressed();
    cholmod_sparse view = view_of(packed);
    Workspace workspace;
    cholmod_common& common = workspace.common;
    const SingleOpenMpLevel single_level;
    const auto release = [&](cholmod_factor* lower) { cholmod_free_factor(&lower, &common); };
    const std::unique_ptr<cholmod_factor, decltype(release)> lower(analysed(packed, common),
                                                                   release);
    if (lower == nullptr)
        throw SolverError("the sparse matrix could not be analysed (out of memory?)");
    cholmod_factorize(&view, lower.get(), &common);
    if (common.status != CHOLMOD_OK || lower->minor < lower->n)
        refuse();
    const auto* order = static_cast<const int*>(lower->Perm);
    std::vector<int> slot_of(lower->n);
    for (std::size_t slot = 0; slot < lower->n; ++slot)
        slot_of[at(order[slot])] = static_cast<int>(slot);
    factor_.reset(new Factor{std::move(slot_of), {}, FrontSolver(fronts_of(*lower))});
}

SparseCholesky::SparseCholesky(MergedMatrix matrix, std::shared_ptr<const SeparatorTree> tree,
                               const SparseCholesky* earlier)
{
    if (!tree)
    {
        *this = SparseCholesky(matrix.merged());
        return;
    }
    Elimination elimination(std::move(matrix), std::move(tree));
    std::vector<int> slot_of;
    for (int unknown = 0; unknown < elimination.matrix().count; ++unknown)
        slot_of.push_back(elimination.slot_of(unknown));
    std::optional<EarlierFactor> before;
    if (earlier != nullptr && earlier->factor_->elimination)
        before.emplace(
            EarlierFactor{*earlier->factor_->elimination, earlier->factor_->solver.factor()});
    try
    {
        FrontSolver solver(frontal_cholesky(elimination, before ? &*before : nullptr));
        factor_.reset(new Factor{std::move(slot_of), std::move(elimination), std::move(solver)});
    }
    catch (const SolverError&)
    {
        refuse();
    }
}

SparseCholesky::~SparseCholesky() = default;
SparseCholesky::SparseCholesky(SparseCholesky&&) noexcept = default;
SparseCholesky& SparseCholesky::operator=(SparseCholesky&&) noexcept = default;

Eigen::MatrixXd SparseCholesky::solve(const Eigen::MatrixXd& right_sides) const
{
    const std::vector<int>& slot_of = factor_->slot_of;
    Eigen::MatrixXd result(right_sides.rows(), right_sides.cols());
    FrontSolver::RightSides some =
        FrontSolver::RightSides::Zero(factor_->solver.factor().slots, right_sides_at_once);
    for (Eigen::Index first = 0; first < right_sides.cols(); first += right_sides_at_once)
    {
        const Eigen::Index count =
            std::min<Eigen::Index>(right_sides_at_once, right_sides.cols() - first);
        for (Eigen::Index column = 0; column < count; ++column)
            for (Eigen::Index row = 0; row < right_sides.rows(); ++row)
                some(slot_of[at(row)], column) = right_sides(row, first + column);
        factor_->solver.solve(some);
        for (Eigen::Index column = 0; column < count; ++column)
            for (Eigen::Index row = 0; row < right_sides.rows(); ++row)
                result(row, first + column) = some(slot_of[at(row)], column);
    }
    return result;
}

Eigen::Index SparseCholesky::size() const
{
    return static_cast<Eigen::Index>(factor_->slot_of.size());
}

double SparseCholesky::factor_entries() const
{
    return factor_->solver.factor().count();
}

SparseMatrix rows_scaled(const SparseMatrix& matrix, const Eigen::VectorXd& factors)
{
    SparseMatrix scaled = matrix;
    for (Eigen::Index column = 0; column < scaled.outerSize(); ++column)
        for (SparseMatrix::InnerIterator entry(scaled, column); entry; ++entry)
            entry.valueRef() *= factors(entry.row());
    return scaled;
}

SparseMatrix own_product(const SparseMatrix& rows, const Eigen::VectorXd& weights)
{
    const SparseMatrix scaled = rows_scaled(rows, weights.cwiseSqrt());
    return SparseMatrix(scaled.transpose()) * scaled;
}

std::string linear_algebra_versions()
{
    int version[3];
    cholmod_version(version);
    return "CHOLMOD " + std::to_string(version[0]) + "." + std::to_string(version[1]) + "."
           + std::to_string(version[2]) + ", Eigen " + std::to_string(EIGEN_WORLD_VERSION) + "."
           + std::to_string(EIGEN_MAJOR_VERSION) + "." + std::to_string(EIGEN_MINOR_VERSION);
}

}  // namespace sheetmorph
