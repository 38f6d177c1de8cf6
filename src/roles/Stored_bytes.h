// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>

namespace CGAL::Shape_correspondence::internal {

// Bytes in memory that are read from front to back.
struct Stored_bytes
{
  const std::uint8_t* next;
  const std::uint8_t* end;
  std::shared_ptr<const void> owner; // owner of the memory; null if it exists as long as the program

  std::size_t size() const { return std::size_t(end - next); }
};

} // namespace CGAL::Shape_correspondence::internal
