// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/surface/live/driver_numbers.h"

#include "sheetmorph/base/index.h"
#include "sheetmorph/base/log_near.h"
#include "sheetmorph/base/rotation.h"

#include <algorithm>

namespace sheetmorph
{

namespace
{

// A rigid body is known by a few of its vertices.
constexpr std::size_t watched_of_a_body = 6;

// Places of the free sheet where its rotation is watched: it is smooth there.
constexpr std::size_t watched_places = 150;

// The least extent of a contact, of the part's size, to which the motion of its vertices is
// related: a tilt of it carries the whole part along.
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

//! A pose that turns nothing, and where the rows of given_logs() lie in it.
struct GivenLogs
{
    explicit GivenLogs(const PlacementInput& part)
    {
        const auto count = static_cast<Eigen::Index>(part.roles.bodies.size());
        targets.handles.resize(part.constraints.handles.size());
        targets.feature_logs.assign(part.constraints.features.size(), Vector3::Zero());
        bodies = {std::vector<RigidMotion>(at(count)), Points::Zero(count, 3),
                  Points::Zero(count, 3)};
        for (const KnownRegion& region : part.constraints.propagated)
        {
            const auto vertices = static_cast<Eigen::Index>(region.vertices.size());
            targets.propagated.push_back(
                {Points::Zero(vertices, 3), Points::Zero(vertices, 3), {}});
        }
    }

    Eigen::Index count() const
    {
        auto rows = static_cast<Eigen::Index>(targets.handles.size()) + bodies.logs.rows();
        for (const PropagatedTarget& target : targets.propagated)
            rows += target.rotation_logs.rows();
        return rows;
    }

    double& at_row(Eigen::Index row, int axis)
    {
        const auto handles = static_cast<Eigen::Index>(targets.handles.size());
        if (row < handles)
            return targets.handles[at(row)].rotation_log(axis);
        row -= handles;
        if (row < bodies.logs.rows())
            return bodies.logs(row, axis);
        row -= bodies.logs.rows();
        std::size_t region = 0;
        for (; row >= targets.propagated[region].rotation_logs.rows(); ++region)
            row -= targets.propagated[region].rotation_logs.rows();
        return targets.propagated[region].rotation_logs(row, axis);
    }

    SurfaceTargets targets;
    BodyMotions bodies;
};

}  // namespace

DriverNumbers::DriverNumbers(const ResponseInput& input, const VertexIds& wanted)
    : input_(input), reach_(input.part.rest.size())
{
    for (const KnownRegion& region : input_.part.constraints.propagated)
        reach_ = std::min(reach_, extent(input_.part.rest.points(), region.vertices));
    reach_ = std::max(reach_, least_reach * input_.part.rest.size());
    find_movers();
    VertexIds vertices = places();
    place_count_ = static_cast<Eigen::Index>(vertices.size());
    vertices.insert(vertices.end(), wanted.begin(), wanted.end());
    spread_turns(vertices);
}

void DriverNumbers::watch(const VertexIds& vertices, Mover mover)
{
    for (const int vertex : some_of(vertices, watched_of_a_body))
    {
        mover.rest = input_.part.rest.points().row(vertex);
        movers_.push_back(mover);
    }
}

void DriverNumbers::find_movers()
{
    const VertexRoles& roles = input_.part.roles;
    const std::vector<KnownRegion>& regions = input_.part.constraints.propagated;
    for (std::size_t region = 0; region < regions.size(); ++region)
        for (std::size_t k = 0; k < regions[region].vertices.size(); ++k)
        {
            const int vertex = regions[region].vertices[k];
            if (roles.role[at(vertex)] == Role::propagated)
                movers_.push_back({input_.part.rest.points().row(vertex), static_cast<int>(region),
                                   static_cast<int>(k), -1, -1});
        }
    std::vector<VertexIds> of_handle(input_.part.constraints.handles.size());
    for (std::size_t i = 0; i < roles.role.size(); ++i)
        if (roles.role[i] == Role::handle)
            of_handle[at(roles.owner[i])].push_back(static_cast<int>(i));
    for (std::size_t k = 0; k < of_handle.size(); ++k)
        watch(of_handle[k], {{}, -1, -1, static_cast<int>(k), -1});
    for (std::size_t k = 0; k < roles.bodies.size(); ++k)
        if (roles.bodies[k].is_known() && roles.bodies[k].motion != Body::Motion::fixed)
            watch(roles.bodies[k].vertices, {{}, -1, -1, -1, static_cast<int>(k)});
}

// Contacts, features and some of the free sheet.
VertexIds DriverNumbers::places() const
{
    const VertexRoles& roles = input_.part.roles;
    VertexIds found, open;
    for (std::size_t i = 0; i < roles.role.size(); ++i)
    {
        if (roles.role[i] == Role::propagated)
            found.push_back(static_cast<int>(i));
        else if (roles.role[i] == Role::free || roles.role[i] == Role::clamped)
            open.push_back(static_cast<int>(i));
    }
    for (const Body& body : roles.bodies)
        found.push_back(body.vertices.front());
    const VertexIds some = some_of(open, watched_places);
    found.insert(found.end(), some.begin(), some.end());
    return found;
}

Points DriverNumbers::given_logs(const SurfaceTargets& targets, const BodyMotions& bodies)
{
    const auto handles = static_cast<Eigen::Index>(targets.handles.size());
    Eigen::Index count = handles + bodies.logs.rows();
    for (const PropagatedTarget& target : targets.propagated)
        count += target.rotation_logs.rows();
    Points given(count, 3);
    for (Eigen::Index k = 0; k < handles; ++k)
        given.row(k) = targets.handles[at(k)].rotation_log.transpose();
    given.middleRows(handles, bodies.logs.rows()) = bodies.logs;
    Eigen::Index row = handles + bodies.logs.rows();
    for (const PropagatedTarget& target : targets.propagated)
    {
        given.middleRows(row, target.rotation_logs.rows()) = target.rotation_logs;
        row += target.rotation_logs.rows();
    }
    return given;
}

// The field is linear in the logs it is given, in every coordinate alike: three of them at once.
void DriverNumbers::spread_turns(const VertexIds& vertices)
{
    GivenLogs given(input_.part);
    turns_ = Weights::Zero(static_cast<Eigen::Index>(vertices.size()), given.count());
    for (Eigen::Index first = 0; first < given.count(); first += 3)
    {
        const int width = static_cast<int>(std::min<Eigen::Index>(3, given.count() - first));
        for (int axis = 0; axis < width; ++axis)
            given.at_row(first + axis, axis) = 1.0;
        const Points logs =
            input_.field.logs(given_rotations(input_.part, given.targets, given.bodies).logs);
        for (int axis = 0; axis < width; ++axis)
        {
            for (std::size_t k = 0; k < vertices.size(); ++k)
                turns_(static_cast<Eigen::Index>(k), first + axis) = logs(vertices[k], axis);
            given.at_row(first + axis, axis) = 0.0;
        }
    }
}

// Rows as those of given_logs().
Points DriverNumbers::given_tilts(const SurfaceTargets& targets, const BodyMotions& bodies)
{
    Points tilts = Points::Zero(given_logs(targets, bodies).rows(), 3);
    auto row = static_cast<Eigen::Index>(targets.handles.size());
    tilts.middleRows(row, bodies.tilts.rows()) = bodies.tilts;
    row += bodies.tilts.rows();
    for (const PropagatedTarget& target : targets.propagated)
    {
        for (std::size_t k = 0; k < target.rotations.size(); ++k)
        {
            const auto own = static_cast<Eigen::Index>(k);
            tilts.row(row + own) =
                tilt_beyond(target.rotations[k], target.rotation_logs.row(own).transpose())
                    .transpose();
        }
        row += target.rotation_logs.rows();
    }
    return tilts;
}

Eigen::RowVector3d DriverNumbers::position(const Mover& mover, const SurfaceTargets& targets,
                                           const BodyMotions& bodies) const
{
    if (mover.region >= 0)
        return targets.propagated[at(mover.region)].positions.row(mover.row);
    const RigidMotion& motion =
        mover.handle >= 0 ? targets.handles[at(mover.handle)] : bodies.motions[at(mover.body)];
    return motion.apply(Vector3(mover.rest.transpose())).transpose();
}

DriverNumbers::Pose DriverNumbers::of(const SurfaceTargets& targets,
                                      const BodyMotions& bodies) const
{
    const Points logs = narrow_product(turns_, given_logs(targets, bodies));
    const Points given = given_tilts(targets, bodies);
    const Points tilts =
        given.isZero(0.0) ? Points(Points::Zero(logs.rows(), 3)) : narrow_product(turns_, given);
    const auto moved = static_cast<Eigen::Index>(movers_.size());
    const Eigen::Index wanted = logs.rows() - place_count_;
    Pose pose{Points(moved + 3 * place_count_, 3), logs.bottomRows(wanted),
              tilts.bottomRows(wanted)};
    for (Eigen::Index k = 0; k < moved; ++k)
        pose.numbers.row(k) =
            (position(movers_[at(k)], targets, bodies) - movers_[at(k)].rest) / reach_;
    for (Eigen::Index k = 0; k < place_count_; ++k)
        pose.numbers.middleRows<3>(moved + 3 * k) =
            (tilted_rotation(logs.row(k).transpose(), tilts.row(k).transpose())
             - Matrix3::Identity())
                .transpose();
    return pose;
}

}  // namespace sheetmorph
