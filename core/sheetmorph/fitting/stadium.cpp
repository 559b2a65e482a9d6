// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/fitting/stadium.h"

#include "sheetmorph/numerics/newton_minimum.h"

#include <Eigen/Geometry>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>

namespace sheetmorph
{

namespace
{

// Rounds of the fit, and the steps over the outline's size that count as small and as none.
constexpr int most_rounds = 100;
constexpr double settled = 1e-9;
constexpr double finest = 1e-16;

// By centre (2), radius, and for slots half_segment and angle.
Eigen::MatrixXd jacobian(const PlanePoints& points, const Stadium& shape, bool is_slot)
{
    Eigen::MatrixXd rows(points.rows(), is_slot ? 5 : 3);
    for (Eigen::Index i = 0; i < points.rows(); ++i)
    {
        const Eigen::Vector2d point = points.row(i).transpose();
        const Eigen::Vector2d out = shape.arm(point).normalized();
        rows.row(i).head<3>() << -out(0), -out(1), -1.0;
        if (!is_slot)
            continue;
        const double along = (point - shape.centre).dot(shape.along());
        const double end = std::clamp(along, -shape.half_segment, shape.half_segment);
        const bool is_beyond = std::abs(along) >= shape.half_segment;
        rows(i, 3) = is_beyond ? -std::copysign(1.0, along) * out.dot(shape.along()) : 0.0;
        rows(i, 4) = -end * out.dot(shape.across());
    }
    return rows;
}

Stadium stepped(const Stadium& shape, const Eigen::VectorXd& step)
{
    Stadium next = shape;
    next.centre += step.head<2>();
    next.radius += step(2);
    if (step.size() == 5)
    {
        next.half_segment = std::max(0.0, next.half_segment + step(3));
        next.angle += step(4);
    }
    return next;
}

//! An outline by Gauss-Newton steps for the distances to it; points in units of its size.
class OutlineProblem : public NewtonProblem
{
public:
    OutlineProblem(const PlanePoints& points, const Stadium& start, bool is_slot)
        : points_(points), shape_(start), before_(start), is_slot_(is_slot)
    {
    }

    const Stadium& shape() const { return shape_; }

    double value() override { return shape_.misses(points_).squaredNorm(); }

    // Model 1 leaves alone what the points do not determine, as the angle of a slot that is round.
    std::optional<NewtonStep> step(int model) override
    {
        const Eigen::VectorXd miss = shape_.misses(points_);
        const Eigen::MatrixXd rows = jacobian(points_, shape_, is_slot_);
        const Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> factor(rows);
        const bool is_determined = factor.rank() == rows.cols();
        if (model == 0 && !is_determined)
            return std::nullopt;
        NewtonStep found{-factor.solve(miss)};
        found.length = found.change.norm() / (shape_.half_segment + shape_.radius);
        found.slope = 2.0 * miss.dot(rows * found.change);
        found.is_exact = is_determined;
        return found;
    }

    void remember() override { before_ = shape_; }
    void restore() override { shape_ = before_; }
    void move(const NewtonStep& step, double share) override
    {
        shape_ = stepped(before_, share * step.change);
    }

private:
    const PlanePoints& points_;
    Stadium shape_, before_;
    bool is_slot_;
};

}  // namespace

Eigen::Vector2d Stadium::along() const
{
    return {std::cos(angle), std::sin(angle)};
}

Eigen::Vector2d Stadium::across() const
{
    return {-std::sin(angle), std::cos(angle)};
}

Eigen::Vector2d Stadium::arm(const Eigen::Vector2d& point) const
{
    const Eigen::Vector2d offset = point - centre;
    return offset - std::clamp(offset.dot(along()), -half_segment, half_segment) * along();
}

Eigen::VectorXd Stadium::misses(const PlanePoints& points) const
{
    Eigen::VectorXd miss(points.rows());
    for (Eigen::Index i = 0; i < points.rows(); ++i)
        miss(i) = arm(points.row(i).transpose()).norm() - radius;
    return miss;
}

Convergence fit_stadium(const PlanePoints& points, const StadiumFit& how, Stadium& shape)
{
    OutlineProblem problem(points, shape, how.is_slot);
    NewtonLimits limits{how.what};
    limits.most_rounds = most_rounds;
    limits.settled = settled;
    limits.finest = finest;
    limits.models = how.leaves_undetermined ? 2 : 1;
    Convergence found = newton_minimum(problem, limits);
    shape = problem.shape();
    return found;
}

}  // namespace sheetmorph
