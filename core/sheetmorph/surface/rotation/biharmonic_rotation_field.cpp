// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/numerics/constrained_minimiser.h"
#include "sheetmorph/surface/operators/point_rows.h"
#include "sheetmorph/surface/operators/shared_unknowns.h"
#include "sheetmorph/surface/operators/ties.h"
#include "sheetmorph/surface/rotation/rotation_field.h"

#include <optional>
#include <utility>

namespace sheetmorph::surface
{

namespace
{

// Clean meshes need one or two. Chosen as in pose_solve.cpp.
constexpr int most_refinements = 8;

class BiharmonicRotationField : public RotationField
{
public:
    BiharmonicRotationField(const RotationFieldInput& input, const BiharmonicRotationField* earlier)
        : ties_(input.roles.ties)
    {
        for (std::size_t k = 0; k < input.constraints.points.size(); ++k)
            if (input.constraints.points[k].is_turned)
                turned_.push_back(static_cast<int>(k));
        const std::vector<char> reached = reached_components(input);
        const Unknowns unknowns = unknowns_of(input, reached);
        const Eigen::Index count = input.mesh.vertex_count();
        is_known_.resize(static_cast<std::size_t>(count));
        for (int i = 0; i < count; ++i)
            is_known_[static_cast<std::size_t>(i)] = is_rotation_known(input.roles, i);
        numerics::QuadraticProblem problem;
        problem.rows = input.operators.rows;
        problem.weights = Eigen::VectorXd::Ones(problem.rows.rows());
        problem.basis = unknowns.basis();
        problem.constraints = point_rows(input.mesh, input.constraints.points, turned_);
        for (std::size_t row = 0; row < turned_.size(); ++row)
            problem.supporting.push_back(static_cast<int>(row));
        problem.stiffness = input.operators.stiffness;
        problem.tree = input.operators.tree;
        minimiser_.emplace(std::move(problem),
                           earlier != nullptr ? &*earlier->minimiser_ : nullptr);
    }

    SpreadRotations spread(const KnownRotations& known) const override
    {
        numerics::ConstrainedMinimiser::Targets targets;
        targets.offset = known.vertices;
        for (std::size_t i = 0; i < is_known_.size(); ++i)
            if (!is_known_[i])
                targets.offset.row(static_cast<Eigen::Index>(i)).setZero();
        targets.rows = Eigen::MatrixXd::Zero(known.vertices.rows(), 3);
        targets.constraints.resize(static_cast<Eigen::Index>(turned_.size()), 3);
        for (std::size_t row = 0; row < turned_.size(); ++row)
            targets.constraints.row(static_cast<Eigen::Index>(row)) =
                known.points.row(turned_[row]);
        numerics::ConstrainedMinimiser::Solution found =
            minimiser_->minimum(targets, most_refinements);
        fill_tied(ties_, found.u);
        found.convergence.what = "the rotations of the sheet";
        found.convergence.unit = "radians";
        return {std::move(found.u), found.convergence};
    }

    Points harmonic(const KnownRotations& known) const override { return spread(known).logs; }

private:
    // Components with at least one given rotation; the others keep r = 0.
    std::vector<char> reached_components(const RotationFieldInput& input) const
    {
        const std::vector<int>& label = input.roles.components.label;
        std::vector<char> reached(static_cast<std::size_t>(input.roles.components.count), 0);
        const auto reach = [&](int vertex)
        {
            const int component = label[static_cast<std::size_t>(vertex)];
            if (component != mesh::Components::unused)
                reached[static_cast<std::size_t>(component)] = 1;
        };
        for (int i = 0; i < input.mesh.vertex_count(); ++i)
            if (is_rotation_known(input.roles, i))
                reach(i);
        for (const int point : turned_)
            reach(input.mesh.triangles()(
                input.constraints.points[static_cast<std::size_t>(point)].triangle, 0));
        return reached;
    }

    static Unknowns unknowns_of(const RotationFieldInput& input, const std::vector<char>& reached)
    {
        SharedUnknowns unknowns(input.roles);
        for (int i = 0; i < input.mesh.vertex_count(); ++i)
        {
            const int component = input.roles.components.label[static_cast<std::size_t>(i)];
            unknowns.add(component != mesh::Components::unused
                         && reached[static_cast<std::size_t>(component)]
                         && input.roles.role[static_cast<std::size_t>(i)] != Role::tied
                         && !is_rotation_known(input.roles, i));
        }
        return unknowns.found();
    }

    std::vector<Tie> ties_;
    std::vector<int> turned_;
    std::vector<char> is_known_;
    std::optional<numerics::ConstrainedMinimiser> minimiser_;
};

}  // namespace

bool is_rotation_known(const VertexRoles& roles, int vertex)
{
    const auto i = static_cast<std::size_t>(vertex);
    switch (roles.role[i])
    {
        case Role::fixed:
        case Role::handle:
        case Role::propagated:
        case Role::clamped:
            return true;
        case Role::body:
        {
            const Body& body = roles.bodies[static_cast<std::size_t>(roles.owner[i])];
            return body.is_known() || body.motion == Body::Motion::prescribed;
        }
        case Role::free:
        case Role::follower:
        case Role::tied:
            return false;
    }
    return false;
}

//! (2.9).
std::unique_ptr<RotationField> biharmonic_rotation_field(const RotationFieldInput& input,
                                                         const RotationField* earlier)
{
    return std::make_unique<BiharmonicRotationField>(
        input, dynamic_cast<const BiharmonicRotationField*>(earlier));
}

}  // namespace sheetmorph::surface
