// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SHAPE_CORRESPONDENCE_ENERGY_FITTED_PIECES_H
#define CGAL_SHAPE_CORRESPONDENCE_ENERGY_FITTED_PIECES_H

#include "energy/Deformable_shape.h"
#include "energy/Piece_list.h"
#include "energy/deform_to_fit.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Shape_correspondence {
namespace internal {

// A source piece after it was fitted to a target piece.
struct Fitted_piece
{
  Piece source, target;
  std::size_t source_index, target_index; // of the pieces
  const std::vector<int>* order;          // of `deform_to_fit()`
  bool lifted;                            // a source curve among sheets: it has a sheet's number of samples
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
  const Sampled_part& target_piece(std::size_t index) const { return target_pieces_[index]; }
  // The samples of the target piece in the order in which the source piece takes them.
  const Sample_lanes& samples(const Fitted_piece& fitted) const { return lanes_[fitted.lanes]; }
  // `Fitted_piece::lanes` are less than this.
  std::size_t number_of_lanes() const { return lanes_.size(); }
  // The least distance of two target pieces.
  double target_distance(const Fitted_piece& first, const Fitted_piece& second) const
  {
    return target_distances_(Eigen::Index(first.target_index), Eigen::Index(second.target_index));
  }
  // E_c of two fitted pieces, `rods` those between their sources.
  double connectedness(const Structural_rods& rods, const Fitted_piece& first, const Fitted_piece& second) const
  {
    if (first.target_index == second.target_index) return collapsed_connectedness;
    return rods.connectedness(target_distance(first, second));
  }

private:
  std::uint32_t fit(const Image& image);
  std::size_t lanes_of(std::size_t target_piece, const std::vector<int>& order);
  void measure_target_pieces(const Deformable_shape& target);

  Piece_list source_pieces_, target_pieces_;
  Eigen::MatrixXd target_distances_;
  std::vector<Fitted_piece> fitted_;
  std::vector<std::size_t> fitted_begin_; // by part
  std::vector<Sample_lanes> lanes_;
  std::vector<std::vector<std::pair<const std::vector<int>*, std::size_t>>> lanes_of_; // by target piece and order
  std::vector<std::size_t> label_begin_;                                               // by part, in `image_begin_`
  std::vector<std::size_t> image_begin_; // by part and label, in `images_`
  std::vector<std::uint32_t> images_;    // fitted pieces
};

// Which of `count` segments of a curve a sample of it is on.
inline int segment_of_sample(std::size_t sample, int count)
{
  return std::min(count - 1, int(sample) * count / (samples_per_side - 1));
}

inline Fitted_pieces::Fitted_pieces(const Aligned_shape& source, const Deformable_shape& target,
                                    const std::vector<std::vector<Group_label>>& labels)
    : source_pieces_(source), target_pieces_(target)
{
  for (std::size_t part = 0; part < source.parts.size(); ++part) {
    const std::size_t group = source.group_of[part];
    const auto& parts = source.groups[group].parts;
    const std::size_t member = std::size_t(std::find(parts.begin(), parts.end(), part) - parts.begin());
    fitted_begin_.push_back(fitted_.size());
    label_begin_.push_back(image_begin_.size());
    for (const Group_label& label : labels[group]) {
      image_begin_.push_back(images_.size());
      for (const Image& image : label.images[member])
        images_.push_back(fit(image));
    }
  }
  fitted_begin_.push_back(fitted_.size());
  image_begin_.push_back(images_.size());
  measure_target_pieces(target);
}

// The index of a fitted piece among those of its part, the last part that has any.
inline std::uint32_t Fitted_pieces::fit(const Image& image)
{
  const std::size_t from = source_pieces_.index(image.source), to = target_pieces_.index(image.target);
  for (std::size_t known = fitted_begin_.back(); known < fitted_.size(); ++known)
    if (fitted_[known].source_index == from && fitted_[known].target_index == to) return std::uint32_t(known);
  const std::vector<int>& order = deform_to_fit(source_pieces_[from], target_pieces_[to]);
  const bool lifted = Eigen::Index(order.size()) != source_pieces_[from].samples.cols();
  fitted_.push_back({image.source, image.target, from, to, &order, lifted, lanes_of(to, order)});
  return std::uint32_t(fitted_.size() - 1);
}

inline std::size_t Fitted_pieces::lanes_of(std::size_t target_piece, const std::vector<int>& order)
{
  if (lanes_of_.size() <= target_piece) lanes_of_.resize(target_pieces_.size());
  for (const auto& known : lanes_of_[target_piece])
    if (known.first == &order) return known.second;
  lanes_of_[target_piece].emplace_back(&order, lanes_.size());
  lanes_.push_back(Sample_lanes(target_pieces_[target_piece].samples, order));
  return lanes_.size() - 1;
}

inline Fitted_range Fitted_pieces::touching(std::size_t part, std::size_t sample, std::size_t label) const
{
  const Fitted_range clones = images(part, label);
  for (const std::uint32_t& image : clones) {
    const Piece& piece = fitted_[image].source;
    if (piece.count > 1 && piece.index == segment_of_sample(sample, piece.count)) return {&image, &image + 1};
  }
  return clones;
}

// Those of whole parts are known.
inline void Fitted_pieces::measure_target_pieces(const Deformable_shape& target)
{
  const Eigen::Index parts = Eigen::Index(target_pieces_.number_of_parts()), n = Eigen::Index(target_pieces_.size());
  target_distances_ = target.part_distances();
  if (n == parts) return;
  target_distances_.conservativeResize(n, n);
  std::vector<Sample_lanes> lanes;
  for (Eigen::Index i = 0; i < n; ++i) {
    const Points& samples = target_pieces_[std::size_t(i)].samples;
    lanes.emplace_back(samples);
    for (Eigen::Index j = 0; i >= parts && j <= i; ++j)
      target_distances_(i, j) = target_distances_(j, i) = least_distance(
          lanes.back(), int(samples.cols()), lanes[std::size_t(j)], int(target_pieces_[std::size_t(j)].samples.cols()));
  }
}

} // namespace internal
} // namespace Shape_correspondence
} // namespace CGAL

#endif // CGAL_SHAPE_CORRESPONDENCE_ENERGY_FITTED_PIECES_H
