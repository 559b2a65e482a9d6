// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/mesh/triangle_mesh.h"

#include <optional>
#include <string>

namespace sheetmorph::recognise
{

//! Where a facet or a vertex of a thin solid lies.
enum class SolidSide : char
{
    main,      //!< on the skin that is solved, its rims included
    opposite,  //!< on the other skin
    wall,      //!< between the skins: outer borders and holes
    lump       //!< where the solid is not thin: a boss, a rib, a welded nut
};

//! A hole through both skins: one feature.
struct ThroughHole
{
    VertexIds rim;       //!< on the main skin, ascending
    VertexIds vertices;  //!< both rims and the wall, ascending
};

//! A closed mesh that is a sheet: two skins, one thickness apart, and the walls between them.
struct ThinSolid
{
    double thickness = 0.0;            //!< mm, the typical one of the largest sheet
    std::vector<SolidSide> facets;     //!< (m); of components that are not thin: main
    std::vector<int> component;        //!< (m) connected across edges of two facets, from 0
    std::vector<double> of_component;  //!< mm: the typical thickness of each, 0 if it is not thin
    std::vector<SolidSide> vertices;   //!< (n); main if any facet around is, then opposite, wall
    Eigen::VectorXd thicknesses;       //!< (n) mm: the local one; NaN on walls and lumps
    std::vector<ThroughHole> holes;    //!< by rising first vertex
    std::vector<VertexIds> walls;  //!< every wall that is one piece, its rims included, ascending
    std::vector<VertexIds> lumps;  //!< each one piece, its foot on the skins included, ascending
};

//! What a mesh was found to be.
struct ThinFinding
{
    std::optional<ThinSolid> solid;
    std::string reason;  //!< why it is none: what is the matter and what could be done
};

//! Recognises a thin solid by its facets: looks through the material from points spread over them,
//! so that the few huge slivers of a CAD tessellation tell as much as a fine mesh. Every closed
//! component is judged by itself; those that are not thin are left as they are.
//! The main skin is the one with fewer embossed or engraved shapes, then the larger one (that
//! without bosses), then the one with the mesh's first facet.
//! \param thickness  mm: where it is known; 0 to find it out
ThinFinding find_thin_solid(const mesh::TriangleMesh& mesh, double thickness = 0.0);

}  // namespace sheetmorph::recognise
