// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/repair/remeshing/remeshing.h"

#include "sheetmorph/base/errors.h"
#include "sheetmorph/mesh/quality/diagnosis.h"
#include "sheetmorph/mesh/quality/quality.h"
#include "sheetmorph/mesh/regions/round_holes.h"
#include "sheetmorph/mesh/topology/boundary.h"
#include "sheetmorph/repair/remeshing/working_mesh.h"
#include "sheetmorph/repair/self_intersections.h"
#include "shapes.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <gtest/gtest.h>
#include <numeric>
#include <random>

namespace sheetmorph::repair
{

using namespace mesh;
namespace
{

RemeshOptions edges_of(double length)
{
    RemeshOptions options;
    options.edge = length;
    return options;
}

TEST(Remeshing, OfFlatsIsExactAndWellShaped)
{
    const TriangleMesh box = shapes::box(1, Vector3(60, 40, 3));
    const RemeshedMesh found = remeshed(box, edges_of(3.0));
    EXPECT_LT(found.deviation, 1e-12);
    EXPECT_EQ(found.flats, 6);
    EXPECT_GT(quality(found.mesh).worst_angle_degrees, 20.0);
    const Diagnosis diagnosis = diagnose(found.mesh, 1e-6);
    EXPECT_EQ(diagnosis.open_edges, 0);
    EXPECT_EQ(diagnosis.flipped_triangles, 0);
    EXPECT_NEAR(diagnosis.pieces[0].volume, 60.0 * 40.0 * 3.0, 1e-6);
    EXPECT_NEAR(diagnosis.edges.median, 3.0, 1.0);
}

TEST(Remeshing, KeepsTheVerticesOfRidgesAndTellsWhereTheNewOnesLie)
{
    const TriangleMesh box = shapes::box(1, Vector3(60, 40, 3));
    const RemeshedMesh found = remeshed(box, edges_of(5.0));
    for (int i = 0; i < box.vertex_count(); ++i)
    {
        ASSERT_EQ(found.is_kept[i], 1);
        EXPECT_EQ(found.mesh.points().row(found.vertex_of[i]), box.points().row(i));
    }
    for (int i = 0; i < found.mesh.vertex_count(); ++i)
    {
        Vector3 place = Vector3::Zero();
        for (int k = 0; k < 3; ++k)
            place += found.barycentric(i, k)
                     * box.points().row(box.triangles()(found.triangle[i], k)).transpose();
        EXPECT_LT((place - found.mesh.points().row(i).transpose()).norm(), 1e-9);
    }
}

TEST(Remeshing, KeepsRimsOrPutsThemOnTheirCircles)
{
    shapes::PlateSpec spec;
    spec.rim = 16;
    const TriangleMesh plate = shapes::plate_with_holes(spec).mesh;
    RemeshOptions options = edges_of(4.0);
    const auto polygon = round_holes(remeshed(plate, options).mesh, 0.05);
    options.are_rims_on_circles = true;
    const RemeshedMesh found = remeshed(plate, options);
    const auto circles = round_holes(found.mesh, 0.05);
    ASSERT_EQ(polygon.size(), 3U);
    ASSERT_EQ(circles.size(), 3U);
    EXPECT_EQ(found.circles, 3);
    EXPECT_NEAR(circles[0].circle.radius, spec.radius, 1e-9);
    EXPECT_LT(circles[0].circle.residual, 1e-9);
    EXPECT_GT(circles[0].rim.size(), 16U);
    const double sagitta = spec.radius * (1.0 - std::cos(shapes::pi / 16.0));
    EXPECT_LE(polygon[0].circle.residual, sagitta);
    EXPECT_NEAR(found.deviation, 0.0, 1.1 * sagitta);  // told, not hidden
}

TEST(Remeshing, FollowsCurvedFacetsWithItsVerticesOnThem)
{
    const TriangleMesh pipe = shapes::half_pipe(40, 1, 20.0, 100.0);
    const RemeshedMesh found = remeshed(pipe, edges_of(4.0));
    EXPECT_GT(quality(found.mesh).worst_angle_degrees, 8.0);
    EXPECT_LT(found.deviation, 4.0 * 4.0 / (8.0 * 20.0) * 2.0);  // twice an edge's own sagitta
    const double area = diagnose(pipe, 1e-6).pieces[0].area;
    EXPECT_NEAR(diagnose(found.mesh, 1e-6).pieces[0].area, area, 0.002 * area);
}

// A bend much tighter than the edges wanted: facets as long as its radius would cut it off.
TEST(Remeshing, EdgesOnABendFollowItsRadius)
{
    const double radius = 10.0;
    const TriangleMesh pipe = shapes::half_pipe(60, 1, radius, 100.0);
    const RemeshedMesh found = remeshed(pipe, edges_of(20.0));
    const double longest = 0.35 * radius * 4.0 / 3.0;
    EXPECT_LT(found.deviation, 2.0 * longest * longest / (8.0 * radius));
}

TEST(Remeshing, KeepsSheetsTogetherThatMeetInAnEdge)
{
    Points points(8, 3);
    points << 0, 0, 0, 0, 30, 0, 20, 0, 0, 20, 30, 0, -20, 0, 0, -20, 30, 0, 0, 0, 20, 0, 30, 20;
    Triangles triangles(6, 3);
    triangles << 0, 2, 3, 0, 3, 1, 0, 1, 5, 0, 5, 4, 0, 1, 7, 0, 7, 6;
    const RemeshedMesh found = remeshed(TriangleMesh(points, triangles), edges_of(4.0));
    const Diagnosis diagnosis = diagnose(found.mesh, 1e-9);
    EXPECT_EQ(diagnosis.pieces.size(), 1U);
    EXPECT_EQ(diagnosis.duplicate_vertices, 0);
    EXPECT_GE(diagnosis.non_manifold_edges, 6);
    EXPECT_LT(found.deviation, 1e-12);
}

TEST(Remeshing, AVertexThatIsGoneIsFollowedOnItsOwnSheetHoweverNearAnotherIs)
{
    const TriangleMesh sheet = shapes::grid(50, 30, 50.0, 30.0);
    const int count = sheet.vertex_count();
    Points points(2 * count, 3);
    points << sheet.points(), sheet.points().rowwise() + Eigen::RowVector3d(0.7, 0.7, 0.01);
    Triangles triangles(2 * sheet.triangle_count(), 3);
    triangles << sheet.triangles(), sheet.triangles().array() + count;
    const RemeshedMesh found = remeshed(TriangleMesh(points, triangles), edges_of(8.0));
    for (int i = 0; i < 2 * count; ++i)
        EXPECT_NEAR(found.mesh.points()(found.vertex_of[i], 2), points(i, 2), 1e-9);
}

// How many vertices at one height have none above or below them at another.
int without_twin(const TriangleMesh& mesh, double height, double other)
{
    int count = 0;
    for (int i = 0; i < mesh.vertex_count(); ++i)
    {
        if (std::abs(mesh.points()(i, 2) - height) > 1e-9)
            continue;
        const Vector3 place = Vector3(mesh.points()(i, 0), mesh.points()(i, 1), other);
        count += (mesh.points().rowwise() - place.transpose()).rowwise().norm().minCoeff() > 1e-9;
    }
    return count;
}

TEST(Remeshing, MeshesTheSkinsOfAPlateAlike)
{
    const RemeshedMesh found = remeshed(shapes::box(1, Vector3(60, 40, 3)), edges_of(3.0));
    EXPECT_EQ(without_twin(found.mesh, 0.0, 3.0), 0);
    EXPECT_EQ(without_twin(found.mesh, 3.0, 0.0), 0);
    EXPECT_TRUE(self_intersections(found.mesh).empty());
}

TEST(Remeshing, MeshesTheSkinsOfTwoPlatesAlikeInWhateverOrderTheirFacetsCome)
{
    const TriangleMesh other =
        shapes::mapped(shapes::box(1, Vector3(50, 30, 4)),
                       [](const Vector3& p) { return Vector3(p + Vector3(100.0, 0.0, 10.0)); });
    const TriangleMesh both = shapes::welded({shapes::box(1, Vector3(60, 40, 3)), other});
    std::vector<int> order(static_cast<std::size_t>(both.triangle_count()));
    std::iota(order.begin(), order.end(), 0);
    for (unsigned seed = 1; seed <= 4; ++seed)
    {
        std::shuffle(order.begin(), order.end(), std::mt19937(seed));
        const TriangleMesh shuffled(both.points(), both.triangles()(order, Eigen::indexing::all));
        const RemeshedMesh found = remeshed(shuffled, edges_of(5.0));
        for (const auto& [low, high] : {std::pair(0.0, 3.0), {10.0, 14.0}})
        {
            EXPECT_EQ(without_twin(found.mesh, low, high), 0) << seed;
            EXPECT_EQ(without_twin(found.mesh, high, low), 0) << seed;
        }
    }
}

TEST(Remeshing, MeshesSkinsAlikeThoughARimHasAVertexMoreOnOneSide)
{
    // Vertices 0 to 7 of a box, and one more in the middle of an edge of its upper face.
    Points points(9, 3);
    points << 0, 0, 0, 60, 0, 0, 60, 40, 0, 0, 40, 0, 0, 0, 3, 60, 0, 3, 60, 40, 3, 0, 40, 3,  //
        31, 0.4, 3;
    Triangles triangles(14, 3);
    triangles << 0, 2, 1, 0, 3, 2, 4, 8, 7, 8, 6, 7, 8, 5, 6, 0, 1, 8, 0, 8, 4, 1, 5, 8,  //
        1, 2, 6, 1, 6, 5, 2, 3, 7, 2, 7, 6, 3, 0, 4, 3, 4, 7;
    const RemeshedMesh found = remeshed(TriangleMesh(points, triangles), edges_of(3.0));
    EXPECT_LT(found.deviation, 1e-9);
    EXPECT_EQ(diagnose(found.mesh, 1e-6).open_edges, 0);
    EXPECT_LT(without_twin(found.mesh, 3.0, 0.0), 25);  // along the edge that differs alone
    EXPECT_GT(std::count_if(found.is_kept.begin(), found.is_kept.end(), [](char c) { return c; }),
              8);
}

TEST(Remeshing, TellsWhenEdgesAreLeft)
{
    const TriangleMesh plate = shapes::grid(2, 2, 40.0, 40.0);
    EXPECT_TRUE(remeshed(plate, {2.0}).convergence.is_converged);
    const std::vector<int> patch(8, 0);
    const std::vector<char> is_flat{1};
    const auto work_with = [&](double size) {
        return WorkingMesh({plate, {}, patch, std::vector<double>(9, size), is_flat, size});
    };
    // Beside the border, whose edges of 20 mm stay, no cut makes sides of 2 mm.
    WorkingMesh fine = work_with(2.0);
    const Convergence cut = split_long_edges(fine, 5);
    EXPECT_FALSE(cut.is_converged);
    EXPECT_GT(cut.miss, 0.0);
    EXPECT_EQ(cut.sentence().find("the edges of the new mesh did not converge in 5 iterations"),
              0U);
    EXPECT_FALSE(flip_to_delaunay(fine, 0).is_converged);
    EXPECT_FALSE(collapse_short_edges(fine, 0).is_converged);
    WorkingMesh coarse = work_with(25.0);
    EXPECT_TRUE(split_long_edges(coarse).is_converged);
    EXPECT_TRUE(flip_to_delaunay(coarse).is_converged);
    EXPECT_TRUE(collapse_short_edges(coarse).is_converged);
}

TEST(Remeshing, MakesManyGoodTrianglesOfTwo)
{
    const auto expect_good = [](double length, double width, double edge)
    {
        const RemeshedMesh found = remeshed(shapes::grid(1, 1, length, width), edges_of(edge));
        const double area = length * width, needed = area / 0.433 / edge / edge;
        EXPECT_TRUE(found.convergence.is_converged);
        EXPECT_GT(quality(found.mesh).worst_angle_degrees, 25.0);
        EXPECT_NEAR(diagnose(found.mesh, 1e-9).pieces[0].area, area, 1e-9 * area);
        EXPECT_NEAR(found.mesh.triangle_count(), needed, 0.1 * needed);
    };
    expect_good(16.0, 16.0, 0.1);
    expect_good(300.0, 10.0, 0.5);
}

// Each edge looks at all the neighbours of its ends: with many the work would grow as its square.
TEST(Remeshing, NoVertexHasMoreNeighboursTheFinerTheEdgesAreSplit)
{
    for (const int count : {50, 100, 200})
    {
        Points points(count, 3);
        Triangles fan(count - 2, 3);
        for (int k = 0; k < count; ++k)
            points.row(k) << 2.0 * std::cos(2.0 * shapes::pi * k / count),
                std::sin(2.0 * shapes::pi * k / count), 0.0;
        for (int k = 0; k < count - 2; ++k)
            fan.row(k) << 0, k + 1, k + 2;
        const double edge = 2.0 * shapes::pi / count;
        const std::vector<int> patch(static_cast<std::size_t>(count - 2), 0);
        const std::vector<double> sizes(static_cast<std::size_t>(count), edge);
        const std::vector<char> is_flat{1};
        const TriangleMesh disc(points, fan);
        WorkingMesh work({disc, {}, patch, sizes, is_flat, edge});
        EXPECT_TRUE(flip_to_delaunay(work).is_converged);
        EXPECT_TRUE(split_long_edges(work).is_converged);
        std::size_t most = 0;
        for (int v = 0; v < work.vertex_count(); ++v)
            most = std::max(most, work.around(v).size());
        EXPECT_LE(most, 12U);
    }
}

TEST(Remeshing, RefusesEdgesThatMakeNoSense)
{
    const TriangleMesh box = shapes::box(1, Vector3(60, 40, 3));
    EXPECT_THROW(remeshed(box, edges_of(0.0)), InvalidInput);
    EXPECT_THROW(remeshed(box, edges_of(1e-4)), InvalidInput);
}

// Triangles between two rows of vertices, one after the other: `first` of them below, the others
// above.
std::vector<std::array<int, 3>> between_rows(const Points& points, int first)
{
    const auto count = static_cast<int>(points.rows());
    std::vector<std::array<int, 3>> made;
    int a = 0, b = first;
    const int last_a = b - 1, last_b = count - 1;
    while (a < last_a || b < last_b)
    {
        const bool is_a = b == last_b || (a < last_a && points(a + 1, 0) < points(b + 1, 0));
        made.push_back({a, is_a ? a + 1 : b + 1, b});
        (is_a ? a : b) += 1;
    }
    return made;
}

// A strip some 10,000 times as long as wide, its two sides cut at places of their own: many of its
// triangles have no height, some stand twice, and some of its sides have three.
TriangleMesh degenerate_strip(std::mt19937& random)
{
    const auto share = [&] { return std::uniform_real_distribution<double>(0.0, 1.0)(random); };
    const double length = 10.0, width = std::pow(10.0, -6.0 + 4.0 * share());
    std::vector<double> below{0.0, length}, above{0.0, length};
    for (std::vector<double>* side : {&below, &above})
    {
        for (int k = static_cast<int>(12 * share()); k > 0; --k)
            side->push_back(length * share());
        std::sort(side->begin(), side->end());
    }
    const auto count = static_cast<int>(below.size() + above.size());
    Points points(count, 3);
    for (int v = 0; v < count; ++v)
    {
        const bool is_below = v < static_cast<int>(below.size());
        points.row(v) << (is_below ? below[static_cast<std::size_t>(v)]
                                   : above[static_cast<std::size_t>(v) - below.size()]),
            is_below ? 0.0 : width, 0.01 * width * share();
    }
    std::vector<std::array<int, 3>> made = between_rows(points, static_cast<int>(below.size()));
    const auto pick = [&] { return static_cast<int>(random() % static_cast<unsigned>(count)); };
    for (std::size_t k = made.size(); k > 0; --k)
        if (share() < 0.2)
            made.push_back({made[k - 1][1], made[k - 1][0], made[k - 1][2]});
        else if (std::array<int, 3> one{made[k - 1][0], made[k - 1][1], pick()};
                 share() < 0.1 && one[2] != one[0] && one[2] != one[1])
            made.push_back(one);
    Triangles triangles(static_cast<Eigen::Index>(made.size()), 3);
    for (std::size_t t = 0; t < made.size(); ++t)
        triangles.row(static_cast<Eigen::Index>(t)) << made[t][0], made[t][1], made[t][2];
    return TriangleMesh(points, triangles);
}

TEST(Remeshing, OfDegenerateStripsStaysAmongItsVertices)
{
    std::mt19937 random(27);
    int refused = 0;
    constexpr int rounds = 60;
    for (int round = 0; round < rounds; ++round)
    {
        const TriangleMesh strip = degenerate_strip(random);
        std::vector<double> sizes(static_cast<std::size_t>(strip.vertex_count()), 0.2);
        const std::vector<int> patch(static_cast<std::size_t>(strip.triangle_count()), 0);
        WorkingMesh work({strip, {}, patch, sizes, {1}, 0.2, 800});
        for (int step = 0; step < 3; ++step)
        {
            split_long_edges(work, 5);
            ASSERT_EQ(work.fault(), "") << "split, round " << round;
            collapse_short_edges(work, 3);
            ASSERT_EQ(work.fault(), "") << "collapsed, round " << round;
            flip_to_delaunay(work, 4);
            ASSERT_EQ(work.fault(), "") << "flipped, round " << round;
            smooth(work);
        }
        for (const Vector3& point : work.point)
            ASSERT_TRUE(point.allFinite());
        if (round % 30 > 0)
            continue;  // each makes tens of thousands of triangles
        try
        {
            const RemeshedMesh found = remeshed(strip, edges_of(0.2));
            ASSERT_TRUE(found.mesh.points().allFinite());
            ASSERT_GE(found.mesh.triangles().minCoeff(), 0);
            ASSERT_LT(found.mesh.triangles().maxCoeff(), found.mesh.vertex_count());
        }
        catch (const InvalidInput&)
        {
            ++refused;
        }
    }
    EXPECT_LT(refused, 2);
}

}  // namespace
}  // namespace sheetmorph::repair
