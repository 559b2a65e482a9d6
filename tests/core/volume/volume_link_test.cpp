// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/volume/volume_link.h"

#include "sheetmorph/base/errors.h"
#include "sheetmorph/base/rotation.h"
#include "volume/link_scene.h"
#include "volume/textbook_weights.h"

#include <Eigen/Dense>
#include <cmath>
#include <gtest/gtest.h>

namespace sheetmorph::volume
{

using namespace mesh;

namespace
{

using scene::farthest;
using scene::linked;
using scene::LinkedSheets;
using scene::state_of;

constexpr double degree = 3.14159265358979323846 / 180.0;

// A strip of half-length 1 and another one 0.1 above it.
TriangleMesh strip(double height)
{
    return shapes::mapped(shapes::grid(20, 4, 2.0, 0.5), [height](const Vector3& p)
                          { return Vector3(p.x() - 1.0, p.y() - 0.25, height); });
}

// The strip's plane rolled up about the y axis, half-length 1 through `angle`.
Vector3 bent(const Vector3& p, double angle)
{
    const double radius = 1.0 / angle;
    return {(radius - p.z()) * std::sin(angle * p.x()), p.y(),
            radius - (radius - p.z()) * std::cos(angle * p.x())};
}

Points bent(const Points& points, double angle)
{
    Points result(points.rows(), 3);
    for (Eigen::Index i = 0; i < points.rows(); ++i)
        result.row(i) = bent(Vector3(points.row(i).transpose()), angle).transpose();
    return result;
}

LinkOptions with_offset(double offset)
{
    LinkOptions options;
    options.offset = offset;
    return options;
}

double bend_error(double offset)
{
    const LinkedSheets sheets = linked(strip(0.0), strip(0.1), with_offset(offset));
    const SourceState state = state_of(sheets, bent(sheets.source.points(), 1.0));
    return farthest(sheets.link.transfer(state).positions, bent(sheets.target.points(), 1.0));
}

TEST(VolumeLinkTest, ASourceAtRestLeavesTheTargetToTheBit)
{
    const LinkedSheets sheets = linked(strip(0.0), strip(0.1), with_offset(0.1));
    const SourceState state = state_of(sheets, sheets.source.points());
    const LinkedTargets found = sheets.link.transfer(state);
    EXPECT_TRUE(found.positions == sheets.target.points());
    EXPECT_TRUE(found.logs.isZero(0.0));
    EXPECT_TRUE(sheets.link.control_vertices(state) == sheets.control.vertices);
}

TEST(VolumeLinkTest, ARigidMotionOfTheSourceIsTheTargets)
{
    for (double offset : {0.0, 0.1})
    {
        const LinkedSheets sheets = linked(strip(0.0), strip(0.1), with_offset(offset));
        const Vector3 log = rotation_log(Vector3(1, 2, 3), 250.0 * degree);
        const RigidMotion motion{Vector3(5, -3, 2), log, Vector3(1, 1, 1)};
        const Points references = log.transpose().replicate(sheets.source.vertex_count(), 1);
        const SourceState state =
            state_of(sheets, motion.apply(sheets.source.points()), references);
        const LinkedTargets found = sheets.link.transfer(state);
        EXPECT_LT(farthest(found.positions, motion.apply(sheets.target.points())), 1e-12);
        EXPECT_LT((found.logs.rowwise() - log.transpose()).cwiseAbs().maxCoeff(), 1e-11);
    }
}

TEST(VolumeLinkTest, AnotherMotionOnTopOfABendMovesTheTargetRigidly)
{
    const LinkedSheets sheets = linked(strip(0.0), strip(0.1), with_offset(0.1));
    const Points deformed = bent(sheets.source.points(), 0.7);
    const LinkedTargets before = sheets.link.transfer(state_of(sheets, deformed));
    const RigidMotion motion{Vector3(5, -3, 2), Vector3(0.2, -0.4, 0.1), Vector3::Zero()};
    SourceState state = state_of(sheets, motion.apply(deformed));
    const LinkedTargets after = sheets.link.transfer(state);
    // The mean of logs depends on the frame to second order, so the fit's remainder differs a
    // little.
    EXPECT_LT(farthest(after.positions, motion.apply(before.positions)), 2e-2);
}

TEST(VolumeLinkTest, OffsetSamplesCarryABend)
{
    const double without = bend_error(0.0), with = bend_error(0.1);
    EXPECT_LT(with, 0.05);
    EXPECT_GT(without, 1.5 * with);
}

//! A link once more, by textbook weights and dense matrices.
class PlainLink
{
public:
    PlainLink(const LinkedSheets& sheets, double offset, double smoothness)
        : sheets_(sheets), offsets_(offset * scene::vertex_normals(sheets.source))
    {
        const Points& rest = sheets.source.points();
        samples_.resize(3 * rest.rows(), 3);
        samples_ << rest, rest + offsets_, rest - offsets_;
        const Eigen::MatrixXd weights = weights_at(samples_);
        const Eigen::MatrixXd laplacian(sheets.control.shape.laplacian());
        const double share = static_cast<double>(weights.rows()) / weights.cols();
        const Eigen::MatrixXd matrix =
            weights.transpose() * weights + smoothness * share * laplacian.transpose() * laplacian;
        fit_ = matrix.ldlt().solve(weights.transpose());
    }

    //! What the control vertices do beyond the mean motion.
    Eigen::MatrixXd displacements(const SourceState& state) const
    {
        const Eigen::Index count = state.positions.rows();
        Points moved = state.positions.replicate(3, 1);
        for (Eigen::Index i = 0; i < count; ++i)
        {
            const Vector3 turned =
                state.rotations[static_cast<std::size_t>(i)] * offsets_.row(i).transpose();
            moved.row(count + i) += turned.transpose();
            moved.row(2 * count + i) -= turned.transpose();
        }
        return fit_ * (moved - state.mean.apply(samples_));
    }

    Vector3 moved(const SourceState& state, const Eigen::MatrixXd& displacements,
                  const Vector3& point) const
    {
        return state.mean.apply(point) + displacements.transpose() * textbook_at(point);
    }

private:
    Eigen::VectorXd textbook_at(const Vector3& point) const
    {
        return textbook_weights(sheets_.control.vertices, sheets_.control.shape.triangles(), point);
    }

    Eigen::MatrixXd weights_at(const Points& points) const
    {
        Eigen::MatrixXd rows(points.rows(), sheets_.control.vertices.rows());
        for (Eigen::Index i = 0; i < points.rows(); ++i)
            rows.row(i) = textbook_at(points.row(i).transpose()).transpose();
        return rows;
    }

    const LinkedSheets& sheets_;
    Points offsets_, samples_;
    Eigen::MatrixXd fit_;
};

TEST(VolumeLinkTest, PlacesAndTurnsItsTargetsAsPlainMatricesDo)
{
    // Off the symmetry planes, where textbook weights have no value.
    const auto shifted = [](double height)
    {
        return shapes::mapped(strip(height),
                              [](const Vector3& p)
                              {
                                  return Vector3(p.x() + 0.013, 0.9 * p.y() + 0.0071 + 0.05 * p.x(),
                                                 p.z() + 0.031 * p.x() * p.x() + 0.0037);
                              });
    };
    LinkOptions options = with_offset(0.05);
    options.smoothness = 0.2;
    const LinkedSheets sheets = linked(shifted(0.0), shifted(0.1), options);
    const SourceState state = state_of(sheets, bent(sheets.source.points(), 0.8));
    const LinkedTargets found = sheets.link.transfer(state);
    const PlainLink plain(sheets, 0.05, 0.2);
    const Eigen::MatrixXd displacements = plain.displacements(state);
    for (Eigen::Index i = 0; i < found.positions.rows(); i += 3)
    {
        const Vector3 rest = sheets.target.points().row(i).transpose();
        const Vector3 expected = plain.moved(state, displacements, rest);
        EXPECT_LT((found.positions.row(i).transpose() - expected).norm(), 1e-9) << i;
        Matrix3 map;
        for (int a = 0; a < 3; ++a)
        {
            const Vector3 step = 1e-4 * Vector3::Unit(a);
            map.col(a) = (plain.moved(state, displacements, rest + step)
                          - plain.moved(state, displacements, rest - step))
                         / 2e-4;
        }
        EXPECT_LT((found.rotation(i) - nearest_rotation(map)).norm(), 1e-4) << i;
    }
}

TEST(VolumeLinkTest, TargetsTurnWithTheBend)
{
    const LinkedSheets sheets = linked(strip(0.0), strip(0.1), with_offset(0.1));
    const SourceState state = state_of(sheets, bent(sheets.source.points(), 0.4));
    const LinkedTargets found = sheets.link.transfer(state);
    for (int i = 0; i < sheets.target.vertex_count(); ++i)
    {
        const Vector3 expected(0.0, -0.5 * 0.4 * sheets.target.points()(i, 0), 0.0);
        EXPECT_LT((found.logs.row(i).transpose() - expected).norm(), 0.05) << i;
    }
}

TEST(VolumeLinkTest, MillimetresAndMetresGiveTheSameShape)
{
    const auto scaled = [](const TriangleMesh& mesh)
    { return TriangleMesh(1e3 * mesh.points(), mesh.triangles()); };
    const LinkedSheets metres = linked(strip(0.0), strip(0.1), with_offset(0.1));
    const LinkedSheets sheets = linked(scaled(strip(0.0)), scaled(strip(0.1)), with_offset(100.0));
    const Points deformed = bent(metres.source.points(), 0.8);
    const Points one = metres.link.transfer(state_of(metres, deformed)).positions;
    const Points other = sheets.link.transfer(state_of(sheets, 1e3 * deformed)).positions;
    EXPECT_LT(farthest(1e3 * one, other), 1e-8);
}

TEST(VolumeLinkTest, AMirroredModelGivesTheMirroredAnswer)
{
    const Matrix3 mirror = Vector3(1.0, -1.0, 1.0).asDiagonal();
    const auto mirrored = [&](const TriangleMesh& mesh)
    { return TriangleMesh(mesh.points() * mirror, mesh.triangles()); };
    const auto skewed = [](const Points& points)
    {
        Points result = bent(points, 0.8);
        result.col(1) += 0.3 * points.col(0).cwiseProduct(points.col(1));
        return result;
    };
    const LinkedSheets one = linked(strip(0.0), strip(0.1), with_offset(0.1));
    const LinkedSheets other =
        linked(mirrored(strip(0.0)), mirrored(strip(0.1)), with_offset(0.1), mirror);
    const Points deformed = skewed(one.source.points());
    const Points straight = one.link.transfer(state_of(one, deformed)).positions;
    const Points image = other.link.transfer(state_of(other, deformed * mirror)).positions;
    EXPECT_LT(farthest(straight * mirror, image), 1e-10);
}

TEST(VolumeLinkTest, ATurnedModelGivesTheTurnedAnswer)
{
    const Matrix3 turn = rotation_from_log(Vector3(0.2, 0.5, -0.3));
    const auto turned = [&](const TriangleMesh& mesh)
    { return TriangleMesh(mesh.points() * turn.transpose(), mesh.triangles()); };
    const LinkedSheets one = linked(strip(0.0), strip(0.1), with_offset(0.1));
    const LinkedSheets other =
        linked(turned(strip(0.0)), turned(strip(0.1)), with_offset(0.1), turn);
    const Points deformed = bent(one.source.points(), 0.8);
    const LinkedTargets straight = one.link.transfer(state_of(one, deformed));
    const LinkedTargets image = other.link.transfer(state_of(other, deformed * turn.transpose()));
    EXPECT_LT(farthest(straight.positions * turn.transpose(), image.positions), 1e-10);
    EXPECT_LT(farthest(straight.logs * turn.transpose(), image.logs), 1e-9);
}

TEST(VolumeLinkTest, AHandleTwistedThroughFourHundredDegreesMovesTheTargetSmoothly)
{
    const LinkedSheets sheets = linked(strip(0.0), strip(0.1), with_offset(0.1));
    const Points rest = sheets.source.points();
    Points last = sheets.target.points();
    double largest = 0.0;
    for (int step = 1; step <= 400; ++step)
    {
        Points deformed(rest.rows(), 3), references = Points::Zero(rest.rows(), 3);
        for (Eigen::Index i = 0; i < rest.rows(); ++i)
        {
            const double share = 0.5 * (rest(i, 0) + 1.0);
            references(i, 0) = 0.5 * share * step * degree;
            const Vector3 about(rest(i, 0), 0.0, 0.0), point = rest.row(i).transpose();
            deformed.row(i) =
                (about + rotation_from_log(references.row(i)) * (point - about)).transpose();
        }
        const Points now = sheets.link.transfer(state_of(sheets, deformed, references)).positions;
        largest = std::max(largest, farthest(now, last));
        last = now;
    }
    EXPECT_LT(largest, 0.02);
}

// A sheet of columns x rows squares above the source.
TriangleMesh wide_sheet(int columns, int rows)
{
    return shapes::mapped(shapes::grid(columns, rows, 1.8, 0.4),
                          [](const Vector3& p) { return Vector3(p.x() - 0.9, p.y() - 0.2, 0.1); });
}

TriangleMesh fine_strip()
{
    return shapes::mapped(shapes::grid(40, 20, 2.0, 0.5),
                          [](const Vector3& p) { return Vector3(p.x() - 1.0, p.y() - 0.25, 0.0); });
}

// Compare every hundredth target with a link to those targets alone.
void expect_as_few(const TriangleMesh& source, const TriangleMesh& target)
{
    const LinkedSheets sheets = linked(source, target, with_offset(0.05));
    VertexIds some;
    for (int vertex = 0; vertex < target.vertex_count(); vertex += 100)
        some.push_back(vertex);
    const LinkSource of{source.points(), scene::vertex_normals(source), {}};
    const Points few = target.points()(some, Eigen::indexing::all);
    const VolumeLink link(sheets.control, of, few, with_offset(0.05));
    const SourceState state = state_of(sheets, bent(source.points(), 0.8));
    const LinkedTargets all = sheets.link.transfer(state), found = link.transfer(state);
    EXPECT_GT(farthest(found.positions, few), 0.1);
    EXPECT_LT(farthest(all.positions(some, Eigen::indexing::all), found.positions), 1e-11);
    EXPECT_LT(farthest(all.logs(some, Eigen::indexing::all), found.logs), 1e-9);
    const LinkedTargets live = sheets.link.transfer(state, Exactness::live);
    EXPECT_LT(farthest(live.positions, all.positions), 2e-6);
    // No link keeps its fit; each computes it once for the picture.
    for (int time = 0; time < 2; ++time)
        EXPECT_TRUE(link.control_vertices(state) == sheets.link.control_vertices(state));
    EXPECT_GT(farthest(link.control_vertices(state), sheets.control.vertices), 0.1);
}

TEST(VolumeLinkTest, ManyTargetsAndFewOnesGiveTheSame)
{
    expect_as_few(fine_strip(), wide_sheet(40, 60));
}

TEST(VolumeLinkTest, ThousandsOfTargetsAndFewOnesGiveTheSame)
{
    expect_as_few(fine_strip(), wide_sheet(100, 60));  // on the control vertices
    expect_as_few(strip(0.0), wide_sheet(100, 60));    // on the inputs
}

TEST(VolumeLinkTest, WeightsThatAreNotKeptMoveTheTargetsTheSameWay)
{
    for (const bool rotations : {true, false})
    {
        LinkOptions options = with_offset(0.05);
        options.rotations = rotations;
        const TriangleMesh target =
            shapes::mapped(shapes::grid(30, 10, 1.8, 0.4),
                           [](const Vector3& p) { return Vector3(p.x() - 0.9, p.y() - 0.2, 0.1); });
        const LinkedSheets kept = linked(strip(0.0), target, options);
        options.most_kept = 1000.0;
        const LinkedSheets anew = linked(strip(0.0), target, options);
        const Points deformed = bent(kept.source.points(), 0.8);
        const LinkedTargets a = kept.link.transfer(state_of(kept, deformed));
        const LinkedTargets b = anew.link.transfer(state_of(anew, deformed));
        EXPECT_GT(farthest(a.positions, target.points()), 0.1);
        EXPECT_LT(farthest(a.positions, b.positions), 1e-12);
        ASSERT_EQ(a.logs.rows(), rotations ? target.vertex_count() : 0);
        for (Eigen::Index k = 0; k < a.logs.rows(); ++k)
            EXPECT_LT((a.rotation(k) - b.rotation(k)).norm(), 1e-9);
        const SourceState rest = state_of(anew, anew.source.points());
        EXPECT_EQ(farthest(anew.link.transfer(rest).positions, target.points()), 0.0);
    }
}

TEST(VolumeLinkTest, OneSourcePointCarriesItsTargetsRigidly)
{
    Points point(1, 3), targets(2, 3), logs(1, 3);
    point << 1, 2, 3;
    targets << 1, 2, 4, 2, 2, 3;
    logs << 0.3, 0.2, 0.1;
    const ControlMesh control(ControlShape(),
                              oriented_box(point, Matrix3::Identity(), {0.1, 0.25, 2.0}));
    const VolumeLink link(control, {point, Points(), {}}, targets);
    const Points moved = point.rowwise() + Eigen::RowVector3d(5, 5, 5);
    const RigidMotion mean =
        mean_motion(point, moved, {{rotation_from_log(logs.row(0).transpose())}, logs});
    const LinkedTargets found = link.transfer({moved, {}, mean, Points()});
    EXPECT_LT(farthest(found.positions, mean.apply(targets)), 1e-12);
    EXPECT_LT((found.logs.rowwise() - logs.row(0)).cwiseAbs().maxCoeff(), 1e-12);
}

TEST(VolumeLinkTest, ArraysThatDisagreeAreRefused)
{
    const LinkedSheets sheets = linked(strip(0.0), strip(0.1), with_offset(0.1));
    EXPECT_THROW(sheets.link.transfer({Points::Zero(3, 3), {}, RigidMotion(), Points()}),
                 InvalidInput);
    const LinkSource no_normals{sheets.source.points(), Points(), {}};
    EXPECT_THROW(VolumeLink(sheets.control, no_normals, sheets.target.points(), with_offset(0.1)),
                 InvalidInput);
    EXPECT_THROW(VolumeLink(sheets.control, LinkSource{Points(0, 3), Points(0, 3), {}},
                            sheets.target.points()),
                 InvalidInput);
}

}  // namespace

}  // namespace sheetmorph::volume
