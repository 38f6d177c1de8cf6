// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "energy/Fitted_pieces.h"
#include "base/Once.h"
#include "energy/Structural_rods.h"
#include "energy/cut_parts.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace CGAL::Shape_correspondence {
using namespace internal;

struct Deformable_shape::Measures
{
  struct Lazy_rods
  {
    Once is_found;
    Structural_rods rods;
  };

  explicit Measures(std::size_t contacts) : rods(new Lazy_rods[4 * contacts]) {}

  std::unique_ptr<Lazy_rods[]> rods; // index: 4 contact + 2 (first part is repeated) + (second part is repeated)
  Once has_distances;
  Eigen::MatrixXd distances;
};

namespace {

Eigen::MatrixXd least_distances(const std::vector<Sampled_part>& parts)
{
  const Eigen::Index n = Eigen::Index(parts.size());
  std::vector<Sample_lanes> lanes;
  for (const Sampled_part& part : parts)
    lanes.emplace_back(part.samples);
  Eigen::MatrixXd result = Eigen::MatrixXd::Zero(n, n);
  for (Eigen::Index i = 0; i < n; ++i)
    for (Eigen::Index j = 0; j < i; ++j) {
      const std::size_t a = std::size_t(i), b = std::size_t(j);
      result(i, j) = result(j, i) =
          least_distance(lanes[a], int(parts[a].samples.cols()), lanes[b], int(parts[b].samples.cols()));
    }
  return result;
}

// Index of the one of `count` equally long segments of a curve that contains a sample of the curve.
int segment_of_sample(std::size_t sample, int count)
{
  return std::min(count - 1, int(sample) * count / (samples_per_side - 1));
}

} // namespace

Deformable_shape::Deformable_shape(Aligned_shape shape)
    : Aligned_shape(std::move(shape)), measures_(std::make_shared<Measures>(contacts.size()))
{}

const Structural_rods& Deformable_shape::rods(std::size_t contact, int first_repeats, int second_repeats) const
{
  Measures::Lazy_rods& lazy = measures_->rods[4 * contact + (first_repeats > 1 ? 2 : 0) + (second_repeats > 1 ? 1 : 0)];
  lazy.is_found([&] {
    const auto& ends = contacts[contact].parts;
    lazy.rods = Structural_rods(parts[ends[0]].samples, parts[ends[1]].samples, first_repeats, second_repeats);
  });
  return lazy.rods;
}

const Eigen::MatrixXd& Deformable_shape::part_distances() const
{
  measures_->has_distances([&] { measures_->distances = least_distances(parts); });
  return measures_->distances;
}

Deformable_shape Deformable_shape::ungrouped() const
{
  Deformable_shape result(Shape_correspondence::ungrouped(*this));
  result.measures_ = measures_;
  return result;
}

Deformable_shape Deformable_shape::regrouped(const std::vector<std::vector<std::size_t>>& sets) const
{
  Deformable_shape result(Shape_correspondence::regrouped(*this, sets));
  result.measures_ = measures_;
  return result;
}

} // namespace CGAL::Shape_correspondence

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

// Returns the index of the fitted piece of an image of the last part; adds it if it is new.
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
