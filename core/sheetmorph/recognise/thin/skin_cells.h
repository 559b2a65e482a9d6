// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "sheetmorph/recognise/thin/inward_probes.h"

namespace sheetmorph::recognise
{

//! Bends sharper than this separate a skin from a wall, radians (30 degrees).
constexpr double crease = 0.5235987755982988;

//! A step in a skin is a ledge, no wall, up to this many thicknesses.
constexpr double highest_ledge = 0.05;

//! Two cells that see each other through the material.
struct OpposedCells
{
    int one, other;
    double area;  //!< mm^2
};

//! Facets that may be skin, gathered without crossing a crease.
struct SkinCells
{
    std::vector<double> thickness;  //!< by component, mm: what most of its surface has behind it
    std::vector<int> patch;         //!< (m) facets joined without a crease, by their first facet
    std::vector<int> cell;          //!< (m) from 0; -1 for facets that are not skin
    std::vector<int> component;     //!< by cell
    std::vector<double> area;       //!< by cell, mm^2
    std::vector<OpposedCells> opposed;  //!< the largest area first

    int count() const { return static_cast<int>(area.size()); }
};

//! A facet may be skin if most of the looks from it end after 0.5 to 1.6 typical thicknesses on a
//! facet that looks the other way, and it lies in a cell larger than the square of the thickness.
//! \param thickness  mm: the typical one where it is known, 0 to find it out
SkinCells skin_cells(const FacetGraph& graph, const std::vector<InwardProbe>& probes,
                     double thickness);

}  // namespace sheetmorph::recognise
