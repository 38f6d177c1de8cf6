// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "base/deadline.h"
#include "energy/Structural_rods.h"
#include "energy/match_groups.h"
#include "structure/align_shapes.h"

#include <Eigen/Core>
#include <boost/range/iterator_range.hpp>

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL::Shape_correspondence {

/// A source or target shape with the quantities that the energy needs of it alone: structural rods and distances of
/// parts, computed on demand and shared by copies, so that repeated matches compute them once. Thread-safe.
class Deformable_shape : public Aligned_shape
{
public:
  explicit Deformable_shape(Aligned_shape shape);

  /// The structural rods of a contact. Each sample of a part is used as often as its `repeats` say: `samples_per_side`
  /// times if a curve becomes a sheet, else once.
  const Structural_rods& rods(std::size_t contact, int first_repeats, int second_repeats) const;
  /// The matrix of the least distances between the samples of every two parts.
  const Eigen::MatrixXd& part_distances() const;

  /// A copy in which every part is a group.
  Deformable_shape ungrouped() const;
  /// A copy in which each of the sets of parts is a group.
  Deformable_shape regrouped(const std::vector<std::vector<std::size_t>>& sets) const;

private:
  struct Measures;

  std::shared_ptr<Measures> measures_;
};

} // namespace CGAL::Shape_correspondence

namespace CGAL::Shape_correspondence::internal {

// Numbers the parts of a shape, and then the pieces of parts that are added to it, each piece once.
class Piece_list
{
public:
  explicit Piece_list(const Aligned_shape& shape) : parts_(&shape.parts), pieces_of_(shape.parts.size()) {}

  std::size_t size() const { return parts_->size() + pieces_.size(); }
  std::size_t index(const Piece& piece);
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
  std::vector<std::vector<std::size_t>> pieces_of_; // indices of pieces, by part
};

// A source piece after it was deformed to fit a target piece.
struct Fitted_piece
{
  Piece source, target;
  std::size_t source_index, target_index; // indices in `source_pieces_` and `target_pieces_`
  int samples;                            // number of samples, with repetitions
  int repeats;       // uses per source sample: `samples_per_side` where a curve becomes a sheet, else 1
  std::size_t lanes; // index of its deformed samples in `lanes_` and `points_`
};

using Fitted_range = boost::iterator_range<const std::uint32_t*>;

// All distinct pairs of pieces that the labels of groups deform into each other, ordered by source part.
class Fitted_pieces
{
public:
  // \param labels the candidate images of each source group \throw Out_of_time
  Fitted_pieces(const Aligned_shape& source, const Deformable_shape& target,
                const std::vector<std::vector<Group_label>>& labels, Deform_to_fit how, const Deadline& deadline);

  // Whether a fitted piece has the samples of its target piece, shared by all pieces fitted to that target.
  bool takes_samples() const { return fit_ == Deform_to_fit::SAMPLES; }

  const Fitted_piece& operator[](std::size_t index) const { return fitted_[index]; }
  // Index of the first fitted piece of a source part; for the number of parts, the end.
  std::size_t begin_of(std::size_t part) const { return fitted_begin_[part]; }
  // The fitted pieces of a source part under a label of its group, one for each clone or each piece that it is cut
  // into.
  Fitted_range images(std::size_t part, std::size_t label) const
  {
    const std::size_t i = label_begin_[part] + label;
    return {images_.data() + image_begin_[i], images_.data() + image_begin_[i + 1]};
  }
  // The images of a part near one of its samples: all clones, or the one segment with the sample.
  Fitted_range touching(std::size_t part, std::size_t sample, std::size_t label) const;

  const Sampled_part& source_piece(std::size_t index) const { return source_pieces_[index]; }
  // The samples of a source piece after the deformation, in the order that they had before.
  const Sample_lanes& samples(const Fitted_piece& fitted) const { return lanes_[fitted.lanes]; }
  const Points& points(const Fitted_piece& fitted) const { return points_[fitted.lanes]; }
  std::size_t number_of_lanes() const { return lanes_.size(); }
  std::size_t number_of_target_pieces() const { return target_pieces_.size(); }
  // The least distance of two fitted pieces; for whole target parts it is looked up.
  double distance(const Fitted_piece& first, const Fitted_piece& second) const
  {
    if (takes_samples() && first.target.is_whole() && second.target.is_whole())
      return part_distances_(Eigen::Index(first.target.part), Eigen::Index(second.target.part));
    return least_distance(samples(first), first.samples, samples(second), second.samples);
  }

private:
  std::uint32_t fit(const Piece_image& image);
  std::size_t lanes_of(std::size_t source_piece, std::size_t target_piece);

  Deform_to_fit fit_;
  Piece_list source_pieces_, target_pieces_;
  const Eigen::MatrixXd& part_distances_; // distances of the target's parts
  std::vector<Fitted_piece> fitted_;
  std::vector<std::size_t> fitted_begin_; // for each source part, its first fitted piece; then their number
  std::vector<Sample_lanes> lanes_;
  std::vector<Points> points_; // same indices as `lanes_`
  // Index in `lanes_`, by target piece and by the order of its samples from `match_extremities()`
  std::map<std::pair<std::size_t, const std::vector<int>*>, std::size_t> lanes_of_;
  std::vector<std::size_t> label_begin_; // for each source part, the index in `image_begin_` of its first label
  std::vector<std::size_t> image_begin_; // by source part and label, the index in `images_` of the first image
  std::vector<std::uint32_t> images_;    // indices of fitted pieces, by source part, label and image
};

} // namespace CGAL::Shape_correspondence::internal
