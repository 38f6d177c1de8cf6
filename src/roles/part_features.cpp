// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "roles/part_features.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <utility>

namespace CGAL::Shape_correspondence::internal {

namespace {

// Relative to the height of the shape: a part that begins lower stands on the ground.
constexpr double height_of_ground = 0.03;
// Relative to the width of the shape: how far over the middle plane a part must reach on both sides to span it.
constexpr double margin_of_middle = 0.05;
// Relative to the diagonal of the shape: greatest distance along an axis of a centre from the mirror image of another.
constexpr double mirror_tolerance = 0.015;
constexpr double nearly_all = 0.98; // least share of the area of its pieces with which a node counts as all of them
constexpr double thinnest = 0.004;  // least side of a box, relative to the diagonal of the shape
constexpr double least_divisor = 1e-9;

double quotient(double a, double b) { return b > least_divisor ? a / b : 0; }

// Makes the rows of features of all nodes of a tree.
class Part_rows
{
public:
  Part_rows(const Surface_patches& surface, const std::vector<Part_node>& nodes, int quarter_turns)
      : surface_(surface),
        nodes_(nodes),
        turn_(turned_by(quarter_turns)),
        result_(Eigen::Index(nodes.size()), part_feature_count),
        contacts_(surface.patches.size())
  {
    box_ = turned(Eigen::AlignedBox3d(Point(Point::Zero()), surface.sides));
    for (const Surface_patches::Contact& c : surface.contacts) {
      if (c.contact.gap > patch_reach) continue;
      contacts_[c.first].push_back({c.second, c.contact});
      contacts_[c.second].push_back({c.first, c.contact.reversed()});
    }
    measure_pieces();
    for (std::size_t i = 0; i < nodes.size(); ++i)
      copies_[nodes[i].shapes].push_back(i);
    depths_.assign(nodes.size(), 0);
    for (std::size_t i = nodes.size(); i-- > 0;)
      if (nodes[i].parent != Part_node::none) depths_[i] = depths_[nodes[i].parent] + 1;
  }

  Byte_rows made()
  {
    for (std::size_t i = 0; i < nodes_.size(); ++i)
      make_row(i);
    return std::move(result_);
  }

private:
  using Piece_number = std::size_t Surface_patch::*;

  struct Piece
  {
    double area = 0;
    Eigen::AlignedBox3d box;
  };

  static Eigen::Matrix3d turned_by(int quarter_turns)
  {
    Eigen::Matrix3d quarter, result = Eigen::Matrix3d::Identity();
    quarter << 0, 0, 1, 0, 1, 0, -1, 0, 0;
    for (int k = 0; k < quarter_turns; ++k)
      result = quarter * result;
    return result;
  }

  Eigen::AlignedBox3d turned(const Eigen::AlignedBox3d& box) const
  {
    Eigen::AlignedBox3d result(Point(turn_ * box.min()));
    result.extend(Point(turn_ * box.max()));
    return result;
  }

  // The coordinates of a point in the unit box of the shape.
  Eigen::Array3d in_box(const Point& turned_point) const
  {
    return (turned_point - box_.min()).array() / box_.sizes().array().max(thinnest);
  }

  void measure_pieces()
  {
    for (const Surface_patch& patch : surface_.patches) {
      for (auto& [number, pieces] : pieces_) {
        Piece& piece = pieces[patch.*number];
        piece.area += patch.moments.area;
        piece.box.extend(patch.box);
      }
    }
    largest_sheet_ = std::max_element(sheets().begin(), sheets().end(), [](const auto& a, const auto& b) {
                       return a.second.area < b.second.area;
                     })->first;
  }

  const std::map<std::size_t, Piece>& sheets() const { return pieces_[0].second; }

  // The patches in contact with a node, and sums over their contacts with it.
  struct Around
  {
    std::set<std::size_t> patches;
    double area = 0; // area of the node near these patches
    Patch_contact borders;
    const Piece* largest = nullptr; // the largest sheet with one of these patches; null if there is none
  };

  Around around(const Part_node& node) const
  {
    std::vector<bool> is_inside(surface_.patches.size(), false);
    for (std::size_t patch : node.patches)
      is_inside[patch] = true;
    Around result;
    for (std::size_t patch : node.patches)
      for (const auto& [other, contact] : contacts_[patch]) {
        if (is_inside[other]) continue;
        result.patches.insert(other);
        result.area += contact.near[0];
        result.borders += contact;
        const Piece& sheet = sheets().at(surface_.patches[other].sheet);
        if (!result.largest || result.largest->area < sheet.area) result.largest = &sheet;
      }
    return result;
  }

  void make_row(std::size_t i)
  {
    const Part_node& node = nodes_[i];
    Feature_bytes row(&result_(Eigen::Index(i), 0));
    const Around others = around(node);
    set_place(node, row);
    set_form(node, row);
    set_offsets(node, others, row);
    set_merges(i, others, row);
    set_pieces(node, row);
    set_copies(i, row);
    set_borders(node, others, row);
  }

  void set_place(const Part_node& node, Feature_bytes& row) const
  {
    const Eigen::AlignedBox3d box = turned(node.box);
    const Eigen::Array3d low = in_box(box.min()), high = in_box(box.max()), middle = (low + high) / 2,
                         extent = high - low;
    row.share(low.y() < height_of_ground);
    row.share(low.y());
    row.share(high.y());
    row.share(middle.y());
    row.share(extent.y());
    row.share(low.z());
    row.share(high.z());
    row.share(middle.z());
    row.share(extent.z());
    row.share(extent.x());
    row.share(2 * std::abs(middle.x() - 0.5));
    row.share(2 * std::max(0.5 - low.x(), high.x() - 0.5));
    row.share(low.x() < 0.5 - margin_of_middle && high.x() > 0.5 + margin_of_middle);
    double lower = 0;
    for (const Surface_patch& patch : surface_.patches)
      if (patch.box.center().y() < node.box.center().y()) lower += patch.moments.area;
    row.share(lower / surface_.area);
  }

  void set_form(const Part_node& node, Feature_bytes& row) const
  {
    Eigen::Array3d side = node.box.sizes().array().max(1e-4);
    row.share(side.matrix().norm());
    row.share(side.y());
    row.share(node.moments.area / surface_.area);
    row.root(node.moments.area / surface_.area);
    const double of_box = side.x() * side.y() + side.y() * side.z() + side.z() * side.x();
    row.ratio(node.moments.area / (2 * of_box));
    const double volume = (node.lengths.array() * std::sqrt(12.)).max(thinnest).prod();
    row.ratio(volume / side.max(thinnest).prod());
    std::sort(side.data(), side.data() + 3);
    row.share(side[1] / side[2]);
    row.share(side[0] / side[2]);
    row.share(quotient(node.lengths[1], node.lengths[2]));
    row.share(quotient(node.lengths[0], node.lengths[2]));
    const Eigen::Matrix3d axes = turn_ * node.axes;
    const Eigen::Matrix3d spread =
        axes * (node.lengths / std::max(node.lengths.norm(), least_divisor)).asDiagonal() * axes.transpose();
    for (int k = 0; k < 3; ++k)
      row.share(spread(k, k));
    row.share(std::abs(spread(0, 1)));
    row.signed_share(spread(1, 2));
    row.share(std::abs(spread(0, 2)));
    const Eigen::Vector3d shape = box_.sizes();
    row.share(shape.x() / (shape.x() + shape.y()));
    row.share(shape.z() / (shape.z() + shape.y()));
  }

  void set_offset(const Eigen::AlignedBox3d& box, const Eigen::AlignedBox3d& from, Feature_bytes& row) const
  {
    const Eigen::Array3d off = in_box(turned(box).center()) - in_box(turned(from).center());
    row.share(std::abs(off.x()));
    row.signed_share(off.y());
    row.signed_share(off.z());
  }

  void set_offsets(const Part_node& node, const Around& others, Feature_bytes& row) const
  {
    set_offset(node.box, sheets().at(largest_sheet_).box, row);
    set_offset(node.box, others.largest ? others.largest->box : node.box, row);
    row.share(others.largest ? node.moments.area / (node.moments.area + others.largest->area) : 1);
  }

  void set_merges(std::size_t i, const Around& others, Feature_bytes& row) const
  {
    const Part_node& node = nodes_[i];
    const double of_parent = node.parent == Part_node::none ? 0 : nodes_[node.parent].affinity;
    row.share(node.affinity);
    row.share(of_parent);
    row.signed_share(node.affinity - of_parent);
    row.count(others.patches.size());
    row.share(node.gap / 0.03);
    row.count(node.patches.size());
    row.share(depths_[i] / 40.);
    row.root(node.parent == Part_node::none ? 1 : node.moments.area / nodes_[node.parent].moments.area);
    if (node.is_leaf()) {
      row.share(0);
      row.share(0);
    } else {
      const Part_node &a = nodes_[node.children[0]], &b = nodes_[node.children[1]];
      row.root(std::min(a.moments.area, b.moments.area) / std::max(node.moments.area, 1e-12));
      row.share(a.shapes == b.shapes);
    }
  }

  // The shares of the node in the areas of the sheets, components and objects of its patches.
  void set_pieces(const Part_node& node, Feature_bytes& row) const
  {
    for (const auto& [number, pieces] : pieces_) {
      std::set<std::size_t> numbers;
      for (std::size_t patch : node.patches)
        numbers.insert(surface_.patches[patch].*number);
      double area = 0;
      for (std::size_t n : numbers)
        area += pieces.at(n).area;
      const double share = node.moments.area / std::max(area, 1e-12);
      row.count(numbers.size());
      row.share(share > nearly_all);
      row.share(share);
    }
  }

  void set_copies(std::size_t i, Feature_bytes& row) const
  {
    const Part_node& node = nodes_[i];
    const std::vector<std::size_t>& copies = copies_.at(node.shapes);
    row.count(copies.size());
    row.share(double(copies.size()) * node.moments.area / surface_.area);
    const Point centre = turn_ * node.centre;
    const double width = box_.min().x() + box_.max().x();
    row.share(std::any_of(copies.begin(), copies.end(), [&](std::size_t j) {
      if (j == i || nodes_[j].patches[0] == node.patches[0]) return false;
      Point image = turn_ * nodes_[j].centre;
      image.x() = width - image.x();
      return ((image - centre).cwiseAbs().array() < mirror_tolerance).all();
    }));
    row.share(std::abs(2 * centre.x() - width) < mirror_tolerance);
    if (node.parent == Part_node::none) {
      row.share(0);
      row.share(0);
      return;
    }
    const Part_node& parent = nodes_[node.parent];
    const Part_node& sibling = nodes_[parent.children[parent.children[0] == i ? 1 : 0]];
    row.share(sibling.shapes == node.shapes);
    row.count(copies_.at(sibling.shapes).size());
  }

  void set_borders(const Part_node& node, const Around& others, Feature_bytes& row) const
  {
    const double border = others.borders.border;
    row.ratio(border / std::max(node.box.diagonal().norm(), 1e-4));
    row.share(border > 0 ? (others.borders.flat_border / border + 2) / 3 : 0);
    row.share(border > 0 ? (others.borders.concave_border / border + 1) / 2 : 0);
    row.ratio(others.area / std::max(node.moments.area, least_divisor));
  }

  const Surface_patches& surface_;
  const std::vector<Part_node>& nodes_;
  Eigen::Matrix3d turn_;
  Byte_rows result_;
  Eigen::AlignedBox3d box_;                                                  // box of the shape, turned
  std::vector<std::vector<std::pair<std::size_t, Patch_contact>>> contacts_; // indexed by patch
  std::array<std::pair<Piece_number, std::map<std::size_t, Piece>>, 3> pieces_{
      {{&Surface_patch::sheet, {}}, {&Surface_patch::component, {}}, {&Surface_patch::object, {}}}};
  std::size_t largest_sheet_ = 0;
  std::map<std::vector<std::size_t>, std::vector<std::size_t>> copies_; // nodes by `Part_node::shapes`
  std::vector<int> depths_;
};

} // namespace

Byte_rows part_features(const Surface_patches& surface, const std::vector<Part_node>& nodes, int quarter_turns)
{
  return Part_rows(surface, nodes, quarter_turns).made();
}

} // namespace CGAL::Shape_correspondence::internal
