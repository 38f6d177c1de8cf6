// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "energy/Rod_memory.h"

#include <algorithm>
#include <new>

namespace CGAL::Shape_correspondence::internal {

Rod_block* Rod_pool::take(std::size_t blocks)
{
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    Free*& first = free_[blocks]; // from now on there, so that giving back allocates nothing
    if (Free* const taken = first) {
      first = taken->next;
      return reinterpret_cast<Rod_block*>(taken);
    }
  }
  return static_cast<Rod_block*>(::operator new(blocks * sizeof(Rod_block), std::align_val_t(alignof(Rod_block))));
}

void Rod_pool::give_back(Rod_block* memory, std::size_t blocks)
{
  const std::lock_guard<std::mutex> lock(mutex_);
  Free*& first = free_[blocks];
  first = new (static_cast<void*>(memory)) Free{first};
}

Rod_pool& rod_pool()
{
  static auto* const pool = new Rod_pool; // never destroyed, so that it outlives static shapes
  return *pool;
}

Rod_block* Rod_arena::take(std::size_t blocks)
{
  if (blocks > left_) {
    const std::size_t size = std::max(blocks, rod_chunk_bytes / sizeof(Rod_block));
    chunks_.reserve(chunks_.size() + 1);
    chunks_.emplace_back(rod_pool().take(size), size);
    left_ = size;
  }
  const auto& [chunk, size] = chunks_.back();
  Rod_block* const taken = chunk + (size - left_);
  left_ -= blocks;
  return taken;
}

void Rod_arena::clear()
{
  for (const auto& [chunk, size] : chunks_)
    rod_pool().give_back(chunk, size);
  chunks_.clear();
  left_ = 0;
}

} // namespace CGAL::Shape_correspondence::internal
