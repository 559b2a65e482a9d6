// SPDX-License-Identifier: LGPL-2.1-or-later
#include "assembly/drawn_assembly.h"

namespace sheetmorph::assembly::frames
{

using namespace surface;

DrawnAssembly::DrawnAssembly(unsigned seed) : draw_(seed)
{
    frame_.name = "drawn" + std::to_string(seed);
    frame_.assembly.energy =
        draw_.one_of<Energy>({Energy::neumann, Energy::neumann, Energy::natural, Energy::paper});
    if (draw_.happens(0.15))
        frame_.assembly.laplacian = Laplacian::intrinsic;
    const int parts = 1 + draw_.whole(4);
    for (int k = 0; k < parts; ++k)
        add_part(k);
    add_regions();
    for (std::size_t k = 0; k < drawn_.size(); ++k)
        add_features(static_cast<int>(k));
    add_relations();
    if (draw_.happens(0.4))
        add_point();
    if (parts > 1 && draw_.happens(0.2))
        frame_.assembly.parts.back().mode = draw_.one_of<Mode>({Mode::all, Mode::boundaries});
    if (parts > 1 && draw_.happens(0.3))
        frame_.assembly.propagation.type = draw_.one_of<PropagationType>(
            {PropagationType::single, PropagationType::whole, PropagationType::whole});
}

Pose DrawnAssembly::another_pose()
{
    Pose pose = frame_.pose;
    for (auto& [name, motion] : pose.handles)
        motion = drawn_motion(name, motion.pivot);
    return pose;
}

std::vector<std::string> DrawnAssembly::dragged()
{
    std::vector<std::string> names;
    const bool all = draw_.happens(0.5);
    for (const PartHandle& handle : frame_.assembly.handles)
        if (all || names.empty())
            names.push_back(handle.name);
    return names;
}

PartRegion DrawnAssembly::end(int part) const
{
    return region("end", part, [](const Vector3& p) { return p.x() > 180.0 - 1e-6; });
}

void DrawnAssembly::add_part(int k)
{
    Vector3 corner = Vector3::Zero();
    const int before = k == 0 ? -1 : draw_.whole(k);
    if (k > 0)
        corner = corners_[static_cast<std::size_t>(before)]
                 + Vector3(150.0, 0.0, draw_.number(1.0, 4.0));
    corners_.push_back(corner);
    drawn_.push_back(drawn_part(draw_, "part" + std::to_string(k), corner));
    frame_.assembly.parts.push_back(drawn_.back().part);
    if (k > 0)
        add_contact(before, k, 150.0, 0.0);
    if (k > 1 && draw_.happens(0.2))
    {
        const int other = draw_.whole(k);
        const double ahead = corner.x() - corners_[static_cast<std::size_t>(other)].x();
        if (other != before && ahead >= 0.0 && ahead < 1.0)
            add_contact(other, k, 120.0, 120.0);
    }
}

void DrawnAssembly::add_contact(int a, int b, double from_a, double from_b)
{
    const auto between = [](double from)
    { return [=](const Vector3& p) { return p.x() > from - 0.1 && p.x() < from + 30.1; }; };
    frame_.assembly.contacts.push_back(
        {"contact" + std::to_string(frame_.assembly.contacts.size()),
         draw_.one_of<ContactType>({ContactType::control_mesh, ContactType::control_mesh,
                                    ContactType::tied, ContactType::rigid}),
         region("a", a, between(from_a)), region("b", b, between(from_b))});
}

void DrawnAssembly::add_regions()
{
    frame_.assembly.fixed = {region("root", 0, [](const Vector3& p) { return p.x() < 1e-6; })};
    add_handle("tip", end(0));
    if (draw_.happens(0.4))
        add_handle("middle", region("middle", 0,
                                    [](const Vector3& p)
                                    { return std::abs(p.x() - 60.0) < 4.0 && p.y() > 50.0; }));
    if (drawn_.size() > 1 && draw_.happens(0.3))
        add_handle("far", end(static_cast<int>(drawn_.size()) - 1));
}

void DrawnAssembly::add_handle(const std::string& name, const PartRegion& where)
{
    if (where.vertices.empty())
        return;
    frame_.assembly.handles.push_back({name, where.part, where.vertices, draw_.happens(0.15)});
    const mesh::TriangleMesh& mesh =
        frame_.assembly.parts[static_cast<std::size_t>(where.part)].mesh;
    frame_.pose.handles[name] =
        drawn_motion(name, mesh.points().row(where.vertices.front()).transpose());
}

RigidMotion DrawnAssembly::drawn_motion(const std::string& name, const Vector3& pivot)
{
    RigidMotion motion{draw_.within(25.0), Vector3::Zero(), pivot};
    const auto handle = std::find_if(frame_.assembly.handles.begin(), frame_.assembly.handles.end(),
                                     [&](const PartHandle& one) { return one.name == name; });
    const double farthest = (draw_.happens(0.2) ? 150.0 : 50.0) * shapes::pi / 360.0;
    if (!handle->is_rotation_free)
        motion.rotation_log = draw_.within(farthest);
    return motion;
}

void DrawnAssembly::add_features(int part)
{
    const DrawnPart& drawn = drawn_[static_cast<std::size_t>(part)];
    for (const VertexIds& vertices : drawn.features)
    {
        if (vertices.empty() || draw_.happens(0.3))
            continue;
        PartFeature feature;
        feature.name = "feature" + std::to_string(frame_.assembly.features.size());
        feature.part = part;
        feature.vertices = vertices;
        feature.rotation = draw_.one_of<FeatureRotation>(
            {FeatureRotation::free, FeatureRotation::free, FeatureRotation::interpolated,
             FeatureRotation::prescribed});
        if (feature.rotation == FeatureRotation::prescribed)
            frame_.pose.feature_logs[feature.name] = draw_.within(0.2);
        if (draw_.happens(0.2))
            bind(feature);
        if (drawn.has_flat_holes && draw_.happens(0.3))
            resize(feature);
        frame_.assembly.features.push_back(feature);
    }
}

void DrawnAssembly::bind(PartFeature& feature)
{
    using Type = FeatureMotion::Type;
    feature.motion.type =
        draw_.one_of<Type>({Type::fixed, Type::translation, Type::plane, Type::line, Type::axis});
    const mesh::TriangleMesh& mesh =
        frame_.assembly.parts[static_cast<std::size_t>(feature.part)].mesh;
    feature.motion.point =
        mesh.points()(feature.vertices, Eigen::indexing::all).colwise().mean().transpose();
    feature.motion.direction = draw_.one_of<Vector3>(
        {Vector3::UnitX(), Vector3::UnitY(), Vector3::UnitZ(), Vector3(0.6, 0.0, 0.8)});
}

void DrawnAssembly::resize(PartFeature& feature)
{
    if (draw_.happens(0.5))
        feature.size = draw_.number(20.0, 28.0);
    else
    {
        feature.is_resizable = true;
        frame_.pose.sizes[feature.name] = draw_.number(20.0, 28.0);
    }
}

// Of two features: that they move as one, or keep their distance.
void DrawnAssembly::add_relations()
{
    const auto count = static_cast<int>(frame_.assembly.features.size());
    if (count < 2 || draw_.happens(0.5))
        return;
    const int a = draw_.whole(count), b = draw_.whole(count);
    if (a == b)
        return;
    const auto part = [&](int k)
    { return frame_.assembly.features[static_cast<std::size_t>(k)].part; };
    if (part(a) == part(b) && draw_.happens(0.5))
        frame_.assembly.groups = {{"group", {a, b}}};
    else
        frame_.assembly.pairs = {{"pair", FeatureLinkType::distance, a, b}};
}

void DrawnAssembly::add_point()
{
    const int part = draw_.whole(static_cast<int>(frame_.assembly.parts.size()));
    const mesh::TriangleMesh& mesh = frame_.assembly.parts[static_cast<std::size_t>(part)].mesh;
    PointConstraint point{"point", draw_.whole(mesh.triangle_count()), {0.2, 0.3, 0.5}};
    point.is_turned = draw_.happens(0.2);
    point.is_rotation_free = !point.is_turned && draw_.happens(0.3);
    Vector3 place = Vector3::Zero();
    for (int k = 0; k < 3; ++k)
        place += point.barycentric(k)
                 * mesh.points().row(mesh.triangles()(point.triangle, k)).transpose();
    frame_.assembly.points = {{"point", part, point}};
    frame_.pose.points["point"] = {place + draw_.within(6.0),
                                   point.is_turned ? draw_.within(0.2) : Vector3::Zero()};
}

}  // namespace sheetmorph::assembly::frames
