// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "blend/Blend_layout.h"

#include "blend/Blend_stage.h"
#include "blend/Blend_structure.h"
#include "blend/schedules.h"
#include "blend/unlike_pairs.h"

#include <array>
#include <utility>

namespace CGAL::Shape_correspondence::internal {
namespace {

/// By part, its group, which comes and goes at one time, so that each takes the place of the other: chains and those
/// that they correspond to, mirror images, what stands, and what takes up most of the place of a part in no body.
std::vector<std::size_t> change_groups(const Blend_stage& stage, const Part_pairs& unlike,
                                       const std::vector<Blend_part>& parts, const std::vector<Unmatched_chain>& chains)
{
  Disjoint_sets sets(parts.size());
  const auto part_of = [&](int end, std::size_t given) { return parts_of(parts, end, given).front(); };
  for (const auto& [s, t] : unlike)
    sets.unite(part_of(0, s), part_of(1, t));
  std::array<std::vector<std::size_t>, 2> going; // by end
  std::size_t standing = Blend_task::no_part;    // one that stands
  for (const Unmatched_chain& chain : chains) {
    if (chain.stands() && standing == Blend_task::no_part) standing = chain.parts[0];
    if (chain.stands()) sets.unite(chain.parts[0], standing);
    for (std::size_t part : chain.parts) {
      const std::size_t image = stage.images[std::size_t(chain.end)][parts[part].given()];
      sets.unite(part, chain.parts[0]);
      if (image != Mirror_images::none) sets.unite(part, part_of(chain.end, image));
      going[std::size_t(chain.end)].push_back(part);
    }
  }
  for (const Unmatched_chain& chain : chains) {
    if (chain.is_body()) continue;
    for (std::size_t part : chain.parts) {
      double most = same_place;
      std::size_t best = part;
      for (std::size_t other : going[std::size_t(1 - chain.end)]) {
        const auto [s, t] = chain.end == 0 ? std::pair(part, other) : std::pair(other, part);
        const double shared = shared_place(stage, parts[s].given(), parts[t].given());
        if (shared > most) most = shared, best = other;
      }
      sets.unite(part, best);
    }
  }
  std::vector<std::size_t> result;
  for (std::size_t part = 0; part < parts.size(); ++part)
    result.push_back(sets[part]);
  return result;
}

} // namespace

const std::vector<std::string>& layout_names()
{
  static const std::vector<std::string> names = {"from the ground up", "from the top down", "chain by chain"};
  return names;
}

std::vector<Blend_layout> blend_layouts(const Blend_stage& stage, const Part_pairs& unlike,
                                        const Blend_structure& blend)
{
  std::vector<Blend_layout> result;
  for (std::size_t i = 0; i < layout_names().size(); ++i) {
    const bool has_bodies = i < 2, is_from_the_ground = i != 1;
    Exchanged_bodies bodies(blend, has_bodies ? unlike : Part_pairs());
    Blend_layout layout{layout_names()[i], {}, {}};
    do {
      layout.chains = unmatched_chains(stage, blend, bodies);
      const auto groups = change_groups(stage, unlike, blend.parts, layout.chains);
      layout.times = times_in_turn(blend.parts, groups, is_from_the_ground);
    } while (unite_open_bodies(blend, layout, bodies));
    result.push_back(std::move(layout));
  }
  return result;
}

} // namespace CGAL::Shape_correspondence::internal
