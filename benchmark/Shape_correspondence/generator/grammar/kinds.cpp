// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "kinds.h"

#include <map>

namespace CGAL::Shape_correspondence::generator {

namespace {

using Draw = void (*)(Sketch&);

const std::map<std::string, Draw>& draws()
{
  static const std::map<std::string, Draw> result{
      {"airplane", draw_aeroplane},   {"bed", draw_bed},   {"car", draw_car},
      {"chair", draw_chair},          {"lamp", draw_lamp}, {"plant", draw_plant},
      {"shelf", draw_shelf},          {"sofa", draw_sofa}, {"table", draw_table},
      {"velocipede", draw_velocipede}};
  return result;
}

constexpr std::uint64_t seeds_of_a_set = 1000000; // seeds reserved for each set: more than it has shapes

} // namespace

Assembly drawn_shape(const std::string& category, std::uint64_t seed)
{
  Sketch sketch(category, seed);
  draws().at(category)(sketch);
  return sketch.finished(category + "_" + std::to_string(seed % seeds_of_a_set));
}

std::vector<Assembly> drawn_shapes(std::size_t count, std::uint64_t seed)
{
  std::vector<Assembly> result;
  auto of_category = draws().begin();
  for (std::size_t i = 0; i < count; ++i) {
    result.push_back(drawn_shape(of_category->first, seed * seeds_of_a_set + i));
    if (++of_category == draws().end()) of_category = draws().begin();
  }
  return result;
}

std::vector<Assembly> compared_shapes(std::uint64_t seed)
{
  constexpr std::uint64_t shapes_of_a_category = 15, first_seed = 1000; // far from those of `drawn_shapes()`
  std::vector<Assembly> result;
  for (const char* const category : {"airplane", "bed", "chair", "lamp", "table", "velocipede"})
    for (std::uint64_t i = 1; i <= shapes_of_a_category; ++i)
      result.push_back(drawn_shape(category, (first_seed + seed) * seeds_of_a_set + i));
  return result;
}

} // namespace CGAL::Shape_correspondence::generator
