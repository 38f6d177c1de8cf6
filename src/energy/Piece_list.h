// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "energy/cut_curves.h"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL::Shape_correspondence::internal {

// The parts of a shape, then the segments of curves that were asked for, each numbered once.
class Piece_list
{
public:
  explicit Piece_list(const Aligned_shape& shape) : parts_(&shape.parts) {}

  std::size_t size() const { return parts_->size() + segments_.size(); }
  std::size_t number_of_parts() const { return parts_->size(); }

  std::size_t index(const Piece& piece)
  {
    if (piece.count == 1) return piece.part;
    // All segments of a cut follow each other
    const Piece first{piece.part, 0, piece.count};
    auto found = std::find(cuts_.begin(), cuts_.end(), first);
    std::size_t begin = 0;
    for (auto cut = cuts_.begin(); cut != found; ++cut)
      begin += std::size_t(cut->count);
    if (found == cuts_.end()) {
      cuts_.push_back(first);
      for (int i = 0; i < piece.count; ++i)
        segments_.push_back(segment((*parts_)[piece.part], i, piece.count));
    }
    return parts_->size() + begin + std::size_t(piece.index);
  }

  const Sampled_part& operator[](std::size_t index) const
  {
    return index < parts_->size() ? (*parts_)[index] : segments_[index - parts_->size()];
  }

private:
  const std::vector<Sampled_part>* parts_;
  std::vector<Piece> cuts_; // the first segment of each
  std::vector<Sampled_part> segments_;
};

} // namespace CGAL::Shape_correspondence::internal
