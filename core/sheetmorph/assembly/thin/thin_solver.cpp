// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/assembly/thin/thin_solver.h"

#include "sheetmorph/assembly/links/control_box.h"
#include "sheetmorph/base/index.h"
#include "sheetmorph/base/log_near.h"
#include "sheetmorph/base/threads/parallel.h"
#include "sheetmorph/base/vertex_sets.h"
#include "sheetmorph/volume/rotations/rotation_kernel.h"

#include <algorithm>
#include <numeric>

namespace sheetmorph::assembly
{

using surface::Deformation;

namespace
{

// A point moves nearly as the mid-surface under it does, so a handful of rounds is enough. Chosen:
// far more.
constexpr int most_rounds = 30;

// Residual relative to the size. From the accuracy that SheetMorph promises, 1e-9: a tenth of it.
constexpr double negligible = 1e-10;

// The same for a point in a live frame. From the accuracy of a frame, 1e-6: the sheet beyond the
// point moves several times as far as the point misses.
constexpr double live = 2e-8;

VertexIds all_vertices(const mesh::TriangleMesh& mesh)
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

Vector3 centre_of(const mesh::TriangleMesh& mesh, VertexIds vertices)
{
    make_set(vertices);
    return rows_of(mesh.points(), vertices).colwise().mean().transpose();
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
        for (const int vertex : regions[k])
            movers[at(vertex)] = {kind, static_cast<int>(k)};
}

// The later overrule the earlier: features, handles, the ground.
void ThinSolver::find_movers(const ThinSolverInput& input)
{
    const Owner& owner = input.system.owners[at(input.index)];
    const Sheet& sheet = input.system.sheets[at(owner.sheet)];
    const auto side_of = [&](int weld)
    { return side_of_weld(input.whole, input.system.welds[at(weld)], input.index); };
    std::vector<VertexIds> features, handles, fixed;
    for (const int feature : owner.features)
    {
        features.push_back(input.whole.features[at(feature)].vertices);
        sizes_.add(part_->mesh(), input.whole.features[at(feature)]);
    }
    for (const int body : owner.bodies)
        if (const int weld = body - static_cast<int>(sheet.features.size());
            weld >= 0 && weld < static_cast<int>(sheet.carriers.size()))
            features.push_back(side_of(sheet.carriers[at(weld)]));
    for (const int handle : owner.handles)
    {
        const surface::KnownRegion& region = sheet.surface.handles[at(handle)];
        free_handles_.push_back(region.is_rotation_free ? owner.own(region.vertices) : VertexIds());
        const std::size_t k = at(handle), own = sheet.handles.size();
        handles.push_back(k < own ? input.whole.handles[at(sheet.handles[k])].vertices
                                  : side_of(sheet.carried[k - own]));
    }
    for (const PartRegion& region : input.whole.fixed)
        if (region.part == input.index)
            fixed.push_back(region.vertices);
    for (const int weld : sheet.held)
        fixed.push_back(side_of(weld));
    movers_.resize(at(part_->mesh().vertex_count()));
    set_movers(movers_, features, Mover::Kind::feature);
    set_movers(movers_, handles, Mover::Kind::handle);
    set_movers(movers_, fixed, Mover::Kind::ground);
    for (const VertexIds& feature : features)
        centres_.push_back(centre_of(part_->mesh(), feature));
    find_middle_movers(owner, sheet);
}

void ThinSolver::find_middle_movers(const Owner& owner, const Sheet& sheet)
{
    const auto own = [&](const auto& regions, const std::vector<int>& which)
    {
        std::vector<VertexIds> found;
        for (const int k : which)
            found.push_back(owner.own(regions[at(k)].vertices));
        return found;
    };
    std::vector<int> all(sheet.surface.fixed.size());
    std::iota(all.begin(), all.end(), 0);
    middle_movers_.resize(part_->skin().vertices.size());
    set_movers(middle_movers_, own(sheet.surface.features, owner.bodies), Mover::Kind::feature);
    set_movers(middle_movers_, own(sheet.surface.handles, owner.handles), Mover::Kind::handle);
    set_movers(middle_movers_, own(sheet.surface.fixed, all), Mover::Kind::ground);
}

void ThinSolver::find_points(const ThinSolverInput& input)
{
    const mesh::TriangleMesh& mesh = part_->mesh();
    const std::vector<int>& points =
        input.system.sheets[at(input.system.sheet_of(input.index))].points;
    for (std::size_t k = 0; k < points.size(); ++k)
    {
        const PartPoint& point = input.whole.points[at(points[k])];
        if (point.part != input.index)
            continue;
        const auto corners = mesh.triangles().row(point.constraint.triangle);
        points_.push_back(
            {k, {{corners(0), corners(1), corners(2)}, point.constraint.barycentric}});
    }
}

Deformation ThinSolver::solve(const surface::SurfaceDeformer& deformer,
                              const surface::SurfaceTargets& targets, Exactness level,
                              const Progress& progress) const
{
    Deformation middle = deformer.deform(targets, level, progress);
    Deformation whole;
    surface::SurfaceTargets asked = targets;
    const double size = part_->mesh().size();
    const double allowed =
        level == Exactness::exact ? mesh::exactness(part_->mesh().points(), size) : live * size;
    Convergence found{"the points of the thin solid", !has_points(), 0, 0.0};
    for (; found.rounds < most_rounds && !found.is_converged; ++found.rounds)
    {
        const double last = found.miss;
        expand(middle, targets, Exactness::live, whole);
        found.miss = ask_for_missing(whole, targets, asked);
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
double ThinSolver::ask_for_missing(const Deformation& whole, const surface::SurfaceTargets& targets,
                                   surface::SurfaceTargets& asked) const
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

volume::LocalRotations ThinSolver::rotations(const Deformation& middle,
                                             const std::vector<RigidMotion>& handles,
                                             Exactness level) const
{
    volume::LocalRotations turned;
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

// How the sheet turns at every anchor of some vertices that hang on it, one after the other.
std::vector<Matrix3> ThinSolver::means(int begin, int end, const BentMiddle& bent) const
{
    const std::vector<Matrix3>& turned = bent.turned.matrices;
    std::vector<Matrix3> found;
    for (int vertex = begin; vertex < end; ++vertex)
        for (const mesh::Anchor& anchor : part_->anchors(vertex))
            if (movers_[at(vertex)].kind == Mover::Kind::sheet)
                found.push_back(
                    anchor.mean([&](int corner) -> const Matrix3& { return turned[at(corner)]; }));
    volume::make_rotations(found);
    return found;
}

ThinSolver::Hung ThinSolver::hung(int vertex, const mesh::Anchor& anchor, const Matrix3& mean,
                                  const BentMiddle& bent) const
{
    const Points& rest = part_->middle().points();
    const std::vector<Matrix3>& turned = bent.turned.matrices;
    const Vector3 foot = anchor.on(rest);
    const Matrix3& first = turned[at(anchor.corners[0])];
    const Vector3 shift = anchor.sum(
        [&](int corner) { return Vector3(bent.middle.positions.row(corner) - rest.row(corner)); });
    const Vector3 bulge = 0.5
                          * anchor.sum(
                              [&](int corner) {
                                  return Vector3((turned[at(corner)] - first)
                                                 * (foot - rest.row(corner).transpose()));
                              });
    const Vector3 arm = part_->mesh().points().row(vertex).transpose() - foot;
    const bool is_logged = bent.turned.logs.rows() > 0;
    const Vector3 log =
        is_logged ? log_near(mean, anchor.on(bent.turned.logs)) : Vector3(Vector3::Zero());
    return {shift + (mean * arm - arm) + bulge, log};
}

void ThinSolver::hang(int vertex, const Matrix3* means, const BentMiddle& bent,
                      Deformation& whole) const
{
    const ThinPart::Anchors& anchors = part_->anchors(vertex);
    Vector3 shift = Vector3::Zero(), log = Vector3::Zero();
    for (std::size_t k = 0; k < anchors.size(); ++k)
    {
        const Hung one = hung(vertex, anchors[k], means[k], bent);
        shift += one.shift / static_cast<double>(anchors.size());
        log += one.log / static_cast<double>(anchors.size());
    }
    whole.positions.row(vertex) = part_->mesh().points().row(vertex) + shift.transpose();
    if (whole.rotation_logs.rows() > 0)
        whole.rotation_logs.row(vertex) = log.transpose();
}

void ThinSolver::carry(int vertex, const RigidMotion& motion, const BentMiddle& bent,
                       Deformation& whole) const
{
    whole.positions.row(vertex) =
        motion.apply(Vector3(bent.rest.row(vertex).transpose())).transpose();
    if (whole.rotation_logs.rows() > 0)
        whole.rotation_logs.row(vertex) = motion.rotation_log.transpose();
}

void ThinSolver::place(int begin, int end, const BentMiddle& bent, Deformation& whole) const
{
    const std::vector<Matrix3> turned = means(begin, end, bent);
    const Matrix3* next = turned.data();
    for (int vertex = begin; vertex < end; ++vertex)
    {
        const Mover& mover = movers_[at(vertex)];
        if (mover.kind == Mover::Kind::sheet)
        {
            hang(vertex, next, bent, whole);
            next += part_->anchors(vertex).size();
        }
        else if (mover.kind == Mover::Kind::ground)
            whole.positions.row(vertex) = part_->mesh().points().row(vertex);
        else
            carry(vertex,
                  mover.kind == Mover::Kind::handle ? bent.handles[at(mover.index)]
                                                    : whole.features[at(mover.index)],
                  bent, whole);
    }
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

void ThinSolver::expand(const Deformation& middle, const surface::SurfaceTargets& targets,
                        Exactness level, Deformation& whole) const
{
    const mesh::TriangleMesh& mesh = part_->mesh();
    const std::vector<RigidMotion> handles = known_handles(middle, targets.handles);
    const bool is_sized = std::any_of(targets.sizes.begin(), targets.sizes.end(),
                                      [](const auto& size) { return size.has_value(); });
    const Points sized = is_sized ? sizes_.laid(mesh.points(), targets.sizes) : Points();
    const volume::LocalRotations turned = rotations(middle, handles, level);
    whole.positions.resize(mesh.vertex_count(), 3);
    whole.rotation_logs = Points::Zero(level == Exactness::exact ? mesh.vertex_count() : 0, 3);
    whole.features.clear();
    for (std::size_t k = 0; k < centres_.size(); ++k)
        whole.features.push_back(about(middle.features[k], centres_[k]));
    whole.convergence = middle.convergence;
    const BentMiddle bent{middle, turned, handles, is_sized ? sized : mesh.points()};
    parallel_ranges(mesh.vertex_count(), microsecond_items,
                    [&](Eigen::Index begin, Eigen::Index end)
                    { place(static_cast<int>(begin), static_cast<int>(end), bent, whole); });
}

VertexIds ThinSolver::read_logs() const
{
    VertexIds vertices = meter_.without_ring();
    for (const VertexIds& handle : free_handles_)
        vertices.insert(vertices.end(), handle.begin(), handle.end());
    make_set(vertices);
    return vertices;
}

}  // namespace sheetmorph::assembly
