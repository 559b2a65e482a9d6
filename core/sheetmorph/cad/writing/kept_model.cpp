// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sheetmorph/cad/writing/kept_model.h"
#include "sheetmorph/base/errors.h"
#include "sheetmorph/cad/cad_guard.h"
#include "sheetmorph/cad/meshing/occt_surface.h"
#include "sheetmorph/cad/meshing/shape_mesh.h"
#include "sheetmorph/cad/reading/cad_shapes.h"

#include <TopExp.hxx>
#include <TopoDS.hxx>
#include <cstdint>
#include <cstring>

namespace sheetmorph::cad
{

namespace
{

class Bytes
{
public:
    template <typename Number>
    void add(const Number* first, std::size_t count)
    {
        const auto length = static_cast<std::uint64_t>(count);
        text.append(reinterpret_cast<const char*>(&length), sizeof length);
        text.append(reinterpret_cast<const char*>(first), count * sizeof(Number));
    }

    std::string text;
};

class Reader
{
public:
    explicit Reader(const std::string& text) : text_(text) {}

    template <typename Number>
    std::vector<Number> numbers()
    {
        std::uint64_t count = 0;
        take(&count, sizeof count);
        if (count > text_.size())
            refuse();
        std::vector<Number> found(count);
        take(found.data(), count * sizeof(Number));
        return found;
    }

    [[noreturn]] static void refuse()
    {
        throw InvalidInput("the kept mesh is not that of the shape", "add the shape again");
    }

private:
    void take(void* there, std::size_t count)
    {
        if (count > text_.size() - at_)
            refuse();
        std::memcpy(there, text_.data() + at_, count);
        at_ += count;
    }

    const std::string& text_;
    std::size_t at_ = 0;
};

// Reads the numbers of a mesh, in the order of the shape's faces and edges.
void read_mesh(ShapeMesh& known, Reader& reader)
{
    const auto points = reader.numbers<double>();
    const auto corners = reader.numbers<int>();
    known.face_of_triangle = reader.numbers<int>();
    known.on_vertex = reader.numbers<int>();
    known.rest = Eigen::Map<const Points>(points.data(), static_cast<int>(points.size() / 3), 3);
    known.triangles =
        Eigen::Map<const Triangles>(corners.data(), static_cast<int>(corners.size() / 3), 3);
    for (int f = 0; f < known.faces.Extent(); ++f)
    {
        VerticesOnFace here{reader.numbers<int>(), {}};
        const auto parameters = reader.numbers<double>();
        for (std::size_t i = 0; i + 1 < parameters.size(); i += 2)
            here.parameters.emplace_back(parameters[i], parameters[i + 1]);
        known.on_face.push_back(std::move(here));
    }
    for (int e = 0; e < known.edges.Extent(); ++e)
        known.on_edge.push_back({reader.numbers<int>(), reader.numbers<double>()});
}

// Checks that the positions at the parameters are those of the vertices.
void check(const ShapeMesh& known)
{
    const double size = (known.rest.colwise().maxCoeff() - known.rest.colwise().minCoeff()).norm();
    for (int f = 0; f < known.faces.Extent(); ++f)
    {
        const VerticesOnFace& here = known.on_face[static_cast<std::size_t>(f)];
        const OcctSurface surface(TopoDS::Face(known.faces(f + 1)));
        if (here.vertices.size() != here.parameters.size())
            Reader::refuse();
        for (std::size_t i = 0; i < here.vertices.size(); i += 1 + here.vertices.size() / 8)
        {
            const int vertex = here.vertices[i];
            if (vertex < 0 || vertex >= known.rest.rows()
                || (surface.point(here.parameters[i]) - known.rest.row(vertex).transpose()).norm()
                       > 1e-3 * size)
                Reader::refuse();
        }
    }
}

}  // namespace

std::string kept_mesh(const CadPart& part)
{
    const ShapeMesh& known = *part.known;
    Bytes bytes;
    bytes.add(known.rest.data(), static_cast<std::size_t>(known.rest.size()));
    bytes.add(known.triangles.data(), static_cast<std::size_t>(known.triangles.size()));
    bytes.add(known.face_of_triangle.data(), known.face_of_triangle.size());
    bytes.add(known.on_vertex.data(), known.on_vertex.size());
    for (const VerticesOnFace& here : known.on_face)
    {
        bytes.add(here.vertices.data(), here.vertices.size());
        std::vector<double> parameters;
        for (const Vector2& uv : here.parameters)
            parameters.insert(parameters.end(), {uv(0), uv(1)});
        bytes.add(parameters.data(), parameters.size());
    }
    for (const VerticesOnEdge& here : known.on_edge)
    {
        bytes.add(here.vertices.data(), here.vertices.size());
        bytes.add(here.parameters.data(), here.parameters.size());
    }
    return bytes.text;
}

CadModel kept_model(const std::string& brep, const std::string& mesh, const std::string& name)
{
    const auto work = [&]
    {
        const std::shared_ptr<CadSource> source = source_of_brep_text(brep, name);
        if (source->bodies.size() != 1)
            Reader::refuse();
        const TopoDS_Shape placed = source->bodies.front().shape;
        const auto known = std::make_shared<ShapeMesh>();
        known->shape = placed.Located(TopLoc_Location());
        TopExp::MapShapes(known->shape, TopAbs_FACE, known->faces);
        TopExp::MapShapes(known->shape, TopAbs_EDGE, known->edges);
        TopExp::MapShapes(known->shape, TopAbs_VERTEX, known->vertices);
        Reader reader(mesh);
        read_mesh(*known, reader);
        check(*known);
        CadPart part;
        part.name = name;
        Points points = known->rest;
        const gp_Trsf place = placed.Location().Transformation();
        for (Eigen::Index i = 0; i < points.rows() && place.Form() != gp_Identity; ++i)
            points.row(i) =
                to_vector(gp_Pnt(points(i, 0), points(i, 1), points(i, 2)).Transformed(place).XYZ())
                    .transpose();
        part.mesh = mesh::TriangleMesh(std::move(points), known->triangles);
        part.face_of_triangle = known->face_of_triangle;
        part.known = known;
        CadModel model;
        model.parts.push_back(std::move(part));
        model.source = source;
        return model;
    };
    return guarded("the kept shape cannot be read", "add the shape again", work);
}

}  // namespace sheetmorph::cad
