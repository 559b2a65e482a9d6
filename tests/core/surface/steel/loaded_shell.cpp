// SPDX-License-Identifier: LGPL-2.1-or-later
#include "surface/steel/loaded_shell.h"

#include "sheetmorph/base/errors.h"

#include <Eigen/SparseCholesky>
#include <algorithm>

namespace sheetmorph::surface::cases
{

namespace
{

Vector3 place(const Points& points, int i)
{
    return points.row(i).transpose();
}

}  // namespace

LoadedShell::LoadedShell(mesh::TriangleMesh mesh, const Sheet& sheet, const ShellSupport& support)
    : rest_(std::move(mesh)), sheet_(sheet), shell_mesh_(rest_)
{
    roles_.role.assign(static_cast<std::size_t>(rest_.vertex_count()), Role::free);
    roles_.owner.assign(roles_.role.size(), -1);
    for (int i = 0; i < rest_.vertex_count(); ++i)
        if (support.clamped(place(rest_.points(), i)))
            roles_.role[static_cast<std::size_t>(i)] = Role::fixed;
    const Points logs = Points::Zero(rest_.vertex_count(), 3);
    const PlacementInput part{rest_, constraints_, roles_};
    const ShellPose pose{part, targets_, bodies_, rest_.points(), logs};
    joints_ = std::make_unique<Joints>(part, targets_, turners_, bodies_);
    ShellMovers movers(shell_mesh_, pose, *joints_, turners_);
    vertices_ = movers.vertices;
    std::vector<char> is_held(static_cast<std::size_t>(movers.open), 0);
    for (const auto& [axis, where] : support.symmetries)
        hold_symmetric(movers, axis, where, is_held);
    for (const auto& [vertex, axis] : support.held)
        is_held[static_cast<std::size_t>(number(vertex, axis))] = 1;
    find_selection(is_held);
    shell_ = std::make_unique<ShellSystem>(ShellInput{shell_mesh_, part, sheet.poisson},
                                           std::move(movers), *joints_);
    load_ = Eigen::VectorXd::Zero(shell_->unknowns());
    stresses_ = shell_->no_stresses();
}

void LoadedShell::pull(int vertex, int axis, double force)
{
    if (vertices_[static_cast<std::size_t>(vertex)].kind == ShellMover::Kind::open)
        load_(number(vertex, axis)) += force / (sheet_.young * sheet_.thickness);
}

bool LoadedShell::carry(double factor, int most_rounds)
{
    const double size = rest_.size();
    for (int round = 0; round < most_rounds; ++round)
    {
        const ShellSystem::Tangent tangent = shell_->tangent(bending(), stresses_);
        const Eigen::VectorXd out_of_balance =
            selection_.transpose() * (factor * load_ - tangent.gradient);
        Eigen::VectorXd change = selection_ * solved(tangent, out_of_balance);
        const double shift = shell_->shift_of(change);
        change /= std::max(1.0, std::max(shift / (0.1 * size), shell_->turn_of(change) / 0.5));
        stresses_ = shell_->predicted(bending(), change);
        shell_->step(change);
        if (shift < 1e-6 * size)
            return true;
    }
    return false;
}

double LoadedShell::moved(int vertex, int axis) const
{
    return shell_->shape().positions(vertex, axis) - rest_.points()(vertex, axis);
}

double LoadedShell::shortest_edge() const
{
    double shortest = 1e300;
    for (const auto& [a, b] : shell_mesh_.edges)
        shortest = std::min(
            shortest,
            (place(shell_->shape().positions, a) - place(shell_->shape().positions, b)).norm()
                / (place(rest_.points(), a) - place(rest_.points(), b)).norm());
    return shortest;
}

int LoadedShell::number(int vertex, int axis) const
{
    return vertices_[static_cast<std::size_t>(vertex)].index + axis;
}

// By the kernel's own factor where the tangent is positive definite; where the sheet snaps it
// is not, and L D L^T takes it as it is.
Eigen::VectorXd LoadedShell::solved(const ShellSystem::Tangent& tangent,
                                    const Eigen::VectorXd& right) const
{
    try
    {
        return numerics::SparseCholesky(
                   {tangent.matrix, unknown_of_, static_cast<int>(right.size())}, shell_->tree())
            .solve(right);
    }
    catch (const SolverError&)
    {
        const numerics::SparseMatrix matrix = selection_.transpose() * *tangent.matrix * selection_;
        return Eigen::SimplicialLDLT<numerics::SparseMatrix>(matrix).solve(right);
    }
}

// Vertices stay in the plane, edges in it do not turn about themselves.
void LoadedShell::hold_symmetric(const ShellMovers& movers, int axis,
                                 const ShellSupport::Where& where, std::vector<char>& is_held) const
{
    const auto is_on = [&](int vertex) { return where(place(rest_.points(), vertex)); };
    for (int i = 0; i < rest_.vertex_count(); ++i)
        if (is_on(i) && vertices_[static_cast<std::size_t>(i)].kind == ShellMover::Kind::open)
            is_held[static_cast<std::size_t>(number(i, axis))] = 1;
    for (std::size_t e = 0; e < movers.edges.size(); ++e)
        if (movers.edges[e].kind == ShellMover::Kind::open && is_on(shell_mesh_.edges[e][0])
            && is_on(shell_mesh_.edges[e][1]))
            is_held[static_cast<std::size_t>(movers.edges[e].index)] = 1;
}

void LoadedShell::find_selection(const std::vector<char>& is_held)
{
    std::vector<Eigen::Triplet<double>> entries;
    unknown_of_.assign(is_held.size(), -1);
    for (std::size_t k = 0; k < is_held.size(); ++k)
    {
        if (is_held[k] != 0)
            continue;
        unknown_of_[k] = static_cast<int>(entries.size());
        entries.emplace_back(static_cast<int>(k), unknown_of_[k], 1.0);
    }
    selection_.resize(static_cast<Eigen::Index>(is_held.size()),
                      static_cast<Eigen::Index>(entries.size()));
    selection_.setFromTriplets(entries.begin(), entries.end());
}

int vertex_near(const mesh::TriangleMesh& mesh, const Vector3& wanted)
{
    int found = 0;
    (mesh.points().rowwise() - wanted.transpose()).rowwise().norm().minCoeff(&found);
    return found;
}

}  // namespace sheetmorph::surface::cases
