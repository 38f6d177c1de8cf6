// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "energy/Sample_lanes.h"

#include <cstddef>
#include <memory>
#include <vector>

namespace CGAL::Shape_correspondence::internal {

// Memory for the rods of many pairs, which are needed at the same time and given up at the same time. One allocation
// for hundreds of them: in a search for tables of energies, single allocations would take a quarter of the time.
class Rod_memory
{
public:
  // Blocks without a value. \pre at most `chunk_blocks`
  Rod_block* take(std::size_t blocks)
  {
    if (chunks_.empty() || used_ + blocks > chunk_blocks) {
      if (chunks_.empty() || ++chunk_ == chunks_.size()) chunks_.emplace_back(new Rod_block[chunk_blocks]);
      used_ = 0;
    }
    used_ += blocks;
    return chunks_[chunk_].get() + used_ - blocks;
  }

  // Whether more is taken than stays in the cache.
  bool is_full() const { return chunk_ >= cached_chunks; }

  // Gives up all blocks; their memory is taken again.
  void clear() { chunk_ = used_ = 0; }

private:
  // Chunks of 96 kB, which allocators keep; larger ones they give back to the system, which has to clear them again
  static constexpr std::size_t chunk_blocks = 512, cached_chunks = 4;

  std::vector<std::unique_ptr<Rod_block[]>> chunks_;
  std::size_t chunk_ = 0, used_ = 0; // the chunk that is being filled, and how many of its blocks are taken
};

} // namespace CGAL::Shape_correspondence::internal
