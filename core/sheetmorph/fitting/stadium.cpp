// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/fitting/stadium.h"

#include "sheetmorph/numerics/newton_minimum.h"

#include <Eigen/Geometry>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>

namespace sheetmorph::fitting
{

namespace
{

// Limits of the iteration; step lengths are relative to the size of the outline. A step below
// `tolerance` has converged: from the accuracy of 1e-9 that SheetMorph promises. One below
// `rounding`, from doubles, is zero. Rims take 3 to 10 iterations, so 100 are never reached by one.
constexpr int most_iterations = 100;
constexpr double tolerance = 1e-9;
constexpr double rounding = 1e-16;

// Derivatives of the distances by centre (2) and radius; for a slot also by half_segment and angle.
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

//! Least squares of the distances from points to an outline, solved by Gauss-Newton steps. The
//! coordinates are divided by the size of the outline.
class OutlineProblem : public numerics::NewtonProblem
{
public:
    OutlineProblem(const PlanePoints& points, const Stadium& start, bool is_slot)
        : points_(points), shape_(start), before_(start), is_slot_(is_slot)
    {
    }

    const Stadium& shape() const { return shape_; }

    double value() override { return shape_.misses(points_).squaredNorm(); }

    // Model 1 keeps parameters that the points do not determine, such as the angle of a round slot.
    std::optional<numerics::NewtonStep> step(int model) override
    {
        const Eigen::VectorXd miss = shape_.misses(points_);
        const Eigen::MatrixXd rows = jacobian(points_, shape_, is_slot_);
        const Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> factor(rows);
        const bool is_determined = factor.rank() == rows.cols();
        if (model == 0 && !is_determined)
            return std::nullopt;
        numerics::NewtonStep found{-factor.solve(miss)};
        found.length = found.change.norm() / (shape_.half_segment + shape_.radius);
        found.slope = 2.0 * miss.dot(rows * found.change);
        found.is_exact = is_determined;
        return found;
    }

    void remember() override { before_ = shape_; }
    void restore() override { shape_ = before_; }
    void move(const numerics::NewtonStep& step, double share) override
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
    numerics::NewtonLimits limits{how.what};
    limits.most_rounds = most_iterations;
    limits.settled = tolerance;
    limits.finest = rounding;
    limits.models = how.leaves_undetermined ? 2 : 1;
    Convergence found = numerics::newton_minimum(problem, limits);
    shape = problem.shape();
    return found;
}

}  // namespace sheetmorph::fitting
