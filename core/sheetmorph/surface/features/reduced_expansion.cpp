// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/surface/features/reduced_expansion.h"

#include "sheetmorph/base/rotation.h"

#include <Eigen/Geometry>
#include <array>

namespace sheetmorph::surface
{

namespace
{

constexpr int none = -1;

//! One freedom of the joints and its effect on one rotating body.
struct Mover
{
    int freedom;
    std::size_t level;
    bool is_turn;
    Vector3 axis;
    Vector3 point;
};

//! First or second derivative of a rotating body's motion.
struct Change
{
    Matrix3 rotation = Matrix3::Zero();
    Vector3 centre = Vector3::Zero();
};

std::vector<Mover> movers_of(const std::vector<JointLevel>& levels)
{
    std::vector<Mover> movers;
    for (std::size_t level = 0; level < levels.size(); ++level)
        for (std::size_t k = 0; k < levels[level].axes.size(); ++k)
            movers.push_back({levels[level].first + static_cast<int>(k), level,
                              levels[level].is_turn, levels[level].axes[k], levels[level].point});
    return movers;
}

Change first_change(const Mover& mover, const BodyState& state)
{
    if (!mover.is_turn)
        return {Matrix3::Zero(), mover.axis};
    return {cross_matrix(mover.axis) * state.rotation,
            mover.axis.cross(state.centre - mover.point)};
}

// A rotation acts on the derivative of the factors inside it. Within one factor, the second
// derivative is the mean of both orders.
Change second_change(const Mover& outer, const Mover& inner, const BodyState& state)
{
    Change change;
    if (!outer.is_turn)
        return change;
    const Change first = first_change(inner, state);
    change.rotation = cross_matrix(outer.axis) * first.rotation;
    change.centre = outer.axis.cross(first.centre);
    if (outer.level == inner.level)
    {
        const Change other = first_change(outer, state);
        change.rotation = 0.5 * (change.rotation + cross_matrix(inner.axis) * other.rotation);
        change.centre = 0.5 * (change.centre + inner.axis.cross(other.centre));
    }
    return change;
}

// Product of forces F with a change of rotating body k: sum of F[turn + b, x] dR[x, b] + F[shift,
// x] dt[x].
double dot(const TurnerColumns& columns, const Points& forces, const Change& change)
{
    double sum = 0.0;
    if (columns.turn != none)
        sum += forces.block<3, 3>(columns.turn, 0).transpose().cwiseProduct(change.rotation).sum();
    if (columns.shift != none)
        sum += forces.row(columns.shift).dot(change.centre.transpose());
    return sum;
}

using Jacobians = std::array<Eigen::SparseMatrix<double>, 3>;

// d rho_x / dq for every coordinate x.
Jacobians jacobians(const Joints& joints, const FeatureResponses& responses)
{
    std::array<std::vector<Eigen::Triplet<double>>, 3> entries;
    for (std::size_t k = 0; k < joints.states().size(); ++k)
    {
        const TurnerColumns& columns = responses.columns()[k];
        for (const Mover& mover : movers_of(joints.levels(k)))
        {
            const Change change = first_change(mover, joints.states()[k]);
            for (int x = 0; x < 3; ++x)
            {
                auto& of_x = entries[static_cast<std::size_t>(x)];
                for (int b = 0; b < 3 && columns.turn != none; ++b)
                    of_x.emplace_back(columns.turn + b, mover.freedom, change.rotation(x, b));
                if (columns.shift != none)
                    of_x.emplace_back(columns.shift, mover.freedom, change.centre(x));
            }
        }
    }
    Jacobians matrices;
    for (std::size_t x = 0; x < 3; ++x)
    {
        int rows = 0;
        for (const TurnerColumns& columns : responses.columns())
            rows += (columns.turn != none ? 3 : 0) + (columns.shift != none ? 1 : 0);
        matrices[x].resize(rows, joints.freedoms());
        matrices[x].setFromTriplets(entries[x].begin(), entries[x].end());
    }
    return matrices;
}

void add_curvature(Eigen::MatrixXd& hessian, const Joints& joints,
                   const FeatureResponses& responses, const Points& forces)
{
    for (std::size_t k = 0; k < joints.states().size(); ++k)
    {
        const std::vector<Mover> movers = movers_of(joints.levels(k));
        for (std::size_t i = 0; i < movers.size(); ++i)
            for (std::size_t j = i; j < movers.size(); ++j)
            {
                const double amount =
                    2.0
                    * dot(responses.columns()[k], forces,
                          second_change(movers[i], movers[j], joints.states()[k]));
                hessian(movers[i].freedom, movers[j].freedom) += amount;
                if (i != j)
                    hessian(movers[j].freedom, movers[i].freedom) += amount;
            }
    }
}

// 2 a, if the antisymmetric part of n is [a] / 2.
Vector3 axial(const Matrix3& n)
{
    return 2.0 * Vector3(n(1, 2) - n(2, 1), n(2, 0) - n(0, 2), n(0, 1) - n(1, 0));
}

// Contribution of the forces on one rotating body to its own block.
Matrix3 curvature(const Matrix3& n)
{
    return n + n.transpose() - 2.0 * n.trace() * Matrix3::Identity();
}

// expand() for bodies that only rotate, block by block (TurnExpansion).
void expand_turns(const Joints& joints, const Measure& measure, const Forces& forces, Expansion& at)
{
    for (std::size_t k = 0; k < joints.states().size(); ++k)
    {
        const auto own = 3 * static_cast<Eigen::Index>(k);
        const Matrix3& rotation = joints.states()[k].rotation;
        const Matrix3 n = rotation * forces.pull.middleRows<3>(own);
        at.gradient.segment<3>(own) = axial(n);
        for (std::size_t l = 0; l <= k; ++l)
        {
            const auto other = 3 * static_cast<Eigen::Index>(l);
            const Matrix3 m = rotation * measure.energy.stiffness.block<3, 3>(own, other)
                              * joints.states()[l].rotation.transpose();
            const Matrix3 block = 2.0 * (m.trace() * Matrix3::Identity() - m.transpose());
            at.hessian.block<3, 3>(own, other) = block;
            at.hessian.block<3, 3>(other, own) = block.transpose();
        }
        at.hessian.block<3, 3>(own, own) += curvature(n);
    }
}

}  // namespace

Forces forces_at(const Joints& joints, const Measure& measure)
{
    Forces found{entries_of(joints, measure.part, measure.responses), {}, 0.0};
    found.pull =
        numerics::narrow_product(measure.energy.stiffness, found.entries) + measure.energy.slope;
    found.value = found.entries.cwiseProduct(found.pull + measure.energy.slope).sum();
    return found;
}

Expansion expand(const Joints& joints, const Measure& measure, const Forces& forces)
{
    Expansion at{Eigen::VectorXd::Zero(joints.freedoms()),
                 Eigen::MatrixXd::Zero(joints.freedoms(), joints.freedoms())};
    if (TurnExpansion::is_possible(joints, measure.responses))
    {
        expand_turns(joints, measure, forces, at);
        return at;
    }
    const Jacobians change = jacobians(joints, measure.responses);
    for (std::size_t x = 0; x < 3; ++x)
    {
        at.gradient +=
            2.0 * (change[x].transpose() * forces.pull.col(static_cast<Eigen::Index>(x)));
        const Eigen::MatrixXd half = measure.energy.stiffness * change[x];
        at.hessian += 2.0 * (change[x].transpose() * half);
    }
    add_curvature(at.hessian, joints, measure.responses, forces.pull);
    return at;
}

bool TurnExpansion::is_possible(const Joints& joints, const FeatureResponses& responses)
{
    for (std::size_t k = 0; k < joints.states().size(); ++k)
    {
        const std::vector<JointLevel>& levels = joints.levels(k);
        if (levels.size() != 1 || !levels[0].is_turn || levels[0].axes.size() != 3)
            return false;
    }
    return responses.at_rest() != nullptr;
}

TurnExpansion::TurnExpansion(const Joints& joints, const Measure& measure, const Forces& forces)
    : gradient_(joints.freedoms()),
      stiffness_(measure.energy.stiffness),
      at_rest_(*measure.responses.at_rest())
{
    for (std::size_t k = 0; k < joints.states().size(); ++k)
    {
        const auto row = 3 * static_cast<Eigen::Index>(k);
        const Matrix3& rotation = joints.states()[k].rotation;
        const Matrix3 n = rotation * forces.pull.middleRows<3>(row);
        rotations_.push_back(rotation);
        curvatures_.push_back(curvature(n));
        gradient_.segment<3>(row) = axial(n);
    }
}

Eigen::VectorXd TurnExpansion::times(const Eigen::VectorXd& q) const
{
    Points turned(q.size(), 3);
    for (std::size_t k = 0; k < rotations_.size(); ++k)
    {
        const auto row = 3 * static_cast<Eigen::Index>(k);
        turned.middleRows<3>(row) = (cross_matrix(q.segment<3>(row)) * rotations_[k]).transpose();
    }
    const Points pull = numerics::narrow_product(stiffness_, turned);
    Eigen::VectorXd product(q.size());
    for (std::size_t k = 0; k < rotations_.size(); ++k)
    {
        const auto row = 3 * static_cast<Eigen::Index>(k);
        product.segment<3>(row) =
            axial(rotations_[k] * pull.middleRows<3>(row)) + curvatures_[k] * q.segment<3>(row);
    }
    return product;
}

Eigen::VectorXd TurnExpansion::nearly_solved(const Eigen::VectorXd& q) const
{
    Eigen::VectorXd turned(q.size());
    for (std::size_t k = 0; k < rotations_.size(); ++k)
    {
        const auto row = 3 * static_cast<Eigen::Index>(k);
        turned.segment<3>(row) = rotations_[k].transpose() * q.segment<3>(row);
    }
    Eigen::VectorXd solved = at_rest_.solve(turned);
    for (std::size_t k = 0; k < rotations_.size(); ++k)
    {
        const auto row = 3 * static_cast<Eigen::Index>(k);
        solved.segment<3>(row) = (rotations_[k] * solved.segment<3>(row)).eval();
    }
    return solved;
}

Eigen::VectorXd gradient_of(const Joints& joints, const FeatureResponses& responses,
                            const Eigen::MatrixXd& forces)
{
    const Jacobians change = jacobians(joints, responses);
    Eigen::VectorXd gradient = Eigen::VectorXd::Zero(joints.freedoms());
    for (std::size_t x = 0; x < 3; ++x)
        gradient += 2.0 * (change[x].transpose() * forces.col(static_cast<Eigen::Index>(x)));
    return gradient;
}

}  // namespace sheetmorph::surface
