// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

// Fuzz target for READER, a macro that names a reader of models: every input is refused, or read and welded.

#include "io/read/model_parts.h"

#include <CGAL/Shape_correspondence/Invalid_input.h>

#include <algorithm>
#include <cstdint>

using namespace CGAL::Shape_correspondence;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  try {
    const IO::Model_content content = IO::READER({reinterpret_cast<const char*>(data), size}, "input");
    for (const IO::Model_part& part : content.parts)
      if (std::all_of(part.corners.begin(), part.corners.end(), [](const Point& p) { return p.allFinite(); }))
        IO::weld(part.corners);
  } catch (const Invalid_input&) {
  }
  return 0;
}
