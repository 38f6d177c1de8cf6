// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "matching/Shape_features.h"
#include "matching/Part_costs.h"

#include <algorithm>
#include <tuple>
#include <vector>

namespace CGAL::Shape_correspondence::internal {

namespace {

void remove_chains(Part_assemblies& assemblies)
{
  const auto is_chain = [&](const std::vector<std::size_t>& panel) {
    return std::any_of(panel.begin(), panel.end(),
                       [&](std::size_t part) { return bool(assemblies.is_in_chain[part]); });
  };
  std::vector<std::vector<std::size_t>>& panels = assemblies.panels;
  panels.erase(std::remove_if(panels.begin(), panels.end(), is_chain), panels.end());
  assemblies.is_in_chain.assign(assemblies.is_in_chain.size(), 0);
}

} // namespace

Shape_features::Shape_features(const Aligned_shape& shape, const Part_matching_options& options)
    : shape(shape), options(options), assemblies(part_assemblies(shape))
{
  if (!options.panels) assemblies.panels.clear();
  if (!options.support) assemblies.support.clear();
  if (!options.chains) remove_chains(assemblies);
  normalized = normalized_shape(shape, assemblies);
}

bool Shape_features::has_chain() const
{
  const std::vector<char>& is_in_chain = assemblies.is_in_chain;
  return std::find(is_in_chain.begin(), is_in_chain.end(), 1) != is_in_chain.end();
}

const Eigen::MatrixXd& Shape_features::costs_within() const
{
  std::call_once(has_costs_within_, [&] { costs_within_ = part_costs(normalized, options.weights); });
  return costs_within_;
}

bool are_same(const Part_matching_options& a, const Part_matching_options& b)
{
  const auto values = [](const Part_matching_options& o) {
    const Part_cost_weights& w = o.weights;
    return std::make_tuple(w.overlap, w.extent, w.ground, w.side, w.front, w.orientation, w.chamfer, w.contacts,
                           w.chain, o.panels, o.support, o.chains);
  };
  return values(a) == values(b);
}

} // namespace CGAL::Shape_correspondence::internal
