// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/surface/flat/flat_system.h"

#include "sheetmorph/base/errors.h"
#include "sheetmorph/base/index.h"

#include <Eigen/Eigenvalues>
#include <cmath>

namespace sheetmorph::surface
{

namespace
{

constexpr double poisson = 0.3;  // of steel and, to 10 %, of aluminium (0.33); from any handbook

// Relative to the size of a rim. Chosen: the thickness of a sheet; a rim that is less plane was
// bent.
constexpr double plane_enough = 1e-3;

// Relative to the diagonal; regularises rigid body motions. Chosen: a condition of 1e9 leaves seven
// digits, and a strain changes by 1e-9.
constexpr double rigid_modes = 1e-9;
constexpr std::size_t fewest_of_rim = 3;  // from geometry: fewer have no plane

using Gradient = Eigen::Matrix2d;

Gradient gradient_of(const FlatTriangle& triangle, const FlatPoints& positions)
{
    Gradient f = Gradient::Zero();
    for (int k = 0; k < 3; ++k)
        f += positions.row(triangle.corners[at(k)]).transpose() * triangle.gradients.row(k);
    return f;
}

Eigen::Vector3d strain_of(const Gradient& f)
{
    return {0.5 * (f.col(0).squaredNorm() - 1.0), 0.5 * (f.col(1).squaredNorm() - 1.0),
            f.col(0).dot(f.col(1))};
}

Matrix3 elasticity()
{
    Matrix3 c;
    c << 1.0, poisson, 0.0, poisson, 1.0, 0.0, 0.0, 0.0, 0.5 * (1.0 - poisson);
    return c;
}

Eigen::Matrix2d tension_of(const Eigen::Matrix2d& stress)
{
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> eigen(stress);
    return eigen.eigenvectors() * eigen.eigenvalues().cwiseMax(0.0).asDiagonal()
           * eigen.eigenvectors().transpose();
}

//! Element gradient and stiffness: 6 unknowns, two per corner.
struct Local
{
    Eigen::Matrix<double, 6, 1> gradient;
    Eigen::Matrix<double, 6, 6> stiffness;
};

Local local_of(const FlatTriangle& triangle, const FlatPoints& positions, bool is_tension_only)
{
    const Gradient f = gradient_of(triangle, positions);
    Eigen::Matrix<double, 3, 6> rows;
    for (int k = 0; k < 3; ++k)
    {
        const double a = triangle.gradients(k, 0), b = triangle.gradients(k, 1);
        rows.block<1, 2>(0, 2 * k) = a * f.col(0).transpose();
        rows.block<1, 2>(1, 2 * k) = b * f.col(1).transpose();
        rows.block<1, 2>(2, 2 * k) = (a * f.col(1) + b * f.col(0)).transpose();
    }
    const Matrix3 c = triangle.area * elasticity();
    const Eigen::Vector3d s = c * strain_of(f);
    Local found{rows.transpose() * s, rows.transpose() * c * rows};
    Eigen::Matrix2d stress;
    stress << s(0), s(2), s(2), s(1);
    if (is_tension_only)
        stress = tension_of(stress);
    const Matrix3 between = triangle.gradients * stress * triangle.gradients.transpose();
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            found.stiffness.block<2, 2>(2 * i, 2 * j).diagonal().array() += between(i, j);
    return found;
}

// (k, 2) projection of points to their best-fitting plane, and their largest distance from it.
std::pair<FlatPoints, double> in_their_plane(const mesh::TriangleMesh& mesh,
                                             const VertexIds& vertices)
{
    const Points points = mesh.points()(vertices, Eigen::indexing::all);
    const Eigen::RowVector3d centre = points.colwise().mean();
    const Eigen::MatrixXd arms = points.rowwise() - centre;
    const Eigen::SelfAdjointEigenSolver<Matrix3> eigen(Matrix3(arms.transpose() * arms));
    const FlatPoints flat = arms * eigen.eigenvectors().rightCols<2>();
    return {flat, (arms * eigen.eigenvectors().col(0)).cwiseAbs().maxCoeff()};
}

// The points rotated (not mirrored) and translated to the best fit, and the remaining sum of
// squares.
std::pair<FlatPoints, double> fitted(const FlatPoints& form, const FlatPoints& places)
{
    const Eigen::RowVector2d from = form.colwise().mean(), to = places.colwise().mean();
    const Eigen::Matrix2d product = (form.rowwise() - from).transpose() * (places.rowwise() - to);
    const double angle = std::atan2(product(0, 1) - product(1, 0), product(0, 0) + product(1, 1));
    Eigen::Matrix2d turn;
    turn << std::cos(angle), std::sin(angle), -std::sin(angle), std::cos(angle);
    FlatPoints found = ((form.rowwise() - from) * turn).rowwise() + to;
    return {found, (found - places).squaredNorm()};
}

}  // namespace

FlatSystem::FlatSystem(const FlatInput& input, std::vector<FlatTriangle> triangles,
                       FlatPoints start)
    : mesh_(input.mesh),
      triangles_(std::move(triangles)),
      positions_(std::move(start)),
      is_rigid_(input.rims.size(), 0),
      rim_of_(at(input.mesh.vertex_count()), -1)
{
    place_rims(input);
    number();
}

// Plane rims take their own shape, with the side up that fits better.
void FlatSystem::place_rims(const FlatInput& input)
{
    for (std::size_t k = 0; k < input.rims.size(); ++k)
    {
        const VertexIds& rim = input.rims[k];
        if (rim.size() < fewest_of_rim)
            continue;
        const auto [form, off] = in_their_plane(mesh_, rim);
        if (off > plane_enough * (form.colwise().maxCoeff() - form.colwise().minCoeff()).norm())
            continue;
        FlatPoints mirrored = form;
        mirrored.col(0) *= -1.0;
        const FlatPoints places = positions_(rim, Eigen::indexing::all);
        const auto one = fitted(form, places), other = fitted(mirrored, places);
        positions_(rim, Eigen::indexing::all) =
            one.second <= other.second ? one.first : other.first;
        is_rigid_[k] = 1;
        for (const int vertex : rim)
            rim_of_[at(vertex)] = static_cast<int>(rims_.size());
        rims_.push_back(rim);
    }
}

void FlatSystem::number()
{
    std::vector<char> is_used(rim_of_.size(), 0);
    for (const FlatTriangle& triangle : triangles_)
        for (const int corner : triangle.corners)
            is_used[at(corner)] = 1;
    first_.assign(rim_of_.size() + rims_.size(), -1);
    const auto add = [this](std::size_t thing, int count, const Vector3& place)
    {
        first_[thing] = count_;
        count_ += count;
        for (int k = 0; k < count; ++k)
            places_.push_back(place);
    };
    for (std::size_t i = 0; i < rim_of_.size(); ++i)
        if (rim_of_[i] < 0 && is_used[i])
            add(i, 2, mesh_.points().row(static_cast<Eigen::Index>(i)).transpose());
    for (std::size_t k = 0; k < rims_.size(); ++k)
        add(rim_of_.size() + k, 3, mesh_.points().row(rims_[k].front()).transpose());
}

Eigen::Vector2d FlatSystem::centre_of(int rim) const
{
    const FlatPoints places = positions_(rims_[at(rim)], Eigen::indexing::all);
    return places.colwise().mean().transpose();
}

FlatSystem::Columns FlatSystem::columns_of(const FlatTriangle& triangle) const
{
    Columns found;
    found.rows = Eigen::Matrix<double, 6, Eigen::Dynamic>::Zero(6, 9);
    for (int k = 0; k < 3; ++k)
    {
        const int vertex = triangle.corners[at(k)], rim = rim_of_[at(vertex)];
        const int first = rim < 0 ? first_[at(vertex)] : first_[rim_of_.size() + at(rim)];
        for (int x = 0; x < (rim < 0 ? 2 : 3); ++x)
        {
            const auto known = std::find(found.ids.begin(), found.ids.end(), first + x);
            const auto column = known - found.ids.begin();
            if (known == found.ids.end())
                found.ids.push_back(first + x);
            if (x < 2)
                found.rows(2 * k + x, column) = 1.0;
            else
            {
                const Eigen::Vector2d arm = positions_.row(vertex).transpose() - centre_of(rim);
                found.rows.block<2, 1>(2 * k, column) << -arm.y(), arm.x();
            }
        }
    }
    found.rows.conservativeResize(6, static_cast<Eigen::Index>(found.ids.size()));
    return found;
}

double FlatSystem::energy() const
{
    double sum = 0.0;
    for (const FlatTriangle& triangle : triangles_)
    {
        const Eigen::Vector3d e = strain_of(gradient_of(triangle, positions_));
        sum += 0.5 * triangle.area * e.dot(elasticity() * e);
    }
    return sum;
}

std::optional<numerics::NewtonStep> FlatSystem::step(int model)
{
    const bool is_tension_only = model > 0;
    Eigen::VectorXd gradient = Eigen::VectorXd::Zero(count_);
    std::vector<Eigen::Triplet<double>> entries;
    double largest = 0.0;
    for (const FlatTriangle& triangle : triangles_)
    {
        const Local local = local_of(triangle, positions_, is_tension_only);
        const Columns columns = columns_of(triangle);
        const Eigen::MatrixXd matrix = columns.rows.transpose() * local.stiffness * columns.rows;
        const Eigen::VectorXd forces = columns.rows.transpose() * local.gradient;
        for (std::size_t a = 0; a < columns.ids.size(); ++a)
        {
            const auto row = static_cast<Eigen::Index>(a);
            gradient(columns.ids[a]) += forces(row);
            largest = std::max(largest, matrix(row, row));
            for (std::size_t b = 0; b < columns.ids.size(); ++b)
                entries.emplace_back(columns.ids[a], columns.ids[b],
                                     matrix(row, static_cast<Eigen::Index>(b)));
        }
    }
    for (int k = 0; k < count_; ++k)
        entries.emplace_back(k, k, rigid_modes * largest);
    auto whole = std::make_shared<numerics::SparseMatrix>(count_, count_);
    whole->setFromTriplets(entries.begin(), entries.end());
    const std::optional<Eigen::VectorXd> change = solved(whole, -gradient);
    if (!change)
        return std::nullopt;
    numerics::NewtonStep found{*change};
    found.length = length_of(*change);
    found.slope = gradient.dot(*change);
    found.is_exact = !is_tension_only;
    return found;
}

// The largest displacement of a vertex in a step, mm.
double FlatSystem::length_of(const Eigen::VectorXd& change) const
{
    double worst = 0.0;
    for (std::size_t i = 0; i < rim_of_.size(); ++i)
        if (first_[i] >= 0)
            worst = std::max(worst, change.segment<2>(first_[i]).norm());
    for (std::size_t k = 0; k < rims_.size(); ++k)
    {
        const Eigen::Vector3d of_rim = change.segment<3>(first_[rim_of_.size() + k]);
        const Eigen::Vector2d centre = centre_of(static_cast<int>(k));
        for (const int vertex : rims_[k])
        {
            const Eigen::Vector2d arm = positions_.row(vertex).transpose() - centre;
            worst = std::max(
                worst, (of_rim.head<2>() + of_rim(2) * Eigen::Vector2d(-arm.y(), arm.x())).norm());
        }
    }
    return worst;
}

std::optional<Eigen::VectorXd> FlatSystem::solved(
    const std::shared_ptr<const numerics::SparseMatrix>& tangent, const Eigen::VectorXd& right)
{
    if (!factor_)
    {
        Points places(count_, 3);
        for (int k = 0; k < count_; ++k)
            places.row(k) = places_[at(k)].transpose();
        auto tree = std::make_shared<const numerics::SeparatorTree>(
            numerics::nested_dissection(*tangent, places));
        factor_.emplace(std::make_shared<const numerics::FrontPattern>(
            numerics::Elimination(numerics::unmerged(tangent), std::move(tree))));
    }
    try
    {
        factor_->factorise(*tangent);
        return factor_->solve(right);
    }
    catch (const SolverError&)
    {
        return std::nullopt;
    }
}

void FlatSystem::move(const numerics::NewtonStep& step, double share)
{
    positions_ = before_;
    for (std::size_t i = 0; i < rim_of_.size(); ++i)
        if (first_[i] >= 0)
            positions_.row(static_cast<Eigen::Index>(i)) +=
                share * step.change.segment<2>(first_[i]).transpose();
    for (std::size_t k = 0; k < rims_.size(); ++k)
    {
        const Eigen::Vector3d of_rim = share * step.change.segment<3>(first_[rim_of_.size() + k]);
        const Eigen::Vector2d centre = centre_of(static_cast<int>(k));
        const Eigen::Rotation2Dd turn(of_rim(2));
        for (const int vertex : rims_[k])
            positions_.row(vertex) =
                (centre + of_rim.head<2>() + turn * (positions_.row(vertex).transpose() - centre))
                    .transpose();
    }
}

}  // namespace sheetmorph::surface
