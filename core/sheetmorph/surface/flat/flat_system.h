// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/numerics/cholesky/sparse_cholesky.h"
#include "sheetmorph/numerics/newton_minimum.h"
#include "sheetmorph/surface/flat/flattening.h"

#include <Eigen/Dense>
#include <optional>

namespace sheetmorph::surface
{

//! A triangle of a membrane in the plane.
struct FlatTriangle
{
    int index;  //!< in the mesh
    std::array<int, 3> corners;
    Eigen::Matrix<double, 3, 2> gradients;  //!< of the shape functions, as it wants to be
    double area;                            //!< mm^2
};

//! The membrane of a sheet in the plane: vertices move freely or with a rim.
class FlatSystem : public numerics::NewtonProblem
{
public:
    //! \param start  where the vertices are; rims are put where they fit best
    FlatSystem(const FlatInput& input, std::vector<FlatTriangle> triangles, FlatPoints start);

    const FlatPoints& positions() const { return positions_; }
    const std::vector<char>& rigid_rims() const { return is_rigid_; }

    //! Over E h and elastic constants.
    double energy() const;

    double value() override { return energy(); }

    //! Of the tangent itself, or (model 1) of that of tension alone. Lengths are mm.
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
    std::vector<int> rim_of_;  // by vertex, or -1
    std::vector<int> first_;   // by vertex, then by rim: unknowns
    int count_ = 0;
    std::vector<Vector3> places_;                     // of the unknowns at rest
    std::optional<numerics::SparseCholesky> factor_;  // of the last tangent; all have one pattern
};

}  // namespace sheetmorph::surface
