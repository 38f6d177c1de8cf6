// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Shape_correspondence/Structural_graph.h>

#include <CGAL/assertions.h>

#include <Eigen/Geometry>

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

/// The contacts between every two groups, by the groups' indices, smaller first.
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

/// The checks of `is_valid_structural_graph()`, up to the first that fails.
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

/// The comparison of `are_same_structural_graphs()`.
class Comparison
{
public:
  Comparison(const Structural_graph& a, const Structural_graph& b, double tolerance)
      : a_(a), b_(b), limit_(tolerance * structure(b).frame.height)
  {}

  bool operator()() { return find_parts() && find_motion() && have_same_groups() && have_same_contacts(); }

private:
  /// Finds the part of b with the name of each part of a.
  bool find_parts()
  {
    std::map<std::string, std::size_t> indices;
    for (std::size_t i = 0; i < structure(b_).parts.size(); ++i)
      indices[structure(b_).parts[i].name] = i;
    for (const Part_abstraction& part : structure(a_).parts) {
      const auto found = indices.find(part.name);
      if (found == indices.end() || structure(b_).parts[found->second].geometry.index() != part.geometry.index())
        return false;
      image_.push_back(found->second);
    }
    return indices.size() == image_.size();
  }

  /// Finds the similarity that maps all control points nearest to their namesakes.
  bool find_motion()
  {
    Points from(3, 0), to(3, 0);
    for (std::size_t i = 0; i < image_.size(); ++i) {
      const Points &p = structure(a_).parts[i].control_points(), &q = structure(b_).parts[image_[i]].control_points();
      if (p.cols() != q.cols()) return false;
      const Eigen::Index n = from.cols();
      from.conservativeResize(3, n + p.cols());
      to.conservativeResize(3, n + q.cols());
      from.rightCols(p.cols()) = p;
      to.rightCols(q.cols()) = q;
    }
    const Eigen::Matrix4d motion = Eigen::umeyama(from, to);
    linear_ = motion.topLeftCorner<3, 3>();
    shift_ = motion.topRightCorner<3, 1>();
    scale_ = std::cbrt(linear_.determinant());
    const Points moved = (linear_ * from).colwise() + shift_;
    return ((moved - to).colwise().norm().array() <= limit_).all();
  }

  bool is_same(const Point& moved, const Point& other) const { return (moved - other).norm() <= limit_; }

  bool is_same_symmetry(const Symmetry& a, const Symmetry& b) const
  {
    if (a.type != b.type || a.order != b.order) return false;
    if (a.type == Symmetry_type::TRANSLATION) return is_same(linear_ * a.direction, b.direction);
    const Point direction = linear_ * a.direction / scale_, apart = linear_ * a.point + shift_ - b.point;
    if ((direction - b.direction).norm() * structure(b_).frame.height > limit_) return false;
    const bool is_axis = a.type == Symmetry_type::ROTATION;
    return (is_axis ? apart.cross(b.direction).norm() : std::abs(apart.dot(b.direction))) <= limit_;
  }

  bool have_same_groups() const
  {
    if (num_vertices(a_) != num_vertices(b_)) return false;
    const std::vector<std::size_t> group = group_of_parts(b_);
    for (std::size_t v = 0; v < num_vertices(a_); ++v) {
      std::vector<std::size_t> members;
      for (std::size_t part : a_[v].parts)
        members.push_back(image_[part]);
      const Part_group& other = b_[group[members[0]]];
      if (members != other.parts || !is_same_symmetry(a_[v].symmetry, other.symmetry)) return false;
    }
    return true;
  }

  /// The regions of a contact, each by the midpoint of its two places.
  static std::vector<Point> places(const Shape_structure& shape, const Contact& contact)
  {
    std::vector<Contact::Parameters> all = {contact.parameters};
    all.insert(all.end(), contact.further.begin(), contact.further.end());
    std::vector<Point> result;
    for (const Contact::Parameters& p : all)
      result.push_back((evaluate(shape.parts[contact.parts[0]], p[0]) + evaluate(shape.parts[contact.parts[1]], p[1])) /
                       2);
    return result;
  }

  bool have_same_contacts() const
  {
    std::map<std::pair<std::size_t, std::size_t>, const Contact*> others;
    for (const Contact& contact : structure(b_).contacts)
      others[std::minmax(contact.parts[0], contact.parts[1])] = &contact;
    if (others.size() != structure(a_).contacts.size()) return false;
    for (const Contact& contact : structure(a_).contacts) {
      const std::size_t p = image_[contact.parts[0]], q = image_[contact.parts[1]];
      const auto found = others.find(std::minmax(p, q));
      if (found == others.end()) return false;
      const std::vector<Point> from = places(structure(a_), contact), to = places(structure(b_), *found->second);
      const auto is_among_them = [&](const Point& x) {
        return std::any_of(to.begin(), to.end(), [&](const Point& y) { return is_same(linear_ * x + shift_, y); });
      };
      if (from.size() != to.size() || !std::all_of(from.begin(), from.end(), is_among_them)) return false;
    }
    return true;
  }

  const Structural_graph &a_, &b_;
  double limit_;
  std::vector<std::size_t> image_; ///< of every part of a
  Eigen::Matrix3d linear_;
  Point shift_;
  double scale_ = 1;
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

bool are_same_structural_graphs(const Structural_graph& a, const Structural_graph& b, double tolerance)
{
  return graph::Comparison(a, b, tolerance)();
}

} // namespace CGAL::Shape_correspondence
