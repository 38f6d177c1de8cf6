// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "energy/Structural_rods.h"
#include "base/quantized.h"

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

constexpr int samples_of_sheet = samples_per_side * samples_per_side;

using Kind = Sampled_part::Kind;
using Permutation = std::vector<int>;

// The 2 orders of the samples of an open curve; the 2 e orders of a closed one, which may begin with any sample.
std::vector<Permutation> curve_orders(bool closed)
{
  constexpr int e = samples_per_side;
  std::vector<Permutation> result;
  for (int start = 0; start < (closed ? e : 1); ++start)
    for (int step : {1, -1}) {
      Permutation order(e);
      for (int i = 0; i < e; ++i)
        order[std::size_t(i)] = ((step > 0 ? i : e - 1 - i) + start) % e;
      result.push_back(order);
    }
  return result;
}

// The 8 symmetries of a square grid.
std::vector<Permutation> sheet_orders()
{
  constexpr int e = samples_per_side;
  std::vector<Permutation> result;
  for (int transposed : {0, 1})
    for (int flip_u : {0, 1})
      for (int flip_v : {0, 1}) {
        Permutation order(samples_of_sheet);
        for (int i = 0; i < e; ++i)
          for (int j = 0; j < e; ++j) {
            const int u = flip_u ? e - 1 - i : i, v = flip_v ? e - 1 - j : j;
            order[std::size_t(i * e + j)] = transposed ? v * e + u : u * e + v;
          }
        result.push_back(order);
      }
  return result;
}

// The candidate orders of samples for two parts, and the samples by which the orders are compared.
struct Fits
{
  std::vector<Permutation> orders;
  std::vector<int> extremities; // ends of a curve, corners of a sheet, all samples of a closed curve
};

const Fits& fits_of(const Sampled_part& source, const Sampled_part& target)
{
  constexpr int e = samples_per_side;
  static const Fits open{curve_orders(false), {0, e - 1}}, closed{curve_orders(true), curve_orders(false)[0]},
      sheet{sheet_orders(), {0, e - 1, samples_of_sheet - e, samples_of_sheet - 1}};
  const auto any_is = [&](Kind kind) { return source.kind == kind || target.kind == kind; };
  return any_is(Kind::SHEET) ? sheet : any_is(Kind::CLOSED_CURVE) ? closed : open;
}

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

  // Frees memory for reuse. \param blocks the number passed to take()
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

const std::vector<int>& match_extremities(const Sampled_part& source, const Sampled_part& target)
{
  const auto& [orders, extremities] = fits_of(source, target);
  const auto from_centre = [count = orders[0].size(), &extremities = extremities](const Sampled_part& part) {
    const int repeats = int(count) / int(part.samples.cols()); // e for a curve fitted to a sheet, else 1
    Eigen::Matrix<double, 3, Eigen::Dynamic, 0, 3, samples_per_side> result(3, Eigen::Index(extremities.size()));
    for (Eigen::Index k = 0; k < result.cols(); ++k)
      result.col(k) = part.samples.col(extremities[std::size_t(k)] / repeats) - part.centroid;
    return result;
  };
  const auto from = from_centre(source), to = from_centre(target);
  const Permutation* best = nullptr;
  Steps best_score = 0; // sum of dot products, greatest where the sum of squared distances is least
  for (const Permutation& order : orders) {
    double sum = 0;
    for (Eigen::Index k = 0; k < from.cols(); ++k) {
      const int image = order[std::size_t(extremities[std::size_t(k)])]; // an extremity as well
      sum += from.col(k).dot(to.col(std::find(extremities.begin(), extremities.end(), image) - extremities.begin()));
    }
    const Steps score = quantized(sum);
    if (!best || score > best_score) best = &order, best_score = score;
  }
  return *best;
}

Points ordered_samples(const Sampled_part& target, const std::vector<int>& order)
{
  const int repeats = int(order.size()) / int(target.samples.cols());
  Points result(3, Eigen::Index(order.size()));
  for (Eigen::Index i = 0; i < result.cols(); ++i)
    result.col(i) = target.samples.col(order[std::size_t(i)] / repeats);
  return result;
}

Points deform_to_fit(const Sampled_part& source, const Sampled_part& target, Deform_to_fit fit)
{
  const Permutation& order = match_extremities(source, target);
  Points result = ordered_samples(target, order);
  const std::vector<int>& extremities = fits_of(source, target).extremities;
  if (fit == Deform_to_fit::SAMPLES || extremities.size() == order.size()) return result;

  const Points from = repeated(source.samples, int(result.cols() / source.samples.cols()));
  const Points displacement = result - from;
  result = from;
  constexpr int e = samples_per_side;
  for (Eigen::Index i = 0; i < result.cols(); ++i) {
    const double u = double(i % e) / (e - 1), v = double(i / e) / (e - 1); // v is 0 on a curve
    const double weights[] = {(1 - u) * (1 - v), u * (1 - v), (1 - u) * v, u * v};
    for (std::size_t k = 0; k < extremities.size(); ++k)
      result.col(i) += weights[k] * displacement.col(extremities[k]);
  }
  return result;
}

Points repeated(const Points& samples, int repeats)
{
  Points result(3, samples.cols() * repeats);
  for (Eigen::Index i = 0; i < result.cols(); ++i)
    result.col(i) = samples.col(i / repeats);
  return result;
}

using namespace internal;

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
