// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "energy/cut_curves.h"
#include "energy/divide_sheets.h"

#include <cstddef>
#include <vector>

namespace CGAL::Shape_correspondence::internal {

// The parts of a shape, then the pieces of parts that were asked for, each numbered once.
class Piece_list
{
public:
  explicit Piece_list(const Aligned_shape& shape) : parts_(&shape.parts), of_part_(shape.parts.size()) {}

  std::size_t size() const { return parts_->size() + pieces_.size(); }

  std::size_t index(const Piece& piece)
  {
    if (piece.is_whole()) return piece.part;
    for (std::size_t known : of_part_[piece.part])
      if (pieces_[known].piece == piece) return parts_->size() + known;
    const Sampled_part& part = (*parts_)[piece.part];
    of_part_[piece.part].push_back(pieces_.size());
    pieces_.push_back(
        {piece, piece.is_segment() ? segment(part, piece.index, piece.count) : rectangle(part, piece.low, piece.high)});
    return size() - 1;
  }

  const Sampled_part& operator[](std::size_t index) const
  {
    return index < parts_->size() ? (*parts_)[index] : pieces_[index - parts_->size()].samples;
  }

private:
  struct Sampled_piece
  {
    Piece piece;
    Sampled_part samples;
  };

  const std::vector<Sampled_part>* parts_;
  std::vector<Sampled_piece> pieces_;
  std::vector<std::vector<std::size_t>> of_part_; // pieces, by part
};

} // namespace CGAL::Shape_correspondence::internal
