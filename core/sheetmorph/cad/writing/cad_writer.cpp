// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/cad/writing/cad_writer.h"
#include "sheetmorph/base/errors.h"
#include "sheetmorph/cad/cad_guard.h"
#include "sheetmorph/cad/writing/body_measurer.h"
#include "sheetmorph/cad/writing/document_copy.h"
#include "sheetmorph/cad/writing/written_file.h"

#include <BRepTools.hxx>
#include <TopExp.hxx>
#include <algorithm>
#include <deque>
#include <sstream>

namespace sheetmorph
{

namespace
{

// A part in the coordinates of its product.
Points in_product(const Points& points, const TopLoc_Location& place)
{
    const gp_Trsf back = place.Transformation().Inverted();
    Points found(points.rows(), 3);
    for (Eigen::Index i = 0; i < points.rows(); ++i)
    {
        const gp_Pnt there = gp_Pnt(points(i, 0), points(i, 1), points(i, 2)).Transformed(back);
        found.row(i) << there.X(), there.Y(), there.Z();
    }
    return found;
}

double size_of(const Points& points)
{
    return (points.colwise().maxCoeff() - points.colwise().minCoeff()).norm();
}

CarriedShape as_it_was(const std::shared_ptr<const ShapeMesh>& known)
{
    const ShapeMesh& mesh = *known;
    CarriedShape same;
    same.mesh = known;
    same.shape = mesh.shape;
    same.is_kept.assign(static_cast<std::size_t>(mesh.faces.Extent()), true);
    same.scale.assign(same.is_kept.size(), 1.0);
    TopTools_IndexedMapOfShape parts;
    TopExp::MapShapes(mesh.shape, parts);
    for (int i = 1; i <= parts.Extent(); ++i)
        same.image.Bind(parts(i), parts(i));
    return same;
}

// The bodies of a model in new forms, those of instances that agree only once.
class NewBodies
{
public:
    NewBodies(const CadModel& model, const CarryTolerances& tolerances)
        : model_(model), tolerances_(tolerances)
    {
    }

    void add(std::size_t part, const Points& positions, const Progress& progress)
    {
        const CadPart& entry = model_.parts[part];
        const Points rest = entry.mesh.points();
        const double least = 1e-9 * size_of(rest);
        const bool is_moved = (positions - rest).rowwise().norm().maxCoeff() > least;
        Points local = is_moved
                           ? in_product(positions, model_.source->bodies[part].shape.Location())
                           : entry.known->rest;
        for (std::size_t k = 0; k < forms_.size(); ++k)
            if (forms_[k].mesh == entry.known.get()
                && (forms_[k].positions - local).rowwise().norm().maxCoeff() <= least)
            {
                bodies.push_back({static_cast<int>(k), &forms_[k].carried});
                return;
            }
        CarriedShape carried =
            is_moved ? carried_one(entry, local, progress) : as_it_was(entry.known);
        forms_.push_back({entry.known.get(), std::move(local), std::move(carried)});
        bodies.push_back({static_cast<int>(forms_.size()) - 1, &forms_.back().carried});
    }

    std::vector<NewBody> bodies;

private:
    struct Form
    {
        const ShapeMesh* mesh;
        Points positions;
        CarriedShape carried;
    };

    CarriedShape carried_one(const CadPart& entry, const Points& local,
                             const Progress& progress) const
    {
        try
        {
            return carried_shape(entry.known, local, tolerances_, progress);
        }
        catch (const InvalidInput& error)
        {
            throw InvalidInput("\"" + entry.name + "\": " + error.what());
        }
        catch (const SolverError& error)
        {
            throw SolverError("\"" + entry.name + "\": " + error.what());
        }
    }

    const CadModel& model_;
    CarryTolerances tolerances_;
    std::deque<Form> forms_;  // whose addresses stay
};

void check(const CadModel& model, const std::vector<Points>& positions, const CadWriting& writing)
{
    if (!model.source)
        throw InvalidInput("the model was not read of a file; read it again");
    if (positions.size() != model.parts.size())
        throw InvalidInput("there must be positions for every part");
    for (std::size_t k = 0; k < positions.size(); ++k)
    {
        if (positions[k].rows() != model.parts[k].mesh.points().rows())
            throw InvalidInput("a part has another number of vertices");
        if (!positions[k].allFinite())
            throw InvalidInput("a position is not a finite number");
        if (!model.parts[k].skipped_faces.empty())
            throw InvalidInput("\"" + model.parts[k].name
                               + "\" has faces that were not meshed; repair them in the CAD "
                                 "system");
    }
    for (const double tolerance : {writing.tolerance, writing.edge_tolerance})
        if (!(tolerance >= 1e-6) || tolerance > 1e6)
            throw InvalidInput("a tolerance is out of range; give 1e-6 to 1e6 mm");
}

// What a written file holds that was read again.
std::vector<CadMeasures> measured(const CadModel& model, const std::vector<Points>& positions,
                                  const std::vector<NewBody>& bodies, const CadWriting& writing)
{
    const std::shared_ptr<CadSource> source = read_document(writing.path, writing.format);
    const CadSource& read = *source;
    if (read.bodies.size() != bodies.size())
        throw SolverError("the written file holds " + std::to_string(read.bodies.size())
                          + " solids and shells instead of " + std::to_string(bodies.size()));
    std::vector<CadMeasures> found;
    for (std::size_t k = 0; k < bodies.size(); ++k)
    {
        const BodyMeasurer measurer(*model.parts[k].known, *bodies[k].carried,
                                    read.bodies[k].shape);
        found.push_back(measurer.measures(positions[k], writing.tolerance));
        found.back().name = model.parts[k].name;
    }
    return found;
}

}  // namespace

std::vector<CadMeasures> write_cad(const CadModel& model, const std::vector<Points>& positions,
                                   const CadWriting& writing, const Progress& progress)
{
    check(model, positions, writing);
    const CarryTolerances tolerances{writing.tolerance, writing.edge_tolerance};
    return guarded("OpenCASCADE cannot write it", "repair the part in the CAD system",
                   [&]
                   {
                       NewBodies made(model, tolerances);
                       const auto count = static_cast<double>(positions.size());
                       for (std::size_t k = 0; k < positions.size(); ++k)
                       {
                           const auto i = static_cast<double>(k);
                           const Progress own =
                               progress.part(0.8 * i / count, 0.8 * (i + 1.0) / count);
                           own.report(0.0, "carrying " + model.parts[k].name);
                           made.add(k, positions[k], own);
                       }
                       progress.report(0.8, "writing");
                       DocumentCopy copy(*model.source, made.bodies);
                       write_document(copy.document(), *model.source, writing.path, writing.format);
                       progress.report(0.9, "measuring");
                       return measured(model, positions, made.bodies, writing);
                   });
}

std::string brep_of(const CadModel& model, int part)
{
    if (!model.source || part < 0 || part >= static_cast<int>(model.source->bodies.size()))
        throw InvalidInput("there is no such part; read the file again");
    std::ostringstream text;
    text.precision(17);
    BRepTools::Write(model.source->bodies[static_cast<std::size_t>(part)].shape, text, false, false,
                     TopTools_FormatVersion_CURRENT);
    return text.str();
}

}  // namespace sheetmorph
