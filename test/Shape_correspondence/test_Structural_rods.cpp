// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "energy/Structural_rods.h"
#include "hand_made_graphs.h"

#include <CGAL/Shape_correspondence/Deformation_energy.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <cstdlib>
#include <string>
#include <utility>

using namespace CGAL::Shape_correspondence;
using hand_made::points;
using internal::Sample_lanes;

TEST_CASE("Eq. 2 and 3: two rods, one turned by 60 degrees")
{
  const Structural_rods rods(points({{0, 0, 0}}), points({{2, 0, 0}, {0, 3, 0}}));
  const double c = 0.5, s = std::sqrt(3) / 2;
  // Lengths change as well, but only directions count
  const Rod_energy energy = rods.energy(points({{0, 0, 0}}), points({{4 * c, 4 * s, 0}, {0, 5, 0}}));
  // Eq. 3, where the cosines of the rotations of the rods are 1/2 and 1: 1 - sqrt((1/4 + 1) / 2)
  CHECK(energy.distortion == Approx(1 - std::sqrt(1.25 / 2)));
}

TEST_CASE("Eq. 2: a rod turned by more than a right angle counts as much as by a right angle")
{
  const Structural_rods rods(points({{0, 0, 0}}), points({{1, 0, 0}}));
  CHECK(rods.energy(points({{0, 0, 0}}), points({{-1, 0.5, 0}})).distortion == 1);
  CHECK(rods.energy(points({{0, 0, 0}}), points({{0, 7, 0}})).distortion == 1);
}

TEST_CASE("Eq. 2: a short rod has a direction, too")
{
  const Structural_rods rods(points({{0, 0, 0}}), points({{.01, 0, 0}}));
  CHECK(rods.energy(points({{0, 0, 0}}), points({{0, .01, 0}})).distortion == 1);
}

TEST_CASE("Eq. 4 with its sign turned: the penalty grows with the distance")
{
  // Eq. 4: the shortest rod has the length d = 1, the longest f = 4
  const Structural_rods rods(points({{0, 0, 0}}), points({{1, 0, 0}, {4, 0, 0}}));
  const auto moved = [&](double x) { return rods.energy(points({{0, 0, 0}}), points({{x, 0, 0}, {x + 3, 0, 0}})); };
  CHECK(moved(0.5).connectedness == 0);
  CHECK(moved(1).connectedness == 0);
  CHECK(moved(2).connectedness == Approx(0.5));
  CHECK(moved(3).connectedness == Approx(0.75));
  CHECK(moved(9).connectedness == 1);
}

TEST_CASE("Touching samples: a rod of length zero has no connection to break")
{
  const Points a = points({{0, 0, 0}, {1, 1, 1}}), b = points({{0, 0, 0}, {0.1, 0.7, 0.3}});
  const Structural_rods rods(a, b);
  const Rod_energy same = rods.energy(a, b);
  CHECK(same.distortion == 0);
  CHECK(same.connectedness == 0);
  // Of four rods, one stays, one rotates by 45 degrees, and two shrink to zero: 1 - sqrt((1 + 1/2) / 4)
  const Structural_rods apart(points({{0, 0, 0}, {0, 1, 0}}), points({{1, 0, 0}, {1, 0, 0}}));
  CHECK(apart.energy(points({{0, 0, 0}, {0, 0, 0}}), points({{1, 0, 0}, {0, 0, 0}})).distortion ==
        Approx(1 - std::sqrt((1 + 0 + 0.5 + 0) / 4)));
}

TEST_CASE("Unmoved rods cost exactly nothing, whatever the numbers")
{
  std::srand(7);
  for (int n : {6, 36}) {
    const Points a = Points::Random(3, n), b = Points::Random(3, 36);
    const Rod_energy energy = Structural_rods(a, b).energy(a, b);
    CHECK(energy.distortion == 0);
    CHECK(energy.connectedness == 0);
    // Translation and scaling of both parts rotate no rod
    const Points shift = Points::Constant(3, 1, 0.25);
    CHECK(Structural_rods(a, b).energy(a.colwise() + shift.col(0), b.colwise() + shift.col(0)).distortion ==
          Approx(0).margin(1e-6));
    CHECK(Structural_rods(a, b).energy(3 * a, 3 * b).distortion == Approx(0).margin(1e-6));
  }
}

namespace {

// Scalar reference of the vectorized kernel: the sum over all rods of the squared cosine of the angle by which a rod
// rotates. It adds in the kernel's order: two rows at a time, into one sum for each lane of a block.
float plain_squared_cosines(const internal::Rod_block* before, const internal::Sample_lanes& first, int n,
                            const internal::Sample_lanes& second, int m)
{
  using namespace internal;
  float sums[block_lanes] = {};
  const auto add_rows = [&](const Sample_lanes& from, int begin, int end, const Sample_lanes& to, int blocks) {
    for (int i = begin; i < end; i += 2, before += 2 * blocks)
      for (int at = 0; at < blocks * block_lanes; ++at) {
        float length[2], along[2] = {};
        for (int row = 0; row < 2; ++row) {
          const int sample = std::min(i + row, end - 1), of_row = sample - i;
          float rod[3], squared = 0;
          for (int axis = 0; axis < 3; ++axis) {
            rod[axis] = to.coordinates[axis][at] - from.coordinates[axis][sample];
            squared += rod[axis] * rod[axis];
            along[row] += before[of_row * blocks + at / block_lanes].direction[axis][at % block_lanes] * rod[axis];
          }
          length[row] = std::max(squared, zero_rod);
          along[row] = std::max(along[row], 0.f);
        }
        const float inverse = 1 / (length[0] * length[1]);
        const float next = i + 1 < end ? along[1] * along[1] * (inverse * length[0]) : 0;
        sums[at % block_lanes] += along[0] * along[0] * (inverse * length[1]) + next;
      }
    before -= (end - begin) % 2 * blocks;
  };
  const int in_blocks = samples_in_blocks(m);
  add_rows(first, 0, n, second, blocks_of(in_blocks));
  add_rows(second, in_blocks, m, first, blocks_of(n));
  for (int half = block_lanes / 2; half > 0; half /= 2)
    for (int k = 0; k < half; ++k)
      sums[k] += sums[k + half];
  return sums[0];
}

} // namespace

TEST_CASE("Vector instructions compare rods with the same bits as scalar arithmetic")
{
  using namespace internal;
  std::srand(3);
  for (const int n : {1, 5, 6, 17, 36})
    for (const int m : {1, 6, 16, 33, 36}) {
      CAPTURE(n, m);
      const Points a = Points::Random(3, n), b = Points::Random(3, m);
      const auto blocks = std::size_t(blocks_of_rods(n, m));
      std::vector<Rod_block> before(2 * blocks);
      for (Rod_block& block : before)
        for (int j = 0; j < block_lanes; ++j) {
          const Point r = Point::Random().normalized();
          for (int axis = 0; axis < 3; ++axis)
            block.direction[axis][j] = float(r[axis]);
        }
      const Sample_lanes first(a), second(b);
      const Rod_block* const rods[2] = {before.data(), before.data() + blocks};
      const Rod_comparison two = compare_rods_of_two(rods, first, n, second, m);
      for (int s = 0; s < 2; ++s) {
        const float expected = plain_squared_cosines(rods[s], first, n, second, m);
        CHECK(two.squared_cosines[s] == expected);
        CHECK(compare_rods_of_one(rods + s, first, n, second, m).squared_cosines[0] == expected);
        CHECK(compare_rods_and_length(rods + s, first, n, second, m).squared_cosines[0] == expected);
      }
      float least = far_away;
      for (int i = 0; i < n; ++i)
        for (int j = 0; j < m; ++j) {
          float squared = 0;
          for (int axis = 0; axis < 3; ++axis) {
            const float along = second.coordinates[axis][j] - first.coordinates[axis][i];
            squared += along * along;
          }
          least = std::min(least, squared);
        }
      CHECK(compare_rods_and_length(rods, first, n, second, m).least_squared_length == least);
      CHECK(least_length_of_rods(nullptr, first, n, second, m).least_squared_length == least);
    }
}

namespace {

// Rods of seven pairs of parts: the library compares pairs two at a time, so that the seventh one is alone.
std::vector<Structural_rods> seven_pairs(int first_count, int second_count)
{
  std::vector<Structural_rods> rods;
  for (int i = 0; i < 7; ++i)
    rods.emplace_back(Points::Random(3, first_count), Points::Random(3, second_count));
  return rods;
}

} // namespace

TEST_CASE("Pairs of parts that become the same target pair have the same distortions together as alone")
{
  std::srand(11);
  const Points c = Points::Random(3, 6), d = Points::Random(3, 36);
  const std::vector<Structural_rods> rods = seven_pairs(6, 36);
  std::vector<const Structural_rods*> pairs;
  std::vector<double> result;
  for (const Structural_rods& pair : rods) {
    pairs.push_back(&pair);
    distortions(pairs, internal::Sample_lanes(c), internal::Sample_lanes(d), result);
    REQUIRE(result.size() == pairs.size());
    for (std::size_t i = 0; i < pairs.size(); ++i)
      CHECK(result[i] == pairs[i]->energy(c, d).distortion);
  }
}

TEST_CASE("Samples with a multiplicity have the energy of as many repeated samples")
{
  std::srand(13);
  for (const int n : {6, 36})
    for (const int m : {6, 36}) {
      const int first = 36 / n, second = 36 / m;
      Points a = Points::Random(3, n), b = Points::Random(3, m);
      b.col(m - 1) = a.col(n - 1); // rods of length zero
      const Points c = Points::Random(3, 36), d = Points::Random(3, 36);
      const Rod_energy expected = Structural_rods(repeated(a, first), repeated(b, second)).energy(c, d);
      const Rod_energy energy = Structural_rods(a, b, first, second).energy(c, d);
      CHECK(energy.distortion == expected.distortion);
      CHECK(energy.connectedness == expected.connectedness);
    }
}

TEST_CASE("Vector instructions give the directions of scalar arithmetic")
{
  std::srand(17);
  for (const int n : {6, 36})
    for (const int m : {1, 6, 16, 32, 36}) {
      const Points a = Points::Random(3, n);
      Points b = Points::Random(3, m);
      b.col(m - 1) = a.col(0); // rods of length zero
      const internal::Sample_lanes from(a), to(b);
      const int in_blocks = internal::samples_in_blocks(m);
      const int row = internal::blocks_of(in_blocks), back_row = internal::blocks_of(n);
      float longest_squared = 0;
      std::vector<internal::Rod_block> expected(std::size_t(internal::blocks_of_rods(n, m)));
      for (internal::Rod_block& block : expected)
        for (auto& axis : block.direction)
          std::fill(std::begin(axis), std::end(axis), 0.f);
      for (int i = 0; i < n; ++i)
        for (int j = 0; j < m; ++j) {
          float rod[3], squared = 0;
          for (int axis = 0; axis < 3; ++axis) {
            rod[axis] = to.coordinates[axis][j] - from.coordinates[axis][i];
            squared += rod[axis] * rod[axis];
          }
          longest_squared = std::max(longest_squared, squared);
          const bool is_back = j >= in_blocks;
          const int lane = is_back ? i : j;
          internal::Rod_block& block =
              expected[std::size_t((is_back ? n * row + (j - in_blocks) * back_row : i * row) + lane / 16)];
          for (int axis = 0; axis < 3 && squared > 0; ++axis)
            block.direction[axis][lane % 16] = (is_back ? -rod[axis] : rod[axis]) * (1 / std::sqrt(squared));
        }
      std::vector<internal::Rod_block> rods(expected.size());
      const internal::Rod_lengths lengths = internal::write_rods(from, n, to, m, rods.data());
      CHECK(lengths.zero == 1);
      CHECK(lengths.longest_squared == longest_squared);
      CHECK(lengths.shortest_squared == 0);
      for (std::size_t block = 0; block < rods.size(); ++block)
        for (int axis = 0; axis < 3; ++axis)
          CHECK(std::equal(std::begin(rods[block].direction[axis]), std::end(rods[block].direction[axis]),
                           expected[block].direction[axis]));
    }
}

TEST_CASE("Rods of every layout agree with Eq. 2 and 3 in double precision")
{
  std::srand(5);
  for (const int n : {1, 6, 16, 17, 36})
    for (const int m : {1, 6, 16, 17, 36}) {
      const Points a = Points::Random(3, n), b = Points::Random(3, m), c = Points::Random(3, n),
                   d = Points::Random(3, m);
      double kept = 0, nearest = 1e9, shortest = 1e9, longest = 0;
      for (int i = 0; i < n; ++i)
        for (int j = 0; j < m; ++j) {
          const Point r = b.col(j) - a.col(i), moved = d.col(j) - c.col(i);
          kept += std::pow(std::max(0.0, r.dot(moved) / (r.norm() * moved.norm())), 2);
          nearest = std::min(nearest, moved.norm());
          shortest = std::min(shortest, r.norm());
          longest = std::max(longest, r.norm());
        }
      for (const Rod_energy& energy : {rod_energy(a, b, c, d), Structural_rods(a, b).energy(c, d)}) {
        CHECK(energy.distortion == Approx(1 - std::sqrt(kept / (n * m))).margin(1e-6));
        CHECK(energy.connectedness == Approx(nearest > shortest ? std::min(1.0, nearest / longest) : 0.0).margin(1e-6));
      }
      CHECK(least_distance(Sample_lanes(c), n, Sample_lanes(d), m) == Approx(nearest).margin(1e-6));
    }
}
