// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "base/limits.h"

#include <CGAL/Shape_correspondence/Correspondence.h>

#include <cstddef>
#include <string>
#include <vector>

namespace CGAL::Shape_correspondence::internal {

/// Checks the part indices of a correspondence against the numbers of parts of the two shapes.
/// \param function name of the caller, for the message \throw Invalid_input if an index is out of range
inline void check_correspondence(const std::string& function, const Correspondence& c, std::size_t source_parts,
                                 std::size_t target_parts)
{
  const auto check = [&](std::size_t count, const std::vector<std::size_t>& parts) {
    for (std::size_t part : parts)
      check_index(function, "part", part, count);
  };
  for (const Part_correspondence& pair : c.pairs) {
    check(source_parts, {pair.source});
    check(target_parts, {pair.target});
  }
  for (const Group_match& group : c.groups) {
    check(source_parts, group.source);
    check(target_parts, group.target);
  }
  check(source_parts, c.unmatched_source);
  check(target_parts, c.unmatched_target);
  const std::size_t deformed = c.direction == Direction::SOURCE_TO_TARGET ? source_parts : target_parts;
  for (const Contact_energy& contact : c.contacts)
    check(deformed, {contact.parts[0], contact.parts[1]});
  const bool has_roles = !c.source_roles.empty() || !c.target_roles.empty();
  if (has_roles && (c.source_roles.size() != source_parts || c.target_roles.size() != target_parts))
    throw Invalid_input(function +
                        ": the correspondence does not have a role for every part of the two shapes; give one "
                        "that was found for them");
}

} // namespace CGAL::Shape_correspondence::internal
