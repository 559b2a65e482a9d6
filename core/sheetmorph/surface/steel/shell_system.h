// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/numerics/cholesky/sparse_cholesky.h"
#include "sheetmorph/surface/steel/shell_element.h"
#include "sheetmorph/surface/steel/shell_movers.h"

namespace sheetmorph::surface
{

//! The data that are independent of the pose.
struct ShellInput
{
    const ShellMesh& mesh;
    const PlacementInput& part;
    double poisson = 0.3;
};

//! Energy, gradient and tangent of a whole shell. The unknowns are free vertices and directors,
//! then the freedoms of the joints, as increments to the current shape.
class ShellSystem
{
public:
    //! \param joints  in their initial state; they move with the shell
    ShellSystem(const ShellInput& input, ShellMovers movers, Joints& joints);

    int unknowns() const { return movers_.open + joints_.freedoms(); }
    const ShellShape& shape() const { return shape_; }

    //! \param bending  h^2 / 12, mm^2
    double energy(double bending) const;

    //! Applies increments of the unknowns; directors are transported with their edges.
    void step(const Eigen::VectorXd& change);
    void restore(const ShellShape& shape);

    //! Largest displacement of a vertex, mm, and largest rotation of a body or director, radians.
    double shift_of(const Eigen::VectorXd& change) const;
    double turn_of(const Eigen::VectorXd& change) const;

    //! A field normal to the sheet without a symmetry; the start of the search for buckling modes.
    Eigen::VectorXd out_of_plane() const;

    using Stresses = std::vector<ShellElement::Stress>;
    Stresses no_stresses() const { return Stresses(elements_.size()); }

    //! The stresses after a step, to first order.
    Stresses predicted(double bending, const Eigen::VectorXd& change) const;

    struct Tangent
    {
        Eigen::VectorXd gradient;
        std::shared_ptr<numerics::SparseMatrix> matrix;  //!< both triangles
    };

    //! The current stresses: their tension and a share of the rest. The tangent of tension alone is
    //! positive semidefinite.
    Stresses eased(double bending, double share) const;

    //! \param stresses  used in the second-order part
    //! \param share     share of the second-order part of bodies
    Tangent tangent(double bending, const Stresses& stresses, double share = 1.0);

    //! A matrix with the pattern of all tangents.
    std::shared_ptr<const numerics::SparseMatrix> pattern() const { return matrix_; }

    //! Elimination order of the tangents.
    const std::shared_ptr<const numerics::SeparatorTree>& tree() const { return tree_; }

    //! Rows (3 k, unknowns) of the constrained points, and their errors (3 k), mm.
    numerics::SparseMatrix point_rows() const;
    Eigen::VectorXd point_misses(const SurfaceTargets& targets) const;

private:
    using Local = Eigen::Matrix<double, 12, Eigen::Dynamic>;
    struct Freedom
    {
        std::array<int, 12> direct;  // by local number: index in `columns`, or -1
        std::vector<int> columns;    // unknowns of the element, ascending
        std::vector<int> things;     // their blocks, ascending
        std::size_t first_slot = 0;
        bool is_jointed = false;
    };

    //! A block of unknowns; an element contains all of them or none.
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
    std::vector<std::size_t> triangles_;  // triangles of the mesh that can move
    std::vector<ShellElement> elements_;
    std::vector<Freedom> freedoms_;
    std::vector<Thing> things_;  // ordered by their unknowns
    std::vector<int> slots_;     // by element, column and row of blocks: first entry
    std::shared_ptr<numerics::SparseMatrix> matrix_;
    std::shared_ptr<const numerics::SeparatorTree> tree_;
};

}  // namespace sheetmorph::surface
