// SPDX-License-Identifier: LGPL-2.1-or-later
#include "layers.h"

PYBIND11_MODULE(_core, module)
{
    module.doc() = "The SheetMorph kernel: deforms sheet-metal meshes, form features stay rigid.";
    sheetmorph::bind_base(module);
    sheetmorph::bind_triangle_mesh(module);
    sheetmorph::bind_mesh(module);
    sheetmorph::bind_pick(module);
    sheetmorph::bind_features(module);
    sheetmorph::bind_diagnosis(module);
    sheetmorph::bind_thin(module);
    sheetmorph::bind_repair(module);
    sheetmorph::bind_recognise(module);
    sheetmorph::bind_description(module);
    sheetmorph::bind_session(module);
    sheetmorph::bind_flat(module);
}
