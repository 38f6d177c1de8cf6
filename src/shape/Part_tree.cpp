// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "shape/Part_tree.h"

#include "base/eigen_system.h"
#include "base/quantized.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <queue>
#include <tuple>
#include <utility>

namespace CGAL::Shape_correspondence::internal {
namespace {

// Relative to the diagonal of the model: the length that sides of a box have at least, and the distance along each axis
// below which a part counts as the mirror image of another.
constexpr double least_thickness_of_box = 0.004;
constexpr double mirror_distance = 0.015;
constexpr double smallest_divisor = 1e-9;

using Indices = std::vector<std::size_t>;

void finish_node(Part_node& node)
{
  const double area = std::max(node.moments.area, 1e-12);
  node.centre = node.moments.first / area;
  node.covariance = node.moments.second / area - node.centre * node.centre.transpose();
  const Eigen_system system = eigen_system((node.covariance + node.covariance.transpose()) / 2);
  node.lengths = system.values.cwiseMax(0).cwiseSqrt();
  node.axes = system.vectors;
}

Part_node merged_node(const std::vector<Part_node>& nodes, std::size_t i, std::size_t j)
{
  const Part_node &a = nodes[i], &b = nodes[j];
  Part_node result;
  result.moments = a.moments;
  result.moments += b.moments;
  result.box = a.box.merged(b.box);
  result.patches = a.patches;
  result.patches.insert(result.patches.end(), b.patches.begin(), b.patches.end());
  std::merge(a.shapes.begin(), a.shapes.end(), b.shapes.begin(), b.shapes.end(), std::back_inserter(result.shapes));
  for (Indices Part_node::*numbers : {&Part_node::sheets, &Part_node::components, &Part_node::objects})
    std::set_union((a.*numbers).begin(), (a.*numbers).end(), (b.*numbers).begin(), (b.*numbers).end(),
                   std::back_inserter(result.*numbers));
  result.children = {i, j};
  finish_node(result);
  return result;
}

Eigen::Array3d thickened_sides(const Eigen::AlignedBox3d& box)
{
  return box.sizes().array().max(least_thickness_of_box);
}

double ratio_or_zero(double a, double b) { return b > smallest_divisor ? a / b : 0; }

/// The features of a pair of nodes.
class Pair_row
{
public:
  /// \param s, b the smaller and the bigger node \param contact that of s with b
  Pair_row(const Surface_patches& surface, const Part_node& s, const Part_node& b, const Patch_contact& contact)
      : features(), surface_(surface), s_(s), b_(b), contact_(contact), row_(features.data())
  {
    set_sizes();
    set_distances();
    set_border();
    set_forms();
    set_places();
  }

  Merge_features features;

private:
  void set_sizes()
  {
    const double area_s = std::max(s_.moments.area, smallest_divisor),
                 area_b = std::max(b_.moments.area, smallest_divisor);
    row_.share(contact_.gap / 0.03);
    row_.share(contact_.near[0] / area_s);
    row_.share(contact_.near[1] / area_b);
    row_.root(area_s / surface_.area);
    row_.root(area_b / surface_.area);
    row_.root(area_s / area_b);
    const Eigen::Array3d side_s = thickened_sides(s_.box), side_b = thickened_sides(b_.box),
                         side_u = thickened_sides(s_.box.merged(b_.box));
    const Eigen::Array3d common = (s_.box.max().cwiseMin(b_.box.max()) - s_.box.min().cwiseMax(b_.box.min()))
                                      .array()
                                      .max(-2 * least_thickness_of_box) +
                                  2 * least_thickness_of_box;
    row_.share((common / side_s).min(1).prod());
    row_.share((common / side_b).min(1).prod());
    row_.share(0.5 * (side_s.prod() + side_b.prod()) / side_u.prod());
    const double of_union = s_.box.merged(b_.box).diagonal().norm();
    row_.share(of_union);
    row_.share(s_.box.diagonal().norm());
    row_.share(b_.box.diagonal().norm());
    row_.share(of_union - b_.box.diagonal().norm());
  }

  void set_distances()
  {
    const Point off = s_.centre - b_.centre;
    row_.share(off.norm());
    row_.share(std::hypot(off.x(), off.z()));
    row_.signed_share(off.y());
    row_.share(std::min(std::abs(off.x()), std::abs(off.z())));
    row_.share(std::min({std::hypot(off.x(), off.z()), std::hypot(off.x(), off.y()), std::hypot(off.y(), off.z())}));
    const Point axis = b_.axes.col(2);
    row_.share((off - axis * off.dot(axis)).norm());
    row_.share(std::abs(off.dot(b_.axes.col(0))));
    row_.share(std::abs(off.dot(s_.axes.col(0))));
    const Eigen::Matrix3d form_s = s_.covariance / std::max(s_.covariance.trace(), smallest_divisor),
                          form_b = b_.covariance / std::max(b_.covariance.trace(), smallest_divisor);
    row_.share((form_s - form_b).cwiseAbs().sum() / 3);
    row_.share(s_.shapes == b_.shapes);
    const auto mirrored = [&](int axis_of_mirror) {
      Point image = s_.centre;
      image[axis_of_mirror] = surface_.sides[axis_of_mirror] - image[axis_of_mirror];
      return ((image - b_.centre).cwiseAbs().array() < mirror_distance).all();
    };
    row_.share(mirrored(0) || mirrored(2));
  }

  void set_border()
  {
    const double border = contact_.border;
    row_.ratio(ratio_or_zero(border, s_.box.diagonal().norm()));
    row_.share(border > 0 ? (contact_.flat_border / border + 2) / 3 : 0);
    row_.share(border > 0 ? (contact_.concave_border / border + 1) / 2 : 0);
    row_.share(have_common(s_.sheets, b_.sheets));
    row_.share(have_common(s_.components, b_.components));
    row_.share(s_.objects.size() == 1 && s_.objects == b_.objects);
    row_.share(contact_.has_common_places);
  }

  /// Whether two sorted lists have a number in common.
  static bool have_common(const Indices& a, const Indices& b)
  {
    for (auto i = a.begin(), j = b.begin(); i != a.end() && j != b.end();)
      if (*i == *j)
        return true;
      else
        *i < *j ? ++i : ++j;
    return false;
  }

  void set_forms()
  {
    row_.count(s_.patches.size());
    row_.count(b_.patches.size());
    const auto set_lengths = [&](const Eigen::Vector3d& lengths) {
      row_.share(ratio_or_zero(lengths[1], lengths[2]));
      row_.share(ratio_or_zero(lengths[0], lengths[2]));
    };
    set_lengths(s_.lengths);
    set_lengths(b_.lengths);
    Part_node both;
    both.moments = s_.moments;
    both.moments += b_.moments;
    finish_node(both);
    set_lengths(both.lengths);
  }

  void set_places()
  {
    const double height = std::max(surface_.sides.y(), least_thickness_of_box);
    for (const Part_node* node : {&s_, &b_}) {
      row_.share(node->box.min().y() / height);
      row_.share(node->box.max().y() / height);
      const auto [near, far] = std::minmax({off_middle(*node, 0), off_middle(*node, 2)});
      row_.share(near);
      row_.share(far);
      const Eigen::Array3d side = thickened_sides(node->box);
      const double widest = std::max({surface_.sides.x(), surface_.sides.z(), least_thickness_of_box});
      row_.share(side.y() / height);
      row_.share(std::max(side.x(), side.z()) / widest);
      row_.share(std::min(side.x(), side.z()) / widest);
    }
  }

  double off_middle(const Part_node& node, int axis) const
  {
    return std::abs(2 * node.centre[axis] / std::max(surface_.sides[axis], least_thickness_of_box) - 1);
  }

  const Surface_patches& surface_;
  const Part_node &s_, &b_;
  const Patch_contact& contact_;
  Feature_bytes row_;
};

class Tree_builder
{
public:
  Tree_builder(const Surface_patches& surface, const Merge_affinity& affinity) : surface_(surface), affinity_(affinity)
  {
    for (std::size_t i = 0; i < surface.patches.size(); ++i) {
      Part_node node;
      node.moments = surface.patches[i].moments;
      node.box = surface.patches[i].box;
      node.patches = {i};
      const Surface_patch& patch = surface.patches[i];
      node.shapes = {patch.shape};
      node.sheets = {patch.sheet};
      node.components = {patch.component};
      node.objects = {patch.object};
      finish_node(node);
      nodes_.push_back(std::move(node));
    }
    contacts_.resize(nodes_.size());
    for (const Surface_patches::Contact& c : surface.contacts) {
      contacts_[c.first][c.second] = c.contact;
      contacts_[c.second][c.first] = c.contact.reversed();
    }
  }

  std::vector<Part_node> built()
  {
    is_merged_.assign(nodes_.size(), false);
    for (std::size_t i = 0; i < surface_.patches.size(); ++i)
      for (const auto& [j, contact] : contacts_[i])
        if (i < j) offer(i, j);
    while (!queue_.empty()) {
      const auto [affinity, i, j] = queue_.top();
      queue_.pop();
      if (!is_merged_[std::size_t(-i)] && !is_merged_[std::size_t(-j)])
        merge(std::size_t(-i), std::size_t(-j), double(affinity) * comparison_grid);
    }
    return std::move(nodes_);
  }

private:
  // The quantized affinity, then the negated indices: of equal affinities, the lowest indices are merged first.
  using Offer = std::tuple<Steps, std::ptrdiff_t, std::ptrdiff_t>;

  void offer(std::size_t i, std::size_t j)
  {
    if (std::pair(nodes_[i].moments.area, j) > std::pair(nodes_[j].moments.area, i)) std::swap(i, j);
    const Pair_row row(surface_, nodes_[i], nodes_[j], contacts_[i].at(j));
    const double affinity = affinity_(nodes_[i], nodes_[j], row.features);
    if (affinity >= 0)
      queue_.emplace(quantized(affinity), -std::ptrdiff_t(std::min(i, j)), -std::ptrdiff_t(std::max(i, j)));
  }

  void merge(std::size_t i, std::size_t j, double affinity)
  {
    const std::size_t k = nodes_.size();
    nodes_.push_back(merged_node(nodes_, i, j));
    nodes_.back().affinity = affinity;
    nodes_.back().gap = contacts_[i].at(j).gap;
    nodes_[i].parent = nodes_[j].parent = k;
    is_merged_[i] = is_merged_[j] = true;
    is_merged_.push_back(false);
    std::map<std::size_t, Patch_contact> of_union;
    for (std::size_t child : {i, j})
      for (const auto& [other, contact] : contacts_[child])
        if (!is_merged_[other]) {
          const auto [known, is_new] = of_union.try_emplace(other, contact);
          if (!is_new) known->second += contact;
        }
    contacts_.push_back(of_union);
    for (const auto& [other, contact] : of_union) {
      contacts_[other][k] = contact.reversed();
      offer(other, k);
    }
  }

  const Surface_patches& surface_;
  const Merge_affinity& affinity_;
  std::vector<Part_node> nodes_;
  std::vector<std::map<std::size_t, Patch_contact>> contacts_; // indexed by two nodes
  std::vector<bool> is_merged_;
  std::priority_queue<Offer> queue_;
};

} // namespace

void Feature_bytes::share(double value)
{
  *next_++ = std::uint8_t(std::lround(254 * std::clamp(double(quantized(value)) * comparison_grid, 0., 1.)));
}

void Feature_bytes::root(double value) { share(std::sqrt(std::max(value, 0.))); }

void Feature_bytes::signed_share(double value) { share((value + 1) / 2); }

void Feature_bytes::ratio(double value) { share(value / (1 + value)); }

void Feature_bytes::count(std::size_t n) { share(std::log2(double(std::max(n, std::size_t(1)))) / 8); }

std::vector<Part_node> part_tree(const Surface_patches& surface, const Merge_affinity& affinity)
{
  return Tree_builder(surface, affinity).built();
}

std::vector<std::size_t> best_cut(const std::vector<Part_node>& nodes, const std::vector<double>& values)
{
  std::vector<double> best = values;
  std::vector<bool> is_cut(nodes.size(), true);
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    if (nodes[i].is_leaf()) continue;
    const double of_children = best[nodes[i].children[0]] + best[nodes[i].children[1]];
    if (quantized(of_children) <= quantized(best[i])) continue;
    best[i] = of_children;
    is_cut[i] = false;
  }
  std::vector<std::size_t> result;
  std::vector<bool> is_above(nodes.size(), true); // whether no ancestor is in the cut
  for (std::size_t i = nodes.size(); i-- > 0;) {
    const std::size_t parent = nodes[i].parent;
    is_above[i] = parent == Part_node::none || (is_above[parent] && !is_cut[parent]);
    if (is_above[i] && is_cut[i]) result.push_back(i);
  }
  std::reverse(result.begin(), result.end());
  return result;
}

} // namespace CGAL::Shape_correspondence::internal
