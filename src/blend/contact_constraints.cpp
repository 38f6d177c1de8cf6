// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "blend/contact_constraints.h"

#include "base/Disjoint_sets.h"
#include "base/quantized.h"
#include "blend/Blend_ends.h"
#include "blend/surface_components.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

namespace CGAL::Shape_correspondence::internal {
namespace {

using Index_pair = std::array<std::size_t, 2>; // of parts, the smaller one first

Index_pair ordered(std::size_t a, std::size_t b) { return {std::min(a, b), std::max(a, b)}; }

/// Chooses the contacts that are to be kept.
class Contact_chooser
{
public:
  /// \param widest_gap by end, that it takes to join all parts
  Contact_chooser(const std::array<Blend_input, 2>& inputs, const std::vector<Blend_part>& parts, double tolerance,
                  const std::array<double, 2>& widest_gap)
      : parts_(parts), tolerance_(tolerance), widest_gap_(widest_gap)
  {
    find_contacts(inputs);
    for (const Contact_constraint& contact : found_)
      if (contact.touch[0] && contact.touch[1]) keep(contact);
    for (std::size_t end : {0u, 1u})
      join_components(end);
  }

  std::vector<Contact_constraint> kept() const
  {
    std::vector<Contact_constraint> result;
    for (const auto& [pair, contact] : kept_)
      result.push_back(contact);
    return result;
  }

private:
  /// The pair on the other side of the mirror plane.
  std::optional<Index_pair> image(const Index_pair& pair) const
  {
    const Blend_part &a = parts_[pair[0]], &b = parts_[pair[1]];
    if (!a.has_image() || !b.has_image() || a.image == b.image) return std::nullopt;
    return ordered(a.image, b.image);
  }

  using Candidates = std::map<Index_pair, std::array<bool, 2>>; // whether the graph of an end has a contact

  void add_candidates(const Blend_input& input, int end, Candidates& candidates) const
  {
    const Shape_structure& shape = structure(input.graph);
    const auto add = [&](std::size_t part, std::size_t other) {
      const auto first = parts_of(parts_, end, part), second = parts_of(parts_, end, other);
      const bool of_whole_parts = part != other && first.size() == 1 && second.size() == 1;
      for (std::size_t a : first)
        for (std::size_t b : second)
          if (a != b && parts_[a].morph && parts_[b].morph)
            candidates[ordered(a, b)][std::size_t(end)] |= of_whole_parts;
    };
    for (const Contact& contact : shape.contacts)
      add(contact.parts[0], contact.parts[1]);
    for (std::size_t part = 0; part < shape.parts.size(); ++part)
      add(part, part);
  }

  /// Pairs that touch at an end, those first that come apart least.
  void find_contacts(const std::array<Blend_input, 2>& inputs)
  {
    Candidates candidates;
    for (int end : {0, 1})
      add_candidates(inputs[std::size_t(end)], end, candidates);
    std::map<Index_pair, Contact_constraint> contacts;
    for (const auto& [pair, is_contact] : candidates) {
      const auto contact = contacts.emplace(pair, contact_of(pair)).first;
      for (std::size_t end : {0u, 1u})
        contact->second.touch[end] = contact->second.touch[end] || is_contact[end];
    }
    make_symmetric(candidates, contacts);
    for (const auto& [pair, contact] : contacts)
      if (contact.touch[0] || contact.touch[1]) found_.push_back(contact);
    const auto width = [](const Contact_constraint& contact) {
      return quantized(std::max(contact.gap[0], contact.gap[1]));
    };
    std::stable_sort(found_.begin(), found_.end(),
                     [&](const Contact_constraint& a, const Contact_constraint& b) { return width(a) < width(b); });
  }

  /// Images touch if either does.
  void make_symmetric(const Candidates& candidates, std::map<Index_pair, Contact_constraint>& contacts) const
  {
    for (const auto& candidate : candidates) {
      const std::optional<Index_pair> mirrored = image(candidate.first);
      if (!mirrored) continue;
      Contact_constraint& own = contacts.at(candidate.first);
      Contact_constraint& other = contacts.emplace(*mirrored, contact_of(*mirrored)).first->second;
      for (std::size_t end : {0u, 1u})
        own.touch[end] = other.touch[end] = own.touch[end] || other.touch[end];
    }
  }

  Contact_constraint contact_of(const Index_pair& pair) const
  {
    Contact_constraint contact;
    contact.parts = pair;
    for (std::size_t end : {0u, 1u}) {
      const contacts::Triangle_tree &a = *parts_[pair[0]].trees[end], &b = *parts_[pair[1]].trees[end];
      contact.gap[end] = std::sqrt(a.nearly_closest(b).squared);
      contact.touch[end] = contact.gap[end] <= tolerance_;
    }
    return contact;
  }

  void keep(const Contact_constraint& contact)
  {
    kept_.emplace(contact.parts, contact);
    const std::optional<Index_pair> mirrored = image(contact.parts);
    if (!mirrored || kept_.count(*mirrored)) return;
    Contact_constraint other = contact_of(*mirrored);
    other.touch = contact.touch;
    kept_.emplace(*mirrored, other);
  }

  /// Keeps more until all matched parts are connected at an end.
  void join_components(std::size_t end)
  {
    const double joined = std::max(tolerance_, widest_gap_[end]);
    Disjoint_sets components(parts_.size());
    for (const auto& [pair, contact] : kept_)
      if (contact.gap[end] <= joined) components.unite(pair[0], pair[1]);
    for (const Contact_constraint& contact : found_)
      if (contact.gap[end] <= joined && components.unite(contact.parts[0], contact.parts[1])) keep(contact);
    for (const Index_pair& pair : connections(end, components))
      keep(contact_of(pair));
  }

  /// The shortest connections between components of matched parts, at an end, as many as join all.
  std::vector<Index_pair> connections(std::size_t end, const Disjoint_sets& components) const
  {
    std::vector<std::size_t> matched;
    std::vector<const contacts::Triangle_tree*> surfaces;
    for (std::size_t a = 0; a < parts_.size(); ++a) {
      if (!parts_[a].morph) continue;
      matched.push_back(a);
      surfaces.push_back(&*parts_[a].trees[end]);
    }
    Disjoint_sets of_matched(matched.size());
    for (std::size_t i = 0; i < matched.size(); ++i)
      for (std::size_t j = 0; j < i; ++j)
        if (components[matched[i]] == components[matched[j]]) of_matched.unite(i, j);
    std::vector<Index_pair> result;
    for (const Surface_connection& connection : shortest_connections(surfaces, of_matched))
      result.push_back({matched[connection.surfaces[0]], matched[connection.surfaces[1]]});
    return result;
  }

  const std::vector<Blend_part>& parts_;
  double tolerance_;
  std::array<double, 2> widest_gap_;
  std::vector<Contact_constraint> found_;
  std::map<Index_pair, Contact_constraint> kept_;
};

} // namespace

double Contact_constraint::allowed_gap(double t) const
{
  if (touch[0] && touch[1]) return (1 - t) * gap[0] + t * gap[1];
  const double before = touch[0] ? gap[0] : std::max(0., 1 - 2 * t) * gap[0];
  const double after = touch[1] ? gap[1] : std::max(0., 2 * t - 1) * gap[1];
  return t < 0.5 ? before : after;
}

std::vector<Contact_constraint> contact_constraints(const std::array<Blend_input, 2>& inputs, const Blend_ends& ends,
                                                    const std::vector<Blend_part>& parts, double tolerance)
{
  return Contact_chooser(inputs, parts, tolerance, ends.widest_gap).kept();
}

} // namespace CGAL::Shape_correspondence::internal
