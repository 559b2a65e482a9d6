// SPDX-License-Identifier: LGPL-2.1-or-later
// Flanges of one sheet that face each other at less than its thickness: each follows its own side.
#include "sheetmorph/assembly/session/deformation_session.h"
#include "sheetmorph/mesh/topology/edges.h"
#include "sheetmorph/recognise/thin/thickness_gauge.h"
#include "assembly/frames.h"
#include "shapes/folded.h"

#include <gtest/gtest.h>
#include <random>

namespace sheetmorph::assembly
{
namespace
{

// The legs of every profile: what is pulled, what is held, what must stay where it is.
enum Leg
{
    pulled,
    held,
    other
};

struct Random
{
    std::mt19937 engine;

    double between(double low, double high)
    {
        return std::uniform_real_distribution<double>(low, high)(engine);
    }
};

struct Profile
{
    const char* name;
    shapes::FoldedSheet (*make)(Random& random, double thickness, double gap);
};

double edge_for(Random& random, double thickness)
{
    return thickness * random.between(1.0, 4.0);
}

// Two flanges over a narrow base, face to face; a hem where the base is no wider than its bends.
shapes::FoldedSheet channel(Random& random, double t, double gap)
{
    const double inner = gap * random.between(0.1, 0.5), length = t * random.between(20.0, 40.0);
    shapes::Folding folding(t, edge_for(random, t));
    folding.straight(length, pulled).bend(90.0, inner, held);
    if (gap - 2.0 * inner > 0.05 * gap)
        folding.straight(gap - 2.0 * inner, held);
    folding.bend(90.0, inner, held).straight(3.0 * t, held);
    return folding.straight(length * random.between(0.5, 1.0), other).extruded(20.0 * t);
}

// Three layers: the second is held.
shapes::FoldedSheet z_fold(Random& random, double t, double gap)
{
    const double length = t * random.between(20.0, 40.0);
    shapes::Folding folding(t, edge_for(random, t));
    folding.straight(length, pulled).bend(180.0, 0.5 * gap, held).straight(length, held);
    folding.bend(-180.0, 0.5 * gap, held).straight(3.0 * t, held);
    return folding.straight(length * random.between(0.5, 0.9), other).extruded(20.0 * t);
}

// A box profile whose ends overlap: the outer skin of the inner end faces the inner skin of the
// outer one. They are connected the long way round only.
shapes::FoldedSheet lapped_box(Random& random, double t, double gap)
{
    const double inner = t * random.between(0.5, 2.0), height = t * random.between(10.0, 20.0);
    const double width = t * random.between(20.0, 30.0);
    shapes::Folding folding(t, edge_for(random, t));
    folding.straight(width, other).bend(90.0, inner, held).straight(height, held);
    folding.bend(90.0, inner, held).straight(width + 3.0 * t, held).bend(90.0, inner, held);
    folding.straight(height + gap + t, held).bend(90.0, inner, held).straight(3.0 * t, held);
    return folding.straight(width * random.between(0.5, 0.9), pulled).extruded(20.0 * t);
}

// A C whose lip ends right above the other flange: a wall of the sheet faces a skin.
shapes::FoldedSheet lip_on_a_face(Random& random, double t, double gap)
{
    const double inner = t * random.between(0.5, 2.0), height = t * random.between(12.0, 20.0);
    const double width = t * random.between(10.0, 20.0), radius = inner + 0.5 * t;
    shapes::Folding folding(t, edge_for(random, t));
    folding.straight(width + t * random.between(12.0, 20.0), pulled).straight(3.0 * t, held);
    folding.bend(90.0, inner, held).straight(height, held).bend(90.0, inner, held);
    folding.straight(width, held).bend(90.0, inner, held);
    return folding.straight(height + radius - 0.5 * t - gap, other).extruded(20.0 * t);
}

const Profile profiles[] = {{"Channel", channel},
                            {"ZFold", z_fold},
                            {"LappedBox", lapped_box},
                            {"LipOnAFace", lip_on_a_face}};

double largest_strain(const mesh::TriangleMesh& mesh, const Points& positions, double shortest)
{
    double worst = 0.0;
    for (int t = 0; t < mesh.triangle_count(); ++t)
        for (int k = 0; k < 3; ++k)
        {
            const int a = mesh.triangles()(t, k), b = mesh.triangles()(t, (k + 1) % 3);
            const double before = (mesh.points().row(a) - mesh.points().row(b)).norm();
            const double after = (positions.row(a) - positions.row(b)).norm();
            if (before > shortest)
                worst = std::max(worst, std::abs(after / before - 1.0));
        }
    return worst;
}

// Vertices of a leg; of the pulled one what is within `reach` of its free end.
VertexIds on_leg(const shapes::FoldedSheet& sheet, Leg leg, double reach = 1e9)
{
    const double last = *std::max_element(sheet.along.begin(), sheet.along.end());
    VertexIds found;
    for (std::size_t v = 0; v < sheet.leg.size(); ++v)
        if (sheet.leg[v] == leg && std::min(sheet.along[v], last - sheet.along[v]) <= reach)
            found.push_back(static_cast<int>(v));
    return found;
}

// Of a profile with the free end of the pulled leg as handle and the held leg fixed.
Assembly assembly_of(const shapes::FoldedSheet& sheet)
{
    Assembly assembly;
    Part part;
    part.name = "profile";
    part.mesh = sheet.mesh;
    part.thin = Thin::yes;
    assembly.parts = {part};
    assembly.fixed = {{"held", 0, on_leg(sheet, held)}};
    assembly.handles = {{"end", 0, on_leg(sheet, pulled, 2.0 * sheet.thickness)}};
    return assembly;
}

// Rigidly turned and mirrored, so that either skin is the main one.
shapes::FoldedSheet placed(shapes::FoldedSheet sheet, Random& random)
{
    const Vector3 axis(random.between(-1, 1), random.between(-1, 1), random.between(-1, 1));
    const Vector3 shift(random.between(-300, 300), random.between(-300, 300), 0.0);
    const RigidMotion motion =
        frames::motion(shift, axis.normalized(), random.between(0, 360), Vector3::Zero());
    const bool is_mirrored = random.between(0.0, 1.0) < 0.5;
    Triangles triangles = sheet.mesh.triangles();
    if (is_mirrored)
        triangles.col(1).swap(triangles.col(2));
    const mesh::TriangleMesh mesh =
        shapes::mapped(sheet.mesh, [&](const Vector3& p)
                       { return motion.apply(is_mirrored ? Vector3(p.x(), -p.y(), p.z()) : p); });
    sheet.mesh = mesh::TriangleMesh(mesh.points(), triangles);
    return sheet;
}

class FacingFlanges : public testing::TestWithParam<Profile>
{
};

TEST_P(FacingFlanges, OneIsPulledTheOtherStaysAndNothingIsStrained)
{
    for (unsigned seed = 0; seed < 8; ++seed)
    {
        Random random{std::mt19937(seed)};
        const double t = random.between(0.5, 3.0);
        const double gap = t * std::exp(random.between(std::log(0.01), std::log(2.0)));
        const shapes::FoldedSheet sheet = placed(GetParam().make(random, t, gap), random);
        SCOPED_TRACE("seed " + std::to_string(seed) + ", thickness " + std::to_string(t) + ", gap "
                     + std::to_string(gap));
        const Assembly assembly = assembly_of(sheet);
        const DeformationSession session(assembly);
        EXPECT_NEAR(session.thin_solid(0)->thickness, t, 1e-6 * t);
        EXPECT_TRUE(session.thin_solid(0)->lumps.empty());
        const Vector3 way(random.between(-1, 1), random.between(-1, 1), random.between(-1, 1));
        Pose pose;
        pose.handles["end"] = frames::motion(t * way.normalized(), {0, 1, 0}, 0.0, Vector3::Zero());
        const Points positions = session.deform(pose).parts[0].positions;
        const VertexIds stay = on_leg(sheet, other);
        const Points moved =
            positions(stay, Eigen::indexing::all) - sheet.mesh.points()(stay, Eigen::indexing::all);
        EXPECT_LT(moved.rowwise().norm().maxCoeff(), 1e-9);
        const recognise::ThicknessChange change =
            recognise::thickness_change(sheet.mesh, *session.thin_solid(0), positions);
        EXPECT_NEAR(change.rest_least, t, 0.02 * t);
        EXPECT_LT(change.rest_most, 1.1 * t);
        EXPECT_LT(change.worst, 0.03);
        EXPECT_LT(change.worst_at_walls, 0.05);
        EXPECT_LT(largest_strain(sheet.mesh, positions, 0.1 * t), 0.15);
    }
}

void PrintTo(const Profile& profile, std::ostream* out)
{
    *out << profile.name;
}

INSTANTIATE_TEST_SUITE_P(Profiles, FacingFlanges, testing::ValuesIn(profiles),
                         [](const auto& each) { return std::string(each.param.name); });

}  // namespace
}  // namespace sheetmorph::assembly
