// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/base/angles.h"
#include "sheetmorph/recognise/thin/inward_probes.h"

namespace sheetmorph::recognise
{

//! A sharper bend separates a skin from a wall, radians. Chosen: walls stand across skins (90
//! degrees); the facets of a coarse bend turn by up to 30 degrees.
constexpr double crease = 30.0 * degree;

//! A step in a skin up to this many thicknesses is a ledge and not a wall. Chosen: engravings and
//! tolerances of thickness are 5 %; walls have the whole thickness.
constexpr double highest_ledge = 0.05;

//! Two cells that face each other through the material.
struct OpposedCells
{
    int one, other;
    double area;  //!< mm^2
};

//! Facets that may be skin, grouped into cells that do not cross a crease.
struct SkinCells
{
    //! by component, mm: the most frequent distance through the material
    std::vector<double> thickness;
    std::vector<int> patch;      //!< (m) facets joined without a crease, named by their first facet
    std::vector<int> cell;       //!< (m) from 0; -1 for facets that are not skin
    std::vector<int> component;  //!< by cell
    std::vector<double> area;    //!< by cell, mm^2
    std::vector<OpposedCells> opposed;  //!< largest area first

    int count() const { return static_cast<int>(area.size()); }
};

//! A facet may be skin if most of its rays hit a facet that faces the opposite way, after 0.5 to
//! 1.6 typical thicknesses. Its cell must also be larger than the square of the thickness.
//! \param thickness  typical thickness, mm; 0: estimated
SkinCells skin_cells(const FacetGraph& graph, const std::vector<InwardProbe>& probes,
                     double thickness);

}  // namespace sheetmorph::recognise
