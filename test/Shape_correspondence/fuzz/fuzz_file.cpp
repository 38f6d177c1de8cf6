// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

// Fuzz target for READER, a macro that names a function of file_readers.h: every input is read or refused.

#include "file_readers.h"

#include <CGAL/Shape_correspondence/Invalid_input.h>

#include <cstdint>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  try {
    file_readers::READER({reinterpret_cast<const char*>(data), size});
  } catch (const CGAL::Shape_correspondence::Invalid_input&) {
  }
  return 0;
}
