// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/numerics/cholesky/sparse_cholesky.h"
#include "sheetmorph/surface/steel/shell_element.h"
#include "sheetmorph/surface/steel/shell_movers.h"

namespace sheetmorph::surface
{

//! What no pose changes.
struct ShellInput
{
    const ShellMesh& mesh;
    const PlacementInput& part;
    double poisson = 0.3;
};

//! Energy, gradient and tangent of a whole shell in its unknowns: open vertices and directors, then
//! the freedoms of the joints, all to first order about the shape in hand.
class ShellSystem
{
public:
    //! \param joints  at the start; it is moved along
    ShellSystem(const ShellInput& input, ShellMovers movers, Joints& joints);

    int unknowns() const { return movers_.open + joints_.freedoms(); }
    const ShellShape& shape() const { return shape_; }

    //! \param bending  h^2 / 12, mm^2
    double energy(double bending) const;

    //! Moves along unknowns; directors are transported with their edges.
    void step(const Eigen::VectorXd& change);
    void restore(const ShellShape& shape);

    //! The farthest any vertex would move, mm, and the farthest a body would turn, radians.
    double shift_of(const Eigen::VectorXd& change) const;
    double turn_of(const Eigen::VectorXd& change) const;

    //! A field at right angles to the sheet where it is, without a symmetry: what buckling modes
    //! are sought from.
    Eigen::VectorXd out_of_plane() const;

    using Stresses = std::vector<ShellElement::Stress>;
    Stresses no_stresses() const { return Stresses(elements_.size()); }

    //! What the stresses become along a step, to first order.
    Stresses predicted(double bending, const Eigen::VectorXd& change) const;

    struct Tangent
    {
        Eigen::VectorXd gradient;
        std::shared_ptr<numerics::SparseMatrix> matrix;  //!< both triangles
    };

    //! The stresses there are now: their tension, and a share of what is not tension. The tangent
    //! of tension alone has no negative direction.
    Stresses eased(double bending, double share) const;

    //! \param stresses  whose second-order part is taken
    //! \param share     of the second-order part of bodies
    Tangent tangent(double bending, const Stresses& stresses, double share = 1.0);

    //! A matrix of the pattern that all tangents have.
    std::shared_ptr<const numerics::SparseMatrix> pattern() const { return matrix_; }

    //! Order of elimination of the tangents.
    const std::shared_ptr<const numerics::SeparatorTree>& tree() const { return tree_; }

    //! Rows (3 k, unknowns) of the points that are held, and what they miss (3 k) mm.
    numerics::SparseMatrix point_rows() const;
    Eigen::VectorXd point_misses(const SurfaceTargets& targets) const;

private:
    using Local = Eigen::Matrix<double, 12, Eigen::Dynamic>;
    struct Freedom
    {
        std::array<int, 12> direct;  // unknown of each local number, or -1
        std::vector<int> columns;    // unknowns of the element, ascending
        std::vector<int> things;     // theirs, ascending
        std::size_t first_slot = 0;
        bool is_jointed = false;
    };

    //! Unknowns that belong together: an element has all of them or none.
    struct Thing
    {
        int first, count;
        Vector3 place;
    };
    struct Projected
    {
        Eigen::MatrixXd matrix;
        Eigen::VectorXd gradient;
    };

    void brace_joints();
    void find_columns();
    static void check_count(std::size_t entries);
    void find_things();
    numerics::SparseMatrix coupled_things() const;
    void find_pattern(const numerics::SparseMatrix& coupled);
    void find_slots(const numerics::SparseMatrix& coupled);
    void find_tree(const numerics::SparseMatrix& coupled);
    void add_to_matrix(const Freedom& freedom, const Eigen::MatrixXd& part);
    std::vector<int> columns_of(const ShellMesh::Triangle& triangle) const;
    ShellElement::Place place_of(std::size_t element) const;
    Local local_rows(std::size_t element) const;
    Vector3 arm(const JointLevel& level, std::size_t axis, const Vector3& point) const;
    void add_second_order(std::size_t element, const ShellElement::Vector& forces,
                          Eigen::MatrixXd& sum) const;
    ShellElement::Vector local_step(std::size_t element, const Eigen::VectorXd& change) const;
    double sign_of(std::size_t element, int local) const;
    void project(std::size_t element, const ShellElement::Matrix& stiffness,
                 const ShellElement::Vector& forces, Projected& found) const;

    const ShellMesh& mesh_;
    PlacementInput part_;
    ShellMovers movers_;
    Joints& joints_;
    ShellShape shape_;
    std::vector<std::size_t> triangles_;  // of the mesh, that can move
    std::vector<ShellElement> elements_;
    std::vector<Freedom> freedoms_;
    std::vector<Thing> things_;  // by their unknowns
    std::vector<int> slots_;     // by element, column and row of things: where their block begins
    std::shared_ptr<numerics::SparseMatrix> matrix_;
    std::shared_ptr<const numerics::SeparatorTree> tree_;
};

}  // namespace sheetmorph::surface
