// SPDX-License-Identifier: LGPL-2.1-or-later
#include "model_answer.h"

#include "sheetmorph/cad/analytic_features.h"

namespace sheetmorph::cad_worker
{

namespace
{

using namespace cad;

void add(Answer& answer, const CadSurface& surface);
void add(Answer& answer, const CadFeature& feature);
void add(Answer& answer, const CadPart& part);
void add(Answer& answer, const KeptCylinder& cylinder);
void add(Answer& answer, const CadMeasures& measures);

template <typename Thing>
void add_list(Answer& answer, const std::vector<Thing>& things)
{
    answer.open('[');
    for (const Thing& one : things)
        add(answer, one);
    answer.close(']');
}

const char* name_of(SurfaceKind kind)
{
    switch (kind)
    {
        case SurfaceKind::plane:
            return "plane";
        case SurfaceKind::cylinder:
            return "cylinder";
        case SurfaceKind::cone:
            return "cone";
        case SurfaceKind::sphere:
            return "sphere";
        case SurfaceKind::torus:
            return "torus";
        default:
            return "other";
    }
}

const char* name_of(CadFeatureKind kind)
{
    switch (kind)
    {
        case CadFeatureKind::round_hole:
            return "round hole";
        case CadFeatureKind::cylinder:
            return "cylinder";
        case CadFeatureKind::cone:
            return "cone";
        case CadFeatureKind::sphere:
            return "sphere";
        default:
            return "plane";
    }
}

void add(Answer& answer, const Vector3& vector)
{
    answer.open('[').value(vector(0)).value(vector(1)).value(vector(2)).close(']');
}

void add(Answer& answer, const Points& points)
{
    answer.array(points.data(), static_cast<std::size_t>(points.rows()), 3);
}

void add(Answer& answer, const CadSurface& surface)
{
    answer.open('{').key("kind").value(name_of(surface.kind)).key("point");
    add(answer, surface.point);
    add(answer.key("axis"), surface.axis);
    answer.key("radius").value(surface.radius).key("minor_radius").value(surface.minor_radius);
    answer.key("half_angle").value(surface.half_angle).key("fit_error").value(surface.fit_error);
    answer.key("name").value(surface.name).key("colour").value(surface.colour).close('}');
}

void add(Answer& answer, const CadFeature& feature)
{
    answer.open('{').key("kind").value(name_of(feature.kind)).key("center");
    add(answer, feature.centre);
    add(answer.key("axis"), feature.axis);
    answer.key("radius").value(feature.radius).key("half_angle").value(feature.half_angle);
    answer.key("length").value(feature.length).key("is_hollow").value(feature.is_hollow);
    answer.key("vertices").array(feature.vertices).key("residual").value(feature.residual);
    answer.close('}');
}

void add(Answer& answer, const CadPart& part)
{
    const Triangles& triangles = part.mesh.triangles();
    answer.open('{').key("name").value(part.name).key("points");
    add(answer, part.mesh.points());
    answer.key("triangles");
    answer.array(triangles.data(), static_cast<std::size_t>(triangles.rows()), 3);
    answer.key("face_of_triangle").array(part.face_of_triangle).key("surfaces");
    add_list(answer, part.surfaces);
    // A part that was kept knows no surfaces.
    add_list(answer.key("found_features"),
             part.surfaces.empty() ? std::vector<CadFeature>() : analytic_features(part));
    answer.key("is_closed").value(part.is_closed).key("deviation").value(part.deviation);
    answer.key("skipped_faces").list(part.skipped_faces);
    answer.key("faults").list(part.faults).key("healed").list(part.healed);
    answer.key("healed_within").value(part.healed_within);
    answer.key("unsettled").value(part.convergence.sentence()).close('}');
}

void add(Answer& answer, const WorstAt& worst)
{
    answer.open('{').key("value").value(worst.value).key("face");
    if (worst.face < 0)
        answer.null();
    else
        answer.value(worst.face);
    add(answer.key("place"), Vector3(worst.place));
    answer.close('}');
}

void add(Answer& answer, const KeptCylinder& cylinder)
{
    answer.open('[').value(cylinder.face).value(cylinder.before);
    answer.value(cylinder.wanted).value(cylinder.after);
    answer.close(']');
}

void add_condition(Answer& answer, const CadMeasures& measures)
{
    answer.key("is_valid").value(measures.is_valid);
    answer.key("invalid_faces").list(measures.invalid_faces);
    answer.key("is_closed").value(measures.is_closed).key("was_closed").value(measures.was_closed);
    answer.key("was_valid").value(measures.was_valid);
    answer.key("faults_before").list(measures.faults).key("healed").list(measures.healed);
    answer.key("healed_within").value(measures.healed_within);
}

void add(Answer& answer, const CadMeasures& measures)
{
    answer.open('{').key("name").value(measures.name).key("faces").value(measures.faces);
    answer.key("washers").value(measures.washers).key("kept").value(measures.kept);
    answer.key("fitted_faces").list(measures.fitted_faces);
    add_condition(answer, measures);
    add(answer.key("gap"), measures.gap);
    add(answer.key("distance"), measures.distance);
    add(answer.key("kink"), measures.kink);
    answer.key("edge_tolerance").value(measures.edge_tolerance);
    answer.key("edge_tolerance_read").value(measures.edge_tolerance_read);
    answer.key("vertex_tolerance").value(measures.vertex_tolerance);
    answer.key("volume_before").value(measures.volume_before);
    answer.key("volume_after").value(measures.volume_after);
    add(answer.key("points"), measures.points);
    answer.key("far_faces").list(measures.far_faces);
    add_list(answer.key("cylinders"), measures.cylinders);
    answer.close('}');
}

}  // namespace

Answer model_answer(const CadModel& model)
{
    Answer answer;
    answer.open('{').key("edge").value(model.edge).key("deflection").value(model.deflection);
    answer.key("angle").value(model.angle).key("lost_faces").value(model.lost_faces);
    answer.key("lost_in").list(model.lost_in).key("unread").list(model.unread);
    add_list(answer.key("parts"), model.parts);
    answer.close('}');
    return answer;
}

Answer measures_answer(const std::vector<CadMeasures>& measures)
{
    Answer answer;
    answer.open('{');
    add_list(answer.key("bodies"), measures);
    answer.close('}');
    return answer;
}

}  // namespace sheetmorph::cad_worker
