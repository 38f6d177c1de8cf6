// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "energy/Structural_rods.h"
#include "base/quantized.h"
#include "energy/deform_to_fit.h"

#include <CGAL/Shape_correspondence/Deformation_energy.h>
#include <CGAL/assertions.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <mutex>

namespace CGAL::Shape_correspondence {
using namespace internal;

namespace {

// E_d, rounded to 0 where the mean squared cosine is 1 up to rounding, so that rigid motion costs nothing.
double rounded_distortion(double mean_squared_cosine)
{
  return mean_squared_cosine > 1 - comparison_grid ? 0 : distortion_energy(mean_squared_cosine);
}

// A pool of memory for rods, which is reused since the system zeroes new memory, which takes long. Thread-safe.
class Rod_pool
{
public:
  Rod_block* take(std::size_t blocks)
  {
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      Free*& first = free_[blocks]; // inserts the key now, so that give_back() never allocates
      if (Free* const taken = first) {
        first = taken->next;
        return reinterpret_cast<Rod_block*>(taken);
      }
    }
    return static_cast<Rod_block*>(::operator new(blocks * sizeof(Rod_block), std::align_val_t(alignof(Rod_block))));
  }

  // \param blocks the number passed to take()
  void give_back(Rod_block* memory, std::size_t blocks)
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    Free*& first = free_[blocks];
    first = new (static_cast<void*>(memory)) Free{first};
  }

private:
  struct Free
  {
    Free* next;
  };

  std::mutex mutex_;
  std::map<std::size_t, Free*> free_; // free lists by number of blocks
};

Rod_pool& rod_pool()
{
  static auto* const pool = new Rod_pool; // never destroyed, so that it outlives static shapes
  return *pool;
}

} // namespace

void internal::Rod_deleter::operator()(Rod_block* rods) const { rod_pool().give_back(rods, blocks); }

Rod_energy rod_energy(const Points& first, const Points& second, const Points& moved_first, const Points& moved_second)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  double squared_cosines = 0, shortest = infinity, shortest_after = infinity, longest = 0;
  for (Eigen::Index i = 0; i < first.cols(); ++i)
    for (Eigen::Index j = 0; j < second.cols(); ++j) {
      const Point before = second.col(j) - first.col(i), after = moved_second.col(j) - moved_first.col(i);
      const double cosine = rod_rotation(before, after);
      squared_cosines += cosine * cosine;
      shortest = std::min(shortest, before.norm());
      longest = std::max(longest, before.norm());
      shortest_after = std::min(shortest_after, after.norm());
    }
  return {rounded_distortion(squared_cosines / double(first.cols() * second.cols())),
          connectedness_energy(shortest, shortest_after, longest)};
}

Structural_rods::Structural_rods(const Points& first, const Points& second, int first_repeats, int second_repeats)
    : Structural_rods(Sample_lanes(repeated(first, first_repeats)), int(first.cols()) * first_repeats,
                      Sample_lanes(repeated(second, second_repeats)), int(second.cols()) * second_repeats)
{}

Structural_rods::Structural_rods(const Sample_lanes& first, int n, const Sample_lanes& second, int m)
    : first_count_(n), second_count_(m)
{
  CGAL_precondition(n <= maximum_samples && m <= maximum_samples);
  const auto blocks = std::size_t(blocks_of_rods(n, m));
  rods_ = {rod_pool().take(blocks), {blocks}};
  const Rod_lengths lengths = write_rods(first, n, second, m, rods_.get());
  zero_ = lengths.zero;
  shortest_ = std::sqrt(double(lengths.shortest_squared));
  longest_ = std::sqrt(double(lengths.longest_squared));
}

// A rod of length zero counts as not rotated.
double Structural_rods::distortion(float squared_cosines) const
{
  return rounded_distortion((zero_ + double(squared_cosines)) * (1 / double(first_count_ * second_count_)));
}

void distortions(const std::vector<const Structural_rods*>& pairs, const Sample_lanes& first,
                 const Sample_lanes& second, std::vector<double>& result)
{
  result.resize(pairs.size());
  for (std::size_t done = 0; done < pairs.size();) {
    const bool are_two = done + 1 < pairs.size();
    const Rod_block* const rods[2] = {pairs[done]->rods_.get(), are_two ? pairs[done + 1]->rods_.get() : nullptr};
    const Rod_comparison moved = (are_two ? compare_rods_of_two : compare_rods_of_one)(
        rods, first, pairs[0]->first_count_, second, pairs[0]->second_count_);
    for (std::size_t i = 0; i < (are_two ? 2 : 1); ++i, ++done)
      result[done] = pairs[done]->distortion(moved.squared_cosines[i]);
  }
}

double Structural_rods::connectedness(double distance) const
{
  return connectedness_energy(shortest_, distance, longest_);
}

Rod_energy Structural_rods::energy(const Sample_lanes& first, const Sample_lanes& second) const
{
  const Rod_block* const before = rods_.get();
  const Rod_comparison moved = compare_rods_and_length(&before, first, first_count_, second, second_count_);
  return {distortion(moved.squared_cosines[0]), connectedness(std::sqrt(double(moved.least_squared_length)))};
}

Rod_energy Structural_rods::energy(const Points& first, const Points& second) const
{
  CGAL_precondition(first.cols() == first_count_ && second.cols() == second_count_);
  return energy(Sample_lanes(first), Sample_lanes(second));
}

double least_distance(const Sample_lanes& first, int n, const Sample_lanes& second, int m)
{
  return std::sqrt(double(least_length_of_rods(nullptr, first, n, second, m).least_squared_length));
}

} // namespace CGAL::Shape_correspondence
