// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <cstdint>
#include <cstring>
#include <string>

namespace CGAL::Shape_correspondence::IO {

/// Appends a number: the same bytes on every machine. \tparam Bits an unsigned integer of its size
template <typename Number, typename Bits>
void append_little_endian(std::string& bytes, Number number)
{
  Bits bits;
  std::memcpy(&bits, &number, sizeof(bits));
  for (std::size_t byte = 0; byte < sizeof(bits); ++byte)
    bytes.push_back(static_cast<char>(bits >> (8 * byte) & 0xFF));
}

} // namespace CGAL::Shape_correspondence::IO
