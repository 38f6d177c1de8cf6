// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "energy/Sample_lanes.h"

#include <cstddef>
#include <memory>
#include <memory_resource>
#include <vector>

namespace CGAL::Shape_correspondence::internal {

constexpr std::size_t rod_chunk_bytes = 1u << 17;

// Where rods are taken from and given back to, for the next ones: allocators would give their memory back to the
// system, and clearing it again takes a quarter of the time of a search.
inline std::pmr::memory_resource& rod_pool()
{
  static auto* const pool = new std::pmr::synchronized_pool_resource({4, rod_chunk_bytes}); // outlives static objects
  return *pool;
}

struct Rod_deleter
{
  std::size_t blocks = 0;

  void operator()(Rod_block* rods) const
  {
    rod_pool().deallocate(rods, blocks * sizeof(Rod_block), alignof(Rod_block));
  }
};

// The rods of one pair.
using Own_rods = std::unique_ptr<Rod_block[], Rod_deleter>;

// Without a value.
inline Own_rods own_rods(std::size_t blocks)
{
  void* const memory = rod_pool().allocate(blocks * sizeof(Rod_block), alignof(Rod_block));
  return Own_rods(static_cast<Rod_block*>(memory), Rod_deleter{blocks});
}

// Memory for the rods of many pairs, which are needed at the same time and given up at the same time. One allocation
// for hundreds of them: in a search for tables of energies, single allocations would take a quarter of the time.
class Rod_memory
{
public:
  Rod_memory() = default;
  Rod_memory(const Rod_memory&) = delete;
  Rod_memory& operator=(const Rod_memory&) = delete;
  ~Rod_memory()
  {
    for (Rod_block* chunk : chunks_)
      rod_pool().deallocate(chunk, rod_chunk_bytes, alignof(Rod_block));
  }

  // Blocks without a value. \pre at most `chunk_blocks`
  Rod_block* take(std::size_t blocks)
  {
    if (chunks_.empty() || used_ + blocks > chunk_blocks) {
      if (chunks_.empty() || ++chunk_ == chunks_.size())
        chunks_.push_back(static_cast<Rod_block*>(rod_pool().allocate(rod_chunk_bytes, alignof(Rod_block))));
      used_ = 0;
    }
    used_ += blocks;
    return chunks_[chunk_] + used_ - blocks;
  }

  // Whether more is taken than stays in the cache.
  bool is_full() const { return chunk_ >= cached_chunks; }

  // Gives up all blocks; their memory is taken again.
  void clear() { chunk_ = used_ = 0; }

private:
  static constexpr std::size_t chunk_blocks = rod_chunk_bytes / sizeof(Rod_block), cached_chunks = 3;

  std::vector<Rod_block*> chunks_;
  std::size_t chunk_ = 0, used_ = 0; // the chunk that is being filled, and how many of its blocks are taken
};

} // namespace CGAL::Shape_correspondence::internal
