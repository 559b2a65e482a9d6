// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/volume/volume_link.h"

#include "sheetmorph/base/errors.h"
#include "sheetmorph/base/index.h"
#include "sheetmorph/base/log_near.h"
#include "sheetmorph/base/rotation.h"
#include "sheetmorph/base/rotations/rotation_batch.h"
#include "sheetmorph/numerics/products/row_space.h"
#include "sheetmorph/volume/mean_value_coordinates.h"
#include "sheetmorph/volume/rotations/rotation_kernel.h"

#include <algorithm>

namespace sheetmorph::volume
{

using numerics::Weights;

namespace
{

// Distance of the points for central differences, relative to the box. Their error is step^2, and
// the weights, exact to 1e-11, add 1e-11 / step. Chosen for 1e-6 and 1e-8: rotations to 1e-6 do not
// show, and no noise grows.
constexpr double difference_step = 1e-3;

// Targets composed at a time, so that the weights of many targets never exist together. Chosen: 256
// rows of 386 weights are 0.8 MB and fit the second cache.
constexpr Eigen::Index chunk = 256;

// Limit on rows that exist together in double precision; of more rows, no rank is computed. Chosen:
// 20,000 rows of 386 weights are 62 MB.
constexpr Eigen::Index most_together = 20000;

// Truncation of the targets' rows. From the storage: a float with a remainder of 16 bits keeps an
// entry to 2^-40 (PanelRows), so the truncation is an eighth of that.
constexpr double negligible = 0x1p-43;

void check(const LinkSource& source, const LinkOptions& options)
{
    const Eigen::Index count = source.points.rows();
    if (count == 0)
        throw InvalidInput("a control mesh without source points",
                           "give the contact region of the "
                           "part that drives it at least one vertex");
    if (!(options.offset >= 0.0))
        throw InvalidInput("the offset of the samples along the normals must not be negative");
    if ((options.offset > 0.0 && source.normals.rows() != count)
        || (source.areas.size() != 0 && source.areas.size() != count))
        throw InvalidInput("the source points of a control mesh need one normal and one area each");
}

Points offsets_of(const LinkSource& source, const LinkOptions& options)
{
    return options.offset > 0.0 ? Points(options.offset * source.normals) : Points(0, 3);
}

// The points of the source and, with normals, the points on both sides of it.
Points samples(const Points& points, const Points& offsets)
{
    if (offsets.rows() == 0)
        return points;
    Points all(3 * points.rows(), 3);
    all << points, points + offsets, points - offsets;
    return all;
}

Eigen::VectorXd areas_of(const LinkSource& source)
{
    if (source.areas.size() == source.points.rows() && source.areas.sum() > 0.0)
        return source.areas;
    return Eigen::VectorXd::Ones(source.points.rows());
}

// A sample at +-h n has the displacement a +- b, where a is that of its point and b that of its
// offset. So there are twice as many inputs as points, not three times as many.
Weights input_rows(const Weights& weighted, Eigen::Index count)
{
    if (weighted.rows() == count)
        return weighted;
    const auto middle = weighted.topRows(count), above = weighted.middleRows(count, count);
    const auto below = weighted.bottomRows(count);
    Weights rows(2 * count, weighted.cols());
    rows << middle + above + below, above - below;
    return rows;
}

std::vector<Eigen::Index> nearest_rows(const Points& points, const Points& targets)
{
    std::vector<Eigen::Index> nearest(static_cast<std::size_t>(targets.rows()));
    for (Eigen::Index i = 0; i < targets.rows(); ++i)
        (points.rowwise() - targets.row(i)).rowwise().squaredNorm().minCoeff(&nearest[i]);
    return nearest;
}

}  // namespace

VolumeLink::VolumeLink(const ControlMesh& control, const LinkSource& source, const Points& targets,
                       const LinkOptions& options)
    : VolumeLink(control, source, options)
{
    targets_ = targets;
    const MeanValueCoordinates coordinates(control.vertices, control.shape.triangles());
    compose(coordinates, fit_by(coordinates));
}

VolumeLink::VolumeLink(const ControlMesh& control, const LinkSource& source,
                       const LinkOptions& options)
    : options_((check(source, options), options)),
      control_(control),
      source_(source.points),
      source_offsets_(offsets_of(source, options)),
      areas_(areas_of(source)),
      steps_(control.box.axes * (difference_step * control.box.half_extents).asDiagonal()),
      later_fit_(std::make_shared<LaterFit>())
{
}

std::unique_ptr<const VolumeLink::Fit> VolumeLink::fit_by(
    const MeanValueCoordinates& coordinates) const
{
    const Points all = samples(source_, source_offsets_);
    const ControlMeshFit fit(coordinates.weights(all),
                             areas_.replicate(all.rows() / areas_.size(), 1),
                             control_.shape.laplacian(), options_.smoothness);
    const Weights rows = input_rows(fit.weighted_samples(), source_.rows());
    return std::make_unique<const Fit>(
        Fit{fit.factor(), fit.factor().half_solve_rows(rows).transpose()});
}

const VolumeLink::Fit& VolumeLink::fit() const
{
    std::call_once(later_fit_->is_there,
                   [this]
                   {
                       if (later_fit_->fit == nullptr)
                           later_fit_->fit = fit_by(
                               MeanValueCoordinates(control_.vertices, control_.shape.triangles()));
                   });
    return *later_fit_->fit;
}

void VolumeLink::compose(const MeanValueCoordinates& coordinates, std::unique_ptr<const Fit> fit)
{
    const Eigen::Index inputs = input_count(), vertices = control_.vertices.rows();
    if (options_.rotations)
        nearest_ = nearest_rows(source_, targets_);
    const double doubles = static_cast<double>(row_count() * std::min(inputs, vertices));
    if (sizeof(double) * doubles > options_.most_kept)
    {
        coordinates_ = std::make_shared<const MeanValueCoordinates>(coordinates);
        later_fit_->fit = std::move(fit);
    }
    else if (row_count() <= most_together)
        keep_low_rank(coordinates, *fit);
    else
        keep_rows(coordinates, *fit);
}

// Stores the rows of the targets as a product of low rank if that takes less memory.
void VolumeLink::keep_low_rank(const MeanValueCoordinates& coordinates, const Fit& fit)
{
    Weights half(row_count(), control_.vertices.rows());
    for (Eigen::Index row = 0, first = 0; row < half.rows(); first += chunk)
    {
        const Weights rows = fit.factor.half_solve_rows(target_rows(coordinates, first));
        half.middleRows(row, rows.rows()) = rows;
        row += rows.rows();
    }
    const Weights half_inputs = fit.from_inputs.transpose();
    // An entry of rows_ takes six bytes, an entry of combined_ eight.
    const Eigen::Index rows = half.rows(), inputs = half_inputs.rows();
    const Weights basis = numerics::row_space(
        {half, half_inputs}, 3 * rows * inputs / (3 * rows + 4 * inputs), negligible);
    Weights through = half_inputs;
    if (basis.rows() != 0)
    {
        through = Weights::Zero(basis.rows(), half.cols());
        numerics::add_product(basis, fit.from_inputs, 1.0, through);
        combined_ = numerics::ExactPanelRows(basis);
    }
    rows_ = numerics::CompactPanelRows(rows, through.rows());
    for (Eigen::Index first = 0; first < rows; first += 4 * chunk)
    {
        const Eigen::Index count = std::min(4 * chunk, rows - first);
        Weights some = Weights::Zero(count, through.rows());
        numerics::add_product(half.middleRows(first, count), through, 1.0, some);
        rows_.set(first, some);
    }
}

// Stores the rows of the targets on the control vertices, or on the inputs if there are fewer.
void VolumeLink::keep_rows(const MeanValueCoordinates& coordinates, const Fit& fit)
{
    const Eigen::Index inputs = input_count(), vertices = control_.vertices.rows();
    const bool is_composed = row_count() * inputs <= vertices * (row_count() + inputs);
    const Weights half_inputs = fit.from_inputs.transpose();
    if (!is_composed)
    {
        Weights control = Weights::Zero(vertices, inputs);
        numerics::add_product(fit.factor.half_solve_rows(Weights::Identity(vertices, vertices)),
                              half_inputs, 1.0, control);
        combined_ = numerics::ExactPanelRows(control);
    }
    rows_ = numerics::CompactPanelRows(row_count(), is_composed ? inputs : vertices);
    for (Eigen::Index first = 0, row = 0; row < row_count(); first += chunk)
    {
        Weights rows = target_rows(coordinates, first);
        if (is_composed)
        {
            Weights composed = Weights::Zero(rows.rows(), inputs);
            numerics::add_product(fit.factor.half_solve_rows(std::move(rows)), half_inputs, 1.0,
                                  composed);
            rows = std::move(composed);
        }
        rows_.set(row, rows);
        row += rows.rows();
    }
}

// A target with rotations has one row for its position and one for each of three derivatives.
Eigen::Index VolumeLink::row_count() const
{
    return (options_.rotations ? 4 : 1) * targets_.rows();
}

// For each target of a chunk, a row for the position and, with rotations, one for each derivative
// along the box's axes. Because of these directions, a rotated model gives the rotated result.
Weights VolumeLink::target_rows(const MeanValueCoordinates& coordinates, Eigen::Index first) const
{
    const Eigen::Index count = std::min(chunk, targets_.rows() - first);
    const auto targets = targets_.middleRows(first, count);
    if (!options_.rotations)
        return coordinates.weights(targets);
    Points around(7 * count, 3);
    for (Eigen::Index i = 0; i < count; ++i)
    {
        around.row(7 * i) = targets.row(i);
        for (int a = 0; a < 3; ++a)
        {
            around.row(7 * i + 2 * a + 1) = targets.row(i) + steps_.col(a).transpose();
            around.row(7 * i + 2 * a + 2) = targets.row(i) - steps_.col(a).transpose();
        }
    }
    const Weights all = coordinates.weights(around);
    Weights rows(4 * count, all.cols());
    for (Eigen::Index i = 0; i < count; ++i)
    {
        rows.row(4 * i) = all.row(7 * i);
        for (int a = 0; a < 3; ++a)
            rows.row(4 * i + a + 1) = (all.row(7 * i + 2 * a + 1) - all.row(7 * i + 2 * a + 2))
                                      / (2.0 * steps_.col(a).norm());
    }
    return rows;
}

// Positions and, with offsets, as many offsets.
Eigen::Index VolumeLink::input_count() const
{
    return source_.rows() + source_offsets_.rows();
}

Points VolumeLink::inputs(const SourceState& state) const
{
    const Eigen::Index count = source_.rows();
    const bool has_offsets = source_offsets_.rows() > 0;
    if (state.positions.rows() != count
        || (has_offsets && static_cast<Eigen::Index>(state.rotations.size()) != count))
        throw InvalidInput(
            "the state of a control mesh's source needs a position, and with offset "
            "samples a rotation, for each of its "
            + std::to_string(count) + " points");
    Points inputs(input_count(), 3);
    inputs.topRows(count) = state.positions - state.mean.apply(source_);
    const Matrix3 rotation = state.mean.rotation();
    for (Eigen::Index i = 0; has_offsets && i < count; ++i)
        inputs.row(count + i) =
            ((state.rotations[i] - rotation) * source_offsets_.row(i).transpose()).transpose();
    return inputs;
}

Points VolumeLink::Fit::displacements(const Points& inputs) const
{
    return factor.solve_upper(numerics::narrow_product(from_inputs, inputs));
}

Points VolumeLink::control_vertices(const SourceState& state) const
{
    return state.mean.apply(control_.vertices) + fit().displacements(inputs(state));
}

// Displacements for all rows of the targets. Rows that are not stored are computed again on all
// threads; so many targets are always one link.
Points VolumeLink::displacements(const Points& inputs, Exactness exactness) const
{
    if (coordinates_ == nullptr)
        return combined_.rows() == 0 ? rows_.times(inputs, exactness)
                                     : rows_.times(combined_.times(inputs, exactness), exactness);
    const Points control = fit().displacements(inputs);
    Points moved(row_count(), 3);
    for (Eigen::Index first = 0, row = 0; row < moved.rows(); first += chunk)
    {
        const Weights rows = target_rows(*coordinates_, first);
        moved.middleRows(row, rows.rows()) = numerics::narrow_product(rows, control);
        row += rows.rows();
    }
    return moved;
}

Matrix3 LinkedTargets::rotation(Eigen::Index row) const
{
    return rotations.empty() ? rotation_from_log(logs.row(row).transpose()) : rotations[at(row)];
}

LinkedTargets VolumeLink::transfer(const SourceState& state, Exactness exactness) const
{
    const Points moved = displacements(inputs(state), exactness);
    LinkedTargets result{state.mean.apply(targets_), Points(), {}};
    if (!options_.rotations)
    {
        result.positions += moved;
        return result;
    }
    const bool has_references = state.logs.rows() == source_.rows();
    Points references(targets_.rows(), 3);
    for (Eigen::Index i = 0; i < targets_.rows(); ++i)
        references.row(i) = has_references
                                ? Eigen::RowVector3d(state.logs.row(nearest_[at(i)]))
                                : Eigen::RowVector3d(state.mean.rotation_log.transpose());
    const Matrix3 rotation = state.mean.rotation(), axes = steps_.colwise().normalized();
    std::vector<Matrix3> maps(at(targets_.rows()), rotation);
    for (Eigen::Index i = 0; i < targets_.rows(); ++i)
    {
        result.positions.row(i) += moved.row(4 * i);
        maps[at(i)] += moved.middleRows<3>(4 * i + 1).transpose() * axes.transpose();
    }
    if (!moved.isZero(0.0))
        make_rotations(maps);
    NearLogs told = logs_near(maps, references);
    for (Eigen::Index i = 0; i < targets_.rows() && !has_references; ++i)
        if (maps[at(i)] == rotation)
            told.logs.row(i) = references.row(i);
    result.logs = std::move(told.logs);
    if (told.tilts.rows() != 0)
        result.rotations = std::move(maps);
    return result;
}

}  // namespace sheetmorph::volume
