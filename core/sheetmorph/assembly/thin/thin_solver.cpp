// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/assembly/thin/thin_solver.h"

#include "sheetmorph/assembly/links/control_box.h"
#include "sheetmorph/base/index.h"
#include "sheetmorph/base/log_near.h"
#include "sheetmorph/base/parallel.h"
#include "sheetmorph/base/vertex_sets.h"

#include <algorithm>
#include <numeric>

namespace sheetmorph
{

namespace
{

// A point moves nearly as the middle under it does, so that a handful of rounds is enough.
constexpr int most_rounds = 30;

// Of the size: a miss that does not show in anything that is measured.
constexpr double negligible = 1e-10;

// Likewise, of a point in a live frame: what it misses moves the sheet beyond it several times as
// far.
constexpr double live = 2e-8;

VertexIds all_vertices(const TriangleMesh& mesh)
{
    VertexIds ids(at(mesh.vertex_count()));
    std::iota(ids.begin(), ids.end(), 0);
    return ids;
}

// The vertices of the whole part on its side of a rigid weld.
VertexIds side_of_weld(const Assembly& whole, const RigidWeld& weld, int part)
{
    VertexIds vertices;
    for (const int contact : weld.contacts)
        for (const PartRegion* side :
             {&whole.contacts[at(contact)].a, &whole.contacts[at(contact)].b})
            if (side->part == part)
                vertices.insert(vertices.end(), side->vertices.begin(), side->vertices.end());
    return vertices;
}

Vector3 centre_of(const TriangleMesh& mesh, VertexIds vertices)
{
    make_set(vertices);
    return rows_of(mesh.points(), vertices).colwise().mean().transpose();
}

std::vector<const VertexIds*> pointers(const std::vector<VertexIds>& regions)
{
    std::vector<const VertexIds*> found;
    for (const VertexIds& region : regions)
        found.push_back(&region);
    return found;
}

template <typename Region>
std::vector<const VertexIds*> vertices_of(const std::vector<Region>& regions)
{
    std::vector<const VertexIds*> found;
    for (const Region& region : regions)
        found.push_back(&region.vertices);
    return found;
}

// The same motion, about another point.
RigidMotion about(const RigidMotion& motion, const Vector3& centre)
{
    return {motion.apply(centre) - centre, motion.rotation_log, centre};
}

}  // namespace

ThinSolver::ThinSolver(const ThinSolverInput& input)
    : part_(input.part), meter_(part_->middle(), all_vertices(part_->middle()))
{
    find_movers(input);
    find_points(input);
}

void ThinSolver::set_movers(Movers& movers, const Regions& regions, Mover::Kind kind)
{
    for (std::size_t k = 0; k < regions.size(); ++k)
        for (const int vertex : *regions[k])
            movers[at(vertex)] = {kind, static_cast<int>(k)};
}

// The later overrule the earlier: features, handles, the ground.
void ThinSolver::find_movers(const ThinSolverInput& input)
{
    const PartConstraints& own = input.problem.own;
    std::vector<VertexIds> features, handles, fixed;
    for (const int feature : own.features)
        features.push_back(input.whole.features[at(feature)].vertices);
    for (const int weld : input.problem.carriers)
        features.push_back(side_of_weld(input.whole, input.welds[at(weld)], input.index));
    for (const int handle : own.handles)
        handles.push_back(input.whole.handles[at(handle)].vertices);
    for (const int weld : input.problem.carried)
        handles.push_back(side_of_weld(input.whole, input.welds[at(weld)], input.index));
    for (const PartRegion& region : input.whole.fixed)
        if (region.part == input.index)
            fixed.push_back(region.vertices);
    for (const int weld : input.problem.held)
        fixed.push_back(side_of_weld(input.whole, input.welds[at(weld)], input.index));
    for (const VertexIds& feature : features)
        centres_.push_back(centre_of(part_->mesh(), feature));
    for (const int feature : own.features)
        sizes_.add(part_->mesh(), input.whole.features[at(feature)]);

    movers_.resize(at(part_->mesh().vertex_count()));
    set_movers(movers_, pointers(features), Mover::Kind::feature);
    set_movers(movers_, pointers(handles), Mover::Kind::handle);
    set_movers(movers_, pointers(fixed), Mover::Kind::ground);
    for (const KnownRegion& handle : own.surface.handles)
        free_handles_.push_back(handle.is_rotation_free ? handle.vertices : VertexIds());
    middle_movers_.resize(part_->skin().vertices.size());
    set_movers(middle_movers_, vertices_of(own.surface.features), Mover::Kind::feature);
    set_movers(middle_movers_, vertices_of(own.surface.handles), Mover::Kind::handle);
    set_movers(middle_movers_, vertices_of(own.surface.fixed), Mover::Kind::ground);
}

void ThinSolver::find_points(const ThinSolverInput& input)
{
    const TriangleMesh& mesh = part_->mesh();
    const std::vector<int>& points = input.problem.own.points;
    for (std::size_t k = 0; k < points.size(); ++k)
    {
        const PointConstraint& point = input.whole.points[at(points[k])].constraint;
        const auto corners = mesh.triangles().row(point.triangle);
        points_.push_back({k, {{corners(0), corners(1), corners(2)}, point.barycentric}});
    }
}

Deformation ThinSolver::solve(const SurfaceDeformer& deformer, const SurfaceTargets& targets,
                              Exactness level, const Progress& progress) const
{
    Deformation middle = deformer.deform(targets, level, progress);
    SurfaceTargets asked = targets;
    const double size = part_->mesh().size();
    const double allowed =
        level == Exactness::exact ? exactness(part_->mesh().points(), size) : live * size;
    Convergence found{"the points of the thin solid", !has_points(), 0, 0.0};
    for (; found.rounds < most_rounds && !found.is_converged; ++found.rounds)
    {
        const double last = found.miss;
        found.miss = ask_for_missing(expand(middle, targets, Exactness::live), targets, asked);
        // As near as asked for; or nearer than counts, and rounding brings it no nearer.
        found.is_converged =
            found.miss <= allowed
            || (found.rounds > 0 && found.miss > 0.5 * last && found.miss <= negligible * size);
        if (found.is_converged)
            break;
        const Convergence before = middle.convergence;
        middle = deformer.deform(asked, level, progress);
        middle.convergence.join(before);
    }
    middle.convergence.join(found);
    return middle;
}

// Moves what is asked for by what the points miss; the farthest miss, mm.
double ThinSolver::ask_for_missing(const Deformation& whole, const SurfaceTargets& targets,
                                   SurfaceTargets& asked) const
{
    double worst = 0.0;
    for (const PlacedPoint& point : points_)
    {
        const Vector3 missing =
            targets.points[point.index].position - point.place.on(whole.positions);
        asked.points[point.index].position += missing;
        worst = std::max(worst, missing.norm());
    }
    return worst;
}

LocalRotations ThinSolver::rotations(const Deformation& middle,
                                     const std::vector<RigidMotion>& handles, Exactness level) const
{
    LocalRotations turned;
    if (level == Exactness::exact)
        turned = meter_.measure(middle.positions, middle.rotation_logs);
    else
        turned.matrices = meter_.matrices(middle.positions, middle.rotation_logs);
    std::vector<Matrix3> of_features, of_handles;
    for (const RigidMotion& motion : middle.features)
        of_features.push_back(motion.rotation());
    for (const RigidMotion& motion : handles)
        of_handles.push_back(motion.rotation());
    for (std::size_t s = 0; s < middle_movers_.size(); ++s)
    {
        const Mover& mover = middle_movers_[s];
        const auto row = static_cast<Eigen::Index>(s);
        if (mover.kind == Mover::Kind::sheet)
            continue;
        if (mover.kind == Mover::Kind::ground)
            turned.matrices[s] = Matrix3::Identity();
        else
            turned.matrices[s] = mover.kind == Mover::Kind::handle ? of_handles[at(mover.index)]
                                                                   : of_features[at(mover.index)];
        if (turned.logs.rows() == 0)
            continue;
        if (mover.kind == Mover::Kind::handle)
            turned.logs.row(row) = handles[at(mover.index)].rotation_log.transpose();
        else
            turned.logs.row(row) = log_near(turned.matrices[s], turned.logs.row(row)).transpose();
    }
    return turned;
}

ThinSolver::Hung ThinSolver::hung(int vertex, const Anchor& anchor, const Sheet& sheet) const
{
    const Points& rest = part_->middle().points();
    const auto turn = [&](int corner) -> const Matrix3&
    { return sheet.turned.matrices[at(corner)]; };
    const Vector3 foot = anchor.on(rest);
    const Matrix3& first = turn(anchor.corners[0]);
    const Vector3 shift = anchor.sum(
        [&](int corner) { return Vector3(sheet.middle.positions.row(corner) - rest.row(corner)); });
    const Vector3 bulge =
        0.5
        * anchor.sum(
            [&](int corner)
            { return Vector3((turn(corner) - first) * (foot - rest.row(corner).transpose())); });
    const Matrix3 mean = anchor.rotation(turn);
    const Vector3 arm = part_->mesh().points().row(vertex).transpose() - foot;
    const bool is_logged = sheet.turned.logs.rows() > 0;
    const Vector3 log =
        is_logged ? log_near(mean, anchor.on(sheet.turned.logs)) : Vector3(Vector3::Zero());
    return {shift + (mean * arm - arm) + bulge, log};
}

void ThinSolver::hang(int vertex, const Sheet& sheet, Deformation& whole) const
{
    const ThinPart::Anchors& anchors = part_->anchors(vertex);
    Vector3 shift = Vector3::Zero(), log = Vector3::Zero();
    for (const Anchor& anchor : anchors)
    {
        const Hung one = hung(vertex, anchor, sheet);
        shift += one.shift / static_cast<double>(anchors.size());
        log += one.log / static_cast<double>(anchors.size());
    }
    whole.positions.row(vertex) = part_->mesh().points().row(vertex) + shift.transpose();
    if (whole.rotation_logs.rows() > 0)
        whole.rotation_logs.row(vertex) = log.transpose();
}

void ThinSolver::place(int vertex, const Sheet& sheet, Deformation& whole) const
{
    const Mover& mover = movers_[at(vertex)];
    if (mover.kind == Mover::Kind::sheet)
        hang(vertex, sheet, whole);
    if (mover.kind != Mover::Kind::handle && mover.kind != Mover::Kind::feature)
        return;
    const RigidMotion& motion = mover.kind == Mover::Kind::handle ? sheet.handles[at(mover.index)]
                                                                  : whole.features[at(mover.index)];
    whole.positions.row(vertex) =
        motion.apply(Vector3(sheet.rest.row(vertex).transpose())).transpose();
    if (whole.rotation_logs.rows() > 0)
        whole.rotation_logs.row(vertex) = motion.rotation_log.transpose();
}

// Handles that the energy turns move as the middle shows.
std::vector<RigidMotion> ThinSolver::known_handles(const Deformation& middle,
                                                   std::vector<RigidMotion> handles) const
{
    for (std::size_t k = 0; k < handles.size(); ++k)
        if (!free_handles_[k].empty())
        {
            const Vector3 log =
                rows_of(middle.rotation_logs, free_handles_[k]).colwise().mean().transpose();
            handles[k] = best_rigid_motion_near(rows_of(part_->middle().points(), free_handles_[k]),
                                                rows_of(middle.positions, free_handles_[k]), log);
        }
    return handles;
}

Deformation ThinSolver::expand(const Deformation& middle, const SurfaceTargets& targets,
                               Exactness level) const
{
    const TriangleMesh& mesh = part_->mesh();
    const std::vector<RigidMotion> handles = known_handles(middle, targets.handles);
    const Points rest = sizes_.laid(mesh.points(), targets.sizes);
    const LocalRotations turned = rotations(middle, handles, level);
    Deformation whole{mesh.points(), {}, {}, middle.convergence};
    if (level == Exactness::exact)
        whole.rotation_logs = Points::Zero(mesh.vertex_count(), 3);
    for (std::size_t k = 0; k < middle.features.size(); ++k)
        whole.features.push_back(about(middle.features[k], centres_[k]));
    const Sheet sheet{middle, turned, handles, rest};
    parallel_ranges(mesh.vertex_count(), microsecond_items,
                    [&](Eigen::Index begin, Eigen::Index end)
                    {
                        for (Eigen::Index vertex = begin; vertex < end; ++vertex)
                            place(static_cast<int>(vertex), sheet, whole);
                    });
    return whole;
}

}  // namespace sheetmorph
