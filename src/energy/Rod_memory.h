// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "energy/rod_kernel.h"

#include <cstddef>
#include <map>
#include <mutex>
#include <utility>
#include <vector>

namespace CGAL::Shape_correspondence::internal {

/// Memory for rods. What is given back is kept for the next ones, since clearing memory that comes from the system
/// takes long. Threads may share it.
class Rod_pool
{
public:
  Rod_block* take(std::size_t blocks);
  /// \param blocks as many as were taken
  void give_back(Rod_block* memory, std::size_t blocks);

private:
  struct Free
  {
    Free* next;
  };

  std::mutex mutex_;
  std::map<std::size_t, Free*> free_; // by number of blocks; each has the next one in it
};

/// The pool of all shapes.
Rod_pool& rod_pool();

/// The chunks in which memory for many rods is taken.
constexpr std::size_t rod_chunk_bytes = 1u << 17;

/// Memory for rods that is given back all at once.
class Rod_arena
{
public:
  Rod_arena() = default;
  ~Rod_arena() { clear(); }
  Rod_arena(const Rod_arena&) = delete;
  Rod_arena& operator=(const Rod_arena&) = delete;

  Rod_block* take(std::size_t blocks);
  void clear();

private:
  std::vector<std::pair<Rod_block*, std::size_t>> chunks_; // with their numbers of blocks
  std::size_t left_ = 0;                                   // in the last chunk
};

} // namespace CGAL::Shape_correspondence::internal
