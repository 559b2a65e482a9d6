// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/assembly/session/live_drag.h"
#include "sheetmorph/base/errors.h"
#include "arrays.h"
#include "layers.h"
#include "progress.h"

#include <pybind11/stl.h>

namespace py = pybind11;

namespace sheetmorph
{

using namespace assembly;

namespace
{

void bind_result(py::module_& module)
{
    py::class_<FeatureResult>(module, "FeatureResult",
                              "How one form feature moved: p = centre + translation + "
                              "rotation (p_hat - centre).")
        .def_readonly("name", &FeatureResult::name)
        .def_readonly("part", &FeatureResult::part)
        .def_readonly("edge_error", &FeatureResult::edge_error, "worst error of (2.4), mm")
        .def_readonly("size", &FeatureResult::size, "mm, None unless it is set")
        .def_readonly("outline_error", &FeatureResult::outline_error,
                      "worst distance of its rim from the exact circle of that size, mm")
        .def_property_readonly("rotation", [](const FeatureResult& feature)
                               { return to_numpy(feature.motion.rotation()); })
        .def_property_readonly("rotation_log", [](const FeatureResult& feature)
                               { return to_numpy(feature.motion.rotation_log); })
        .def_property_readonly("translation", [](const FeatureResult& feature)
                               { return to_numpy(feature.motion.translation); })
        .def_property_readonly(
            "centre", [](const FeatureResult& feature) { return to_numpy(feature.motion.pivot); });
}

std::vector<int> previews(const Deformed& pose)
{
    std::vector<int> parts;
    for (std::size_t part = 0; part < pose.parts.size(); ++part)
        if (pose.parts[part].is_preview)
            parts.push_back(static_cast<int>(part));
    return parts;
}

std::vector<std::pair<int, std::string>> unsettled(const Deformed& pose)
{
    std::vector<std::pair<int, std::string>> found;
    for (std::size_t part = 0; part < pose.parts.size(); ++part)
        if (!pose.parts[part].convergence.is_converged)
            found.emplace_back(static_cast<int>(part), pose.parts[part].convergence.sentence());
    return found;
}

py::object sheet_positions(const py::object& self, std::size_t part)
{
    const auto& pose = self.cast<const Deformed&>();
    if (part >= pose.parts.size())
        throw InvalidInput("part " + std::to_string(part) + " does not exist");
    const bool is_thin = pose.middles[part].positions.rows() > 0;
    return view_of((is_thin ? pose.middles : pose.parts)[part].positions, self);
}

void bind_deformed(py::module_& module)
{
    py::class_<Deformed, std::shared_ptr<Deformed>>(module, "Deformed", "Every part in one pose.")
        .def(
            "positions",
            [](const py::object& self, std::size_t part)
            {
                const auto& parts = self.cast<const Deformed&>().parts;
                if (part >= parts.size())
                    throw InvalidInput("part " + std::to_string(part) + " does not exist");
                return view_of(parts[part].positions, self);
            },
            py::arg("part"), "(n, 3) float64 mm, a read-only view that keeps the result alive.")
        .def("sheet_positions", &sheet_positions, py::arg("part"),
             "(n, 3) float64 mm of what DeformationSession.sheet() is.")
        .def_readonly("features", &Deformed::features)
        .def_readonly("contacts", &Deformed::contacts)
        .def_readonly("spread", &Deformed::spread,
                      "mm: how far apart, at most, several contacts want one vertex")
        .def_property_readonly("previews", &previews,
                               "indices of the parts whose exact answer is refined besides")
        .def_property_readonly("unsettled", &unsettled,
                               "(part index, sentence) of what was not solved to its end");

    py::class_<ContactFidelity>(module, "ContactFidelity", "How well one contact was kept, mm.")
        .def_readonly("contact", &ContactFidelity::contact)
        .def_readonly("source_part", &ContactFidelity::source_part)
        .def_readonly("target_part", &ContactFidelity::target_part)
        .def_readonly("deviation", &ContactFidelity::deviation,
                      "farthest a driven vertex is from the source side's best rigid motion")
        .def_readonly("region_size", &ContactFidelity::region_size);

    py::class_<Timing>(module, "Timing")
        .def_readonly("stage", &Timing::stage)
        .def_readonly("seconds", &Timing::seconds);
}

// Another Python thread may change an assembly or a pose as soon as the lock of Python is released:
// the kernel reads a copy.
DeformationSession session_from(const Assembly& assembly, const py::object& callback,
                                const DeformationSession* previous)
{
    const Assembly copy(assembly);
    const LongWork work(callback);
    return DeformationSession(copy, work.progress(), previous);
}

std::vector<std::string> names_of(const DeformationSession& session, const std::vector<int>& parts)
{
    std::vector<std::string> names;
    for (const int part : parts)
        names.push_back(session.assembly().parts[static_cast<std::size_t>(part)].name);
    return names;
}

// (contact index, source part index, target part index) of every contact in use.
std::vector<std::tuple<int, int, int>> directions(const DeformationSession& session)
{
    std::vector<std::tuple<int, int, int>> found;
    for (const DirectedContact& contact : session.plan().contacts)
        found.emplace_back(contact.contact, contact.source(session.assembly()).part,
                           contact.target(session.assembly()).part);
    return found;
}

py::object control_mesh(const DeformationSession& session, int contact, const Deformed& pose)
{
    std::optional<ShownControlMesh> shown = session.control_mesh(contact, pose);
    if (!shown)
        return py::none();
    return py::make_tuple(to_numpy(std::move(shown->vertices)),
                          to_numpy(std::move(shown->triangles)));
}

std::unique_ptr<LiveDrag> begin_drag(const DeformationSession& session,
                                     const std::vector<std::string>& handles, const Pose& start)
{
    return session.begin_drag(handles, start);
}

Deformed deform(const DeformationSession& session, const Pose& pose, bool exact,
                const py::object& callback)
{
    const Pose copy(pose);
    const LongWork work(callback);
    return session.deform(copy, exact ? Exactness::exact : Exactness::live, work.progress());
}

// The array of a frame holds it, so that its memory is not used again before.
std::shared_ptr<Deformed> frame(LiveDrag& drag, const Pose& pose)
{
    const Pose copy(pose);
    const py::gil_scoped_release without_gil;
    return std::const_pointer_cast<Deformed>(drag.frame(copy));
}

std::vector<bool> answered(const LiveDrag& drag)
{
    std::vector<char> parts;
    {
        // A frame of another thread may be under way.
        const py::gil_scoped_release without_gil;
        parts = drag.answered();
    }
    return {parts.begin(), parts.end()};
}

void bind_drag(py::module_& module)
{
    py::class_<LiveDrag>(module, "LiveDrag",
                         "Live frames while some handles are dragged; how the parts answer to them "
                         "is worked out in the background.")
        .def("frame", &frame, py::arg("pose"), "Every part in one pose, within 1e-6 of the size.")
        .def_property_readonly("failure", &LiveDrag::failure,
                               "What the background work has failed with, empty if it has not.")
        .def("wait", &LiveDrag::wait, py::call_guard<LongWork>(),
             "Returns when the background work is done.")
        .def_property_readonly("is_ready", &LiveDrag::is_ready)
        .def_property_readonly("answered", &answered,
                               "By part: whether the last frame needed no substitution.");
}

void bind_results(py::module_& module)
{
    bind_result(module);
    bind_deformed(module);
    bind_drag(module);
}

// What the propagation order made of the parts.
void bind_order(py::class_<DeformationSession>& session)
{
    session
        .def_property_readonly(
            "order", [](const DeformationSession& of) { return names_of(of, of.plan().order); },
            "parts as they are deformed, the primary first")
        .def_property_readonly(
            "levels", [](const DeformationSession& of) { return of.plan().level; },
            "by part: contacts from the primary, -1 if not reached")
        .def_property_readonly("directions", &directions,
                               "(contact, source part, target part) indices")
        .def_property_readonly("unreached", [](const DeformationSession& of)
                               { return names_of(of, of.plan().unreached); });
}

std::vector<std::vector<std::string>> joined_labels(const DeformationSession& session)
{
    std::vector<std::vector<std::string>> all;
    for (JoinedBody& body : session.joined_bodies())
        all.push_back(std::move(body.labels));
    return all;
}

std::vector<std::vector<std::pair<std::string, std::string>>> joined_subjects(
    const DeformationSession& session)
{
    std::vector<std::vector<std::pair<std::string, std::string>>> all;
    for (const JoinedBody& body : session.joined_bodies())
    {
        auto& pairs = all.emplace_back();
        for (const Subject& subject : body.of)
            pairs.emplace_back(subject.kind, subject.name);
    }
    return all;
}

// What became of bodies and pieces that nobody listed as such.
void bind_union(py::class_<DeformationSession>& session)
{
    session
        .def_property_readonly(
            "joined_subjects", &joined_subjects,
            "(kind, name) of the entries that each of `joined_bodies` is made of")
        .def_property_readonly("joined_bodies", &joined_labels,
                               "Labels of form features and rigid contacts that are one body.")
        .def_property_readonly(
            "loose_pieces",
            [](const DeformationSession& of)
            {
                std::vector<std::tuple<int, int, int, py::array_t<double>>> found;
                for (const LoosePieces& loose : of.loose_pieces())
                    found.emplace_back(loose.part, loose.pieces, loose.vertices,
                                       to_numpy(loose.place));
                return found;
            },
            "(part index, pieces, vertices, place of one at rest) of parts with pieces that "
            "nothing holds.")
        .def("is_held", &DeformationSession::is_held, py::arg("part"),
             "Whether a fixed region holds a part, its own or through rigid contacts.");
}

// Poses and their answers.
void bind_answers(py::class_<DeformationSession>& session)
{
    session.def(
        "deform", &deform, py::arg("pose"), py::arg("exact") = true,
        py::arg("progress") = py::none(),
        "Every part in one pose, always from rest. progress(fraction, task): return False to "
        "cancel (raises Cancelled).");
}

}  // namespace

void bind_session(py::module_& module)
{
    bind_results(module);
    py::class_<DeformationSession> bound(module, "DeformationSession",
                                         "The assembly, ready to be deformed. Construction is "
                                         "the pre-processing phase; deform() only substitutes.");
    bind_order(bound);
    bind_union(bound);
    bind_answers(bound);
    bound
        .def(py::init(&session_from), py::arg("assembly"), py::arg("progress") = py::none(),
             py::arg("previous") = nullptr,
             "progress(fraction, task): return False to cancel (raises Cancelled). previous: a "
             "session of an earlier state; what did not change is taken over.")
        .def("sheet", &DeformationSession::sheet, py::arg("part"),
             py::return_value_policy::reference_internal,
             "TriangleMesh of what is deformed of a part: its own, or the middle of a thin solid.")
        .def("sheet_thickness", &DeformationSession::sheet_thickness, py::arg("part"),
             "mm: how thick the sheet of a part is as 'steel'.")
        .def("begin_drag", &begin_drag, py::arg("handles"), py::arg("start") = Pose{},
             "A LiveDrag of the named handles; the others stay as in the pose `start`.")
        .def("thin_solid", &DeformationSession::thin_solid, py::arg("part"),
             py::return_value_policy::reference_internal,
             "The ThinSolid that a part is solved as, None if it is solved as it is.")
        .def("control_mesh", &control_mesh, py::arg("contact"), py::arg("pose"),
             "(vertices (m, 3) mm, triangles (t, 3)) of one contact's control mesh in a Deformed "
             "pose, -1 for the single one; None if it has none.")
        .def_property_readonly(
            "features",
            [](const DeformationSession& session) { return session.assembly().features; },
            "of all parts; with a plane of symmetry those of the other side come last")
        .def_property_readonly(
            "shapes", [](const DeformationSession& session) { return session.shapes(); },
            "by feature: its FeatureShape where its size can be set, else None")
        .def_property_readonly("timings", &DeformationSession::timings);
}

}  // namespace sheetmorph
