// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "base/clamped.h"
#include "base/limits.h"
#include "io/read/graph_documents.h"
#include "io/read/xml_document.h"
#include "io/system/quoting.h"

#include <CGAL/Shape_correspondence/IO/structural_graph_formats.h>
#include <CGAL/Shape_correspondence/Invalid_input.h>

#include <boost/algorithm/string/case_conv.hpp>
#include <boost/algorithm/string/trim.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <sstream>

namespace CGAL::Shape_correspondence::IO {
namespace {

using Tree = boost::property_tree::ptree;

constexpr int spline_samples = 33, side_samples = 9; // of a spline, along a side

/// The values at `t` in [0, 1] of the basis of a B-spline with `n` control points and clamped uniform knots; cubic, or
/// of the highest degree that so few points have (recurrence of Cox and de Boor).
Eigen::VectorXd b_spline_basis(int n, double t)
{
  const int degree = std::min(3, n - 1), inner = n - degree;
  const auto knot = [&](int i) { return std::min(1.0, std::max(0.0, double(i - degree) / inner)); };
  const int span = degree + std::min(inner - 1, static_cast<int>(t * inner));
  std::vector<double> values(n + degree + 1, 0.0);
  values[span] = 1;
  for (int k = 1; k <= degree; ++k)
    for (int i = 0; i < n + degree - k; ++i) {
      const double left = knot(i + k) - knot(i), right = knot(i + k + 1) - knot(i + 1);
      const double from_left = left > 0 ? (t - knot(i)) / left * values[i] : 0;
      const double from_right = right > 0 ? (knot(i + k + 1) - t) / right * values[i + 1] : 0;
      values[i] = from_left + from_right;
    }
  return Eigen::Map<Eigen::VectorXd>(values.data(), n);
}

/// A rational B-spline sheet: control points row by row; a curve is a sheet of one column.
struct B_spline
{
  Points points;
  Eigen::VectorXd weights;
  int rows = 0, cols = 0;

  Point operator()(double u, double v) const
  {
    const Eigen::VectorXd in_u = b_spline_basis(rows, u), in_v = b_spline_basis(cols, v);
    Point sum = Point::Zero();
    double total = 0;
    for (int i = 0; i < rows; ++i)
      for (int j = 0; j < cols; ++j) {
        const double weight = in_u[i] * in_v[j] * weights[i * cols + j];
        sum += weight * points.col(i * cols + j);
        total += weight;
      }
    return sum / total;
  }
};

/// An element of the document, or one of its children, that knows where it is.
class Xml_reader
{
public:
  Xml_reader(const Tree& tree, std::string place) : tree_(tree), place_(std::move(place)) {}

  [[noreturn]] void fail(const std::string& what) const { refuse(place_ + " " + what, remedy::correct_text); }

  std::vector<Xml_reader> children(const std::string& key) const
  {
    std::vector<Xml_reader> result;
    for (const auto& [name, child] : tree_)
      if (name == key) result.emplace_back(child, place_);
    return result;
  }

  std::vector<std::string> texts(const std::string& key) const
  {
    std::vector<std::string> result;
    for (const auto& [name, child] : tree_)
      if (name == key) result.push_back(utf8_text(boost::trim_copy(child.data(), std::locale::classic())));
    return result;
  }

  std::string text(const std::string& key) const
  {
    const std::vector<std::string> all = texts(key);
    if (all.empty() || all[0].empty()) fail("has no <" + key + ">");
    return all[0];
  }

  std::vector<double> numbers(const std::string& text) const
  {
    std::vector<double> result;
    std::istringstream in(text);
    in.imbue(std::locale::classic());
    for (double x; in >> x;)
      result.push_back(x);
    if (!in.eof()) fail("has '" + text + "', which are not numbers");
    return result;
  }

private:
  const Tree& tree_;
  std::string place_;
};

/// A part and the spline that it was sampled from, whose parameters edges name.
struct Spline_part
{
  Part_abstraction part;
  B_spline spline;
};

std::vector<int> control_counts(const Xml_reader& node)
{
  std::vector<int> result;
  for (const Xml_reader& controls : node.children("controls"))
    for (const std::string& text : controls.texts("c")) {
      const std::vector<double> count = node.numbers(text);
      if (count.size() != 1 || count[0] < 1 || count[0] > 1e4 || count[0] != std::floor(count[0]))
        node.fail("has '" + text + "' in <controls>, which is not a number of control points");
      result.push_back(static_cast<int>(count[0]));
    }
  return result;
}

B_spline read_spline(const Xml_reader& node, bool is_sheet)
{
  B_spline spline;
  const std::vector<std::string> points = node.texts("point");
  spline.points.resize(3, points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const std::vector<double> p = node.numbers(points[i]);
    if (p.size() != 3) node.fail("has a <point> '" + points[i] + "' that is not three numbers");
    spline.points.col(i) << p[0], p[1], p[2];
    if (!(spline.points.col(i).array().abs() <= internal::largest_coordinate).all()) // nor is NaN
      node.fail("has a <point> '" + points[i] + "' with a coordinate beyond 1e15");
  }
  spline.rows = static_cast<int>(points.size());
  spline.cols = 1;
  if (is_sheet) {
    const std::vector<int> counts = control_counts(node);
    if (counts.size() != 2) node.fail("is a sheet, but <controls> does not hold two counts <c>");
    spline.rows = counts[0];
    spline.cols = counts[1];
    if (std::size_t(spline.rows) * spline.cols != points.size())
      node.fail("has " + std::to_string(points.size()) + " <point>s, but <controls> says " +
                std::to_string(spline.rows) + " x " + std::to_string(spline.cols));
  }
  if (spline.rows < 2 || (is_sheet && spline.cols < 2)) node.fail("has fewer than two control points along a side");
  if ((spline.points.rowwise().maxCoeff() - spline.points.rowwise().minCoeff()).norm() == 0)
    node.fail("has all its control points at the same place");
  spline.weights = Eigen::VectorXd::Ones(points.size());
  for (const std::string& text : node.texts("weights")) {
    const std::vector<double> weights = node.numbers(text);
    if (weights.empty()) continue;
    if (weights.size() != points.size()) node.fail("does not have as many <weights> as points");
    spline.weights = Eigen::Map<const Eigen::VectorXd>(weights.data(), weights.size());
    constexpr double least = 1e-6, greatest = 1e6;
    if (!(spline.weights.array() >= least && spline.weights.array() <= greatest).all())
      node.fail("has <weights> that are not between 1e-6 and 1e6");
  }
  return spline;
}

Spline_part read_part(const Xml_reader& node)
{
  Spline_part result;
  result.part.name = node.text("id");
  const std::string type = boost::to_upper_copy(node.text("type"));
  if (type != "CURVE" && type != "SHEET") node.fail("has the <type> '" + type + "', which is none of CURVE, SHEET");
  const bool is_sheet = type == "SHEET";
  result.spline = read_spline(node, is_sheet);
  const int rows = is_sheet ? side_samples : spline_samples, cols = is_sheet ? side_samples : 1;
  Points points(3, rows * cols);
  for (int i = 0; i < rows; ++i)
    for (int j = 0; j < cols; ++j)
      points.col(i * cols + j) = result.spline(double(i) / (rows - 1), cols == 1 ? 0 : double(j) / (cols - 1));
  if (is_sheet)
    result.part.geometry = Sheet{points, rows, cols};
  else
    result.part.geometry = Curve{points, false};
  return result;
}

using Indices = std::map<std::string, std::size_t>;

std::vector<std::size_t> members(const Xml_reader& element, const Indices& indices)
{
  std::vector<std::size_t> result;
  for (const std::string& name : element.texts("n")) {
    const auto found = indices.find(name);
    if (found == indices.end()) element.fail("names the node '" + name + "', which does not exist");
    result.push_back(found->second);
  }
  return result;
}

/// Where one end of an edge is on its part, a parameter for each `uv`.
std::vector<Eigen::Vector2d> read_coordinates(const Xml_reader& coord, const Spline_part& part)
{
  std::vector<Eigen::Vector2d> result;
  for (const std::string& text : coord.texts("uv")) {
    const std::vector<double> uv = coord.numbers(text);
    if (uv.size() < 2 || std::isnan(uv[0]) || std::isnan(uv[1]))
      coord.fail("has a <uv> '" + text + "' that is not two numbers");
    const Point place = part.spline(internal::clamped_to_unit(uv[0]), internal::clamped_to_unit(uv[1]));
    result.push_back(nearest_parameter(part.part, place));
  }
  if (result.empty()) coord.fail("has a <coord> without <uv>");
  return result;
}

/// The places where two parts are nearest, for an edge that does not say where it is.
Contact::Parameters nearest_places(const Part_abstraction& a, const Part_abstraction& b)
{
  Contact::Parameters best;
  double least = std::numeric_limits<double>::infinity();
  for (const auto& column : a.control_points().colwise()) {
    const Eigen::Vector2d on_b = nearest_parameter(b, column);
    const double distance = (evaluate(b, on_b) - column).norm();
    if (distance >= least) continue;
    least = distance;
    best = {nearest_parameter(a, evaluate(b, on_b)), on_b};
  }
  return best;
}

Contact read_edge(const Xml_reader& edge, const std::vector<Spline_part>& parts, const Indices& indices)
{
  const std::vector<std::size_t> ends = members(edge, indices);
  if (ends.size() != 2 || ends[0] == ends[1]) edge.fail("does not join two nodes");
  Contact contact{{ends[0], ends[1]}, {}, {}};
  std::vector<std::vector<Eigen::Vector2d>> places;
  for (const Xml_reader& coord : edge.children("coord"))
    if (places.size() < 2) places.push_back(read_coordinates(coord, parts[ends[places.size()]]));
  if (places.size() < 2) {
    contact.parameters = nearest_places(parts[ends[0]].part, parts[ends[1]].part);
    return contact;
  }
  contact.parameters = {places[0][0], places[1][0]};
  for (std::size_t i = 1; i < std::min(places[0].size(), places[1].size()); ++i)
    contact.further.push_back({places[0][i], places[1][i]});
  return contact;
}

/// The symmetry of a group of which the document says its members alone: that which is detected, or else the mirror
/// plane half-way between two, the mean step of several.
Part_group make_group(const std::vector<std::size_t>& parts, const Shape_structure& shape,
                      const std::vector<Part_group>& detected)
{
  for (const Part_group& group : detected)
    if (std::set<std::size_t>(group.parts.begin(), group.parts.end()) ==
        std::set<std::size_t>(parts.begin(), parts.end()))
      return group;
  Part_group group;
  group.parts = parts;
  const auto middle = [&](std::size_t part) { return Point(shape.parts[part].control_points().rowwise().mean()); };
  const Point first = middle(parts.front()), last = middle(parts.back());
  group.symmetry.point = first;
  if (parts.size() == 2 && (last - first).norm() > 0) {
    group.symmetry.type = Symmetry_type::REFLECTION;
    group.symmetry.point = (first + last) / 2;
    group.symmetry.direction = (first - last).normalized();
  } else if (parts.size() > 1) {
    group.symmetry.type = Symmetry_type::TRANSLATION;
    group.symmetry.direction = (last - first) / (double(parts.size()) - 1);
  }
  return group;
}

/// The elements of one name in a document, which are numbered in messages.
std::vector<Xml_reader> elements(const Tree& document, const std::string& name, const std::string& file)
{
  std::vector<Xml_reader> result;
  for (const auto& [key, element] : document)
    if (key == name) result.emplace_back(element, file + ": " + name + " " + std::to_string(result.size() + 1));
  return result;
}

std::vector<Spline_part> read_parts(const Tree& document, const std::string& file, Indices& indices)
{
  std::vector<Spline_part> parts;
  for (const Xml_reader& node : elements(document, "node", file)) {
    parts.push_back(read_part(node));
    if (!indices.emplace(parts.back().part.name, indices.size()).second) node.fail("has the <id> of an earlier one");
    if (parts.size() > internal::most_parts)
      throw Invalid_input(file + ": it has more than " + std::to_string(internal::most_parts) +
                          " <node>s, the most that a shape may have; join some of them");
  }
  if (parts.size() < 2)
    throw Invalid_input(file + ": it has fewer than two <node>s; describe a shape of two parts or more");
  return parts;
}

/// Edges between the same nodes are one contact.
std::vector<Contact> read_contacts(const Tree& document, const std::string& file, const std::vector<Spline_part>& parts,
                                   const Indices& indices)
{
  std::vector<Contact> contacts;
  for (const Xml_reader& edge : elements(document, "edge", file))
    contacts.push_back(read_edge(edge, parts, indices));
  return merged_contacts(std::move(contacts));
}

/// The groups that the document gives, and one of its own for every part that it leaves out; none if it gives none.
std::vector<Part_group> read_groups(const Tree& document, const std::string& file, const Shape_structure& shape,
                                    const Indices& indices, bool are_wanted)
{
  std::vector<std::vector<std::size_t>> lists;
  std::set<std::size_t> grouped;
  for (const Xml_reader& group : elements(document, "group", file)) {
    lists.push_back(members(group, indices));
    if (lists.back().empty()) group.fail("has no <n>");
    for (std::size_t part : lists.back())
      if (!grouped.insert(part).second) group.fail("names a node that is in a group already");
  }
  std::vector<Part_group> groups;
  if (lists.empty() || !are_wanted) return groups;
  for (std::size_t part = 0; part < shape.parts.size(); ++part)
    if (grouped.count(part) == 0) lists.push_back({part});
  const std::vector<Part_group> detected = detect_symmetry_groups(shape.parts, shape.frame);
  for (const std::vector<std::size_t>& list : lists)
    groups.push_back(make_group(list, shape, detected));
  return groups;
}

} // namespace

Structural_graph read_structural_graph_xml(std::istream& in, const std::string& file_name, const Point& up,
                                           const Structure_options& options)
{
  const Tree tree = parse_xml(read_document(in, file_name), file_name);
  const auto document = tree.find("document");
  if (document == tree.not_found())
    throw Invalid_input(file_name +
                        ": it has no <document>, as a structure graph in XML has; check that it is the right file");
  Shape_structure shape;
  Indices indices;
  shape.name = file_name;
  const std::vector<Spline_part> parts = read_parts(document->second, file_name, indices);
  for (const Spline_part& part : parts)
    shape.parts.push_back(part.part);
  shape.frame = frame_of_abstractions(shape.parts, up);
  shape.contacts = read_contacts(document->second, file_name, parts, indices);
  std::vector<Part_group> groups = read_groups(document->second, file_name, shape, indices, options.symmetry.enabled);
  return complete_structural_graph(std::move(shape), std::move(groups), options);
}

} // namespace CGAL::Shape_correspondence::IO
