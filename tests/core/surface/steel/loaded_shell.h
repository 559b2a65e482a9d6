// SPDX-License-Identifier: LGPL-2.1-or-later
// The shell of the steel answer under forces, which no user has: for benchmarks that prescribe
// them.
#pragma once

#include "sheetmorph/surface/steel/shell_system.h"
#include "shapes.h"

#include <functional>
#include <memory>

namespace sheetmorph::surface::cases
{

//! What carries a sheet: vertices that are clamped, and planes of symmetry.
struct ShellSupport
{
    using Where = std::function<bool(const Vector3&)>;
    Where clamped = [](const Vector3&) { return false; };
    std::vector<std::pair<int, Where>> symmetries;  //!< axis that stays, and on which vertices
    std::vector<std::pair<int, int>> held;          //!< vertex, axis
};

struct Sheet
{
    double young, poisson, thickness;
};

class LoadedShell
{
public:
    LoadedShell(mesh::TriangleMesh mesh, const Sheet& sheet, const ShellSupport& support);

    //! Adds a force along an axis; what the sheet carries at a load factor of 1.
    void pull(int vertex, int axis, double force);

    //! Newton's method with the stresses that the step before predicts. False: it did not settle.
    bool carry(double factor, int most_rounds = 40);

    //! mm, along an axis.
    double moved(int vertex, int axis) const;

    //! Of its length at rest.
    double shortest_edge() const;

    const mesh::TriangleMesh& rest() const { return rest_; }

private:
    double bending() const { return sheet_.thickness * sheet_.thickness / 12.0; }
    int number(int vertex, int axis) const;
    void hold_symmetric(const ShellMovers& movers, int axis, const ShellSupport::Where& where,
                        std::vector<char>& is_held) const;
    void find_selection(const std::vector<char>& is_held);
    Eigen::VectorXd solved(const ShellSystem::Tangent& tangent, const Eigen::VectorXd& right) const;

    mesh::TriangleMesh rest_;
    Sheet sheet_;
    ShellMesh shell_mesh_;
    SurfaceConstraints constraints_;
    SurfaceTargets targets_;
    VertexRoles roles_;
    BodyMotions bodies_;
    std::vector<Turner> turners_;
    std::unique_ptr<Joints> joints_;
    std::vector<ShellMover> vertices_;
    std::unique_ptr<ShellSystem> shell_;
    ShellSystem::Stresses stresses_;
    numerics::SparseMatrix selection_;
    std::vector<int> unknown_of_;  // of the selection, or -1
    Eigen::VectorXd load_;
};

//! The vertex nearest to a place.
int vertex_near(const mesh::TriangleMesh& mesh, const Vector3& wanted);

}  // namespace sheetmorph::surface::cases
