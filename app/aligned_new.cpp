// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <cstdlib>
#include <new>

// Memory is aligned as on systems of 64 bits, by 16 bytes; Emscripten's own is by 8. By the alignment, Eigen chooses
// which numbers of an array it adds up first, so results would have other last digits.

void* operator new(std::size_t size)
{
  constexpr std::size_t alignment = 16;
  if (void* const memory = std::aligned_alloc(alignment, (size + alignment - 1) / alignment * alignment)) return memory;
  throw std::bad_alloc();
}

void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
