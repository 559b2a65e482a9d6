// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/numerics/newton_minimum.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <limits>
#include <string>

namespace sheetmorph::numerics
{

namespace
{

// Chosen: the last step is 2^-30, a billionth of the whole, as short as a converged one.
constexpr int most_halvings = 30;

// Share of the decrease that the slope promises (Armijo's condition); from Nocedal and Wright,
// Numerical Optimization, 2006, section 3.1.
constexpr double sufficient = 1e-4;

// Chosen: a step ten times shorter than the one before shows quadratic convergence. Linear
// convergence is rarely so fast.
constexpr double tenfold = 0.1;

class Descent
{
public:
    Descent(NewtonProblem& problem, const NewtonLimits& limits)
        : problem_(problem), limits_(limits), values_{problem.value()}
    {
    }

    Convergence run(const Progress& progress)
    {
        Convergence found{limits_.what, false, 0, 0.0, limits_.unit};
        for (bool goes_on = true; goes_on && found.rounds < limits_.most_rounds; ++found.rounds)
        {
            if (limits_.task != nullptr)
                progress.report(
                    static_cast<double>(found.rounds) / limits_.most_rounds,
                    std::string(limits_.task) + " step " + std::to_string(found.rounds + 1));
            found.is_converged = false;
            goes_on = round(found);
        }
        return found;
    }

private:
    //! Takes one step. Returns false if another one is useless.
    bool round(Convergence& found)
    {
        const double before = length_;
        length_ = std::numeric_limits<double>::infinity();
        for (int model = 0; model < limits_.models; ++model)
        {
            const std::optional<NewtonStep> step = problem_.step(model);
            if (!step || !step->change.allFinite() || !std::isfinite(step->length))
                continue;
            const bool is_whole = step->is_exact && !step->is_bounded;
            found.miss = step->length;
            found.is_converged = is_whole && step->length <= limits_.settled;
            bool is_last = step->length <= limits_.finest || is_noise(step->length, before);
            const double share = taken_share(*step, model);
            if (share > 0.0)
            {
                if (is_whole && share == 1.0)
                {
                    length_ = step->length;
                    if (squares(step->length, before))
                        found.is_converged = is_last = true;
                }
                return !(found.is_converged && is_last);
            }
            if (is_whole && std::abs(step->slope) <= limits_.unseen_gain * std::abs(values_.back()))
                found.is_converged = true;
            if (found.is_converged)
                return false;
        }
        return false;
    }

    // Whether the step shows the rounding of the gradient, because steps no longer shrink.
    bool is_noise(double length, double before) const
    {
        return limits_.squares_below > 0.0 && length <= limits_.settled && length > 0.5 * before;
    }

    bool squares(double length, double before) const
    {
        const double left = length * (length / before) * (length / before);
        return before < limits_.squares_below && length < tenfold * before && left <= limits_.left;
    }

    //! The share of the step that was taken: 1, a half, a quarter ...; 0 if no share lowers the
    //! value.
    double taken_share(const NewtonStep& step, int model)
    {
        const double here = values_.back();
        const double highest = *std::max_element(values_.begin(), values_.end());
        const bool may_rise = model == 0 && limits_.remembered > 1;
        problem_.remember();
        double share = 1.0;
        for (int halving = 0; halving < (may_rise ? 1 : most_halvings); ++halving, share *= 0.5)
        {
            problem_.move(step, share);
            const double value = problem_.value();
            const double promised = sufficient * share * std::min(step.slope, 0.0);
            if (value <= (may_rise ? highest : here + promised) + limits_.noise * std::abs(here))
            {
                values_.push_back(value);
                if (values_.size() > static_cast<std::size_t>(limits_.remembered))
                    values_.pop_front();
                return share;
            }
        }
        problem_.restore();
        return 0.0;
    }

    NewtonProblem& problem_;
    const NewtonLimits& limits_;
    std::deque<double> values_;
    double length_ = std::numeric_limits<double>::infinity();  // of the last exact step
};

}  // namespace

Convergence newton_minimum(NewtonProblem& problem, const NewtonLimits& limits,
                           const Progress& progress)
{
    return Descent(problem, limits).run(progress);
}

}  // namespace sheetmorph::numerics
