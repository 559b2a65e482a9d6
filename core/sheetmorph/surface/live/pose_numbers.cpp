// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/surface/live/pose_numbers.h"

#include "sheetmorph/base/index.h"
#include "sheetmorph/base/log_near.h"
#include "sheetmorph/base/rotation.h"
#include "sheetmorph/surface/live/span.h"
#include "sheetmorph/surface/operators/point_rows.h"

#include <algorithm>

namespace sheetmorph::surface
{

namespace
{

// Number of vertices that represent a rigid body. From geometry: three determine its motion; with
// six, a few may lie on a line.
constexpr std::size_t watched_of_a_body = 6;

// Limit on the vertices that represent a contact. Chosen: a control mesh has 386 vertices, so its
// motion of a contact has about as many degrees of freedom.
constexpr std::size_t watched_of_a_region = 300;

// Limits on the places at which the sheet's rotation is an input, and on the candidates. Chosen,
// not measured: both limit the time of the set-up, whose dense products grow with their product.
constexpr std::size_t most_places = 400;
constexpr std::size_t most_candidates = 4000;

// Places whose field rows differ by less are redundant. Chosen: the error of a rotation, 1e-4 of
// its range, is of second order for the sheet between two such places.
constexpr double same_turn = 1e-4;

// Smallest extent of a contact, relative to the part's size, to which displacements are related.
// From the lever: an error at a contact this small grows by the inverse, 50, at the far end.
// Chosen so that single precision (6e-8) is still 3e-6 there.
constexpr double least_reach = 0.02;

VertexIds some_of(const VertexIds& vertices, std::size_t count)
{
    if (vertices.size() <= count)
        return vertices;
    VertexIds some;
    for (std::size_t k = 0; k < count; ++k)
        some.push_back(vertices[k * (vertices.size() - 1) / (count - 1)]);
    return some;
}

double extent(const Points& points, const VertexIds& vertices)
{
    Eigen::RowVector3d low = points.row(vertices.front()), high = low;
    for (const int vertex : vertices)
    {
        low = low.cwiseMin(points.row(vertex));
        high = high.cwiseMax(points.row(vertex));
    }
    return (high - low).norm();
}

// Visits all rotations that a pose gives, in a fixed order.
template <typename Targets, typename Bodies, typename Visit>
void visit_logs(Targets& targets, Bodies& bodies, Visit visit)
{
    for (auto& motion : targets.handles)
        visit(motion.rotation_log);
    for (Eigen::Index k = 0; k < bodies.logs.rows(); ++k)
        visit(bodies.logs.row(k));
    for (auto& point : targets.points)
        visit(point.rotation_log);
    for (auto& target : targets.propagated)
        for (Eigen::Index k = 0; k < target.rotation_logs.rows(); ++k)
            visit(target.rotation_logs.row(k));
}

Points given_logs(const KnownPose& pose)
{
    Eigen::Index count = 0;
    visit_logs(pose.targets, pose.bodies, [&](const auto&) { ++count; });
    Points logs(count, 3);
    count = 0;
    visit_logs(pose.targets, pose.bodies,
               [&](const auto& log) { logs.row(count++) << log(0), log(1), log(2); });
    return logs;
}

// Tilts in the order of given_logs().
Points given_tilts(const KnownPose& pose, Eigen::Index rows)
{
    const std::vector<PropagatedTarget>& propagated = pose.targets.propagated;
    Points tilts = Points::Zero(rows, 3);
    const auto handles = static_cast<Eigen::Index>(pose.targets.handles.size());
    tilts.middleRows(handles, pose.bodies.tilts.rows()) = pose.bodies.tilts;
    Eigen::Index row =
        handles + pose.bodies.tilts.rows() + static_cast<Eigen::Index>(pose.targets.points.size());
    for (const PropagatedTarget& target : propagated)
    {
        for (std::size_t k = 0; k < target.rotations.size(); ++k)
        {
            const auto own = static_cast<Eigen::Index>(k);
            const Vector3 log = target.rotation_logs.row(own).transpose();
            tilts.row(row + own) = tilt_beyond(target.rotations[k], log).transpose();
        }
        row += target.rotation_logs.rows();
    }
    return tilts;
}

// Farthest point sampling: up to `count` rows, each the farthest from the earlier ones.
VertexIds far_rows(const numerics::Weights& points, const VertexIds& candidates, std::size_t count)
{
    VertexIds found;
    Eigen::VectorXd distance =
        Eigen::VectorXd::Constant(static_cast<Eigen::Index>(candidates.size()), 1e300);
    Eigen::Index next = 0;
    while (found.size() < std::min(count, candidates.size()) && distance(next) > same_turn)
    {
        found.push_back(candidates[at(next)]);
        for (std::size_t k = 0; k < candidates.size(); ++k)
        {
            double& nearest = distance(static_cast<Eigen::Index>(k));
            nearest =
                std::min(nearest, (points.row(candidates[k]) - points.row(found.back())).norm());
        }
        distance.maxCoeff(&next);
    }
    return found;
}

}  // namespace

KnownPose::KnownPose(const PreparedSurface& part, const SurfaceTargets& pose)
    : targets(pose), bodies(known_body_motions(part.placement(), pose))
{
}

PoseNumbers::PoseNumbers(const PreparedSurface& part, const std::vector<KnownPose>& samples)
    : part_(part), reach_(part.rest.size())
{
    for (const KnownRegion& region : part.constraints.propagated)
        reach_ = std::min(reach_, extent(part.rest.points(), region.vertices));
    reach_ = std::max(reach_, least_reach * part.rest.size());
    span_turns(samples);
    find_movers();
    find_places();
}

// The field is linear in the given logs and treats all coordinates alike, so one evaluation
// computes three basis rotations.
void PoseNumbers::span_turns(const std::vector<KnownPose>& samples)
{
    Eigen::MatrixXd columns(given_logs(samples.front()).rows(),
                            3 * static_cast<Eigen::Index>(samples.size()));
    for (std::size_t k = 0; k < samples.size(); ++k)
        columns.middleCols(3 * static_cast<Eigen::Index>(k), 3) = given_logs(samples[k]);
    directions_ = spanned(std::move(columns)).directions.transpose();
    const Eigen::Index count = directions_.rows();
    field_.resize(part_.rest.vertex_count(), count);
    SurfaceTargets targets = samples.front().targets;
    BodyMotions bodies = samples.front().bodies;
    bodies.tilts.setZero();
    for (PropagatedTarget& target : targets.propagated)
        target.rotations.clear();
    for (Eigen::Index first = 0; first < count; first += 3)
    {
        const Eigen::Index width = std::min<Eigen::Index>(3, count - first);
        Eigen::Index row = 0;
        visit_logs(targets, bodies,
                   [&](auto&& log)
                   {
                       for (Eigen::Index axis = 0; axis < 3; ++axis)
                           log(axis) = axis < width ? directions_(first + axis, row) : 0.0;
                       ++row;
                   });
        field_.middleCols(first, width) =
            part_.field->spread(given_rotations(part_.placement(), targets, bodies).logs)
                .logs.leftCols(width);
    }
}

PoseNumbers::Turns PoseNumbers::turns(const KnownPose& pose) const
{
    const Points given = given_logs(pose);
    Turns turns{numerics::narrow_product(directions_, given), Points(0, 3), 0.0};
    const auto missed = [&](const Points& wanted, const Points& blended)
    {
        const Points left = wanted - directions_.transpose() * blended;
        return left.rows() == 0 ? 0.0 : left.cwiseAbs().maxCoeff();
    };
    turns.miss = missed(given, turns.logs);
    const Points tilts = given_tilts(pose, given.rows());
    if (!tilts.isZero(0.0))
    {
        turns.tilts = numerics::narrow_product(directions_, tilts);
        turns.miss = std::max(turns.miss, missed(tilts, turns.tilts));
    }
    return turns;
}

void PoseNumbers::watch(const VertexIds& vertices, Item item)
{
    for (const int vertex : some_of(vertices, watched_of_a_body))
    {
        item.rest = part_.rest.points().row(vertex);
        items_.push_back(item);
    }
}

void PoseNumbers::find_movers()
{
    const VertexRoles& roles = part_.roles;
    const Points& rest = part_.rest.points();
    const std::vector<KnownRegion>& regions = part_.constraints.propagated;
    for (std::size_t region = 0; region < regions.size(); ++region)
    {
        const std::size_t step = regions[region].vertices.size() / watched_of_a_region + 1;
        for (std::size_t k = 0; k < regions[region].vertices.size(); k += step)
            if (const int vertex = regions[region].vertices[k];
                roles.role[at(vertex)] == Role::propagated)
                items_.push_back({Item::Kind::region, static_cast<int>(region),
                                  static_cast<Eigen::Index>(k), rest.row(vertex)});
    }
    std::vector<VertexIds> of_handle(part_.constraints.handles.size());
    for (std::size_t i = 0; i < roles.role.size(); ++i)
        if (roles.role[i] == Role::handle)
            of_handle[at(roles.owner[i])].push_back(static_cast<int>(i));
    for (std::size_t k = 0; k < of_handle.size(); ++k)
        watch(of_handle[k], {Item::Kind::handle, static_cast<int>(k), 0, {}});
    for (std::size_t k = 0; k < roles.bodies.size(); ++k)
        if (roles.bodies[k].is_known() && roles.bodies[k].motion != Body::Motion::fixed)
            watch(roles.bodies[k].vertices, {Item::Kind::body, static_cast<int>(k), 0, {}});
    for (std::size_t k = 0; k < part_.constraints.points.size(); ++k)
        items_.push_back({Item::Kind::point, static_cast<int>(k), 0, Eigen::RowVector3d::Zero()});
}

// Selects places far apart in the field weights, so that they include the extremes of every weight.
void PoseNumbers::find_places()
{
    VertexIds candidates;
    for (const Body& body : part_.roles.bodies)
        candidates.push_back(body.vertices.front());
    for (Eigen::Index k = 0; k < field_.cols(); ++k)
        for (const double sign : {-1.0, 1.0})
        {
            Eigen::Index row = 0;
            (sign * field_.col(k)).maxCoeff(&row);
            candidates.push_back(static_cast<int>(row));
        }
    const int step = part_.rest.vertex_count() / static_cast<int>(most_candidates) + 1;
    for (int vertex = 0; vertex < part_.rest.vertex_count(); vertex += step)
        candidates.push_back(vertex);
    for (const int vertex : far_rows(field_, candidates, most_places))
        items_.push_back({Item::Kind::place, vertex, 0, Eigen::RowVector3d::Zero()});
}

Eigen::RowVector3d PoseNumbers::displacement(const Item& item, const KnownPose& pose) const
{
    if (item.kind == Item::Kind::point)
        return point_displacements(part_.rest, {part_.constraints.points[at(item.index)]},
                                   {pose.targets.points[at(item.index)]})
            .row(0);
    if (item.kind == Item::Kind::region)
        return pose.targets.propagated[at(item.index)].positions.row(item.row) - item.rest;
    const RigidMotion& motion = item.kind == Item::Kind::handle
                                    ? pose.targets.handles[at(item.index)]
                                    : pose.bodies.motions[at(item.index)];
    return motion.apply(Vector3(item.rest.transpose())).transpose() - item.rest;
}

std::vector<int> PoseNumbers::items() const
{
    std::vector<int> rows;
    for (std::size_t k = 0; k < items_.size(); ++k)
        rows.insert(rows.end(), items_[k].kind == Item::Kind::place ? 3 : 1, static_cast<int>(k));
    return rows;
}

std::vector<int> PoseNumbers::movers() const
{
    std::vector<int> movers;
    for (std::size_t k = 0; k < items_.size(); ++k)
        if (items_[k].kind != Item::Kind::place)
            movers.push_back(static_cast<int>(k));
    return movers;
}

void PoseNumbers::keep(const std::vector<int>& items)
{
    std::vector<Item> kept;
    for (const int item : items)
        kept.push_back(items_[at(item)]);
    items_ = std::move(kept);
}

void PoseNumbers::keep(const std::vector<int>& items, VertexIds vertices)
{
    keep(items);
    for (const Item& item : items_)
        if (item.kind == Item::Kind::place)
            vertices.push_back(item.index);
    std::sort(vertices.begin(), vertices.end());
    vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
    field_ = numerics::Weights(field_(vertices, Eigen::indexing::all));
    kept_ = std::move(vertices);
}

Eigen::Index PoseNumbers::row_of(int vertex) const
{
    if (kept_.empty())
        return vertex;
    return std::lower_bound(kept_.begin(), kept_.end(), vertex) - kept_.begin();
}

Points PoseNumbers::of(const KnownPose& pose, const Turns& turns) const
{
    Points numbers(3 * static_cast<Eigen::Index>(items_.size()), 3);
    Eigen::Index row = 0;
    for (const Item& item : items_)
    {
        if (item.kind != Item::Kind::place)
        {
            numbers.row(row++) = displacement(item, pose) / reach_;
            continue;
        }
        const auto weights = field_.row(row_of(item.index));
        const Vector3 log = (weights * turns.logs).transpose();
        const Matrix3 turn = turns.tilts.rows() == 0
                                 ? rotation_from_log(log)
                                 : tilted_rotation(log, (weights * turns.tilts).transpose());
        numbers.middleRows<3>(row) = (turn - Matrix3::Identity()).transpose();
        row += 3;
    }
    numbers.conservativeResize(row, Eigen::NoChange);
    return numbers;
}

}  // namespace sheetmorph::surface
