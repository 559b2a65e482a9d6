// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/mesh/search/picking.h"
#include "sheetmorph/mesh/topology/vertex_triangles.h"
#include "sheetmorph/recognise/facets/facet_graph.h"
#include "sheetmorph/recognise/thin/thin_solid.h"

#include <map>

namespace sheetmorph::recognise
{

//! Finds the points across the sheet from a vertex: the nearest points of a skin that a walk over
//! facets and straight through the material reaches. A flange beyond an air gap is never found,
//! however narrow the gap is.
class AcrossSheet
{
public:
    AcrossSheet(const mesh::TriangleMesh& mesh, const ThinSolid& solid);

    //! The nearest point of a skin across the sheet from a vertex, and all points at the same
    //! distance. Empty if the component does not have this skin.
    //! \param skin  main or opposite
    std::vector<mesh::Hit> places(int vertex, SolidSide skin) const;

    //! The typical thickness of the sheet at a vertex, mm; 0 if the vertex is not on a sheet.
    double thickness(int vertex) const;

    //! The point of the deformed skin that is nearest to `point`, searched outwards from one facet.
    //! \param positions  (n, 3) mm, of the whole mesh
    mesh::Hit nearest_around(int facet, const Vector3& point, const Points& positions) const;

private:
    class Walk;
    struct Component
    {
        std::vector<int> facets;  // of the whole mesh
        mesh::PickingTree tree;
    };

    double thickness_at(int facet) const
    {
        const int component = graph_.component(facet);
        return solid_.of_component[static_cast<std::size_t>(component)];
    }
    SolidSide side(int facet) const { return solid_.facets[static_cast<std::size_t>(facet)]; }
    bool crosses(int facet, SolidSide skin, Walk& walk, std::vector<Vector3>& crossed) const;
    int facet_behind(int facet, const Vector3& point, SolidSide skin) const;

    const mesh::TriangleMesh& mesh_;
    const ThinSolid& solid_;
    double size_;
    FacetGraph graph_;
    mesh::VertexTriangles around_;
    std::map<int, Component> thin_;  // by component with two skins
};

}  // namespace sheetmorph::recognise
