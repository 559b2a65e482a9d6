// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/numerics/sparse_cholesky.h"

#include "sheetmorph/base/errors.h"
#include "sheetmorph/numerics/nested_dissection.h"
#include "sheetmorph/numerics/supernodal_solver.h"

#include <algorithm>
#include <cholmod.h>
#include <omp.h>
#include <optional>

namespace sheetmorph
{

namespace
{

// Below these sizes a minimum-degree ordering fills no more than nested dissection does, by places
// or by METIS (which takes longer than the factorisation).
constexpr Eigen::Index places_from = 70000;
constexpr Eigen::Index metis_from = 100000;

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

SupernodalFactor view_of(const cholmod_factor& lower)
{
    return {static_cast<int>(lower.n),          static_cast<int>(lower.nsuper),
            static_cast<int*>(lower.super),     static_cast<int*>(lower.pi),
            static_cast<int*>(lower.px),        static_cast<int*>(lower.s),
            static_cast<const double*>(lower.x)};
}

cholmod_factor* analysed(const SparseMatrix& matrix, const Points& places, cholmod_common& common)
{
    cholmod_sparse view = view_of(matrix);
    common.supernodal = CHOLMOD_SUPERNODAL;
    common.nmethods = 1;
    common.postorder = 1;
    if (matrix.rows() >= places_from && places.rows() == matrix.rows())
    {
        std::vector<int> order = nested_dissection(matrix, places);
        common.method[0].ordering = CHOLMOD_GIVEN;
        return cholmod_analyze_p(&view, order.data(), nullptr, 0, &common);
    }
    common.method[0].ordering = matrix.rows() < metis_from ? CHOLMOD_AMD : CHOLMOD_METIS;
    return cholmod_analyze(&view, &common);
}

}  // namespace

struct SparseCholesky::Factor
{
    Factor() = default;
    ~Factor()
    {
        if (lower != nullptr)
            cholmod_free_factor(&lower, &workspace.common);
    }
    Factor(const Factor&) = delete;
    Factor& operator=(const Factor&) = delete;

    Workspace workspace;
    cholmod_factor* lower = nullptr;
    std::optional<SupernodalSolver> solver;
    Eigen::Index size = 0;
    double entries = 0.0;
};

SparseCholesky::SparseCholesky(const SparseMatrix& matrix, const Points& places)
    : factor_(std::make_unique<Factor>())
{
    factor_->size = matrix.rows();
    if (matrix.rows() == 0)
        return;
    SparseMatrix packed = matrix;
    packed.makeCompressed();
    cholmod_sparse view = view_of(packed);
    cholmod_common& common = factor_->workspace.common;
    const SingleOpenMpLevel single_level;
    factor_->lower = analysed(packed, places, common);
    if (factor_->lower == nullptr)
        throw SolverError("the sparse matrix could not be analysed (out of memory?)");
    factor_->entries = common.lnz;
    cholmod_factorize(&view, factor_->lower, &common);
    if (common.status != CHOLMOD_OK || factor_->lower->minor < factor_->lower->n)
        throw SolverError(
            "the energy's matrix is not positive definite; "
            "the part has no unique shape under these constraints");
    factor_->solver.emplace(view_of(*factor_->lower));
}

SparseCholesky::~SparseCholesky() = default;
SparseCholesky::SparseCholesky(SparseCholesky&&) noexcept = default;
SparseCholesky& SparseCholesky::operator=(SparseCholesky&&) noexcept = default;

Eigen::MatrixXd SparseCholesky::solve(const Eigen::MatrixXd& right_sides) const
{
    if (factor_->size == 0 || right_sides.cols() == 0)
        return Eigen::MatrixXd::Zero(factor_->size, right_sides.cols());
    const int* order = static_cast<const int*>(factor_->lower->Perm);
    Eigen::MatrixXd result(right_sides.rows(), right_sides.cols());
    SupernodalSolver::RightSides some =
        SupernodalSolver::RightSides::Zero(right_sides.rows(), right_sides_at_once);
    for (Eigen::Index first = 0; first < right_sides.cols(); first += right_sides_at_once)
    {
        const Eigen::Index count =
            std::min<Eigen::Index>(right_sides_at_once, right_sides.cols() - first);
        for (Eigen::Index column = 0; column < count; ++column)
            for (Eigen::Index row = 0; row < right_sides.rows(); ++row)
                some(row, column) = right_sides(order[row], first + column);
        factor_->solver->solve(some);
        for (Eigen::Index column = 0; column < count; ++column)
            for (Eigen::Index row = 0; row < right_sides.rows(); ++row)
                result(order[row], first + column) = some(row, column);
    }
    return result;
}

Eigen::Index SparseCholesky::size() const
{
    return factor_->size;
}

double SparseCholesky::factor_entries() const
{
    return factor_->entries;
}

SparseMatrix rows_scaled(const SparseMatrix& matrix, const Eigen::VectorXd& factors)
{
    SparseMatrix scaled = matrix;
    for (Eigen::Index column = 0; column < scaled.outerSize(); ++column)
        for (SparseMatrix::InnerIterator entry(scaled, column); entry; ++entry)
            entry.valueRef() *= factors(entry.row());
    return scaled;
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
