// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "blend/contacts_to_keep.h"

#include "base/quantized.h"
#include "blend/Blend_stage.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <optional>

namespace CGAL::Shape_correspondence::internal {
namespace {

using Index_pair = std::array<std::size_t, 2>; // of parts, the smaller one first

/// Two parts that touch at an end: where, in order along the axes, and how wide the gap between them is.
struct Touch
{
  std::vector<Point> at;
  double gap;
};

Point middle(const std::vector<Point>& points)
{
  return std::accumulate(points.begin(), points.end(), Point(Point::Zero())) / double(points.size());
}

class Contact_finder
{
public:
  Contact_finder(const Blend_stage& stage, const std::vector<Blend_part>& parts, double tolerance)
      : stage_(stage), parts_(parts), tolerance_(tolerance)
  {}

  std::vector<Kept_contact> contacts() const
  {
    const std::array<std::map<Index_pair, Touch>, 2> touching = {touching_at(0), touching_at(1)};
    std::vector<Kept_contact> result;
    for (const auto& [pair, touch] : touching[0])
      if (const auto other = touching[1].find(pair); other != touching[1].end())
        result.push_back(contact(pair, touch, other->second));
    return result;
  }

private:
  Kept_contact contact(const Index_pair& pair, const Touch& source, const Touch& target) const
  {
    Kept_contact result{pair, {}, {source.gap, target.gap}};
    const bool are_paired = source.at.size() == target.at.size();
    const std::vector<Point> from = are_paired ? source.at : std::vector<Point>{middle(source.at)};
    const std::vector<Point> to = are_paired ? target.at : std::vector<Point>{middle(target.at)};
    for (std::size_t i = 0; i < from.size(); ++i)
      result.points.push_back({parts_[pair[0]].carried(from[i], to[i]), parts_[pair[1]].carried(from[i], to[i])});
    return result;
  }

  /// The parts whose given parts have a contact in the graph: if there are several pieces of one, those that touch.
  std::map<Index_pair, Touch> touching_at(int end) const
  {
    std::map<Index_pair, Touch> result;
    const Shape_structure& shape = structure(stage_.graphs[std::size_t(end)]);
    for (const Contact& contact : shape.contacts) {
      const auto first = parts_of(parts_, end, contact.parts[0]), second = parts_of(parts_, end, contact.parts[1]);
      const bool are_whole = first.size() == 1 && second.size() == 1;
      for (std::size_t a : first)
        for (std::size_t b : second) {
          if (a == b) continue;
          const Index_pair pair = {std::min(a, b), std::max(a, b)};
          std::optional<Touch> touch = touch_of(pair, end);
          if (are_whole) touch = Touch{stage_.places_of(end, contact), touch ? touch->gap : gap_of(pair, end)};
          if (!touch) continue;
          const auto [known, is_new] = result.emplace(pair, *touch);
          if (is_new) continue; // else of several parts that become one
          known->second.at.insert(known->second.at.end(), touch->at.begin(), touch->at.end());
          known->second.gap = std::max(known->second.gap, touch->gap);
        }
    }
    return result;
  }

  const contacts::Triangle_tree& tree(std::size_t part, int end) const
  {
    return parts_[part].trees[std::size_t(parts_[part].end_surface(end))];
  }

  double gap_of(const Index_pair& pair, int end) const
  {
    return std::sqrt(tree(pair[0], end).nearly_closest(tree(pair[1], end)).squared);
  }

  /// If the surfaces are near.
  std::optional<Touch> touch_of(const Index_pair& pair, int end) const
  {
    const contacts::Closest_pair closest = tree(pair[0], end).nearly_closest(tree(pair[1], end));
    if (closest.squared > tolerance_ * tolerance_) return std::nullopt;
    return Touch{{(closest.first + closest.second) / 2}, std::sqrt(closest.squared)};
  }

  const Blend_stage& stage_;
  const std::vector<Blend_part>& parts_;
  double tolerance_;
};

} // namespace

std::vector<Kept_contact> contacts_to_keep(const Blend_stage& stage, const std::vector<Blend_part>& parts,
                                           double tolerance)
{
  return Contact_finder(stage, parts, tolerance).contacts();
}

} // namespace CGAL::Shape_correspondence::internal
