// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <CGAL/Shape_correspondence/Part_abstraction.h>
#include <CGAL/Shape_correspondence/Shape_frame.h>
#include <CGAL/Shape_correspondence/Structural_graph.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace CGAL::Shape_correspondence::IO {

/// The frame of a shape for which only the abstractions are known.
inline Shape_frame frame_of_abstractions(const std::vector<Part_abstraction>& parts, const Point& up)
{
  constexpr int samples_along = 6; // samples of a curve, or along each side of a sheet
  Points all(3, 0);
  for (const Part_abstraction& part : parts) {
    const Points samples = sample(part, samples_along);
    all.conservativeResize(Eigen::NoChange, all.cols() + samples.cols());
    all.rightCols(samples.cols()) = samples;
  }
  return compute_shape_frame(all, up);
}

/// Merges contacts of the same two parts into one with the places of all.
inline std::vector<Contact> merged_contacts(std::vector<Contact> contacts)
{
  std::vector<Contact> result;
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> earlier;
  for (Contact& contact : contacts) {
    const auto [place, is_new] = earlier.emplace(std::minmax(contact.parts[0], contact.parts[1]), result.size());
    if (is_new) {
      result.push_back(std::move(contact));
      continue;
    }
    Contact& known = result[place->second];
    contact.further.insert(contact.further.begin(), contact.parameters);
    for (auto& parameters : contact.further) {
      if (known.parts != contact.parts) std::swap(parameters[0], parameters[1]);
      known.further.push_back(parameters);
    }
  }
  return result;
}

} // namespace CGAL::Shape_correspondence::IO
