// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

// Every shape the kernel's tests use, made in code: namespace sheetmorph::shapes.
#include "shapes/plates.h"
#include "shapes/sheets.h"
#include "shapes/solids.h"
#include "shapes/thin.h"
#include "shapes/variations.h"
