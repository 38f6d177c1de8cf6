// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "cli/collection_work.h"
#include "cli/progress_bar.h"

#include <CGAL/Shape_correspondence/Invalid_input.h>

namespace CGAL::Shape_correspondence::cli {

void Collection_work::run(Team& team)
{
  std::vector<std::size_t> missing;
  for (std::size_t tile = 0; tile < tiles_.size(); ++tile)
    if (is_mine(tile) && !store_.has(tiles_.name(tile))) missing.push_back(tile);
  missing = team.from_first(std::move(missing)); // others may have begun
  std::vector<std::size_t> before;               // pairs, by place in the list
  std::size_t total = 0;
  for (std::size_t tile : missing) {
    before.push_back(total);
    total += tiles_.number_of_pairs(tile);
  }
  if (options_.merge && !missing.empty())
    throw Invalid_input(
        options_.store + ": " + std::to_string(total) +
        " pairs of shapes are missing; run the shares (--tile) that are not done, or leave --merge out");
  Common_options shown = common_;
  shown.quiet = common_.quiet || !team.is_first();
  Progress_bar bar(shown, "matching", "pair");
  team.for_each(missing.size(), [&](std::size_t k) {
    Energy_matrix_options matching = matching_;
    matching.progress = [&](std::size_t done, std::size_t) {
      bar.show(before[k] + done, total);
      return true;
    };
    store_.insert(tiles_.name(missing[k]), tiles_.computed(missing[k], matching));
  });
}

} // namespace CGAL::Shape_correspondence::cli
