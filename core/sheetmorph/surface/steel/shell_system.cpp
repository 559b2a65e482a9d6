// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/surface/steel/shell_system.h"

#include "sheetmorph/base/errors.h"
#include "sheetmorph/base/index.h"
#include "sheetmorph/base/threads/parallel.h"
#include "sheetmorph/base/vertex_sets.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>

namespace sheetmorph::surface
{

namespace
{

using Kind = ShellMover::Kind;

constexpr Eigen::Index least_elements = 100;  // fewest for a thread; chosen, not measured
constexpr std::size_t chunk = 4096;           // elements in memory at a time; chosen, not measured

Vector3 row_of(const Points& points, int row)
{
    return points.row(row).transpose();
}

// Applies the smallest rotation between two unit vectors to a vector.
Vector3 transported(const Vector3& vector, const Vector3& from, const Vector3& to)
{
    const double cosine = from.dot(to);
    if (cosine < -0.999)  // from geometry: opposite vectors have no smallest rotation
        return vector;
    const Vector3 axis = from.cross(to);
    return cosine * vector + axis.cross(vector) + axis * (axis.dot(vector) / (1.0 + cosine));
}

}  // namespace

ShellSystem::ShellSystem(const ShellInput& input, ShellMovers movers, Joints& joints)
    : mesh_(input.mesh), part_(input.part), movers_(std::move(movers)), joints_(joints)
{
    for (std::size_t t = 0; t < mesh_.triangles.size(); ++t)
    {
        const ShellMesh::Triangle& triangle = mesh_.triangles[t];
        const std::vector<int> columns = columns_of(triangle);
        if (columns.empty())
            continue;
        ShellElement::Place rest;
        for (std::size_t k = 0; k < 3; ++k)
        {
            rest.corners[k] = row_of(part_.rest.points(), triangle.corners[k]);
            rest.directors[k] = mesh_.directors[at(triangle.edges[k])];
        }
        triangles_.push_back(t);
        elements_.emplace_back(rest, input.poisson);
        freedoms_.push_back({{}, columns, {}, 0, false});
    }
    find_columns();
    find_things();
    const numerics::SparseMatrix coupled = coupled_things();
    find_pattern(coupled);
    find_slots(coupled);
    find_tree(coupled);
    restore(movers_.start);
}

// Ascending; empty if all corners and directors are prescribed.
std::vector<int> ShellSystem::columns_of(const ShellMesh::Triangle& triangle) const
{
    std::vector<int> columns;
    const auto add = [&](const ShellMover& mover, int count)
    {
        if (mover.kind == Kind::open)
            for (int k = 0; k < count; ++k)
                columns.push_back(mover.index + k);
        if (mover.kind == Kind::joint)
            for (const JointLevel& level : joints_.levels(at(mover.index)))
                for (std::size_t axis = 0; axis < level.axes.size(); ++axis)
                    columns.push_back(movers_.open + level.first + static_cast<int>(axis));
    };
    for (const int corner : triangle.corners)
        add(movers_.vertices[at(corner)], 3);
    for (const int edge : triangle.edges)
        add(movers_.edges[at(edge)], 1);
    std::sort(columns.begin(), columns.end());
    columns.erase(std::unique(columns.begin(), columns.end()), columns.end());
    return columns;
}

void ShellSystem::find_columns()
{
    for (std::size_t e = 0; e < elements_.size(); ++e)
    {
        const ShellMesh::Triangle& triangle = mesh_.triangles[triangles_[e]];
        Freedom& freedom = freedoms_[e];
        freedom.direct.fill(-1);
        for (int k = 0; k < 3; ++k)
        {
            const ShellMover& vertex = movers_.vertices[at(triangle.corners[at(k)])];
            const ShellMover& edge = movers_.edges[at(triangle.edges[at(k)])];
            freedom.is_jointed |= vertex.kind == Kind::joint || edge.kind == Kind::joint;
            const auto local = [&freedom](int column)
            {
                return static_cast<int>(
                    std::lower_bound(freedom.columns.begin(), freedom.columns.end(), column)
                    - freedom.columns.begin());
            };
            for (int x = 0; x < 3 && vertex.kind == Kind::open; ++x)
                freedom.direct[at(3 * k + x)] = local(vertex.index + x);
            if (edge.kind == Kind::open)
                freedom.direct[at(9 + k)] = local(edge.index);
        }
    }
}

// The sparse matrices count their entries as int.
void ShellSystem::check_count(std::size_t entries)
{
    if (entries > static_cast<std::size_t>(std::numeric_limits<int>::max()))
        throw SolverError(
            "the sheet has too many vertices for the energy steel and for refine: "
            "about ten million are possible",
            "use a coarser mesh");
}

// Expands couplings of blocks to blocks of the matrix; the columns of a block have the same rows.
void ShellSystem::find_pattern(const numerics::SparseMatrix& coupled)
{
    const auto count_of = [this](Eigen::Index thing) { return things_[at(thing)].count; };
    std::vector<int> heights(things_.size(), 0);
    std::size_t entries = 0;
    for (Eigen::Index k = 0; k < coupled.outerSize(); ++k)
    {
        for (numerics::SparseMatrix::InnerIterator entry(coupled, k); entry; ++entry)
            heights[at(k)] += count_of(entry.row());
        entries += at(heights[at(k)]) * at(count_of(k));
    }
    check_count(entries);
    matrix_ = std::make_shared<numerics::SparseMatrix>(unknowns(), unknowns());
    matrix_->resizeNonZeros(static_cast<Eigen::Index>(entries));
    int* const starts = matrix_->outerIndexPtr();
    int* row = matrix_->innerIndexPtr();
    for (Eigen::Index k = 0; k < coupled.outerSize(); ++k)
        for (int column = 0; column < count_of(k); ++column)
        {
            const int unknown = things_[at(k)].first + column;
            starts[unknown + 1] = starts[unknown] + heights[at(k)];
            for (numerics::SparseMatrix::InnerIterator entry(coupled, k); entry; ++entry)
                for (int r = 0; r < count_of(entry.row()); ++r)
                    *row++ = things_[at(entry.row())].first + r;
        }
}

void ShellSystem::find_slots(const numerics::SparseMatrix& coupled)
{
    for (Freedom& freedom : freedoms_)
    {
        freedom.first_slot = slots_.size();
        for (const int column : freedom.things)
        {
            int slot = matrix_->outerIndexPtr()[things_[at(column)].first];
            numerics::SparseMatrix::InnerIterator entry(coupled, column);
            for (const int thing : freedom.things)
            {
                for (; entry.row() != thing; ++entry)
                    slot += things_[at(entry.row())].count;
                slots_.push_back(slot);
            }
        }
    }
}

ShellElement::Place ShellSystem::place_of(std::size_t element) const
{
    const ShellMesh::Triangle& triangle = mesh_.triangles[triangles_[element]];
    ShellElement::Place place;
    for (std::size_t k = 0; k < 3; ++k)
    {
        place.corners[k] = row_of(shape_.positions, triangle.corners[k]);
        place.directors[k] = shape_.directors[at(triangle.edges[k])];
    }
    return place;
}

double ShellSystem::energy(double bending) const
{
    Eigen::VectorXd parts(static_cast<Eigen::Index>(elements_.size()));
    parallel_ranges(parts.size(), least_elements,
                    [&](Eigen::Index begin, Eigen::Index end)
                    {
                        for (Eigen::Index e = begin; e < end; ++e)
                            parts(e) = elements_[at(e)].energy(
                                elements_[at(e)].strain(place_of(at(e))), bending);
                    });
    return parts.sum();
}

// Derivative of a point's position with respect to one unknown of a level.
Vector3 ShellSystem::arm(const JointLevel& level, std::size_t axis, const Vector3& point) const
{
    return level.is_turn ? Vector3(level.axes[axis].cross(point - level.point)) : level.axes[axis];
}

double ShellSystem::sign_of(std::size_t element, int local) const
{
    return local < 9 ? 1.0 : mesh_.triangles[triangles_[element]].signs[at(local - 9)];
}

// Projects the matrix and the gradient of an element onto its own columns.
void ShellSystem::project(std::size_t element, const ShellElement::Matrix& stiffness,
                          const ShellElement::Vector& forces, Projected& found) const
{
    const Freedom& freedom = freedoms_[element];
    if (freedom.is_jointed)
    {
        const Local rows = local_rows(element);
        found.matrix.noalias() = rows.transpose() * (stiffness * rows);
        found.gradient.noalias() = rows.transpose() * forces;
        return;
    }
    const auto count = static_cast<Eigen::Index>(freedom.columns.size());
    found.matrix.resize(count, count);
    found.gradient.resize(count);
    for (int a = 0; a < 12; ++a)
    {
        const int column = freedom.direct[at(a)];
        if (column < 0)
            continue;
        const double sign = sign_of(element, a);
        found.gradient(column) = sign * forces(a);
        for (int b = 0; b < 12; ++b)
            if (freedom.direct[at(b)] >= 0)
                found.matrix(freedom.direct[at(b)], column) =
                    sign * sign_of(element, b) * stiffness(b, a);
    }
}

// (12, columns) derivatives of corners and directors with respect to the unknowns.
ShellSystem::Local ShellSystem::local_rows(std::size_t element) const
{
    const Freedom& freedom = freedoms_[element];
    const ShellMesh::Triangle& triangle = mesh_.triangles[triangles_[element]];
    Local rows = Local::Zero(12, static_cast<Eigen::Index>(freedom.columns.size()));
    for (int k = 0; k < 12; ++k)
        if (freedom.direct[at(k)] >= 0)
            rows(k, freedom.direct[at(k)]) = sign_of(element, k);
    const auto each_column = [&](int turner, const auto& use)
    {
        for (const JointLevel& level : joints_.levels(at(turner)))
            for (std::size_t axis = 0; axis < level.axes.size(); ++axis)
            {
                const int column = movers_.open + level.first + static_cast<int>(axis);
                use(level, axis,
                    std::lower_bound(freedom.columns.begin(), freedom.columns.end(), column)
                        - freedom.columns.begin());
            }
    };
    for (int k = 0; k < 3; ++k)
    {
        const int corner = triangle.corners[at(k)], edge = triangle.edges[at(k)];
        if (movers_.vertices[at(corner)].kind == Kind::joint)
            each_column(movers_.vertices[at(corner)].index,
                        [&](const JointLevel& level, std::size_t axis, Eigen::Index column) {
                            rows.block<3, 1>(3 * k, column) =
                                arm(level, axis, row_of(shape_.positions, corner));
                        });
        if (movers_.edges[at(edge)].kind == Kind::joint)
            each_column(movers_.edges[at(edge)].index,
                        [&](const JointLevel& level, std::size_t axis, Eigen::Index column)
                        {
                            if (level.is_turn)
                                rows(9 + k, column) =
                                    triangle.signs[at(k)]
                                    * level.axes[axis].dot(mesh_.direction(shape_.positions, edge));
                        });
    }
    return rows;
}

// Second-order contribution of forces along the curved paths of bodies.
void ShellSystem::add_second_order(std::size_t element, const ShellElement::Vector& forces,
                                   Eigen::MatrixXd& sum) const
{
    const Freedom& freedom = freedoms_[element];
    const ShellMesh::Triangle& triangle = mesh_.triangles[triangles_[element]];
    const auto column_of = [&](const JointLevel& level, std::size_t axis)
    {
        const int column = movers_.open + level.first + static_cast<int>(axis);
        return std::lower_bound(freedom.columns.begin(), freedom.columns.end(), column)
               - freedom.columns.begin();
    };
    for (int k = 0; k < 3; ++k)
    {
        const ShellMover& mover = movers_.vertices[at(triangle.corners[at(k)])];
        if (mover.kind != Kind::joint)
            continue;
        const Vector3 force = forces.segment<3>(3 * k);
        const Vector3 point = row_of(shape_.positions, triangle.corners[at(k)]);
        const std::vector<JointLevel>& levels = joints_.levels(at(mover.index));
        for (std::size_t outer = 0; outer < levels.size(); ++outer)
            for (std::size_t a = 0; a < levels[outer].axes.size() && levels[outer].is_turn; ++a)
                for (std::size_t inner = outer; inner < levels.size(); ++inner)
                    for (std::size_t b = 0; b < levels[inner].axes.size(); ++b)
                    {
                        const Vector3 moved = arm(levels[inner], b, point);
                        const double change = force.dot(levels[outer].axes[a].cross(moved));
                        const Eigen::Index row = column_of(levels[outer], a);
                        const Eigen::Index column = column_of(levels[inner], b);
                        const double share = inner == outer ? 0.5 : 1.0;
                        sum(row, column) += share * change;
                        sum(column, row) += share * change;
                    }
    }
}

ShellElement::Vector ShellSystem::local_step(std::size_t element,
                                             const Eigen::VectorXd& change) const
{
    const Freedom& freedom = freedoms_[element];
    if (!freedom.is_jointed)
    {
        ShellElement::Vector local = ShellElement::Vector::Zero();
        for (int k = 0; k < 12; ++k)
            if (freedom.direct[at(k)] >= 0)
                local(k) = sign_of(element, k) * change(freedom.columns[at(freedom.direct[at(k)])]);
        return local;
    }
    Eigen::VectorXd own(static_cast<Eigen::Index>(freedom.columns.size()));
    for (std::size_t k = 0; k < freedom.columns.size(); ++k)
        own(static_cast<Eigen::Index>(k)) = change(freedom.columns[k]);
    return local_rows(element) * own;
}

ShellSystem::Stresses ShellSystem::predicted(double bending, const Eigen::VectorXd& change) const
{
    Stresses found(elements_.size());
    parallel_ranges(static_cast<Eigen::Index>(elements_.size()), least_elements,
                    [&](Eigen::Index begin, Eigen::Index end)
                    {
                        for (auto e = at(begin); e < at(end); ++e)
                            found[e] = elements_[e].predicted(elements_[e].strain(place_of(e)),
                                                              bending, local_step(e, change));
                    });
    return found;
}

ShellSystem::Stresses ShellSystem::eased(double bending, double share) const
{
    Stresses found(elements_.size());
    parallel_ranges(static_cast<Eigen::Index>(elements_.size()), least_elements,
                    [&](Eigen::Index begin, Eigen::Index end)
                    {
                        for (auto e = at(begin); e < at(end); ++e)
                        {
                            const ShellElement::Stress whole =
                                elements_[e].stress(elements_[e].strain(place_of(e)), bending);
                            found[e] = whole;
                            if (share == 1.0)
                                continue;
                            const ShellElement::Stress pull = ShellElement::tension(whole);
                            found[e].membrane =
                                pull.membrane + share * (whole.membrane - pull.membrane);
                            found[e].moments = share * whole.moments;
                        }
                    });
    return found;
}

ShellSystem::Tangent ShellSystem::tangent(double bending, const Stresses& stresses, double share)
{
    Tangent found{Eigen::VectorXd::Zero(unknowns()), matrix_};
    std::fill(matrix_->valuePtr(), matrix_->valuePtr() + matrix_->nonZeros(), 0.0);
    std::vector<Projected> parts(std::min(chunk, elements_.size()));
    for (std::size_t first = 0; first < elements_.size(); first += chunk)
    {
        const std::size_t count = std::min(chunk, elements_.size() - first);
        const auto work = [&](Eigen::Index begin, Eigen::Index end)
        {
            for (auto k = at(begin); k < at(end); ++k)
            {
                const std::size_t e = first + k;
                const ShellElement::Strain strain = elements_[e].strain(place_of(e));
                const ShellElement::Vector forces = elements_[e].gradient(strain, bending);
                project(e, elements_[e].stiffness(strain, bending, stresses[e]), forces, parts[k]);
                if (freedoms_[e].is_jointed && share > 0.0)
                    add_second_order(e, share * forces, parts[k].matrix);
            }
        };
        parallel_ranges(static_cast<Eigen::Index>(count), least_elements, work);
        for (std::size_t k = 0; k < count; ++k)
        {
            add_to_matrix(freedoms_[first + k], parts[k].matrix);
            const std::vector<int>& columns = freedoms_[first + k].columns;
            for (std::size_t c = 0; c < columns.size(); ++c)
                found.gradient(columns[c]) += parts[k].gradient(static_cast<Eigen::Index>(c));
        }
    }
    brace_joints();
    return found;
}

void ShellSystem::add_to_matrix(const Freedom& freedom, const Eigen::MatrixXd& part)
{
    const int* slot = slots_.data() + freedom.first_slot;
    const double* column_values = part.data();
    for (const int column : freedom.things)
    {
        const Thing& across = things_[at(column)];
        const int height =
            matrix_->outerIndexPtr()[across.first + 1] - matrix_->outerIndexPtr()[across.first];
        Eigen::Index row = 0;
        for (const int thing : freedom.things)
        {
            const int rows = things_[at(thing)].count;
            double* to = matrix_->valuePtr() + *slot++;
            for (int c = 0; c < across.count; ++c, to += height)
                for (int r = 0; r < rows; ++r)
                    to[r] += column_values[c * part.rows() + row + r];
            row += rows;
        }
        column_values += across.count * part.rows();
    }
}

// Freedoms without a triangle, such as those of a body with one vertex, need a pivot to stay at
// rest.
void ShellSystem::brace_joints()
{
    if (joints_.freedoms() == 0)
        return;
    const double brace = 1e-10 * matrix_->diagonal().mean();  // chosen: it only gives a pivot
    for (int k = movers_.open; k < unknowns(); ++k)
        matrix_->coeffRef(k, k) += brace;
}

Eigen::VectorXd ShellSystem::out_of_plane() const
{
    const Points& rest = part_.rest.points();
    Vector3 held = Vector3::Zero();
    double count = 0.0;
    for (std::size_t i = 0; i < movers_.vertices.size(); ++i)
        if (part_.roles.role[i] == Role::fixed)
        {
            held += row_of(rest, static_cast<int>(i));
            count += 1.0;
        }
    held /= std::max(count, 1.0);
    Eigen::VectorXd field = Eigen::VectorXd::Zero(unknowns());
    for (const std::size_t t : triangles_)
    {
        const ShellMesh::Triangle& triangle = mesh_.triangles[t];
        std::array<Vector3, 3> corners;
        for (std::size_t k = 0; k < 3; ++k)
            corners[k] = row_of(shape_.positions, triangle.corners[k]);
        const Vector3 normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
        for (const int corner : triangle.corners)
            if (const ShellMover& mover = movers_.vertices[at(corner)]; mover.kind == Kind::open)
                field.segment<3>(mover.index) += (row_of(rest, corner) - held).norm()
                                                 / std::sqrt(std::max(normal.norm(), 1e-300))
                                                 * normal;
    }
    return field;
}

double ShellSystem::shift_of(const Eigen::VectorXd& change) const
{
    double worst = 0.0;
    for (std::size_t i = 0; i < movers_.vertices.size(); ++i)
    {
        const ShellMover& mover = movers_.vertices[i];
        Vector3 shift = Vector3::Zero();
        if (mover.kind == Kind::open)
            shift = change.segment<3>(mover.index);
        if (mover.kind == Kind::joint)
            for (const JointLevel& level : joints_.levels(at(mover.index)))
                for (std::size_t axis = 0; axis < level.axes.size(); ++axis)
                    shift += change(movers_.open + level.first + static_cast<int>(axis))
                             * arm(level, axis, row_of(shape_.positions, static_cast<int>(i)));
        worst = std::max(worst, shift.norm());
    }
    return worst;
}

double ShellSystem::turn_of(const Eigen::VectorXd& change) const
{
    double worst = 0.0;
    for (const ShellMover& mover : movers_.edges)
        if (mover.kind == Kind::open)
            worst = std::max(worst, std::abs(change(mover.index)));
    for (std::size_t k = 0; k < joints_.states().size(); ++k)
        for (const JointLevel& level : joints_.levels(k))
            for (std::size_t axis = 0; axis < level.axes.size() && level.is_turn; ++axis)
                worst = std::max(
                    worst, std::abs(change(movers_.open + level.first + static_cast<int>(axis))));
    return worst;
}

void ShellSystem::step(const Eigen::VectorXd& change)
{
    const ShellShape before = shape_;
    joints_.step(change.tail(joints_.freedoms()));
    shape_.bodies = joints_.states();
    for (std::size_t i = 0; i < movers_.vertices.size(); ++i)
    {
        const ShellMover& mover = movers_.vertices[i];
        const auto row = static_cast<Eigen::Index>(i);
        if (mover.kind == Kind::open)
            shape_.positions.row(row) += change.segment<3>(mover.index).transpose();
        if (mover.kind == Kind::joint)
        {
            const BodyState& from = before.bodies[at(mover.index)];
            const BodyState& to = shape_.bodies[at(mover.index)];
            const Vector3 arm_before = before.positions.row(row).transpose() - from.centre;
            shape_.positions.row(row) =
                (to.centre + to.rotation * (from.rotation.transpose() * arm_before)).transpose();
        }
    }
    for (std::size_t e = 0; e < movers_.edges.size(); ++e)
    {
        const ShellMover& mover = movers_.edges[e];
        Vector3& director = shape_.directors[e];
        if (mover.kind == Kind::joint)
            director = shape_.bodies[at(mover.index)].rotation
                       * (before.bodies[at(mover.index)].rotation.transpose() * director);
        if (mover.kind == Kind::known)
            continue;
        const Vector3 now = mesh_.direction(shape_.positions, static_cast<int>(e));
        if (mover.kind == Kind::open)
        {
            director =
                transported(director, mesh_.direction(before.positions, static_cast<int>(e)), now);
            const double angle = change(mover.index);
            director = std::cos(angle) * director + std::sin(angle) * now.cross(director);
        }
        director = (director - director.dot(now) * now).normalized();
    }
}

void ShellSystem::restore(const ShellShape& shape)
{
    shape_ = shape;
    joints_.restore(shape.bodies);
}

numerics::SparseMatrix ShellSystem::point_rows() const
{
    std::vector<Eigen::Triplet<double>> entries;
    int row = 0;
    for (std::size_t k = 0; k < part_.constraints.points.size(); ++k)
    {
        if (!movers_.is_point_held[k])
            continue;
        const PointConstraint& point = part_.constraints.points[k];
        for (int c = 0; c < 3; ++c)
        {
            const int corner = part_.rest.triangles()(point.triangle, c);
            const ShellMover& mover = movers_.vertices[at(corner)];
            for (int x = 0; x < 3 && mover.kind == Kind::open; ++x)
                entries.emplace_back(row + x, mover.index + x, point.barycentric(c));
            if (mover.kind != Kind::joint)
                continue;
            for (const JointLevel& level : joints_.levels(at(mover.index)))
                for (std::size_t axis = 0; axis < level.axes.size(); ++axis)
                {
                    const Vector3 moved = arm(level, axis, row_of(shape_.positions, corner));
                    for (int x = 0; x < 3; ++x)
                        entries.emplace_back(row + x,
                                             movers_.open + level.first + static_cast<int>(axis),
                                             point.barycentric(c) * moved(x));
                }
        }
        row += 3;
    }
    numerics::SparseMatrix rows(row, unknowns());
    rows.setFromTriplets(entries.begin(), entries.end());
    return rows;
}

Eigen::VectorXd ShellSystem::point_misses(const SurfaceTargets& targets) const
{
    std::vector<double> misses;
    for (std::size_t k = 0; k < part_.constraints.points.size(); ++k)
    {
        if (!movers_.is_point_held[k])
            continue;
        const PointConstraint& point = part_.constraints.points[k];
        Vector3 place = Vector3::Zero();
        for (int c = 0; c < 3; ++c)
            place += point.barycentric(c)
                     * row_of(shape_.positions, part_.rest.triangles()(point.triangle, c));
        for (int x = 0; x < 3; ++x)
            misses.push_back(targets.points[k].position(x) - place(x));
    }
    return Eigen::Map<const Eigen::VectorXd>(misses.data(),
                                             static_cast<Eigen::Index>(misses.size()));
}

}  // namespace sheetmorph::surface
