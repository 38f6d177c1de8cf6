// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "structure/align_shapes.h"
#include "base/directions.h"
#include "base/quantized.h"

#include <CGAL/Shape_correspondence/abstract_part.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>
#include <tuple>

namespace CGAL::Shape_correspondence {
using namespace internal;

namespace {

Point frame_point(const Shape_frame& frame, const Point& world)
{
  return frame.axes.transpose() * (world - frame.origin) / frame.height;
}

Sampled_part sampled_part(const Part_abstraction& part, const Shape_frame& frame, const Eigen::Matrix3d& turn)
{
  Sampled_part result;
  result.kind = part.is_sheet()          ? Sampled_part::Kind::SHEET
                : part.is_closed_curve() ? Sampled_part::Kind::CLOSED_CURVE
                                         : Sampled_part::Kind::CURVE;
  result.samples = turn * frame.to_frame(sample(part, samples_per_side));
  result.centroid = result.samples.rowwise().mean();
  const Eigen::Index n = std::min<Eigen::Index>(part.surface.cols(), surface_samples);
  result.surface = n > 0 ? Points(turn * frame.to_frame(part.surface.leftCols(n))) : result.samples;
  return result;
}

// The volume of a part; if unknown, that of its hull or of the thickened bounding box of its abstraction.
double prominence(const Part_abstraction& part, const Sampled_part& sampled)
{
  if (part.volume > 0) return part.volume;
  if (part.hull_volume > 0) return part.hull_volume;
  constexpr double assumed_thickness = 0.02; // added to the extents of the box, over the shape's height
  const Point extent = sampled.samples.rowwise().maxCoeff() - sampled.samples.rowwise().minCoeff();
  return (extent.array() + assumed_thickness).prod();
}

Symmetry in_common_frame(const Symmetry& symmetry, const Shape_frame& frame, const Eigen::Matrix3d& turn)
{
  Symmetry result = symmetry;
  result.point = turn * frame_point(frame, symmetry.point);
  result.direction = turn * (frame.axes.transpose() * symmetry.direction);
  if (symmetry.type == Symmetry_type::TRANSLATION) result.direction /= frame.height;
  return result;
}

std::size_t nearest_sample(const Points& samples, const Point& p)
{
  Eigen::Index nearest;
  (samples.colwise() - p).colwise().squaredNorm().minCoeff(&nearest);
  return std::size_t(nearest);
}

void build_graph(const std::vector<Part_group>& groups, Aligned_shape& shape)
{
  shape.graph = Aligned_shape::Graph();
  shape.group_of.resize(shape.parts.size());
  shape.boxes.clear();
  for (const Part_group& group : groups) {
    Eigen::AlignedBox3d box;
    for (std::size_t part : group.parts) {
      shape.group_of[part] = shape.boxes.size();
      box.extend(Point(shape.parts[part].samples.rowwise().minCoeff()));
      box.extend(Point(shape.parts[part].samples.rowwise().maxCoeff()));
    }
    shape.boxes.push_back(box);
    add_vertex(group, shape.graph);
  }
  for (std::size_t c = 0; c < shape.contacts.size(); ++c) {
    const std::size_t g = shape.group_of[shape.contacts[c].parts[0]], h = shape.group_of[shape.contacts[c].parts[1]];
    if (g == h) continue;
    auto [connected, found] = edge(g, h, shape.graph);
    if (!found) connected = add_edge(g, h, shape.graph).first;
    shape.graph[connected].contacts.push_back(c);
  }
}

double sampled_hull_volume(const Aligned_shape& shape, const std::vector<std::size_t>& parts)
{
  Points all(3, 0);
  for (std::size_t part : parts) {
    const Points& surface = shape.parts[part].surface;
    all.conservativeResize(3, all.cols() + surface.cols());
    all.rightCols(surface.cols()) = surface;
  }
  return convex_hull_volume(all);
}

// The symmetry of two parts that remain of an orbit under two vertical mirror planes: a reflection, or half a turn.
Symmetry symmetry_of_pair(const Symmetry& orbit, const Point& a, const Point& b)
{
  const Point second_normal = orbit.direction.cross(Point::UnitY());
  const auto is_between = [&](const Point& normal) {
    return normal.dot(a - orbit.point) * normal.dot(b - orbit.point) < 0;
  };
  Symmetry result = orbit;
  if (!is_between(second_normal)) return result;
  result.direction = second_normal;
  if (is_between(orbit.direction)) {
    result.type = Symmetry_type::ROTATION;
    result.direction = Point::UnitY();
    result.order = 2;
  }
  return result;
}

// A group reduced to some of its parts. Its volume shrinks in proportion to the prominence of the parts, its hull
// volume in proportion to the hull of the sampled surfaces.
Part_group remaining(const Aligned_shape& shape, const Part_group& group, std::vector<std::size_t> parts)
{
  Part_group result = group;
  if (parts.size() < group.parts.size()) {
    const auto prominence = [&](const std::vector<std::size_t>& of) {
      return std::accumulate(of.begin(), of.end(), 0.,
                             [&](double sum, std::size_t part) { return sum + shape.prominence[part]; });
    };
    const double hull = sampled_hull_volume(shape, group.parts);
    result.volume *= prominence(parts) / prominence(group.parts);
    if (hull > 0) result.hull_volume *= sampled_hull_volume(shape, parts) / hull;
    if (parts.size() == 1) result.symmetry.type = Symmetry_type::NONE;
    if (parts.size() == 2 && group.symmetry.type == Symmetry_type::REFLECTION)
      result.symmetry =
          symmetry_of_pair(group.symmetry, shape.parts[parts[0]].centroid, shape.parts[parts[1]].centroid);
  }
  result.parts = std::move(parts);
  return result;
}

} // namespace

bool is_isolated(const Aligned_shape& shape, std::size_t group)
{
  return out_degree(group, shape.graph) == 0 &&
         std::none_of(shape.contacts.begin(), shape.contacts.end(),
                      [&](const Aligned_shape::Contact& contact) { return shape.group_of[contact.parts[0]] == group; });
}

Aligned_shape restricted(const Aligned_shape& shape, const std::vector<char>& is_kept)
{
  Aligned_shape result;
  std::vector<std::size_t> index(shape.parts.size());
  for (std::size_t part = 0; part < shape.parts.size(); ++part) {
    if (!is_kept[part]) continue;
    index[part] = result.parts.size();
    result.parts.push_back(shape.parts[part]);
    result.original.push_back(shape.original[part]);
    result.prominence.push_back(shape.prominence[part]);
  }
  std::vector<Part_group> kept_groups;
  for (const Part_group& group : groups(shape)) {
    std::vector<std::size_t> kept;
    std::copy_if(group.parts.begin(), group.parts.end(), std::back_inserter(kept),
                 [&](std::size_t part) { return is_kept[part]; });
    if (kept.empty()) continue;
    kept_groups.push_back(remaining(shape, group, kept));
    for (std::size_t& part : kept_groups.back().parts)
      part = index[part];
  }
  for (Aligned_shape::Contact contact : shape.contacts) {
    if (!is_kept[contact.parts[0]] || !is_kept[contact.parts[1]]) continue;
    contact.parts = {index[contact.parts[0]], index[contact.parts[1]]};
    result.contacts.push_back(contact);
  }
  build_graph(kept_groups, result);
  return result;
}

Aligned_shape ungrouped(Aligned_shape shape)
{
  std::vector<Part_group> single(shape.parts.size());
  for (std::size_t part = 0; part < shape.parts.size(); ++part)
    single[part].parts = {part};
  build_graph(single, shape);
  return shape;
}

Aligned_shape regrouped(Aligned_shape shape, const std::vector<std::vector<std::size_t>>& sets)
{
  std::vector<char> is_in_set(shape.parts.size(), 0);
  std::vector<Part_group> result;
  for (const std::vector<std::size_t>& set : sets) {
    Part_group group;
    for (std::size_t part = 0; part < shape.parts.size(); ++part) {
      if (std::find(set.begin(), set.end(), shape.original[part]) == set.end()) continue;
      group.parts.push_back(part);
      group.volume += shape.prominence[part];
      is_in_set[part] = 1;
    }
    group.hull_volume = group.volume;
    if (!group.parts.empty()) result.push_back(std::move(group));
  }
  for (const Part_group& group : groups(shape)) {
    std::vector<std::size_t> rest;
    std::copy_if(group.parts.begin(), group.parts.end(), std::back_inserter(rest),
                 [&](std::size_t part) { return !is_in_set[part]; });
    if (!rest.empty()) result.push_back(remaining(shape, group, std::move(rest)));
  }
  std::sort(result.begin(), result.end(),
            [](const Part_group& a, const Part_group& b) { return a.parts[0] < b.parts[0]; });
  build_graph(result, shape);
  return shape;
}

std::vector<char> most_prominent_parts(const Aligned_shape& shape, std::size_t count)
{
  const auto prominence = [&](std::size_t group) {
    double most = 0;
    for (std::size_t part : shape.group(group).parts)
      most = std::max(most, shape.prominence[part]);
    return most;
  };
  std::vector<std::size_t> order(shape.number_of_groups());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return prominence(a) > prominence(b); });
  std::vector<char> is_kept(shape.parts.size(), 0);
  std::size_t left = count;
  std::vector<std::size_t> too_large; // parts of groups that did not fit
  for (std::size_t group : order) {
    const auto& parts = shape.group(group).parts;
    if (parts.size() > left) {
      too_large.insert(too_large.end(), parts.begin(), parts.end());
      continue;
    }
    for (std::size_t part : parts)
      is_kept[part] = 1;
    left -= parts.size();
  }
  too_large.resize(std::min(left, too_large.size()));
  for (std::size_t part : too_large)
    is_kept[part] = 1;
  return is_kept;
}

namespace {

using Grid_point = std::array<Steps, 3>;

Grid_point grid_point(const Point& p) { return {quantized(p.y()), quantized(p.x()), quantized(p.z())}; }

// Parts are ordered by their centroids along this direction: by height, then from side to side, then from back to
// front. Its skew components make ties rare, so that rounding hardly ever changes the order.
const Point direction_of_order(0.03, 1, 0.001);

// Sort key of a part: its position along `direction_of_order` and its extent.
using Place = std::pair<Steps, Grid_point>;

Place place_of(const Sampled_part& part)
{
  return {quantized(direction_of_order.dot(part.centroid)),
          grid_point(part.samples.rowwise().maxCoeff() - part.samples.rowwise().minCoeff())};
}

// The samples of a part as a sorted set, which tells parts with equal keys apart, such as parts that cross each other.
std::vector<Grid_point> sample_set(const Sampled_part& part)
{
  std::vector<Grid_point> result;
  for (const auto& sample : part.samples.colwise())
    result.push_back(grid_point(sample));
  std::sort(result.begin(), result.end());
  return result;
}

// Adds the parts ordered by their keys. \return for each part of the graph, its index in the aligned shape
std::vector<std::size_t> add_parts(const Shape_structure& shape, const Eigen::Matrix3d& turn, Aligned_shape& result)
{
  std::vector<Sampled_part> sampled;
  std::vector<Place> places;
  for (const Part_abstraction& part : shape.parts) {
    sampled.push_back(sampled_part(part, shape.frame, turn));
    places.push_back(place_of(sampled.back()));
  }
  result.original.resize(sampled.size());
  std::iota(result.original.begin(), result.original.end(), std::size_t(0));
  std::stable_sort(result.original.begin(), result.original.end(), [&](std::size_t a, std::size_t b) {
    return places[a] != places[b] ? places[a] < places[b] : sample_set(sampled[a]) < sample_set(sampled[b]);
  });
  std::vector<std::size_t> rank(sampled.size());
  for (std::size_t i = 0; i < rank.size(); ++i) {
    const std::size_t part = result.original[i];
    rank[part] = i;
    result.parts.push_back(std::move(sampled[part]));
    result.prominence.push_back(prominence(shape.parts[part], result.parts.back()));
    if (shape.features.size() > 0) result.parts.back().features = shape.features.col(Eigen::Index(part));
  }
  return rank;
}

std::vector<Part_group> aligned_groups(const Structural_graph& graph, const Eigen::Matrix3d& turn,
                                       const std::vector<std::size_t>& rank)
{
  std::vector<Part_group> result;
  for (std::size_t v = 0; v < num_vertices(graph); ++v) {
    Part_group group = graph[v];
    for (std::size_t& part : group.parts)
      part = rank[part];
    std::sort(group.parts.begin(), group.parts.end());
    group.symmetry = in_common_frame(group.symmetry, structure(graph).frame, turn);
    result.push_back(std::move(group));
  }
  std::sort(result.begin(), result.end(),
            [](const Part_group& a, const Part_group& b) { return a.parts[0] < b.parts[0]; });
  return result;
}

// Adds one contact for each pair of touching parts.
void add_contacts(const Shape_structure& shape, const Eigen::Matrix3d& turn, const std::vector<std::size_t>& rank,
                  Aligned_shape& result)
{
  for (const Contact& contact : shape.contacts) {
    Aligned_shape::Contact c;
    const bool swap = rank[contact.parts[0]] > rank[contact.parts[1]];
    for (int side = 0; side < 2; ++side) {
      const std::size_t part = contact.parts[side];
      const Point p = turn * frame_point(shape.frame, evaluate(shape.parts[part], contact.parameters[side]));
      c.parts[side ^ int(swap)] = rank[part];
      c.samples[side ^ int(swap)] = nearest_sample(result.parts[rank[part]].samples, p);
    }
    result.contacts.push_back(c);
  }
  std::sort(result.contacts.begin(), result.contacts.end(),
            [](const Aligned_shape::Contact& a, const Aligned_shape::Contact& b) {
              return std::tie(a.parts, a.samples) < std::tie(b.parts, b.samples);
            });
  const auto same_parts = [](const Aligned_shape::Contact& a, const Aligned_shape::Contact& b) {
    return a.parts == b.parts;
  };
  result.contacts.erase(std::unique(result.contacts.begin(), result.contacts.end(), same_parts), result.contacts.end());
}

} // namespace

Aligned_shape align_shape(const Structural_graph& graph, int quarter_turns)
{
  using namespace internal;
  const Shape_structure& shape = structure(graph);
  const Eigen::Matrix3d turn = quarter_turn(quarter_turns);
  Aligned_shape result;
  const std::vector<std::size_t> rank = add_parts(shape, turn, result);
  add_contacts(shape, turn, rank, result);
  build_graph(aligned_groups(graph, turn, rank), result);
  return result;
}

namespace {

// The angle about the up axis from the orientation of the file (x to the right, projected to the ground) to the frame.
double given_turn(const Shape_frame& frame)
{
  const Point up = frame.axes.col(1);
  const Point sideways = std::abs(up.x()) < 0.9 ? Point::UnitX() : Point::UnitY();
  const Point right = (sideways - sideways.dot(up) * up).normalized(), front = right.cross(up);
  return std::atan2(-front.dot(frame.axes.col(0)), right.dot(frame.axes.col(0)));
}

} // namespace

int given_quarter_turns(const Shape_frame& frame) { return int(std::lround(given_turn(frame) / (EIGEN_PI / 2))); }

std::vector<int> alignment_turns(const Shape_frame& source, const Shape_frame& target)
{
  // A frame differs from the orientation of its file by a small turn plus quarter turns
  const double from = given_turn(source), to = given_turn(target), quarter = double(EIGEN_PI / 2);
  const double given = quarter * (given_quarter_turns(target) - given_quarter_turns(source));
  const auto off = [&](double angle, int q) {
    return quantized(double(std::abs(std::remainder(angle - q * quarter, 2 * EIGEN_PI))));
  };
  const bool half_turns = source.mirror_x != source.mirror_z && target.mirror_x != target.mirror_z;
  std::vector<std::tuple<Steps, Steps, int>> turns;
  for (int q = 0; q < 4; q += half_turns ? 2 : 1)
    turns.emplace_back(off(given, q), off(to - from, q), q);
  std::sort(turns.begin(), turns.end());
  std::vector<int> result;
  for (const auto& turn : turns)
    result.push_back(std::get<2>(turn));
  return result;
}

} // namespace CGAL::Shape_correspondence
