// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/numerics/sparse_cholesky.h"

#include "sheetmorph/base/errors.h"

#include <cholmod.h>
#include <omp.h>

namespace sheetmorph
{

namespace
{

// Below this size a minimum-degree ordering costs less than nested dissection saves.
constexpr Eigen::Index nested_dissection_from = 100000;

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

cholmod_dense view_of(const Eigen::MatrixXd& matrix)
{
    cholmod_dense view{};
    view.nrow = static_cast<std::size_t>(matrix.rows());
    view.ncol = static_cast<std::size_t>(matrix.cols());
    view.nzmax = static_cast<std::size_t>(matrix.size());
    view.d = view.nrow;
    view.x = const_cast<double*>(matrix.data());
    view.xtype = CHOLMOD_REAL;
    view.dtype = CHOLMOD_DOUBLE;
    return view;
}

void choose_ordering(cholmod_common& common, Eigen::Index size)
{
    common.supernodal = CHOLMOD_AUTO;
    common.nmethods = 1;
    common.method[0].ordering = size < nested_dissection_from ? CHOLMOD_AMD : CHOLMOD_METIS;
    common.postorder = 1;
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
    Eigen::Index size = 0;
    double entries = 0.0;
};

SparseCholesky::SparseCholesky(const SparseMatrix& matrix) : factor_(std::make_unique<Factor>())
{
    factor_->size = matrix.rows();
    if (matrix.rows() == 0)
        return;
    SparseMatrix packed = matrix;
    packed.makeCompressed();
    cholmod_sparse view = view_of(packed);
    cholmod_common& common = factor_->workspace.common;
    choose_ordering(common, matrix.rows());
    const SingleOpenMpLevel single_level;
    factor_->lower = cholmod_analyze(&view, &common);
    if (factor_->lower == nullptr)
        throw SolverError("the sparse matrix could not be analysed (out of memory?)");
    factor_->entries = common.lnz;
    cholmod_factorize(&view, factor_->lower, &common);
    if (common.status != CHOLMOD_OK || factor_->lower->minor < factor_->lower->n)
        throw SolverError(
            "the energy's matrix is not positive definite; "
            "the part has no unique shape under these constraints");
}

SparseCholesky::~SparseCholesky() = default;
SparseCholesky::SparseCholesky(SparseCholesky&&) noexcept = default;
SparseCholesky& SparseCholesky::operator=(SparseCholesky&&) noexcept = default;

Eigen::MatrixXd SparseCholesky::solve(const Eigen::MatrixXd& right_sides) const
{
    if (factor_->size == 0 || right_sides.cols() == 0)
        return Eigen::MatrixXd::Zero(factor_->size, right_sides.cols());
    Workspace workspace;
    cholmod_dense view = view_of(right_sides);
    const SingleOpenMpLevel single_level;
    cholmod_dense* solution = cholmod_solve(CHOLMOD_A, factor_->lower, &view, &workspace.common);
    if (solution == nullptr)
        throw SolverError("the linear system could not be solved (out of memory?)");
    Eigen::MatrixXd result = Eigen::Map<Eigen::MatrixXd>(static_cast<double*>(solution->x),
                                                         right_sides.rows(), right_sides.cols());
    cholmod_free_dense(&solution, &workspace.common);
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
