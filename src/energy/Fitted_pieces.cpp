// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "energy/Fitted_pieces.h"
#include "energy/cut_parts.h"
#include "energy/deform_to_fit.h"

#include <algorithm>

namespace CGAL::Shape_correspondence::internal {

std::size_t Piece_list::index(const Piece& piece)
{
  if (piece.is_whole()) return piece.part;
  for (std::size_t known : pieces_of_[piece.part])
    if (pieces_[known].piece == piece) return parts_->size() + known;
  const Sampled_part& part = (*parts_)[piece.part];
  pieces_of_[piece.part].push_back(pieces_.size());
  pieces_.push_back(
      {piece, piece.is_segment() ? segment(part, piece.index, piece.count) : rectangle(part, piece.low, piece.high)});
  return size() - 1;
}

namespace {

// Index of the one of `count` equally long segments of a curve that contains a sample of the curve.
int segment_of_sample(std::size_t sample, int count)
{
  return std::min(count - 1, int(sample) * count / (samples_per_side - 1));
}

} // namespace

Fitted_pieces::Fitted_pieces(const Aligned_shape& source, const Deformable_shape& target,
                             const std::vector<std::vector<Group_label>>& labels, Deform_to_fit how,
                             const Deadline& deadline)
    : fit_(how), source_pieces_(source), target_pieces_(target), part_distances_(target.part_distances())
{
  lanes_.reserve(target.parts.size());
  for (std::size_t part = 0; part < source.parts.size(); ++part) {
    const std::size_t group = source.group_of[part];
    const auto& parts = source.group(group).parts;
    const std::size_t member = std::size_t(std::find(parts.begin(), parts.end(), part) - parts.begin());
    fitted_begin_.push_back(fitted_.size());
    label_begin_.push_back(image_begin_.size());
    for (const Group_label& label : labels[group]) {
      deadline.check();
      image_begin_.push_back(images_.size());
      for (const Piece_image& image : label.images[member])
        images_.push_back(fit(image));
    }
  }
  fitted_begin_.push_back(fitted_.size());
  image_begin_.push_back(images_.size());
}

// Returns the index of a fitted piece of the last part.
std::uint32_t Fitted_pieces::fit(const Piece_image& image)
{
  const std::size_t from = source_pieces_.index(image.source), to = target_pieces_.index(image.target);
  for (std::size_t known = fitted_begin_.back(); known < fitted_.size(); ++known)
    if (fitted_[known].source_index == from && fitted_[known].target_index == to) return std::uint32_t(known);
  const std::size_t lanes = lanes_of(from, to);
  const int samples = int(points_[lanes].cols()), repeats = samples / int(source_pieces_[from].samples.cols());
  fitted_.push_back({image.source, image.target, from, to, samples, repeats, lanes});
  return std::uint32_t(fitted_.size() - 1);
}

std::size_t Fitted_pieces::lanes_of(std::size_t source_piece, std::size_t target_piece)
{
  const Sampled_part &source = source_pieces_[source_piece], &target = target_pieces_[target_piece];
  if (!takes_samples()) {
    points_.push_back(deform_to_fit(source, target, fit_));
    lanes_.emplace_back(points_.back());
    return lanes_.size() - 1;
  }
  const std::vector<int>& order = match_extremities(source, target);
  const auto [known, is_new] = lanes_of_.try_emplace({target_piece, &order}, lanes_.size());
  if (!is_new) return known->second;
  points_.push_back(ordered_samples(target, order));
  lanes_.emplace_back(points_.back());
  return lanes_.size() - 1;
}

Fitted_range Fitted_pieces::touching(std::size_t part, std::size_t sample, std::size_t label) const
{
  const Fitted_range clones = images(part, label);
  for (const std::uint32_t& image : clones) {
    const Piece& piece = fitted_[image].source;
    if (piece.is_segment() && piece.index == segment_of_sample(sample, piece.count)) return {&image, &image + 1};
  }
  return clones;
}

} // namespace CGAL::Shape_correspondence::internal
