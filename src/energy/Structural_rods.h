// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "energy/rod_kernel.h"
#include "structure/Sampled_part.h"

#include <CGAL/Shape_correspondence/Energy_options.h>
#include <CGAL/Shape_correspondence/Points.h>

#include <cstddef>
#include <memory>
#include <vector>

namespace CGAL::Shape_correspondence {

/// Deform-to-fit (paper, section 5): the positions of the samples of `source` after it takes the shape of `target`.
/// With `SAMPLES` these are the target's samples in the order of `match_extremities()`; with `EXTREMITIES`, the
/// source's samples displaced by interpolation between its ends or corners. If one part is a sheet, there are
/// `samples_per_side`² samples.
Points deform_to_fit(const Sampled_part& source, const Sampled_part& target,
                     Deform_to_fit fit = Deform_to_fit::SAMPLES);

/// The first step of deform-to-fit: sample i of the source goes to sample `result[i]` of the target. After the centres
/// are aligned, extremities are matched by proximity: of the 2 directions of a curve, the 8 layouts of a sheet or the
/// 2 e orders of a closed curve (e = `samples_per_side`), the one with the least sum of squared distances of ends,
/// corners or samples. If one part is a sheet, a curve counts as a sheet of e equal columns: sample j of that sheet is
/// sample j / e of the curve. The result is an entry of a static table.
const std::vector<int>& match_extremities(const Sampled_part& source, const Sampled_part& target);

Points ordered_samples(const Sampled_part& target, const std::vector<int>& order);

/// Every sample repeated `repeats` times in a row, as for a curve that counts as a sheet of equal columns.
Points repeated(const Points& samples, int repeats);

namespace internal {

/// Returns the memory of rods to a pool shared by all shapes.
struct Rod_deleter
{
  std::size_t blocks = 0;
  void operator()(Rod_block* rods) const;
};

} // namespace internal

struct Rod_energy
{
  double distortion = 0;
  double connectedness = 0;
};

/// The value of E_c for two connected parts that become the same part, or overlapping pieces of one. The paper does not
/// define this case; the value is the one the authors' program uses.
constexpr double collapsed_connectedness = 0.5;

/// E_d and E_c of a pair of connected parts by Eqs. 2 to 4, from their samples before and after the deformation.
Rod_energy rod_energy(const Points& first, const Points& second, const Points& moved_first, const Points& moved_second);

/// The structural rods of a pair of connected parts before the deformation (paper, section 4.3): all vectors from a
/// sample of the first part to a sample of the second. The energies equal those of `rod_energy()` within single
/// precision; the rods are computed once for many deformations and compared with vector instructions.
class Structural_rods
{
public:
  Structural_rods() = default;
  /// The rods between samples repeated `first_repeats` and `second_repeats` times: a curve that becomes a sheet is
  /// repeated `samples_per_side` times. \pre each part has at most `samples_per_side`² samples
  Structural_rods(const Points& first, const Points& second, int first_repeats = 1, int second_repeats = 1);
  Structural_rods(const internal::Sample_lanes& first, int n, const internal::Sample_lanes& second, int m);

  std::size_t bytes() const { return rods_.get_deleter().blocks * sizeof(internal::Rod_block); }

  /// E_c (Eq. 4) if the least distance of the two parts after the deformation is `distance`.
  double connectedness(double distance) const;

  /// E_d and E_c after the samples of the two parts moved to `first` and `second`.
  Rod_energy energy(const internal::Sample_lanes& first, const internal::Sample_lanes& second) const;
  Rod_energy energy(const Points& first, const Points& second) const;

private:
  friend void distortions(const std::vector<const Structural_rods*>& pairs, const internal::Sample_lanes& first,
                          const internal::Sample_lanes& second, std::vector<double>& result);
  double distortion(float squared_cosines) const;

  std::unique_ptr<internal::Rod_block[], internal::Rod_deleter> rods_;
  int first_count_ = 0, second_count_ = 0;
  double zero_ = 0;     // number of rods of length zero
  double shortest_ = 0; // d of Eq. 4
  double longest_ = 0;  // f of Eq. 4
};

/// E_d (Eq. 3) for each of several pairs of parts that are deformed to the same samples `first` and `second`; all pairs
/// have equally many samples. O(number of rods).
void distortions(const std::vector<const Structural_rods*>& pairs, const internal::Sample_lanes& first,
                 const internal::Sample_lanes& second, std::vector<double>& result);

/// The least distance between a sample of one part and a sample of another, in single precision. O(number of pairs).
double least_distance(const internal::Sample_lanes& first, int n, const internal::Sample_lanes& second, int m);

} // namespace CGAL::Shape_correspondence
