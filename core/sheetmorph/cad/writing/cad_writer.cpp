// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/cad/writing/cad_writer.h"
#include "sheetmorph/base/errors.h"
#include "sheetmorph/base/threads/parallel.h"
#include "sheetmorph/cad/cad_guard.h"
#include "sheetmorph/cad/writing/body_measurer.h"
#include "sheetmorph/cad/writing/document_copy.h"
#include "sheetmorph/cad/writing/written_file.h"

#include <BRepTools.hxx>
#include <TopExp.hxx>
#include <algorithm>
#include <cmath>
#include <deque>
#include <sstream>

namespace sheetmorph::cad
{

namespace
{

// Positions of a part in the coordinates of its product.
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

void note_condition(CadMeasures& found, const NamedShape& before)
{
    found.faults = before.faults;
    found.healed = before.healed;
    found.healed_within = before.healed_within;
    found.was_valid = before.faults.empty();
}

// The new forms of the bodies of a model; equal instances share one.
class NewBodies
{
public:
    NewBodies(const CadModel& model, const std::vector<Points>& positions) : model_(model)
    {
        for (std::size_t k = 0; k < positions.size(); ++k)
            form_of_.push_back(find_form(k, positions[k]));
    }

    //! Carries all forms, the largest first.
    void carry(const CarryTolerances& tolerances, const Progress& progress)
    {
        std::vector<Form*> order;
        for (Form& form : forms_)
            order.push_back(&form);
        std::stable_sort(order.begin(), order.end(),
                         [](const Form* one, const Form* other)
                         { return one->positions.rows() > other->positions.rows(); });
        std::vector<Task> tasks;
        for (Form* form : order)
            tasks.push_back({"carrying " + model_.parts[form->part].name,
                             [this, form, &tolerances](const Progress& own)
                             { carry_one(*form, tolerances, own); }});
        run_tasks(tasks, progress);
    }

    // Measures the written file after reading it again.
    std::vector<CadMeasures> measured(const std::vector<Points>& positions,
                                      const CadWriting& writing, const Progress& progress) const
    {
        const std::shared_ptr<CadSource> source = read_document(writing.path, writing.format);
        const std::vector<NamedShape>& read = source->bodies;
        const std::vector<NewBody> wanted = bodies();
        if (read.size() != wanted.size())
            throw SolverError("the written file holds " + std::to_string(read.size())
                              + " solids and shells instead of " + std::to_string(wanted.size()));
        std::vector<CadMeasures> found(wanted.size());
        std::vector<Task> tasks;
        for (std::size_t k = 0; k < wanted.size(); ++k)
            tasks.push_back({"measuring " + model_.parts[k].name, [&, k](const Progress& own)
                             {
                                 own.report(0.0, "measuring " + model_.parts[k].name);
                                 const BodyMeasurer measurer(*model_.parts[k].known,
                                                             *wanted[k].carried, read[k]);
                                 found[k] = measurer.measures(positions[k], writing.tolerance);
                                 found[k].name = model_.parts[k].name;
                                 note_condition(found[k], model_.source->bodies[k]);
                             }});
        progress.report(0.5, "measuring");
        run_tasks(tasks, progress.part(0.5, 1.0));
        return found;
    }

    std::vector<NewBody> bodies() const
    {
        std::vector<NewBody> found;
        for (const std::size_t k : form_of_)
            found.push_back({static_cast<int>(k), &forms_[k].carried});
        return found;
    }

private:
    struct Form
    {
        std::size_t part;  // the first with this form
        bool is_moved;
        Points positions;
        CarriedShape carried;
    };

    std::size_t find_form(std::size_t part, const Points& positions)
    {
        const CadPart& entry = model_.parts[part];
        const Points rest = entry.mesh.points();
        const double least = 1e-9 * size_of(rest);
        const bool is_moved = (positions - rest).rowwise().norm().maxCoeff() > least;
        Points local = is_moved
                           ? in_product(positions, model_.source->bodies[part].shape.Location())
                           : entry.known->rest;
        for (std::size_t k = 0; k < forms_.size(); ++k)
            if (model_.parts[forms_[k].part].known == entry.known
                && (forms_[k].positions - local).rowwise().norm().maxCoeff() <= least)
                return k;
        forms_.push_back({part, is_moved, std::move(local), {}});
        return forms_.size() - 1;
    }

    void carry_one(Form& form, const CarryTolerances& tolerances, const Progress& progress) const
    {
        const CadPart& entry = model_.parts[form.part];
        progress.report(0.0, "carrying " + entry.name);
        try
        {
            form.carried = form.is_moved
                               ? carried_shape(entry.known, form.positions, tolerances, progress)
                               : as_it_was(entry.known);
        }
        catch (const InvalidInput& error)
        {
            throw InvalidInput("\"" + entry.name + "\": " + error.fault().what, error.fault().todo);
        }
        catch (const SolverError& error)
        {
            throw SolverError("\"" + entry.name + "\": " + error.fault().what, error.fault().todo);
        }
    }

    const CadModel& model_;
    std::vector<std::size_t> form_of_;  // one per part
    std::deque<Form> forms_;            // with stable addresses
};

// A decimal fraction of the unit that is negligible against a tolerance, mm.
double decimal_grain(double tolerance, double unit)
{
    // Chosen: rounding to the grain moves a pole by half of it at most, 0.2 % of the tolerance.
    constexpr double share = 0.004;
    return unit * std::pow(10.0, std::floor(std::log10(share * tolerance / unit)));
}

void check(const CadModel& model, const std::vector<Points>& positions, const CadWriting& writing)
{
    if (!model.source)
        throw InvalidInput("the model was not read from a file", "read it again");
    if (positions.size() != model.parts.size())
        throw InvalidInput("there must be positions for every part");
    for (std::size_t k = 0; k < positions.size(); ++k)
    {
        if (positions[k].rows() != model.parts[k].mesh.points().rows())
            throw InvalidInput("a part has another number of vertices");
        if (!positions[k].allFinite())
            throw InvalidInput("a position is not a finite number");
        if (!model.parts[k].skipped_faces.empty())
            throw InvalidInput("\"" + model.parts[k].name + "\" has faces that were not meshed",
                               "repair them in the CAD "
                               "system");
    }
    for (const double tolerance : {writing.tolerance, writing.edge_tolerance})
        if (!(tolerance >= 1e-6) || tolerance > 1e6)
            throw InvalidInput("a tolerance is out of range", "give 1e-6 to 1e6 mm");
}

}  // namespace

std::vector<CadMeasures> write_cad(const CadModel& model, const std::vector<Points>& positions,
                                   const CadWriting& writing, const Progress& progress)
{
    check(model, positions, writing);
    const CarryTolerances tolerances{
        writing.tolerance, writing.edge_tolerance,
        decimal_grain(writing.edge_tolerance, millimetres_in(model.source->unit))};
    return guarded("it cannot be written", "repair the part in the CAD system",
                   [&]
                   {
                       progress.report(0.0, "carrying shapes");
                       NewBodies made(model, positions);
                       made.carry(tolerances, progress.part(0.0, 0.6));
                       progress.report(0.6, "writing");
                       const std::vector<NewBody> bodies = made.bodies();  // the copy stores it
                       DocumentCopy copy(*model.source, bodies);
                       write_document(copy.document(), *model.source, writing);
                       progress.report(0.7, "reading it again");
                       return made.measured(positions, writing, progress.part(0.7, 1.0));
                   });
}

std::string brep_of(const CadModel& model, int part)
{
    if (!model.source || part < 0 || part >= static_cast<int>(model.source->bodies.size()))
        throw InvalidInput("there is no such part", "read the file again");
    std::ostringstream text;
    text.precision(17);
    BRepTools::Write(model.source->bodies[static_cast<std::size_t>(part)].shape, text, false, false,
                     TopTools_FormatVersion_CURRENT);
    return text.str();
}

}  // namespace sheetmorph::cad
