// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "energy/Deformable_shape.h"
#include "energy/Rod_memory.h"

#include <atomic>
#include <mutex>
#include <utility>
#include <vector>

namespace CGAL::Shape_correspondence {
using namespace internal;

// What is found when it is first asked for. Without std::call_once(), which makes a system call whenever something is
// found, even if no thread waits: for rods, that takes longer than to find them.
struct Deformable_shape::Measures
{
  struct Lazy_rods
  {
    std::atomic<bool> is_found{false};
    Structural_rods rods;
  };

  explicit Measures(std::size_t contacts) : rods(new Lazy_rods[4 * contacts]) {}

  // Calls `find` unless that was done before.
  template <typename Find>
  void find_once(std::atomic<bool>& is_found, const Find& find)
  {
    if (is_found.load(std::memory_order_acquire)) return;
    const std::lock_guard<std::mutex> lock(mutex);
    if (is_found.load(std::memory_order_relaxed)) return;
    find();
    is_found.store(true, std::memory_order_release);
  }

  std::mutex mutex;
  std::unique_ptr<Lazy_rods[]> rods; // at 4 contact + 2 (first repeated) + (second repeated)
  Rod_memory memory;                 // where their directions are
  std::atomic<bool> has_distances{false};
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

} // namespace

Deformable_shape::Deformable_shape(Aligned_shape shape)
    : Aligned_shape(std::move(shape)), measures_(std::make_shared<Measures>(contacts.size()))
{}

const Structural_rods& Deformable_shape::rods(std::size_t contact, int first_repeats, int second_repeats) const
{
  Measures::Lazy_rods& lazy = measures_->rods[4 * contact + (first_repeats > 1 ? 2 : 0) + (second_repeats > 1 ? 1 : 0)];
  measures_->find_once(lazy.is_found, [&] {
    const auto& ends = contacts[contact].parts;
    const Points &first = parts[ends[0]].samples, &second = parts[ends[1]].samples;
    const int n = int(first.cols()) * first_repeats, m = int(second.cols()) * second_repeats;
    lazy.rods =
        Structural_rods(Sample_lanes(first, first_repeats), n, first_repeats, Sample_lanes(second, second_repeats), m,
                        second_repeats, measures_->memory.take(Structural_rods::size(n, m)));
  });
  return lazy.rods;
}

const Eigen::MatrixXd& Deformable_shape::part_distances() const
{
  measures_->find_once(measures_->has_distances, [&] { measures_->distances = least_distances(parts); });
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
