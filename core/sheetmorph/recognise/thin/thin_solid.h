// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/mesh/triangle_mesh.h"

#include <optional>
#include <string>

namespace sheetmorph::recognise
{

//! Distance through the material, in thicknesses, beyond which the opposite facet is not the other
//! skin of the same sheet. From geometry: at the corner of a folded box, where three sheets meet,
//! the two skins are sqrt(3) = 1.73 thicknesses apart. Measured: at half of it a fold without a
//! radius leaves its skin (ThinSolid.AFinelyMeshedFoldWithoutRadiusStaysOnItsSkin); at twice, a
//! boss is no lump (ThinSolid.ABossIsALumpWithItsFootOnBothSkins).
constexpr double farthest_skin = 1.8;

//! Where a facet or a vertex of a thin solid lies.
enum class SolidSide : char
{
    main,      //!< on the skin that is solved, rims included
    opposite,  //!< on the other skin
    wall,      //!< between the skins: outer borders and holes
    lump       //!< where the solid is not thin: a boss, a rib, a welded nut
};

//! A hole through both skins, treated as one feature.
struct ThroughHole
{
    VertexIds rim;       //!< on the main skin, ascending
    VertexIds vertices;  //!< both rims and the wall, ascending
};

//! A closed mesh of a sheet: two skins, one thickness apart, and the walls between them.
struct ThinSolid
{
    double thickness = 0.0;            //!< typical thickness of the largest sheet, mm
    std::vector<SolidSide> facets;     //!< (m); main on components that are not thin
    std::vector<int> component;        //!< (m) facets connected across edges of two facets, from 0
    std::vector<double> of_component;  //!< by component: typical thickness, mm; 0 if not thin
    //! (n); the first of main, opposite and wall among its facets
    std::vector<SolidSide> vertices;
    Eigen::VectorXd thicknesses;     //!< (n) local thickness, mm; NaN on walls and lumps
    std::vector<ThroughHole> holes;  //!< ordered by first vertex
    std::vector<VertexIds> walls;    //!< every connected wall with its rims, ascending
    std::vector<VertexIds> lumps;    //!< each connected lump with its foot on the skins, ascending
};

//! Result of the search for a thin solid.
struct ThinFinding
{
    std::optional<ThinSolid> solid;
    std::string reason;  //!< if there is none: the cause and a remedy
};

//! Recognises a thin solid from rays cast through the material. The rays start at points spread
//! over the facets, so that the few huge slivers of a CAD tessellation give as much information as
//! a fine mesh. Every closed component is classified separately; those that are not thin stay
//! unchanged.
//! The main skin is the one with less area of embossed or engraved shapes, then the larger one
//! (without bosses), then the one with the first facet of the mesh.
//! \param thickness  typical thickness, mm; 0: estimated
ThinFinding find_thin_solid(const mesh::TriangleMesh& mesh, double thickness = 0.0);

}  // namespace sheetmorph::recognise
