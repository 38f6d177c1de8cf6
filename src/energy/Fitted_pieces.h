// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "energy/Deformable_shape.h"
#include "energy/Piece_list.h"
#include "energy/deform_to_fit.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL::Shape_correspondence::internal {

// A source piece after it was fitted to a target piece.
struct Fitted_piece
{
  Piece source, target;
  std::size_t source_index, target_index; // of the pieces
  const std::vector<int>* order;          // of `deform_to_fit()`
  int repeats;                            // of the source's samples: e where a curve becomes a sheet of equal columns
  std::size_t source_lanes;               // `Fitted_pieces::source_samples()`
  std::size_t lanes;                      // `Fitted_pieces::samples()`
};

// Indices of fitted pieces.
struct Fitted_range
{
  const std::uint32_t *first, *last;
  const std::uint32_t* begin() const { return first; }
  const std::uint32_t* end() const { return last; }
  std::size_t size() const { return std::size_t(last - first); }
  bool empty() const { return first == last; }
};

// All that the labels of groups ask to be fitted, every two pieces once, those of a source part together.
class Fitted_pieces
{
public:
  // \param labels by source group
  Fitted_pieces(const Aligned_shape& source, const Deformable_shape& target,
                const std::vector<std::vector<Group_label>>& labels);

  const Fitted_piece& operator[](std::size_t index) const { return fitted_[index]; }
  // The first one of a source part; one more part is the end.
  std::size_t begin_of(std::size_t part) const { return fitted_begin_[part]; }
  // What a source part is fitted to when it has a label.
  Fitted_range images(std::size_t part, std::size_t label) const
  {
    const std::size_t i = label_begin_[part] + label;
    return {images_.data() + image_begin_[i], images_.data() + image_begin_[i + 1]};
  }
  // What of that touches at a sample of the part: all clones, or the one segment.
  Fitted_range touching(std::size_t part, std::size_t sample, std::size_t label) const;

  const Sampled_part& source_piece(std::size_t index) const { return source_pieces_[index]; }
  // The samples of the source piece, as often as they count.
  const Sample_lanes& source_samples(const Fitted_piece& fitted) const { return source_lanes_[fitted.source_lanes]; }
  const Sampled_part& target_piece(std::size_t index) const { return target_pieces_[index]; }
  // `Fitted_piece::target_index` are less than this.
  std::size_t number_of_target_pieces() const { return target_pieces_.size(); }
  // The samples of the target piece in the order in which the source piece takes them.
  const Sample_lanes& samples(const Fitted_piece& fitted) const { return lanes_[fitted.lanes]; }
  // `Fitted_piece::lanes` are less than this.
  std::size_t number_of_lanes() const { return lanes_.size(); }
  // The least distance of two target pieces. Those of whole parts are known.
  double target_distance(const Fitted_piece& first, const Fitted_piece& second) const
  {
    if (first.target.is_whole() && second.target.is_whole())
      return part_distances_(Eigen::Index(first.target.part), Eigen::Index(second.target.part));
    return least_distance(samples(first), int(first.order->size()), samples(second), int(second.order->size()));
  }
  // E_c of two fitted pieces, `rods` those between their sources.
  double connectedness(const Structural_rods& rods, const Fitted_piece& first, const Fitted_piece& second) const
  {
    if (overlap(first.target, second.target)) return collapsed_connectedness;
    return rods.connectedness(target_distance(first, second));
  }

private:
  std::uint32_t fit(const Piece_image& image);
  std::size_t source_lanes_of(std::size_t source_piece, int repeats);
  std::size_t lanes_of(std::size_t target_piece, const std::vector<int>& order);

  Piece_list source_pieces_, target_pieces_;
  const Eigen::MatrixXd& part_distances_; // of the target
  std::vector<Fitted_piece> fitted_;
  std::vector<std::size_t> fitted_begin_; // by part
  std::vector<Sample_lanes> source_lanes_, lanes_;
  std::vector<std::array<std::size_t, 2>>
      source_lanes_at_; // by source piece, those of samples that count once or often
  std::vector<std::vector<std::pair<const std::vector<int>*, std::size_t>>> lanes_of_; // by target piece and order
  std::vector<std::size_t> label_begin_;                                               // by part, in `image_begin_`
  std::vector<std::size_t> image_begin_; // by part and label, in `images_`
  std::vector<std::uint32_t> images_;    // fitted pieces
};

} // namespace CGAL::Shape_correspondence::internal
