// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "blend/Blend_part.h"
#include "blend/Field_morph.h"
#include "blend/unlike_pairs.h"

#include <array>
#include <cstddef>
#include <map>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL::Shape_correspondence::internal {

/// Parts of the source that become parts of the target together, by distance fields, as they have no map onto each
/// other.
struct Part_set
{
  std::array<std::vector<std::size_t>, 2> parts; ///< by end, in order
  Blend_obstacle reason = Blend_obstacle::NONE;  ///< why there is no map
};

/// The sets of parts that pairs connect.
/// \param torn those of the pairs that have no map; others are unlike
std::vector<Part_set> connected_sets(const Blend_stage& stage, const Part_pairs& pairs, const Torn_pairs& torn);

/// Makes the parts of a blend from sets of parts.
class Part_set_maker
{
public:
  explicit Part_set_maker(const Blend_stage& stage) : stage_(stage) {}

  /// Takes out the sets that do not hold together on their way, mirror images together. \return those taken out
  std::vector<Part_set> take_broken(std::vector<Part_set>& sets);
  /// Adds the parts that become of sets. \pre the sets hold together
  void add(const std::vector<Part_set>& sets, std::vector<Blend_part>& parts);

private:
  using Key = std::pair<std::array<std::vector<std::size_t>, 2>, bool>; ///< parts by end, whether in the mirror

  std::size_t image_of(const std::vector<Part_set>& sets, std::size_t number) const;
  Part_mesh mesh_of(const Part_set& set, std::size_t end, bool in_mirror) const;
  std::shared_ptr<const Field_morph> morph_of(const Part_set& set, bool in_mirror);
  std::shared_ptr<const Field_morph> make_morph(const Part_set& set, bool in_mirror) const;

  const Blend_stage& stage_;
  std::map<Key, std::shared_ptr<const Field_morph>> known_; ///< none of those that do not hold together
};

} // namespace CGAL::Shape_correspondence::internal
