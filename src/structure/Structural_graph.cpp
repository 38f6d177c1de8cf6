// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Shape_correspondence/Structural_graph.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <limits>
#include <map>
#include <utility>

namespace CGAL::Shape_correspondence {
namespace {
namespace graph {

constexpr std::size_t no_group = std::numeric_limits<std::size_t>::max();

/// The contacts between two groups, by the indices of the groups, the smaller first.
using Contacts_of_pairs = std::map<std::pair<std::size_t, std::size_t>, std::vector<std::size_t>>;

Contacts_of_pairs contacts_of_pairs(const std::vector<Contact>& contacts, const std::vector<std::size_t>& group)
{
  Contacts_of_pairs result;
  for (std::size_t c = 0; c < contacts.size(); ++c) {
    const std::size_t a = group[contacts[c].parts[0]], b = group[contacts[c].parts[1]];
    if (a != b) result[std::minmax(a, b)].push_back(c);
  }
  return result;
}

bool is_finite(const Part_abstraction& part)
{
  return part.control_points().allFinite() && part.surface.allFinite() && part.hull.allFinite() &&
         std::isfinite(part.volume) && std::isfinite(part.hull_volume) && std::isfinite(part.area);
}

bool is_finite(const Part_group& group)
{
  const Symmetry& s = group.symmetry;
  return s.point.allFinite() && s.direction.allFinite() && std::isfinite(s.residual) && std::isfinite(group.volume) &&
         std::isfinite(group.hull_volume);
}

bool is_finite(const Contact& contact)
{
  const auto fits = [](const Contact::Parameters& p) { return p[0].allFinite() && p[1].allFinite(); };
  return fits(contact.parameters) && std::all_of(contact.further.begin(), contact.further.end(), fits);
}

bool is_finite(const Shape_frame& frame)
{
  return frame.origin.allFinite() && frame.axes.allFinite() && std::isfinite(frame.height);
}

/// The checks of `is_valid_structural_graph()`, which stop at the first failure.
class Validity_check
{
public:
  Validity_check(const Structural_graph& graph, bool verbose)
      : graph_(graph), shape_(structure(graph)), verbose_(verbose)
  {}

  bool operator()() const
  {
    return numbers_are_finite() && groups_partition_parts() && contacts_name_parts() && edges_agree_with_contacts() &&
           groups_have_edges();
  }

private:
  bool fails(const std::string& what) const
  {
    if (verbose_) std::cerr << "structural graph of '" << shape_.name << "': " << what << std::endl;
    return false;
  }

  bool numbers_are_finite() const
  {
    if (!is_finite(shape_.frame)) return fails("the frame is not finite");
    if (!(shape_.frame.height > 0)) return fails("the frame's height is not positive");
    for (const Part_abstraction& part : shape_.parts)
      if (!is_finite(part)) return fails("part '" + part.name + "' is not finite");
    for (const Contact& contact : shape_.contacts)
      if (!is_finite(contact)) return fails("the parameters of a contact are not finite");
    for (std::size_t v = 0; v < num_vertices(graph_); ++v)
      if (!is_finite(graph_[v])) return fails("group " + std::to_string(v) + " is not finite");
    const Eigen::MatrixXd& features = shape_.features;
    if (features.size() > 0 && std::size_t(features.cols()) != shape_.parts.size())
      return fails("there are features of " + std::to_string(features.cols()) + " parts");
    if (!features.allFinite()) return fails("the features are not finite");
    return true;
  }

  bool groups_partition_parts() const
  {
    std::vector<int> uses(shape_.parts.size(), 0);
    for (std::size_t v = 0; v < num_vertices(graph_); ++v) {
      if (graph_[v].parts.empty()) return fails("group " + std::to_string(v) + " has no part");
      for (std::size_t part : graph_[v].parts) {
        if (part >= uses.size()) return fails("group " + std::to_string(v) + " has a part that does not exist");
        ++uses[part];
      }
    }
    for (std::size_t part = 0; part < uses.size(); ++part)
      if (uses[part] != 1)
        return fails("part '" + shape_.parts[part].name + "' is in " + std::to_string(uses[part]) + " groups");
    return true;
  }

  bool contacts_name_parts() const
  {
    for (const Contact& contact : shape_.contacts)
      if (contact.parts[0] >= shape_.parts.size() || contact.parts[1] >= shape_.parts.size() ||
          contact.parts[0] == contact.parts[1])
        return fails("a contact does not name two parts");
    return true;
  }

  bool edges_agree_with_contacts() const
  {
    Contacts_of_pairs expected = contacts_of_pairs(shape_.contacts, group_of_parts(graph_));
    for (auto [edge, last] = edges(graph_); edge != last; ++edge) {
      const auto found = expected.find(std::minmax(source(*edge, graph_), target(*edge, graph_)));
      if (found == expected.end()) return fails("two edges join the same groups, or one has no contact");
      if (found->second != graph_[*edge].contacts) return fails("an edge does not have the contacts of its groups");
      expected.erase(found);
    }
    return expected.empty() || fails("two groups in contact have no edge");
  }

  bool groups_have_edges() const
  {
    if (num_vertices(graph_) < 2) return true;
    for (std::size_t v = 0; v < num_vertices(graph_); ++v)
      if (out_degree(v, graph_) == 0) return fails("group " + std::to_string(v) + " touches no other");
    return true;
  }

  const Structural_graph& graph_;
  const Shape_structure& shape_;
  bool verbose_;
};

} // namespace graph
} // namespace

std::vector<std::size_t> group_of_parts(const Structural_graph& graph)
{
  std::vector<std::size_t> result(structure(graph).parts.size(), graph::no_group);
  for (std::size_t v = 0; v < num_vertices(graph); ++v)
    for (std::size_t part : graph[v].parts)
      result[part] = v;
  return result;
}

Structural_graph make_structural_graph(Shape_structure shape, std::vector<Part_group> groups)
{
  Structural_graph graph(groups.size());
  structure(graph) = std::move(shape);
  for (std::size_t v = 0; v < groups.size(); ++v)
    graph[v] = std::move(groups[v]);
  const std::vector<std::size_t> group = group_of_parts(graph);
  CGAL_precondition(std::find(group.begin(), group.end(), graph::no_group) == group.end());
  for (auto& [pair, contacts] : graph::contacts_of_pairs(structure(graph).contacts, group))
    add_edge(pair.first, pair.second, Group_contact{std::move(contacts)}, graph);
  return graph;
}

bool is_valid_structural_graph(const Structural_graph& graph, bool verbose)
{
  return graph::Validity_check(graph, verbose)();
}

} // namespace CGAL::Shape_correspondence
