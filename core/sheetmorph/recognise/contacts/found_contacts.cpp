// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/recognise/contacts/found_contacts.h"

#include "sheetmorph/base/disjoint_sets.h"
#include "sheetmorph/base/errors.h"
#include "sheetmorph/base/vertex_sets.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <map>
#include <set>
#include <string>
#include <tuple>

namespace sheetmorph::recognise
{

namespace
{

// Minimum share of a patch on flanges for a flange contact, and of touches by free edges alone for
// an edge contact. Chosen above a half, so that a patch is never both.
constexpr double mostly = 0.6;

// A patch within this many washer radii of its bolts belongs to these bolts and is dropped. Chosen:
// around a bolt, sheets touch to about twice the washer. Measured: a larger value drops the patch
// of Contacts.CoaxialHolesAreABolt.
constexpr double bolt_reach = 2.2;

bool share_any(const VertexIds& a, const VertexIds& b)
{
    VertexIds both;
    std::set_intersection(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(both));
    return !both.empty();
}

VertexIds with_washer(const Feature& feature)
{
    VertexIds all = feature.vertices;
    for (const VertexIds& ring : feature.washer)
        merge_into(all, ring);
    return all;
}

// Share of the vertices that lie in flanges of their part.
double share_on_flanges(const ContactPart& part, const VertexIds& vertices)
{
    VertexIds flanges;
    for (const Feature& feature : part.features)
        if (feature.kind == FeatureKind::flange)
            merge_into(flanges, feature.vertices);
    VertexIds both;
    std::set_intersection(flanges.begin(), flanges.end(), vertices.begin(), vertices.end(),
                          std::back_inserter(both));
    return static_cast<double>(both.size()) / static_cast<double>(vertices.size());
}

// One label per connection. Connections of one joint, and those that share a vertex, have one
// label.
std::vector<int> labels_of(const std::vector<Connection>& connections)
{
    DisjointSets sets(static_cast<int>(connections.size()));
    std::map<std::pair<char, int>, int> first;
    for (std::size_t i = 0; i < connections.size(); ++i)
    {
        const Connection& c = connections[i];
        const int own = static_cast<int>(i);
        for (const std::pair<char, int>& key :
             {std::pair('a', c.vertex_a), std::pair('b', c.vertex_b), std::pair('j', c.joint)})
            if (key.second >= 0)
                sets.join(first.emplace(key, own).first->second, own);
    }
    std::vector<int> labels;
    for (std::size_t i = 0; i < connections.size(); ++i)
        labels.push_back(sets.root(static_cast<int>(i)));
    return labels;
}

void leave_out(VertexIds& vertices, const VertexIds& others)
{
    VertexIds rest;
    std::set_difference(vertices.begin(), vertices.end(), others.begin(), others.end(),
                        std::back_inserter(rest));
    vertices = std::move(rest);
}

}  // namespace

ContactCollector::ContactCollector(const std::vector<ContactPart>& parts,
                                   const std::vector<PartShape>& shapes,
                                   const ContactTolerances& tolerances)
    : parts_(parts), shapes_(shapes), tolerances_(tolerances)
{
}

void ContactCollector::take_connections(const std::vector<Connection>& connections, double longest)
{
    const auto check = [&](int part, int vertex)
    {
        if (part < 0 || part >= static_cast<int>(parts_.size()) || vertex < 0
            || vertex >= parts_[part].mesh.vertex_count())
            throw InvalidInput("a connection names vertex " + std::to_string(vertex) + " of part "
                               + std::to_string(part) + ", which does not exist");
    };
    for (const Connection& c : connections)
    {
        check(c.part_a, c.vertex_a);
        check(c.part_b, c.vertex_b);
        const double away = (parts_[c.part_a].mesh.points().row(c.vertex_a)
                             - parts_[c.part_b].mesh.points().row(c.vertex_b))
                                .norm();
        if (away > longest && !c.is_rigid)
            continue;
        if (c.part_a < c.part_b)
            connected_[{c.part_a, c.part_b}].push_back(c);
        else if (c.part_b < c.part_a)
            connected_[{c.part_b, c.part_a}].push_back(
                {c.part_b, c.vertex_b, c.part_a, c.vertex_a, c.joint, c.is_rigid});
    }
}

void ContactCollector::take_bolts(const std::vector<Bolt>& bolts)
{
    for (const Bolt& bolt : bolts)
    {
        const Feature& one = parts_[bolt.part_a].features[bolt.feature_a];
        const Feature& other = parts_[bolt.part_b].features[bolt.feature_b];
        FoundContact contact;
        contact.kind = ContactKind::bolt;
        contact.part_a = bolt.part_a;
        contact.part_b = bolt.part_b;
        contact.a = with_washer(one);
        contact.b = with_washer(other);
        measure(contact);
        contact.center = 0.5 * (one.center + other.center);
        contact.axis = one.axis;
        contact.distance = bolt.distance;
        bolted_[{bolt.part_a, bolt.part_b}].push_back(contact);
    }
}

void ContactCollector::take_pair(int a, int b)
{
    const PartShape& one = shapes_[a];
    const PartShape& other = shapes_[b];
    const double reach = tolerances_.gap + 0.5 * (one.thickness() + other.thickness());
    const std::array<std::vector<Touch>, 2> touches = {
        one.touches(other, reach, tolerances_.facing_angle),
        other.touches(one, reach, tolerances_.facing_angle)};
    std::vector<FoundContact> contacts;
    for (const Patch& patch : patches_of(one, other, touches, reach))
    {
        const FoundContact contact = contact_of(patch, {a, b});
        const auto smaller = std::min(contact.a.size(), contact.b.size());
        if (smaller >= static_cast<std::size_t>(tolerances_.smallest) && !is_all_bolts(contact))
            contacts.push_back(contact);
    }
    if (tolerances_.joins_pairs)
        join_pair(contacts);
    if (!contacts.empty())
        found_[{a, b}] = std::move(contacts);
}

FoundContact ContactCollector::contact_of(const Patch& patch, const Pair& pair) const
{
    FoundContact contact;
    contact.part_a = pair.first;
    contact.part_b = pair.second;
    contact.a = shapes_[pair.first].graph().originals(patch.sides[0]);
    contact.b = shapes_[pair.second].graph().originals(patch.sides[1]);
    contact.distance = patch.distance;
    measure(contact);
    if (patch.edge_share > mostly)
        contact.kind = ContactKind::edge;
    else if (is_on_flanges(contact))
        contact.kind = ContactKind::flange;
    return contact;
}

bool ContactCollector::is_on_flanges(const FoundContact& contact) const
{
    return share_on_flanges(parts_[contact.part_a], contact.a) >= mostly
           && share_on_flanges(parts_[contact.part_b], contact.b) >= mostly;
}

bool ContactCollector::is_all_bolts(const FoundContact& contact) const
{
    const auto bolts = bolted_.find({contact.part_a, contact.part_b});
    if (bolts == bolted_.end())
        return false;
    const auto is_near = [&](const Vector3& point)
    {
        for (const FoundContact& bolt : bolts->second)
            if ((point - bolt.center).norm() <= 0.5 * bolt_reach * bolt.size / std::sqrt(2.0))
                return true;
        return false;
    };
    for (const auto& [part, side] :
         {std::pair(contact.part_a, &contact.a), std::pair(contact.part_b, &contact.b)})
        for (const int vertex : *side)
            if (!is_near(parts_[part].mesh.points().row(vertex).transpose()))
                return false;
    return true;
}

void ContactCollector::join_pair(std::vector<FoundContact>& contacts) const
{
    for (std::size_t i = 1; i < contacts.size(); ++i)
    {
        merge_into(contacts[0].a, contacts[i].a);
        merge_into(contacts[0].b, contacts[i].b);
        contacts[0].kind = std::max(contacts[0].kind, contacts[i].kind);
        contacts[0].distance = std::max(contacts[0].distance, contacts[i].distance);
    }
    if (contacts.size() > 1)
    {
        contacts.resize(1);
        measure(contacts[0]);
    }
}

void ContactCollector::measure(FoundContact& contact) const
{
    const Points& a = parts_[contact.part_a].mesh.points();
    const Points& b = parts_[contact.part_b].mesh.points();
    Points all(contact.a.size() + contact.b.size(), 3);
    all << a(contact.a, Eigen::indexing::all), b(contact.b, Eigen::indexing::all);
    const Eigen::RowVector3d low = all.colwise().minCoeff();
    const Eigen::RowVector3d high = all.colwise().maxCoeff();
    contact.center = 0.5 * (low + high).transpose();
    contact.size = (high - low).norm();
}

// One contact per joint of a pair; joints that share a vertex form one contact. Several flexible
// joints make a seam.
std::vector<FoundContact> ContactCollector::welds_of(const Pair& pair) const
{
    const std::vector<Connection>& connections = connected_.at(pair);
    const std::vector<int> labels = labels_of(connections);
    std::map<int, FoundContact> welds;
    std::map<int, std::vector<int>> joints;
    for (std::size_t i = 0; i < connections.size(); ++i)
    {
        const Connection& c = connections[i];
        FoundContact& weld = welds[labels[i]];
        merge_into(weld.a, {c.vertex_a});
        merge_into(weld.b, {c.vertex_b});
        ++weld.connections;
        weld.distance = (parts_[pair.first].mesh.points().row(c.vertex_a)
                         - parts_[pair.second].mesh.points().row(c.vertex_b))
                            .norm();
        weld.is_spot = weld.is_spot || c.is_rigid;
        joints[labels[i]].push_back(c.joint >= 0 ? c.joint : -2 - static_cast<int>(i));
    }
    std::vector<FoundContact> found;
    for (auto& [label, weld] : welds)
    {
        std::vector<int>& own = joints[label];
        std::sort(own.begin(), own.end());
        weld.is_spot = weld.is_spot || own.front() == own.back();
        weld.kind = ContactKind::weld;
        weld.part_a = pair.first;
        weld.part_b = pair.second;
        measure(weld);
        found.push_back(std::move(weld));
    }
    return found;
}

// Adds the welds of a pair. A flexible weld turns the patch it touches into a seam. A rigid body,
// or a weld outside all patches, becomes a contact of its own.
void ContactCollector::add_connected(std::vector<FoundContact>& contacts, const Pair& pair)
{
    const std::vector<Connection>& connections = connected_.at(pair);
    std::set<int> rigid;
    for (const Connection& c : connections)
        if (c.is_rigid)
            rigid.insert(c.vertex_a);
    const std::size_t patches = contacts.size();
    for (FoundContact& weld : welds_of(pair))
    {
        const bool is_rigid = std::any_of(weld.a.begin(), weld.a.end(),
                                          [&](int vertex) { return rigid.count(vertex) > 0; });
        bool is_taken = false;
        for (std::size_t k = 0; k < patches; ++k)
        {
            FoundContact& patch = contacts[k];
            if (!share_any(patch.a, weld.a) && !share_any(patch.b, weld.b))
                continue;
            if (is_rigid)
            {
                leave_out(patch.a, weld.a);
                leave_out(patch.b, weld.b);
            }
            else if (!is_taken)
            {
                patch.connections += weld.connections;
                patch.kind = ContactKind::weld;
                is_taken = true;
            }
        }
        if (!is_taken)
            contacts.push_back(std::move(weld));
    }
    const auto is_empty = [](const FoundContact& contact)
    { return contact.a.empty() || contact.b.empty(); };
    contacts.erase(std::remove_if(contacts.begin(), contacts.end(), is_empty), contacts.end());
}

std::vector<FoundContact> ContactCollector::found()
{
    for (const auto& [pair, elements] : connected_)
        add_connected(found_[pair], pair);
    for (const auto& [pair, bolts] : bolted_)
        found_[pair].insert(found_[pair].end(), bolts.begin(), bolts.end());
    std::vector<FoundContact> all;
    for (const auto& [pair, contacts] : found_)
        all.insert(all.end(), contacts.begin(), contacts.end());
    return all;
}

}  // namespace sheetmorph::recognise
