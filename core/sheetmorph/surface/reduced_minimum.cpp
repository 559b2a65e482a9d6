// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/surface/reduced_minimum.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <array>
#include <limits>

namespace sheetmorph
{

namespace
{

constexpr int none = -1;
constexpr int most_steps = 100;
constexpr double smallest_step = 1e-14;  // radians, or of the size of the feature
constexpr double rounding = 1e-9;        // steps below it that shrink no more are noise
constexpr double unfelt = 1e-11;         // of the stiffest freedom: the energy does not feel it

//! One freedom of the joints as it moves one turner.
struct Mover
{
    int freedom;
    std::size_t level;
    bool is_turn;
    Vector3 axis;
    Vector3 point;
};

//! First or second derivative of a turner's motion.
struct Change
{
    Matrix3 rotation = Matrix3::Zero();
    Vector3 centre = Vector3::Zero();
};

Matrix3 crossing(const Vector3& axis)
{
    Matrix3 matrix;
    matrix << 0.0, -axis.z(), axis.y(), axis.z(), 0.0, -axis.x(), -axis.y(), axis.x(), 0.0;
    return matrix;
}

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
    return {crossing(mover.axis) * state.rotation, mover.axis.cross(state.centre - mover.point)};
}

// A turn acts on what the factors inside it change; of one factor, on the mean of both orders.
Change second_change(const Mover& outer, const Mover& inner, const BodyState& state)
{
    Change change;
    if (!outer.is_turn)
        return change;
    const Change first = first_change(inner, state);
    change.rotation = crossing(outer.axis) * first.rotation;
    change.centre = outer.axis.cross(first.centre);
    if (outer.level == inner.level)
    {
        const Change other = first_change(outer, state);
        change.rotation = 0.5 * (change.rotation + crossing(inner.axis) * other.rotation);
        change.centre = 0.5 * (change.centre + inner.axis.cross(other.centre));
    }
    return change;
}

//! The energy about one configuration.
struct Expansion
{
    double value = 0.0;
    Eigen::VectorXd gradient;
    Eigen::MatrixXd hessian;
};

//! What a configuration is measured with.
struct Measure
{
    const PlacementInput& part;
    const FeatureResponses& responses;
    const ReducedEnergy& energy;

    double value(const Joints& joints) const
    {
        const Eigen::MatrixXd rho = entries_of(joints, part, responses);
        return (rho.cwiseProduct(energy.stiffness * rho + 2.0 * energy.slope)).sum();
    }
};

// Rows of F that a change of turner k meets: sum of F[turn + b, x] dR[x, b] + F[shift, x] dt[x].
double dot(const TurnerColumns& columns, const Eigen::MatrixXd& forces, const Change& change)
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
                   const FeatureResponses& responses, const Eigen::MatrixXd& forces)
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

Expansion expand(const Joints& joints, const Measure& measure)
{
    const Eigen::MatrixXd rho = entries_of(joints, measure.part, measure.responses);
    const Eigen::MatrixXd forces = measure.energy.stiffness * rho + measure.energy.slope;
    Expansion at;
    at.value = (rho.cwiseProduct(forces + measure.energy.slope)).sum();
    at.gradient = Eigen::VectorXd::Zero(joints.freedoms());
    at.hessian = Eigen::MatrixXd::Zero(joints.freedoms(), joints.freedoms());
    const Jacobians change = jacobians(joints, measure.responses);
    for (std::size_t x = 0; x < 3; ++x)
    {
        at.gradient += 2.0 * (change[x].transpose() * forces.col(static_cast<Eigen::Index>(x)));
        const Eigen::MatrixXd half = measure.energy.stiffness * change[x];
        at.hessian += 2.0 * (change[x].transpose() * half);
    }
    add_curvature(at.hessian, joints, measure.responses, forces);
    return at;
}

// Numbers that make every freedom about as stiff as any other; what nothing feels gets none.
Eigen::VectorXd scales(const Expansion& at)
{
    const Eigen::VectorXd stiff = at.hessian.diagonal().cwiseAbs();
    const double largest = stiff.size() > 0 ? stiff.maxCoeff() : 0.0;
    return stiff.unaryExpr(
        [largest](double value)
        { return value > 1e-18 * largest && value > 0.0 ? 1.0 / std::sqrt(value) : 0.0; });
}

// The Newton step; where the energy is not convex, along eigenvectors with |eigenvalue|.
Eigen::VectorXd newton_step(const Expansion& at)
{
    const Eigen::VectorXd scale = scales(at);
    Eigen::MatrixXd scaled = scale.asDiagonal() * at.hessian * scale.asDiagonal();
    const Eigen::VectorXd right = -(scale.asDiagonal() * at.gradient);
    const Eigen::LLT<Eigen::MatrixXd> factor(scaled);
    if (factor.info() == Eigen::Success
        && factor.matrixLLT().diagonal().cwiseAbs().minCoeff() > std::sqrt(unfelt))
        return scale.asDiagonal() * factor.solve(right);
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(scaled);
    const Eigen::VectorXd values = eigen.eigenvalues().cwiseAbs();
    const double largest = values.maxCoeff();
    const Eigen::VectorXd inverse = values.unaryExpr(
        [largest](double value) { return value > unfelt * largest ? 1.0 / value : 0.0; });
    const Eigen::VectorXd along = eigen.eigenvectors().transpose() * right;
    return scale.asDiagonal() * Eigen::VectorXd(eigen.eigenvectors() * inverse.cwiseProduct(along));
}

// No freedom turns or shifts by more than a quarter of a radian of its own scale at once.
double shortened(const Eigen::VectorXd& step, const Joints& joints)
{
    double turn = 0.0;
    for (std::size_t k = 0; k < joints.states().size(); ++k)
        for (const Mover& mover : movers_of(joints.levels(k)))
            if (mover.is_turn)
                turn = std::max(turn, std::abs(step(mover.freedom)));
    return turn > 0.8 ? 0.8 / turn : 1.0;
}

}  // namespace

Eigen::MatrixXd entries_of(const Joints& joints, const PlacementInput& part,
                           const FeatureResponses& responses)
{
    const std::vector<TurnerColumns>& columns = responses.columns();
    int rows = 0;
    for (const TurnerColumns& of_turner : columns)
        rows += (of_turner.turn != none ? 3 : 0) + (of_turner.shift != none ? 1 : 0);
    Eigen::MatrixXd entries = Eigen::MatrixXd::Zero(rows, 3);
    for (std::size_t k = 0; k < columns.size(); ++k)
    {
        const BodyState& state = joints.states()[k];
        if (columns[k].turn != none)
            entries.block<3, 3>(columns[k].turn, 0) =
                (state.rotation - Matrix3::Identity()).transpose();
        if (columns[k].shift != none)
        {
            const int body = responses.turners()[k].body;
            const Vector3& rest = part.roles.bodies[static_cast<std::size_t>(body)].centre;
            entries.row(columns[k].shift) = (state.centre - rest).transpose();
        }
    }
    return entries;
}

void minimise(Joints& joints, const PlacementInput& part, const FeatureResponses& responses,
              const ReducedEnergy& energy)
{
    const Measure measure{part, responses, energy};
    double last = std::numeric_limits<double>::infinity();
    for (int count = 0; count < most_steps && joints.freedoms() > 0; ++count)
    {
        const Expansion here = expand(joints, measure);
        Eigen::VectorXd step = newton_step(here);
        step *= shortened(step, joints);
        const double noise = 1e-14 * std::abs(here.value);
        const std::vector<BodyState> start = joints.states();
        bool is_lower = false;
        for (int halving = 0; halving < 40 && !is_lower; ++halving, step *= 0.5)
        {
            joints.restore(start);
            joints.step(step);
            is_lower = measure.value(joints) <= here.value + noise;
        }
        const double length = step.cwiseAbs().maxCoeff();
        if (!is_lower)
            joints.restore(start);
        if (!is_lower || length <= smallest_step || (last < rounding && length > 0.5 * last))
            return;
        last = length;
    }
}

}  // namespace sheetmorph
