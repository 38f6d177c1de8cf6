// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "energy/Rod_memory.h"
#include "energy/Sample_lanes.h"

#include <CGAL/Shape_correspondence/Points.h>

#include <cstddef>
#include <vector>

namespace CGAL::Shape_correspondence {

/// E_d and E_c of one pair of connected parts.
struct Rod_energy
{
  double distortion = 0;
  double connectedness = 0;
};

/// E_c of two connected parts that become one and the same part, or overlapping pieces of one: the connection is lost,
/// the parts are not apart. The paper is silent; this is the authors' charge.
constexpr double collapsed_connectedness = 0.5;

/// The structural rods of a pair of connected parts before the deformation (paper, section 4.3): all vectors from a
/// sample of the first part to a sample of the second. Kept, since a pair meets many candidate deformations.
class Structural_rods
{
public:
  Structural_rods() = default;
  /// Rods between samples of which each counts `first_repeats` or `second_repeats` times: a curve counts as a sheet of
  /// equal columns. \pre either then has at most `samples_per_side`² samples
  Structural_rods(const Points& first, const Points& second, int first_repeats = 1, int second_repeats = 1);
  /// The same of samples of which the lanes already have as many as they count times, `first_count` and `second_count`
  /// in all, in memory that is not theirs and outlives them. \pre `memory` has `size()` blocks
  Structural_rods(const internal::Sample_lanes& first, int first_count, const internal::Sample_lanes& second,
                  int second_count, internal::Rod_block* memory);
  /// How many blocks of directions so many samples have.
  static std::size_t size(int first_count, int second_count);

  /// E_c (Eq. 4), `connectedness_energy()`, when the least distance of two samples is now `distance`.
  double connectedness(double distance) const;

  /// E_d and E_c after the samples moved to `first` and `second`.
  Rod_energy energy(const internal::Sample_lanes& first, const internal::Sample_lanes& second) const;
  Rod_energy energy(const Points& first, const Points& second) const;

private:
  Structural_rods(const Points& first, const Points& second, int first_repeats, int second_repeats,
                  internal::Own_rods memory);

  friend void distortions(const std::vector<const Structural_rods*>& pairs, const internal::Sample_lanes& first,
                          const internal::Sample_lanes& second, std::vector<double>& result);
  double distortion(float squared_cosines) const;

  internal::Own_rods memory_; // where it is theirs
  const internal::Rod_block* rods_ = nullptr;
  int first_count_ = 0, second_count_ = 0;
  double directionless_ = 0; // how many rods have length zero
  double share_ = 0;         // of one rod in the mean over all
  double shortest_ = 0;      // d
  double longest_ = 0;       // f
};

/// E_d (Eq. 3), `distortion_energy()`, of pairs of parts that all turn into the samples `first` and `second`, as many
/// as each of them had; cosines (Eq. 2) are summed in single precision. A rod of length zero keeps its direction
/// whatever happens; one that becomes zero loses it. 0 if the mean of squared cosines is 1 to within `comparison_grid`,
/// so that what does not move costs nothing. O(number of rods).
void distortions(const std::vector<const Structural_rods*>& pairs, const internal::Sample_lanes& first,
                 const internal::Sample_lanes& second, std::vector<double>& result);

/// The least distance between a sample of one part and a sample of another, in single precision. O(number of pairs).
double least_distance(const Points& first, const Points& second);
double least_distance(const internal::Sample_lanes& first, int first_count, const internal::Sample_lanes& second,
                      int second_count);

} // namespace CGAL::Shape_correspondence
