// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "blend/exchange_reason.h"

#include "base/quantized.h"

#include <CGAL/Shape_correspondence/blend_shapes.h>

#include <algorithm>
#include <array>
#include <limits>
#include <numeric>
#include <utility>

namespace CGAL::Shape_correspondence::internal {

namespace {

/// The area of all parts at the end where it is smaller.
double least_area(const std::vector<Blend_part>& parts)
{
  std::array<double, 2> areas = {0, 0};
  for (const Blend_part& part : parts)
    for (std::size_t end : {0u, 1u})
      areas[end] += part.rests[end]->extent().area;
  return std::min(areas[0], areas[1]);
}

} // namespace

Surface_fault surface_fault(const Blend_part& part)
{
  const double change = part.morph->switch_time();
  std::vector<std::pair<int, double>> samples = {{0, change}, {1, change}};
  for (double t : {0.25, 0.5, 0.75})
    if (t != change) samples.emplace_back(part.morph->surface(t), t);
  Surface_fault result;
  for (const auto& [surface, t] : samples) {
    const Rest_surface& rest = *part.rests[std::size_t(surface)];
    const Points points = part.points(surface, t);
    const Surface_extent extent = rest.extent(points);
    const double torn = rest.torn_area(points, extent);
    result.torn = std::max(result.torn, torn);
    if (extent.area > 0) result.torn_share = std::max(result.torn_share, torn / extent.area);
    result.thinning = std::max(result.thinning, thinning_of(part, extent, 1));
  }
  return result;
}

std::vector<Blend_exchange> exchanges(const std::vector<Blend_part>& parts)
{
  constexpr double most_torn = 0.5; // of the tolerance: motions that close gaps tear, too
  constexpr double torn_part = 10;  // tolerances, of a part by itself
  std::vector<Blend_exchange> result(parts.size(), Blend_exchange::NONE);
  std::vector<double> torn(parts.size(), 0);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const Surface_fault fault = surface_fault(parts[i]);
    if (fault.torn_share > torn_part * Shape_blend::torn_tolerance)
      result[i] = Blend_exchange::TORN;
    else if (fault.thinning > Shape_blend::thinning_tolerance)
      result[i] = Blend_exchange::THIN;
    else
      torn[i] = fault.torn;
  }
  std::vector<std::size_t> order(parts.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return quantized(torn[a]) > quantized(torn[b]); });
  double rest = std::accumulate(torn.begin(), torn.end(), 0.);
  for (std::size_t part : order) {
    if (rest <= most_torn * Shape_blend::torn_tolerance * least_area(parts)) break;
    result[part] = Blend_exchange::TORN;
    rest -= torn[part];
  }
  for (std::size_t i = 0; i < parts.size(); ++i)
    if (parts[i].has_image() && result[i] == Blend_exchange::NONE) result[i] = result[parts[i].image];
  return result;
}

double thinning_of(const Blend_part& part, const Surface_extent& extent, double remaining)
{
  bool are_closed = true, is_flat = false;
  for (const std::optional<Rest_surface>& surface : part.rests)
    if (surface) {
      are_closed = are_closed && surface->is_closed() && surface->extent().thickness > Surface_extent::least_thickness;
      is_flat = is_flat || surface->extent().is_flat();
    }
  if (is_flat) return 0;
  const auto thickness = [&](const Surface_extent& of) { return are_closed ? of.thickness : of.spread(); };
  double at_ends = std::numeric_limits<double>::infinity();
  for (const std::optional<Rest_surface>& surface : part.rests)
    if (surface) at_ends = std::min(at_ends, thickness(surface->extent()));
  return std::max(0., 1 - thickness(extent) / (at_ends * remaining));
}

} // namespace CGAL::Shape_correspondence::internal
