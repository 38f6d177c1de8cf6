// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "matching/match_parts.h"
#include "base/quantized.h"
#include "matching/Shape_features.h"
#include "matching/part_blocks.h"

#include <CGAL/Shape_correspondence/Invalid_input.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace CGAL::Shape_correspondence {
using namespace internal;

namespace {

// Logistic model of how often a pair is right by the margin of its cost, set on one half of the development set, by
// source family, and on the generated shapes, which weigh the same. Pairs of blocks may have any margin below 0.
constexpr double confidence_offset = 0.37, confidence_slope = 0.52, least_margin = -0.5, largest_margin = 3;

// Parts that pair one to one at no more cost count as equal; set on the development set and the generated shapes.
constexpr double equal_part_cost = 0.5;

// Legs that pair one to one at no more cost are alike, and so many of them show that legs correspond to legs, not the
// support to the support; set on the generated shapes of given and of drawn styles.
constexpr double alike_leg_cost = 4;
constexpr std::size_t least_alike_legs = 2;

void check(const Part_matching_options& options)
{
  const Part_cost_weights& w = options.weights;
  for (double value : {w.overlap, w.extent, w.ground, w.side, w.front, w.orientation, w.chamfer, w.contacts, w.chain,
                       options.excess, options.confident_excess, options.shared_counterpart, options.upside_down})
    if (!(value >= 0) || !std::isfinite(value))
      throw Invalid_input("match_parts: the weights and bounds of costs must be finite and not negative");
}

// Pairs that cost least for one of their parts and, over both, at most so much more than least.
Match_matrix pairs_within(const Eigen::MatrixXd& costs, double excess)
{
  const Eigen::VectorXd least_in_row = costs.rowwise().minCoeff(), least_in_column = costs.colwise().minCoeff();
  Match_matrix result(costs.rows(), costs.cols());
  for (Eigen::Index i = 0; i < costs.rows(); ++i)
    for (Eigen::Index j = 0; j < costs.cols(); ++j) {
      const long over_row = quantized(costs(i, j) - least_in_row[i]);
      const long over_column = quantized(costs(i, j) - least_in_column[j]);
      result(i, j) = (over_row == 0 || over_column == 0) && over_row + over_column <= quantized(excess);
    }
  return result;
}

// How many of the pairs each of the rows is in.
std::vector<std::size_t> number_of_pairs(const Match_matrix& pairs, const std::vector<std::size_t>& rows,
                                         const std::vector<std::size_t>& columns)
{
  std::vector<std::size_t> result;
  for (std::size_t i : rows)
    result.push_back(std::size_t(std::count_if(
        columns.begin(), columns.end(), [&](std::size_t j) { return pairs(Eigen::Index(i), Eigen::Index(j)); })));
  return result;
}

bool are_all(const std::vector<std::size_t>& counts, std::size_t count)
{
  return std::all_of(counts.begin(), counts.end(), [&](std::size_t c) { return c == count; });
}

// Do the parts of a block pair one to one, each with one that is as good as equal?
bool are_equal_pairs(const Block& block, const Match_matrix& confident, const Eigen::MatrixXd& costs)
{
  const std::vector<std::size_t> of_source = number_of_pairs(confident, block.source, block.target),
                                 of_target = number_of_pairs(confident.transpose(), block.target, block.source);
  if (!are_all(of_source, 1) || !are_all(of_target, 1)) return false;
  for (std::size_t i : block.source)
    for (std::size_t j : block.target)
      if (confident(Eigen::Index(i), Eigen::Index(j)) &&
          quantized(costs(Eigen::Index(i), Eigen::Index(j))) > quantized(equal_part_cost))
        return false;
  return true;
}

std::vector<char> flags(const std::vector<std::size_t>& parts, std::size_t count)
{
  std::vector<char> result(count, 0);
  for (std::size_t part : parts)
    result[part] = 1;
  return result;
}

std::vector<char> is_in_panel(const Shape_features& features)
{
  std::vector<std::size_t> parts;
  for (const std::vector<std::size_t>& panel : features.assemblies.panels)
    parts.insert(parts.end(), panel.begin(), panel.end());
  return flags(parts, features.size());
}

void match_all(const std::vector<std::size_t>& source, const std::vector<std::size_t>& target, Match_matrix& pairs)
{
  for (std::size_t i : source)
    for (std::size_t j : target)
      pairs(Eigen::Index(i), Eigen::Index(j)) = true;
}

// Every part of a block with every other where they differ in number, or are in panels.
void complete_blocks(const std::vector<Block>& blocks, const Match_matrix& confident, const Eigen::MatrixXd& costs,
                     const Shape_features& source, const Shape_features& target, Match_matrix& pairs)
{
  const std::vector<char> source_panels = is_in_panel(source), target_panels = is_in_panel(target);
  const auto has_panel = [](const std::vector<std::size_t>& parts, const std::vector<char>& is_in_panel) {
    return std::any_of(parts.begin(), parts.end(), [&](std::size_t part) { return bool(is_in_panel[part]); });
  };
  for (const Block& block : blocks)
    if (block.source.size() != block.target.size() ||
        ((has_panel(block.source, source_panels) || has_panel(block.target, target_panels)) &&
         !are_equal_pairs(block, confident, costs)))
      match_all(block.source, block.target, pairs);
}

// Does every leg of the shape with fewer legs pair with a leg of its own, and do those left over stand on the ground?
bool supports_pair_one_to_one(const Match_matrix& confident, const Part_assemblies& fewer, const Part_assemblies& more)
{
  const std::vector<std::size_t> of_fewer = number_of_pairs(confident, fewer.legs, more.legs),
                                 of_more = number_of_pairs(confident.transpose(), more.legs, fewer.legs);
  if (!are_all(of_fewer, 1)) return false;
  for (std::size_t k = 0; k < of_more.size(); ++k)
    if (of_more[k] > 1 || (of_more[k] == 0 && !more.is_on_ground[more.legs[k]])) return false;
  return true;
}

// Legs of either shape that pair with one of the other's each, and are alike.
std::size_t number_of_alike_legs(const Match_matrix& confident, const Eigen::MatrixXd& costs,
                                 const std::vector<std::size_t>& a, const std::vector<std::size_t>& b)
{
  const std::vector<std::size_t> of_a = number_of_pairs(confident, a, b),
                                 of_b = number_of_pairs(confident.transpose(), b, a);
  std::size_t result = 0;
  for (std::size_t k = 0; k < a.size(); ++k)
    for (std::size_t l = 0; l < b.size(); ++l) {
      const auto i = Eigen::Index(a[k]), j = Eigen::Index(b[l]);
      result += confident(i, j) && of_a[k] == 1 && of_b[l] == 1 && quantized(costs(i, j)) <= quantized(alike_leg_cost);
    }
  return result;
}

// How the supports of two shapes correspond.
enum class Support_matching {
  AS_OTHER_PARTS, // by blocks
  ALIKE_LEGS,     // legs to the legs that they pair with only: either shape has some without a counterpart
  AS_SETS         // every part to every part
};

Support_matching support_matching(const Match_matrix& confident, const Eigen::MatrixXd& costs, const Part_assemblies& a,
                                  const Part_assemblies& b, bool alike_legs)
{
  if (a.support.empty() || b.support.empty()) return Support_matching::AS_OTHER_PARTS;
  if (a.legs.size() <= b.legs.size() ? supports_pair_one_to_one(confident, a, b)
                                     : supports_pair_one_to_one(confident.transpose(), b, a))
    return Support_matching::AS_OTHER_PARTS;
  return alike_legs && number_of_alike_legs(confident, costs, a.legs, b.legs) >= least_alike_legs
             ? Support_matching::ALIKE_LEGS
             : Support_matching::AS_SETS;
}

void leave_out(const std::vector<std::size_t>& left_out, std::vector<std::size_t>& parts)
{
  const auto is_left_out = [&](std::size_t part) { return std::binary_search(left_out.begin(), left_out.end(), part); };
  parts.erase(std::remove_if(parts.begin(), parts.end(), is_left_out), parts.end());
}

// Takes out pairs of a leg and a part that is not in the support.
void separate_supports(const Shape_features& source, const Shape_features& target, Match_matrix& pairs)
{
  const std::vector<char> a = flags(source.assemblies.support, source.size()),
                          b = flags(target.assemblies.support, target.size());
  for (std::size_t i : source.assemblies.legs)
    for (std::size_t j = 0; j < target.size(); ++j)
      if (!b[j]) pairs(Eigen::Index(i), Eigen::Index(j)) = false;
  for (std::size_t j : target.assemblies.legs)
    for (std::size_t i = 0; i < source.size(); ++i)
      if (!a[i]) pairs(Eigen::Index(i), Eigen::Index(j)) = false;
}

Match_matrix matched(const Cost_matrices& costs, const Shape_features& source, const Shape_features& target,
                     const Part_matching_options& options)
{
  Match_matrix confident = pairs_within(costs.all, options.confident_excess),
               pairs = pairs_within(costs.all, options.excess);
  const Part_assemblies &a = source.assemblies, &b = target.assemblies;
  const Support_matching supports = support_matching(confident, costs.of_parts, a, b, options.alike_legs);
  if (supports == Support_matching::AS_SETS) separate_supports(source, target, confident);
  std::vector<Block> blocks = joined_blocks(confident, source, target, options);
  if (supports == Support_matching::ALIKE_LEGS)
    for (Block& block : blocks) {
      leave_out(a.legs, block.source);
      leave_out(b.legs, block.target);
    }
  complete_blocks(blocks, confident, costs.of_parts, source, target, pairs);
  if (supports == Support_matching::AS_SETS) {
    separate_supports(source, target, pairs);
    match_all(a.legs, b.legs, pairs);
  }
  return pairs;
}

// Mirrored at a level plane, so that left and right, front and back stay.
Aligned_shape turned_over(Aligned_shape shape)
{
  for (Sampled_part& part : shape.parts)
    part.surface.row(1) *= -1;
  return shape;
}

// By how much the best pair that was not taken costs more, of either part.
double margin(const Eigen::MatrixXd& costs, const Match_matrix& pairs, Eigen::Index i, Eigen::Index j)
{
  double alternative = std::numeric_limits<double>::infinity();
  for (Eigen::Index k = 0; k < costs.cols(); ++k)
    if (!pairs(i, k)) alternative = std::min(alternative, costs(i, k));
  for (Eigen::Index k = 0; k < costs.rows(); ++k)
    if (!pairs(k, j)) alternative = std::min(alternative, costs(k, j));
  return std::clamp(alternative - costs(i, j), least_margin, largest_margin);
}

double confidence(double margin) { return 1 / (1 + std::exp(-(confidence_offset + confidence_slope * margin))); }

Cost_matrices costs_of(const Shape_features& a, const Shape_features& b, const Part_matching_options& options)
{
  return part_costs(a.normalized, a.shape, b.normalized, b.shape, options.weights);
}

// Without surfaces: enough to tell whether the full costs may be less.
long rough_cost(const Shape_features& a, const Shape_features& b, const Part_matching_options& options)
{
  return quantized(mean_least_cost(rough_costs(a.normalized, b.normalized, options.weights)));
}

Part_matching matching_of(Cost_matrices costs, const Shape_features& source, const Shape_features& target,
                          const Part_matching_options& options)
{
  const Match_matrix pairs = matched(costs, source, target, options);
  Part_matching result;
  for (Eigen::Index i = 0; i < pairs.rows(); ++i)
    for (Eigen::Index j = 0; j < pairs.cols(); ++j)
      if (pairs(i, j))
        result.pairs.push_back({std::size_t(i), std::size_t(j), confidence(margin(costs.all, pairs, i, j))});
  result.costs = std::move(costs.all);
  return result;
}

} // namespace

bool comes_first(const Aligned_shape& a, const Aligned_shape& b)
{
  const auto key = [](const Aligned_shape& shape) {
    double height = 0;
    for (const Sampled_part& part : shape.parts)
      height += part.surface.row(1).mean();
    return std::make_pair(shape.parts.size(), quantized(height));
  };
  return key(a) < key(b);
}

Part_matching match_parts(const Aligned_shape& source, const Aligned_shape& target,
                          const Part_matching_options& options)
{
  check(options);
  const Shape_features a(source, options), b(target, options);
  Cost_matrices costs = costs_of(a, b, options);
  // What has a chain hangs from it
  const bool one_has_chain = a.has_chain() != b.has_chain();
  if (!one_has_chain && (a.assemblies.has_main_surface || b.assemblies.has_main_surface || a.has_chain()))
    return matching_of(std::move(costs), a, b, options);

  const Aligned_shape source_over = turned_over(source), target_over = turned_over(target);
  const Shape_features a_over(source_over, options), b_over(target_over, options);
  const long rough = rough_cost(a, b, options);
  long least =
      one_has_chain ? std::numeric_limits<long>::max() : quantized(mean_least_cost(costs.all) - options.upside_down);
  std::pair<const Shape_features*, const Shape_features*> best{&a, &b};
  std::array<std::pair<const Shape_features*, const Shape_features*>, 2> ways{{{&a, &b_over}, {&a_over, &b}}};
  if (comes_first(source, target)) std::swap(ways[0], ways[1]); // the first is taken where both cost the same
  for (const auto& turned : ways) {
    if (!one_has_chain && rough_cost(*turned.first, *turned.second, options) >= rough) continue;
    Cost_matrices costs_over = costs_of(*turned.first, *turned.second, options);
    if (quantized(mean_least_cost(costs_over.all)) >= least) continue;
    least = quantized(mean_least_cost(costs_over.all));
    costs = std::move(costs_over);
    best = turned;
  }
  Part_matching result = matching_of(std::move(costs), *best.first, *best.second, options);
  result.upside_down = best.first != &a || best.second != &b;
  return result;
}

} // namespace CGAL::Shape_correspondence
