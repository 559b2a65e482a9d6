// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/surface/operators/hinged_sheets.h"

#include "sheetmorph/base/index.h"

#include <Eigen/SVD>
#include <algorithm>
#include <map>
#include <set>

namespace sheetmorph::surface
{

using mesh::Anchor;

namespace
{

// Points are collinear, and sheets flat, if their width or thickness relative to their length is
// smaller. Chosen: the thickness of a sheet. The stiffness of a narrower hinge is 1e-6 of that of a
// wide one (its square), so it would turn freely.
constexpr double in_line = 1e-3;

// Squared extents: length, width, thickness.
Vector3 extents(const Points& points)
{
    if (points.rows() == 0)
        return Vector3::Zero();
    const Points spread = points.rowwise() - points.colwise().mean();
    return Eigen::JacobiSVD<Matrix3>(spread.transpose() * spread).singularValues();
}

//! Supported points of one sheet, which keep their distances.
struct Held
{
    std::vector<Anchor> places;
    std::set<int> seams;  // vertices where the sheet ends at another one
};

class Sheets
{
public:
    explicit Sheets(const HingedInput& input)
        : input_(input),
          sheets_(mesh::connected_components(input.mesh)),
          is_firm_(at(sheets_.count), 0),
          faces_(at(sheets_.count)),
          vertices_(at(sheets_.count)),
          carried_(at(sheets_.count))
    {
        lay();
        for (const Tie& tie : input_.roles.ties)
        {
            tie_of_[tie.vertex] = &tie;
            if (const int below = sheet_of(tie.place); below != mesh::Components::unused)
                carried_[at(below)].push_back(&tie);
        }
    }

    VertexIds hinged()
    {
        VertexIds found;
        while (grow() || straighten_one(found))
            ;
        return found;
    }

private:
    void lay()
    {
        const Triangles& triangles = input_.mesh.triangles();
        for (int t = 0; t < input_.mesh.triangle_count(); ++t)
            if (const int sheet = sheets_.label[at(triangles(t, 0))];
                sheet != mesh::Components::unused)
                faces_[at(sheet)].push_back(t);
        for (int i = 0; i < input_.mesh.vertex_count(); ++i)
            if (const int sheet = sheets_.label[at(i)]; sheet != mesh::Components::unused)
            {
                vertices_[at(sheet)].push_back(i);
                is_firm_[at(sheet)] |= input_.clamps[at(i)];
            }
    }

    // The sheet of an anchor; unused if its corners are on different sheets.
    int sheet_of(const Anchor& place) const
    {
        const int sheet = sheets_.label[at(place.corners[0])];
        const bool is_one =
            std::all_of(place.corners.begin(), place.corners.end(),
                        [&](int corner) { return sheets_.label[at(corner)] == sheet; });
        return is_one ? sheet : mesh::Components::unused;
    }

    bool is_firm(int sheet) const
    {
        return sheet != mesh::Components::unused && is_firm_[at(sheet)];
    }

    bool is_firm(const Body& body) const
    {
        return body.is_known() || body.handle >= 0
               || std::any_of(body.vertices.begin(), body.vertices.end(),
                              [&](int vertex) { return is_firm(sheets_.label[at(vertex)]); });
    }

    bool is_border(int vertex) const { return input_.is_interior[at(vertex)] == 0; }

    // The border vertices on both sides of a tie.
    VertexIds seam_of(const Tie& tie) const
    {
        VertexIds found;
        for (std::size_t k = 0; k < 3 && is_border(tie.vertex); ++k)
            if (tie.place.weights(static_cast<Eigen::Index>(k)) > 0.0
                && is_border(tie.place.corners[k]))
                found.push_back(tie.place.corners[k]);
        if (!found.empty())
            found.push_back(tie.vertex);
        return found;
    }

    void add_seam(const Tie& tie, int sheet, Held& held) const
    {
        for (const int vertex : seam_of(tie))
            if (sheets_.label[at(vertex)] == sheet)
                held.seams.insert(vertex);
    }

    // The points at which supported bodies and sheets support a sheet.
    Held held(int sheet) const
    {
        Held found;
        for (const int vertex : vertices_[at(sheet)])
        {
            const int owner = input_.roles.owner[at(vertex)];
            const auto tie = tie_of_.find(vertex);
            const bool is_tied = tie != tie_of_.end() && is_firm(sheet_of(tie->second->place));
            if (is_tied
                || (input_.roles.role[at(vertex)] == Role::body
                    && is_firm(input_.roles.bodies[at(owner)])))
                found.places.push_back(Anchor::at_vertex(vertex));
            if (is_tied)
                add_seam(*tie->second, sheet, found);
        }
        for (const Tie* tie : carried_[at(sheet)])
            if (is_firm(sheets_.label[at(tie->vertex)]))
            {
                found.places.push_back(tie->place);
                add_seam(*tie, sheet, found);
            }
        return found;
    }

    // The vertices of each body on a sheet.
    std::map<int, std::vector<Anchor>> bodies_on(int sheet) const
    {
        std::map<int, std::vector<Anchor>> found;
        for (const int vertex : vertices_[at(sheet)])
            if (input_.roles.role[at(vertex)] == Role::body)
                found[input_.roles.owner[at(vertex)]].push_back(Anchor::at_vertex(vertex));
        return found;
    }

    Points points_of(const std::vector<Anchor>& places) const
    {
        Points points(static_cast<Eigen::Index>(places.size()), 3);
        for (std::size_t k = 0; k < places.size(); ++k)
            points.row(static_cast<Eigen::Index>(k)) =
                places[k].on(input_.mesh.points()).transpose();
        return points;
    }

    bool is_flat(int sheet) const
    {
        std::vector<Anchor> all;
        for (const int vertex : vertices_[at(sheet)])
            all.push_back(Anchor::at_vertex(vertex));
        const Vector3 size = extents(points_of(all));
        return size(2) <= in_line * in_line * size(0);
    }

    // Whether points on one face are not collinear, so that they determine its plane.
    bool have_a_face(int sheet, const std::vector<Anchor>& places) const
    {
        std::set<int> corners;
        std::map<std::set<int>, std::vector<Anchor>> inside;
        for (const Anchor& place : places)
            if (place.weights.maxCoeff() == 1.0)
                corners.insert(place.heaviest());
            else
                inside[{place.corners.begin(), place.corners.end()}].push_back(place);
        for (const int face : faces_[at(sheet)])
        {
            const auto row = input_.mesh.triangles().row(face);
            const auto here = inside.find({row(0), row(1), row(2)});
            std::vector<Anchor> of_face =
                here != inside.end() ? here->second : std::vector<Anchor>();
            for (const int corner : row)
                if (corners.count(corner) > 0)
                    of_face.push_back(Anchor::at_vertex(corner));
            if (of_face.size() > 2 && !are_in_line(points_of(of_face)))
                return true;
        }
        return false;
    }

    // Whether a border edge connects two of the vertices. Rows across such an edge keep both sheets
    // from tilting about it.
    bool have_a_side(int sheet, const std::set<int>& vertices) const
    {
        std::map<std::pair<int, int>, int> uses;
        for (const int face : faces_[at(sheet)])
        {
            const auto row = input_.mesh.triangles().row(face);
            for (int k = 0; k < 3 && vertices.size() > 1; ++k)
                if (vertices.count(row(k)) > 0 && vertices.count(row((k + 1) % 3)) > 0)
                    ++uses[std::minmax({row(k), row((k + 1) % 3)})];
        }
        return std::any_of(uses.begin(), uses.end(),
                           [](const auto& side) { return side.second == 1; });
    }

    bool keeps_from_tilting(int sheet, const std::vector<Anchor>& places) const
    {
        return places.size() > 2 && !are_in_line(points_of(places))
               && (is_flat(sheet) || have_a_face(sheet, places));
    }

    bool cannot_tilt(int sheet) const
    {
        const Held found = held(sheet);
        if (found.places.empty())
            return false;
        if (have_a_side(sheet, found.seams) || keeps_from_tilting(sheet, found.places))
            return true;
        const auto bodies = bodies_on(sheet);
        return std::any_of(bodies.begin(), bodies.end(),
                           [&](const auto& body)
                           { return keeps_from_tilting(sheet, body.second); });
    }

    bool grow()
    {
        bool has_grown = false;
        for (int sheet = 0; sheet < sheets_.count; ++sheet)
            if (!is_firm(sheet) && cannot_tilt(sheet))
            {
                is_firm_[at(sheet)] = true;
                has_grown = true;
            }
        return has_grown;
    }

    bool straighten_one(VertexIds& found)
    {
        for (int sheet = 0; sheet < sheets_.count; ++sheet)
            if (!is_firm(sheet) && !held(sheet).places.empty())
            {
                const VertexIds& all = vertices_[at(sheet)];
                found.insert(found.end(), all.begin(), all.end());
                is_firm_[at(sheet)] = true;
                return true;
            }
        return false;
    }

    const HingedInput& input_;
    mesh::Components sheets_;
    std::vector<char> is_firm_;  // by sheet: whether it cannot tilt
    std::vector<std::vector<int>> faces_;
    std::vector<VertexIds> vertices_;
    std::vector<std::vector<const Tie*>> carried_;  // by sheet: ties that it supports
    std::map<int, const Tie*> tie_of_;              // by vertex
};

}  // namespace

bool are_in_line(const Points& points)
{
    const Vector3 size = extents(points);
    return size(1) <= in_line * in_line * size(0);
}

VertexIds hinged_vertices(const HingedInput& input)
{
    const bool holds_nothing = input.roles.bodies.empty() && input.roles.ties.empty();
    return holds_nothing ? VertexIds() : Sheets(input).hinged();
}

}  // namespace sheetmorph::surface
