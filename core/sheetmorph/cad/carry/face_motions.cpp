// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/cad/carry/face_motions.h"
#include "sheetmorph/base/errors.h"

#include <BRep_Tool.hxx>
#include <TopoDS.hxx>
#include <algorithm>
#include <numeric>

namespace sheetmorph::cad
{

Points rows_of(const VertexIds& vertices, const Points& points)
{
    Points rows(static_cast<Eigen::Index>(vertices.size()), 3);
    for (std::size_t i = 0; i < vertices.size(); ++i)
        rows.row(static_cast<Eigen::Index>(i)) = points.row(vertices[i]);
    return rows;
}

double rigid_tolerance(const ShapeMesh& mesh)
{
    // From the accuracy that SheetMorph promises: a rigid motion is exact to 1e-9 of the size.
    constexpr double share = 1e-9;
    return share * (mesh.rest.colwise().maxCoeff() - mesh.rest.colwise().minCoeff()).norm();
}

Handle(Geom_Surface) placed_surface(const TopoDS_Face& face)
{
    TopLoc_Location place;
    const Handle(Geom_Surface) surface = BRep_Tool::Surface(face, place);
    return Handle(Geom_Surface)::DownCast(surface->Transformed(place.Transformation()));
}

namespace
{

// Gives adjacent faces with one motion the same numbers, those of the largest face. Then the circle
// of a hole, its wall and its washer have one axis to the last digit.
class SharedMotions
{
public:
    SharedMotions(const ShapeMesh& mesh, const Points& result, double tolerance)
        : mesh_(mesh),
          result_(result),
          tolerance_(tolerance),
          faces_at_(static_cast<std::size_t>(mesh.rest.rows())),
          is_done_(mesh.on_face.size(), false)
    {
        for (std::size_t f = 0; f < mesh.on_face.size(); ++f)
            for (const int vertex : mesh.on_face[f].vertices)
                faces_at_[static_cast<std::size_t>(vertex)].push_back(f);
    }

    void share(FaceMotions& motions)
    {
        std::vector<std::size_t> order(motions.size());
        std::iota(order.begin(), order.end(), std::size_t{0});
        const auto size = [&](std::size_t face) { return mesh_.on_face[face].vertices.size(); };
        std::stable_sort(order.begin(), order.end(),
                         [&](std::size_t one, std::size_t other)
                         { return size(one) > size(other); });
        for (const std::size_t face : order)
            if (motions[face] && motions[face]->scale == 1.0 && !is_done_[face])
                share_from(face, motions);
    }

private:
    void share_from(std::size_t first, FaceMotions& motions)
    {
        const KeptMotion& motion = *motions[first];
        std::vector<std::size_t> waiting{first};
        while (!waiting.empty())
        {
            const std::size_t face = waiting.back();
            waiting.pop_back();
            if (is_done_[face] || !motions[face] || motions[face]->scale != 1.0
                || !carries(motion, face))
                continue;
            is_done_[face] = true;
            if (face != first)
                motions[face] = motion;
            for (const int vertex : mesh_.on_face[face].vertices)
                for (const std::size_t beside : faces_at_[static_cast<std::size_t>(vertex)])
                    if (!is_done_[beside])
                        waiting.push_back(beside);
        }
    }

    bool carries(const KeptMotion& motion, std::size_t face) const
    {
        const VertexIds& vertices = mesh_.on_face[face].vertices;
        const auto is_there = [&](int vertex)
        {
            const Vector3 before = mesh_.rest.row(vertex).transpose();
            const Vector3 after = result_.row(vertex).transpose();
            return (motion.point(before) - after).norm() <= tolerance_;
        };
        return std::all_of(vertices.begin(), vertices.end(), is_there);
    }

    const ShapeMesh& mesh_;
    const Points& result_;
    double tolerance_;
    std::vector<std::vector<std::size_t>> faces_at_;  // by vertex
    std::vector<bool> is_done_;
};

}  // namespace

FaceMotions face_motions(const ShapeMesh& mesh, const Points& result, double tolerance)
{
    FaceMotions found;
    for (int f = 0; f < mesh.faces.Extent(); ++f)
    {
        VertexIds vertices = mesh.on_face[static_cast<std::size_t>(f)].vertices;
        if (vertices.empty())
            throw InvalidInput("face " + std::to_string(f) + " has no mesh that can carry it",
                               "repair it in the CAD system");
        std::sort(vertices.begin(), vertices.end());
        vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
        const Points before = rows_of(vertices, mesh.rest), after = rows_of(vertices, result);
        found.push_back(rigid_fit(before, after, tolerance, false));
        if (!found.back())
            found.back() = resized_fit(before, after, tolerance,
                                       placed_surface(TopoDS::Face(mesh.faces(f + 1))));
    }
    SharedMotions(mesh, result, tolerance).share(found);
    return found;
}

}  // namespace sheetmorph::cad
