// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/numerics/cholesky/sparse_cholesky.h"
#include "sheetmorph/numerics/newton_minimum.h"
#include "sheetmorph/surface/flat/flattening.h"

#include <Eigen/Dense>
#include <optional>

namespace sheetmorph::surface
{

//! A triangle of a plane membrane.
struct FlatTriangle
{
    int index;  //!< in the mesh
    std::array<int, 3> corners;
    //! Of the shape functions on its stress-free shape, 1/mm.
    Eigen::Matrix<double, 3, 2> gradients;
    double area;  //!< mm^2
};

//! The plane membrane of a sheet. Vertices move freely or with a rigid rim.
class FlatSystem : public numerics::NewtonProblem
{
public:
    //! \param start  initial positions; rims move to their best-fitting position
    FlatSystem(const FlatInput& input, std::vector<FlatTriangle> triangles, FlatPoints start);

    const FlatPoints& positions() const { return positions_; }
    const std::vector<char>& rigid_rims() const { return is_rigid_; }

    //! Membrane energy divided by E h / (1 - nu^2), mm^2.
    double energy() const;

    double value() override { return energy(); }

    //! Newton step. Model 0 uses the full tangent; model 1 only includes tensile stress, so that it
    //! is positive semidefinite. Step lengths are in mm.
    std::optional<numerics::NewtonStep> step(int model) override;

    void remember() override { before_ = positions_; }
    void restore() override { positions_ = before_; }
    void move(const numerics::NewtonStep& step, double share) override;

private:
    using Rows = Eigen::Matrix<double, 2, Eigen::Dynamic>;
    struct Columns
    {
        std::vector<int> ids;
        Eigen::Matrix<double, 6, Eigen::Dynamic> rows;
    };
    void place_rims(const FlatInput& input);
    void number();
    std::optional<Eigen::VectorXd> solved(
        const std::shared_ptr<const numerics::SparseMatrix>& tangent, const Eigen::VectorXd& right);
    Columns columns_of(const FlatTriangle& triangle) const;
    double length_of(const Eigen::VectorXd& change) const;
    Eigen::Vector2d centre_of(int rim) const;

    const mesh::TriangleMesh& mesh_;
    std::vector<FlatTriangle> triangles_;
    FlatPoints positions_, before_;
    std::vector<VertexIds> rims_;
    std::vector<char> is_rigid_;
    std::vector<int> rim_of_;  // by vertex; or -1
    std::vector<int> first_;   // by vertex, then by rim: first unknown
    int count_ = 0;
    std::vector<Vector3> places_;                     // rest positions of the unknowns
    std::optional<numerics::SparseCholesky> factor_;  // of the last tangent; same pattern
};

}  // namespace sheetmorph::surface
