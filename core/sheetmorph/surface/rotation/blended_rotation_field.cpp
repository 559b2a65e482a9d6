// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/base/index.h"
#include "sheetmorph/numerics/products/panel_rows.h"
#include "sheetmorph/surface/operators/shared_unknowns.h"
#include "sheetmorph/surface/operators/ties.h"
#include "sheetmorph/surface/rotation/rotation_field.h"
#include "sheetmorph/surface/rotation/smooth_weights.h"

#include <algorithm>

namespace sheetmorph::surface
{

namespace
{

// Limit on the entries of stored responses to single vertices. Chosen, not measured: up to 0.8 MB,
// reading them is faster than back-substitution.
constexpr Eigen::Index most_kept = 100000;

// From smoothstep, which makes 3 w^2 = 3e-16 of it: that is rounding.
constexpr double least_weight = 1e-8;

// Numbers all prescribed rotations. A vertex belongs to one source or to none.
struct Sources
{
    static constexpr int none = -1;
    static constexpr int rest = 0;  // fixed regions, and components without a given rotation

    std::vector<int> of_vertex;
    int count = 1;
    int first_handle = 1;
    int first_body = 1;
    int first_region = 1;
    int first_point = 1;
};

int source_of_body(const Sources& sources, const Body& body, int index)
{
    switch (body.motion)
    {
        case Body::Motion::fixed:
            return Sources::rest;
        case Body::Motion::handle:
            return sources.first_handle + body.driver;
        case Body::Motion::propagated:
        case Body::Motion::prescribed:
            return sources.first_body + index;
        case Body::Motion::interpolated:
        case Body::Motion::free:
            break;
    }
    return Sources::none;
}

int source_of_vertex(const Sources& sources, const VertexRoles& roles, int vertex);

// Between regions with different rotations, the field determines the rotation.
int source_of_clamp(const Sources& sources, const VertexRoles& roles, const Clamp& clamp)
{
    const int source = source_of_vertex(sources, roles, clamp.carriers.front().vertex);
    for (const Clamp::Carrier& carrier : clamp.carriers)
        if (source_of_vertex(sources, roles, carrier.vertex) != source)
            return Sources::none;
    return source;
}

int source_of_vertex(const Sources& sources, const VertexRoles& roles, int vertex)
{
    const int owner = roles.owner[at(vertex)];
    switch (roles.role[at(vertex)])
    {
        case Role::fixed:
        case Role::follower:
        case Role::tied:
            return Sources::rest;
        case Role::handle:
            return sources.first_handle + owner;
        case Role::propagated:
            return sources.first_region + owner;
        case Role::body:
            return source_of_body(sources, roles.bodies[at(owner)], owner);
        case Role::clamped:
            return source_of_clamp(sources, roles, roles.clamps[at(owner)]);
        case Role::free:
            break;
    }
    return Sources::none;
}

// A point with a prescribed rotation applies it to the corners of its triangle, and to a feature
// there as a whole.
void add_turned_points(Sources& sources, const RotationFieldInput& input)
{
    std::vector<int> of_body(input.roles.bodies.size(), Sources::none);
    for (std::size_t k = 0; k < input.constraints.points.size(); ++k)
    {
        const PointConstraint& point = input.constraints.points[k];
        for (int corner = 0; point.is_turned && corner < 3; ++corner)
        {
            const int vertex = input.mesh.triangles()(point.triangle, corner);
            int& source = sources.of_vertex[at(vertex)];
            if (source != Sources::none)
                continue;
            source = sources.first_point + static_cast<int>(k);
            if (input.roles.role[at(vertex)] == Role::body)
                of_body[at(input.roles.owner[at(vertex)])] = source;
        }
    }
    for (std::size_t body = 0; body < of_body.size(); ++body)
        if (of_body[body] != Sources::none)
            for (const int vertex : input.roles.bodies[body].vertices)
                sources.of_vertex[at(vertex)] = of_body[body];
}

// Components without a source keep their orientation.
void settle_unturned_components(Sources& sources, const VertexRoles& roles)
{
    std::vector<char> has_source(at(roles.components.count), 0);
    for (std::size_t i = 0; i < sources.of_vertex.size(); ++i)
        if (sources.of_vertex[i] != Sources::none && roles.components.label[i] >= 0)
            has_source[at(roles.components.label[i])] = 1;
    for (std::size_t i = 0; i < sources.of_vertex.size(); ++i)
        if (roles.components.label[i] >= 0 && !has_source[at(roles.components.label[i])])
            sources.of_vertex[i] = Sources::rest;
}

Sources number_sources(const RotationFieldInput& input)
{
    Sources sources;
    sources.first_body = sources.first_handle + static_cast<int>(input.constraints.handles.size());
    sources.first_region = sources.first_body + static_cast<int>(input.roles.bodies.size());
    sources.first_point =
        sources.first_region + static_cast<int>(input.constraints.propagated.size());
    sources.count = sources.first_point + static_cast<int>(input.constraints.points.size());
    for (int i = 0; i < input.mesh.vertex_count(); ++i)
        sources.of_vertex.push_back(source_of_vertex(sources, input.roles, i));
    add_turned_points(sources, input);
    settle_unturned_components(sources, input.roles);
    return sources;
}

Unknowns unknowns_of(const Sources& sources, const VertexRoles& roles)
{
    SharedUnknowns unknowns(roles);
    for (const int source : sources.of_vertex)
        unknowns.add(source == Sources::none);
    return unknowns.found();
}

std::vector<int> used_sources(const Sources& sources)
{
    std::vector<char> is_used(at(sources.count), 0);
    for (const int source : sources.of_vertex)
        if (source != Sources::none)
            is_used[at(source)] = 1;
    std::vector<int> used;
    for (int source = 0; source < sources.count; ++source)
        if (is_used[at(source)])
            used.push_back(source);
    return used;
}

// The vertices of every used source.
std::vector<VertexIds> vertices_of(const Sources& sources, const std::vector<int>& used)
{
    std::vector<int> column(at(sources.count), Sources::none);
    for (std::size_t k = 0; k < used.size(); ++k)
        column[at(used[k])] = static_cast<int>(k);
    std::vector<VertexIds> vertices(used.size());
    for (std::size_t i = 0; i < sources.of_vertex.size(); ++i)
        if (sources.of_vertex[i] != Sources::none)
            vertices[at(column[at(sources.of_vertex[i])])].push_back(static_cast<int>(i));
    return vertices;
}

class BlendedRotationField : public RotationField
{
public:
    BlendedRotationField(const RotationFieldInput& input, const BlendedRotationField* earlier)
        : sources_(number_sources(input)),
          unknowns_(unknowns_of(sources_, input.roles)),
          harmonic_(input.operators.harmonic),
          factor_(unknowns_.merged(harmonic_), input.operators.harmonic_tree,
                  earlier != nullptr ? &earlier->factor_ : nullptr),
          used_(used_sources(sources_)),
          weights_(sheet(), vertices_of(sources_, used_), {0.0, least_weight, false}),
          ties_(input.roles.ties)
    {
        keep_answers();
    }

    SpreadRotations spread(const KnownRotations& known) const override
    {
        const Points of_source = source_logs(known);
        Points of_used(static_cast<Eigen::Index>(used_.size()), 3);
        for (std::size_t k = 0; k < used_.size(); ++k)
            of_used.row(static_cast<Eigen::Index>(k)) = of_source.row(used_[k]);
        Points logs = weights_.times(of_used);
        Points excess = Points::Zero(known.vertices.rows(), 3);
        for (const int i : single_)
            excess.row(i) = known.vertices.row(i) - of_source.row(sources_.of_vertex[at(i)]);
        if (!excess.isZero(0.0))
            add_harmonic_excess(logs, excess);
        fill_tied(ties_, logs);
        return {logs, {}};
    }

    Points harmonic(const KnownRotations& known) const override
    {
        const Points of_source = source_logs(known);
        Points logs = Points::Zero(known.vertices.rows(), 3);
        VertexIds given;
        for (int i = 0; i < known.vertices.rows(); ++i)
            if (const int source = sources_.of_vertex[at(i)]; source != Sources::none)
            {
                logs.row(i) = is_single(i) ? known.vertices.row(i) : of_source.row(source);
                given.push_back(i);
            }
        const Points of_unknown = solved_for(logs, given);
        for (Eigen::Index i = 0; i < logs.rows(); ++i)
            if (const int unknown = unknowns_.of_vertex[at(i)]; unknown != Unknowns::known)
                logs.row(i) = of_unknown.row(unknown);
        fill_tied(ties_, logs);
        return logs;
    }

private:
    WeightedSheet sheet() const { return {*harmonic_, unknowns_, factor_}; }

    Points source_logs(const KnownRotations& known) const
    {
        Points logs = Points::Zero(sources_.count, 3);
        logs.middleRows(sources_.first_handle, known.handles.rows()) = known.handles;
        logs.middleRows(sources_.first_body, known.bodies.rows()) = known.bodies;
        logs.middleRows(sources_.first_region, known.regions.rows()) = known.regions;
        logs.middleRows(sources_.first_point, known.points.rows()) = known.points;
        return logs;
    }

    bool is_single(int vertex) const
    {
        const int source = sources_.of_vertex[at(vertex)];
        return source >= sources_.first_region && source < sources_.first_point;
    }

    void keep_answers()
    {
        const auto vertices = static_cast<int>(sources_.of_vertex.size());
        for (int i = 0; i < vertices; ++i)
            if (is_single(i))
                single_.push_back(i);
        const auto count = static_cast<Eigen::Index>(single_.size());
        is_kept_ = count * unknowns_.count <= most_kept;
        if (!is_kept_ || unknowns_.count == 0)
            return;
        std::vector<VertexIds> each;
        for (const int vertex : single_)
            each.push_back({vertex});
        answers_ = numerics::ExactPanelRows(
            numerics::Weights(-factor_.solve(pull_of(sheet(), each.data(), count))));
    }

    // Harmonic values of the unknowns for given values (n, 3) of the single vertices.
    Points harmonic_values(const Points& given) const
    {
        if (unknowns_.count == 0)
            return Points(0, 3);
        if (is_kept_)
            return answers_.times(given(single_, Eigen::indexing::all));
        return solved_for(given, single_);
    }

    // (unknowns, 3) harmonic values for given values (n, 3) of some prescribed vertices; the others
    // are 0.
    Points solved_for(const Points& given, const VertexIds& vertices) const
    {
        Eigen::MatrixXd pull = Eigen::MatrixXd::Zero(unknowns_.count, 3);
        for (const int vertex : vertices)
            for (numerics::SparseMatrix::InnerIterator entry(*harmonic_, vertex); entry; ++entry)
                if (const int unknown = unknowns_.of_vertex[at(entry.row())];
                    unknown != Unknowns::known)
                    pull.row(unknown) += entry.value() * given.row(vertex);
        return -factor_.solve(pull);
    }

    // Rotations vary within a propagated region. Their deviation from the region's mean decays
    // harmonically.
    void add_harmonic_excess(Points& logs, const Points& excess) const
    {
        const Points of_unknown = harmonic_values(excess);
        for (Eigen::Index i = 0; i < logs.rows(); ++i)
        {
            const int unknown = unknowns_.of_vertex[static_cast<std::size_t>(i)];
            logs.row(i) += unknown == Unknowns::known ? Eigen::RowVector3d(excess.row(i))
                                                      : Eigen::RowVector3d(of_unknown.row(unknown));
        }
    }

    Sources sources_;
    Unknowns unknowns_;
    std::shared_ptr<const numerics::SparseMatrix> harmonic_;  // K (n, n)
    numerics::SparseCholesky factor_;
    std::vector<int> used_;  // sources with vertices
    SmoothWeights weights_;  // (n, used sources)
    std::vector<Tie> ties_;
    VertexIds single_;  // in propagated regions: each has its own rotation
    bool is_kept_ = false;
    numerics::ExactPanelRows answers_;  // (unknowns, single vertices), if kept
};

}  // namespace

//! (2.7), with smoothed weights.
std::unique_ptr<RotationField> blended_rotation_field(const RotationFieldInput& input,
                                                      const RotationField* earlier)
{
    return std::make_unique<BlendedRotationField>(
        input, dynamic_cast<const BlendedRotationField*>(earlier));
}

}  // namespace sheetmorph::surface
