// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/cad/writing/cad_writer.h"
#include "sheetmorph/base/errors.h"
#include "sheetmorph/cad/analytic_features.h"
#include "sheetmorph/cad/reading/cad_reader.h"
#include "sheetmorph/cad/reading/cad_shapes.h"
#include "cad/cad_files.h"

#include <BOPAlgo_ArgumentAnalyzer.hxx>
#include <TColStd_HSequenceOfExtendedString.hxx>
#include <TDF_LabelSequence.hxx>
#include <XCAFDoc_DocumentTool.hxx>
#include <XCAFDoc_LayerTool.hxx>
#include <cmath>
#include <filesystem>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <map>

namespace sheetmorph::cad::test
{

namespace
{

const CadMeshing coarse{4.0, 0.1, 0.35};

// The pin of the assembly, bent in its own coordinates, where it stands.
Points bent(const CadModel& model, std::size_t part, double share)
{
    const gp_Trsf place = model.source->bodies[part].shape.Location().Transformation();
    const Points rest = model.parts[part].mesh.points();
    Points found(rest.rows(), 3);
    for (Eigen::Index i = 0; i < rest.rows(); ++i)
    {
        gp_Pnt point(rest(i, 0), rest(i, 1), rest(i, 2));
        point.Transform(place.Inverted());
        point.SetX(point.X() + share * point.Z() * point.Z());
        point.Transform(place);
        found.row(i) << point.X(), point.Y(), point.Z();
    }
    return found;
}

// What FreeCAD's *Check Geometry* finds with its Boolean check on.
std::map<BOPAlgo_CheckStatus, int> boolean_faults(const TopoDS_Shape& shape)
{
    BOPAlgo_ArgumentAnalyzer analyzer;
    analyzer.SetShape1(shape);
    analyzer.ArgumentTypeMode() = true;
    analyzer.SelfInterMode() = true;
    analyzer.SmallEdgeMode() = true;
    analyzer.ContinuityMode() = true;
    analyzer.CurveOnSurfaceMode() = true;
    analyzer.Perform();
    std::map<BOPAlgo_CheckStatus, int> found;
    for (const BOPAlgo_CheckResult& one : analyzer.GetCheckResult())
        ++found[one.GetCheckStatus()];
    return found;
}

double lift(double x)
{
    return 0.0004 * x * x * (1.0 + 0.02 * x);
}

// The plate: lifted along its length, the holes with what is 4 mm around them as rigid bodies.
Points bent_plate(const Points& rest)
{
    Points found = rest;
    for (Eigen::Index i = 0; i < rest.rows(); ++i)
    {
        const double x = rest(i, 0), y = rest(i, 1), z = rest(i, 2);
        found(i, 2) += lift(x);
        for (const auto& [middle, radius] : {std::pair(15.0, 3.0), {40.0, 5.0}})
        {
            const double away = std::hypot(x - middle, y - 20.0) - radius - 4.0;
            const double share = away <= 0.0 ? 1.0 : std::pow(std::max(0.0, 1.0 - away / 6.0), 2);
            const double turn = std::atan(lift(middle + 0.5) - lift(middle - 0.5));
            const double there = middle + (x - middle) * std::cos(turn) - z * std::sin(turn);
            const double up = lift(middle) + (x - middle) * std::sin(turn) + z * std::cos(turn);
            found(i, 0) += share * (there - found(i, 0));
            found(i, 2) += share * (up - found(i, 2));
        }
    }
    return found;
}

// What became of the assembly with both pins bent.
std::shared_ptr<CadSource> written(const std::array<double, 2>& shares)
{
    const TemporaryFolder folder;
    write_assembly_step(folder.file("in.step"));
    const CadModel model = read_cad(folder.file("in.step"), coarse, Progress());
    std::vector<Points> positions{model.parts[0].mesh.points()};
    for (const std::size_t k : {std::size_t{1}, std::size_t{2}})
        positions.push_back(bent(model, k, shares[k - 1]));
    const auto measures = write_cad(model, positions, {folder.file("out.step")}, {});
    for (const CadMeasures& one : measures)
        EXPECT_TRUE(one.is_valid && one.is_closed) << one.name;
    return source_of_step(folder.file("out.step"));
}

std::vector<std::string> layers_of(const CadSource& source)
{
    const auto tool = XCAFDoc_DocumentTool::LayerTool(source.document.shapes()->BaseLabel());
    TDF_LabelSequence shapes;
    source.document.shapes()->GetShapes(shapes);
    std::vector<std::string> found;
    for (int i = 1; i <= shapes.Length(); ++i)
        if (const auto layers = tool->GetLayers(shapes.Value(i)); !layers.IsNull())
            for (int k = 1; k <= layers->Length(); ++k)
                found.emplace_back(TCollection_AsciiString(layers->Value(k)).ToCString());
    return found;
}

}  // namespace

TEST(CadWriter, InstancesThatAreDrivenAlikeStayInstances)
{
    const auto source = written({0.02, 0.02});
    ASSERT_EQ(source->bodies.size(), 3U);
    EXPECT_TRUE(source->bodies[1].shape.IsPartner(source->bodies[2].shape));
    EXPECT_FALSE(source->bodies[1].shape.Location().IsEqual(source->bodies[2].shape.Location()));
}

TEST(CadWriter, AnInstanceThatIsDrivenDifferentlyBecomesAProduct)
{
    for (const std::array<double, 2> shares : {std::array{0.02, 0.01}, {0.0, 0.02}})
    {
        const auto source = written(shares);
        ASSERT_EQ(source->bodies.size(), 3U);
        EXPECT_FALSE(source->bodies[1].shape.IsPartner(source->bodies[2].shape));
        EXPECT_EQ(source->bodies[0].name, "plate");
        EXPECT_EQ(source->bodies[1].name.substr(0, 3), "pin");
        EXPECT_EQ(source->bodies[2].name.substr(0, 3), "pin");
    }
}

TEST(CadWriter, NamesColoursAndLayersStayAndANamelessCompoundIsOneAgain)
{
    const TemporaryFolder folder;
    write_coloured_step(folder.file("in.step"));
    const CadModel model = read_cad(folder.file("in.step"), coarse, Progress());
    std::vector<Points> positions;
    for (std::size_t k = 0; k < model.parts.size(); ++k)
        positions.push_back(bent(model, k, 0.02));
    write_cad(model, positions, {folder.file("out.step")}, {});
    const auto before = source_of_step(folder.file("in.step"));
    const auto after = source_of_step(folder.file("out.step"));
    ASSERT_EQ(before->bodies.size(), 3U);
    ASSERT_EQ(after->bodies.size(), 3U);
    int blue = 0;
    for (std::size_t k = 0; k < 3; ++k)
    {
        EXPECT_EQ(after->bodies[k].name, before->bodies[k].name);
        EXPECT_EQ(after->bodies[k].product, before->bodies[k].product);
        ASSERT_EQ(after->bodies[k].faces.size(), before->bodies[k].faces.size());
        for (std::size_t f = 0; f < before->bodies[k].faces.size(); ++f)
        {
            EXPECT_EQ(after->bodies[k].faces[f].colour, before->bodies[k].faces[f].colour);
            blue += after->bodies[k].faces[f].colour == "#0000ff" ? 1 : 0;
        }
    }
    EXPECT_EQ(blue, 1);
    EXPECT_EQ(layers_of(*before), std::vector<std::string>{"sheets"});
    EXPECT_EQ(layers_of(*after), layers_of(*before));
}

TEST(CadWriter, FreeCADsBooleanCheckAcceptsBentParts)
{
    const TemporaryFolder folder;
    write_assembly_step(folder.file("in.step"));
    const CadModel model = read_cad(folder.file("in.step"), coarse, Progress());
    for (const NamedShape& body : model.source->bodies)
        ASSERT_THAT(boolean_faults(body.shape), testing::IsEmpty()) << body.name;
    write_cad(
        model,
        {bent_plate(model.parts[0].mesh.points()), bent(model, 1, 0.02), bent(model, 2, 0.01)},
        {folder.file("out.step")}, {});
    const auto source = source_of_step(folder.file("out.step"));
    ASSERT_EQ(source->bodies.size(), 3U);
    for (const NamedShape& body : source->bodies)
        EXPECT_THAT(boolean_faults(body.shape), testing::IsEmpty()) << body.name;
}

// Read again by a reader that knows nothing of the bending: the held holes are cylinders of the
// same radius where their rigid motions put them.
TEST(CadWriter, HeldHolesAreExactCylindersWhereTheyMoved)
{
    const TemporaryFolder folder;
    write_plate_step(folder.file("in.step"));
    const CadModel model = read_cad(folder.file("in.step"), coarse, Progress());
    const auto measures =
        write_cad(model, {bent_plate(model.parts[0].mesh.points())}, {folder.file("out.step")}, {});
    ASSERT_EQ(measures.size(), 1U);
    EXPECT_LT(measures[0].distance.value, 0.01);
    EXPECT_LT(measures[0].kink.value, 0.1);
    EXPECT_LT(measures[0].gap.value, 0.0005);
    EXPECT_THAT(measures[0].far_faces, testing::IsEmpty());
    const CadModel again = read_cad(folder.file("out.step"), coarse, Progress());
    std::map<double, CadFeature> holes;
    for (const CadFeature& feature : analytic_features(again.parts[0]))
        if (feature.kind == CadFeatureKind::round_hole)
            holes[std::round(feature.radius)] = feature;
    ASSERT_EQ(holes.size(), 2U);
    for (const auto& [middle, radius] : {std::pair(15.0, 3.0), {40.0, 5.0}})
    {
        const double turn = std::atan(lift(middle + 0.5) - lift(middle - 0.5));
        const Vector3 axis(-std::sin(turn), 0.0, std::cos(turn));
        const CadFeature& hole = holes.at(radius);
        EXPECT_NEAR(hole.radius, radius, 1e-9);
        EXPECT_LT(hole.residual, 1e-9);
        EXPECT_LT((hole.axis - axis).norm(), 1e-9);
        EXPECT_LT((hole.centre - Vector3(middle, 20.0, lift(middle)) - axis).norm(), 1e-8);
    }
}

TEST(CadWriter, IsCancelledInEveryStageAndSaysHowFarItIs)
{
    const TemporaryFolder folder;
    write_assembly_step(folder.file("in.step"));
    const CadModel model = read_cad(folder.file("in.step"), coarse, Progress());
    const std::vector<Points> positions{model.parts[0].mesh.points(), bent(model, 1, 0.02),
                                        bent(model, 2, 0.01)};
    for (const std::string stage : {"carrying", "writing", "reading", "measuring"})
    {
        double last = 0.0;
        const Progress progress(
            [&](double fraction, const std::string& task)
            {
                EXPECT_GE(fraction, last - 1e-12);
                last = fraction;
                return task.rfind(stage, 0) != 0;
            });
        EXPECT_THROW(write_cad(model, positions, {folder.file("out.step")}, progress), Cancelled)
            << stage;
    }
}

}  // namespace sheetmorph::cad::test
