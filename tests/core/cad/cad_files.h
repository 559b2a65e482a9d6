// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>

namespace sheetmorph::cad::test
{

//! A folder of the running test that vanishes with it.
class TemporaryFolder
{
public:
    TemporaryFolder();
    ~TemporaryFolder();
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;

    std::string file(const std::string& name) const { return path_ + "/" + name; }

private:
    std::string path_;
};

//! Makes files with OpenCASCADE. The plate is 60 x 40 x 2 mm from the origin, with a hole of
//! radius 3 mm through (15, 20) along z and one of radius 5 mm through (40, 20).
void write_plate_step(const std::string& path);
void write_plate_iges(const std::string& path);
void write_plate_brep(const std::string& path);

//! The plate without thickness, its faces a shell, and a ball of radius 4 mm about (100, 0, 0).
void write_sheet_and_ball_brep(const std::string& path);

//! An assembly of "plate", "pin" (a cylinder of radius 3 mm, 8 mm long) at (15, 20, -3) and the
//! same pin at (40, 20, -3), turned by 90 degrees about the x axis.
void write_assembly_step(const std::string& path);

//! The plate in red, its upper face in blue, on the layer "sheets", and a product without a name:
//! a compound of two pins.
void write_coloured_step(const std::string& path);

//! A bent strip: two flats of 20 x 30 x 1 mm and a quarter of a cylinder between, radii 1 and 2.
void write_bend_brep(const std::string& path);

//! A cone, a torus and a box that is a spline solid.
void write_solids_brep(const std::string& path);

}  // namespace sheetmorph::cad::test
