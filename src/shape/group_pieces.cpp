// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "shape/group_pieces.h"
#include "base/limits.h"
#include "shape/Triangle_tree.h"
#include "shape/convex_hull.h"
#include "shape/sample_triangles.h"

#include <CGAL/Shape_correspondence/Invalid_input.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <set>
#include <utility>

namespace CGAL::Shape_correspondence::internal {
namespace {

using contacts::Triangle;
using contacts::Triangle_tree;

// Calibrated on raw files of which the parts are known (the manual's page on accuracy). Lengths over the size of the
// model.
constexpr int piece_samples = 64;           // points sampled on a piece
constexpr Eigen::Index vertex_samples = 64; // greatest number of vertices among the samples of a piece
constexpr double hull_tolerance = 0.005;    // distance outside of a hull that still counts as inside
constexpr std::size_t most_pieces = 1000;   // an object with more pieces, such as the leaves of a tree, stays whole
constexpr double share_in_hull = 0.95;      // least share of a piece inside the hull of the piece that holds it
constexpr double share_interlocked = 0.3;   // least share of each of two interlocked pieces in the other one's hull
constexpr double alike = 0.01;              // largest relative difference of sizes or areas that count as equal
constexpr double holder_size = 0.5; // largest size of a piece that holds others; a larger one is the frame of the model
constexpr double assembly_size = 0.3; // largest size of an object whose pieces stay together if they touch
constexpr double unlimited = 1e100;   // a limit above all distances

/// A piece with its search structures, made on demand.
class Measured_piece
{
public:
  Measured_piece(const Loose_piece& piece, double model_size)
      : piece_(piece), tree_(triangles_of(piece.surface)), samples_(samples_of(piece.surface)), model_size_(model_size)
  {}

  const Triangle_tree& tree() const { return tree_; }
  const Points& samples() const { return samples_; }

  bool is_within(const Measured_piece& other, double distance) const
  {
    return tree_.is_within(other.tree_, distance * distance);
  }

  /// One-sided Hausdorff distance from this piece to another one; infinite if it is `limit` or more.
  double distance_to(const Measured_piece& other, double limit) const
  {
    double result = 0;
    for (Eigen::Index i = 0; i < samples_.cols(); ++i) {
      double squared = limit * limit;
      Point nearest;
      std::size_t triangle = 0;
      if (!other.tree_.improve_nearest(samples_.col(i), nearest, squared, triangle))
        return std::numeric_limits<double>::infinity();
      result = std::max(result, squared);
    }
    return std::sqrt(result);
  }

  /// Share of this piece within `tolerance` of the convex hull of another.
  double share_in(const Measured_piece& other, double tolerance) const
  {
    return other.hull().share_inside(samples_, tolerance);
  }

private:
  /// Points sampled by area, and vertices, so that corners are among them.
  static Points samples_of(const Part_mesh& mesh)
  {
    std::vector<Point> points = contacts::sample_triangles(contacts::sampled_triangles_of(mesh), piece_samples).points;
    const Eigen::Index step = 1 + (mesh.points.cols() - 1) / vertex_samples;
    for (Eigen::Index v = 0; v < mesh.points.cols(); v += step)
      points.push_back(mesh.points.col(v));
    Points result(3, Eigen::Index(points.size()));
    for (std::size_t i = 0; i < points.size(); ++i)
      result.col(Eigen::Index(i)) = points[i];
    return result;
  }

  const Hull_planes& hull() const
  {
    if (!hull_) hull_.emplace(piece_.surface.points, hull_tolerance * model_size_);
    return *hull_;
  }

  const Loose_piece& piece_;
  Triangle_tree tree_;
  Points samples_;
  double model_size_;
  mutable std::optional<Hull_planes> hull_; ///< made on demand
};

/// The piece that another piece may join, and why.
struct Join
{
  std::size_t to;
  double distance; ///< one-sided Hausdorff distance from the joining piece; the nearest piece is joined
  const char* reason;
};

class Grouping
{
public:
  Grouping(const std::vector<Loose_piece>& pieces, const std::vector<std::string>& names, std::size_t objects,
           double size, const Part_splitting_options& options)
      : pieces_(pieces),
        names_(names),
        objects_(objects),
        size_(size),
        options_(options),
        measured_(pieces.size()),
        result_{Disjoint_sets(pieces.size()), std::vector<std::string>(pieces.size()),
                std::vector<std::string>(objects)}
  {}

  Piece_groups run()
  {
    check_number();
    for (std::size_t begin = 0; begin < pieces_.size();) {
      std::size_t end = begin;
      while (end < pieces_.size() && pieces_[end].object == pieces_[begin].object)
        ++end;
      if (end - begin > 1) group_object(begin, end);
      begin = end;
    }
    return std::move(result_);
  }

private:
  /// Throws `Invalid_input` if there are too many pieces to be grouped.
  void check_number() const
  {
    std::vector<std::size_t> count(objects_, 0);
    for (const Loose_piece& piece : pieces_)
      ++count[piece.object];
    std::size_t grouped = 0;
    for (std::size_t n : count)
      if (objects_ == 1 || n <= most_pieces) grouped += n;
    if (grouped > most_grouped_pieces)
      throw Invalid_input("it has " + std::to_string(grouped) + " loose pieces, of which at most " +
                          std::to_string(most_grouped_pieces) +
                          " can be grouped into parts; join pieces to objects in a program for modelling, and take the "
                          "objects as parts");
  }

  /// Groups the pieces of an object.
  void group_object(std::size_t begin, std::size_t end)
  {
    std::string& kept = result_.kept[pieces_[begin].object];
    if (objects_ > 1 && end - begin > most_pieces)
      kept = "they are too many";
    else if (objects_ > 1 && holds_all_others(largest(begin, end), begin, end))
      kept = "its largest piece holds the others";
    else if (objects_ > 1 && is_assembly(begin, end))
      kept = "it is small, and its pieces touch";
    if (!kept.empty()) {
      unite(begin, end);
      return;
    }
    for (std::size_t i = begin; i < end; ++i)
      if (const std::optional<Join> join = join_of(i, begin, end)) {
        result_.sets.unite(i, join->to);
        result_.reasons[i] = join->reason + (' ' + names_[join->to]);
      }
    join_interlocked(begin, end);
    if (number_of_groups(begin, end) <= options_.most_parts || objects_ == 1) return;
    kept = "it would be " + std::to_string(number_of_groups(begin, end)) + " parts";
    unite(begin, end);
  }

  void unite(std::size_t begin, std::size_t end)
  {
    for (std::size_t i = begin + 1; i < end; ++i)
      result_.sets.unite(begin, i);
  }

  std::size_t number_of_groups(std::size_t begin, std::size_t end) const
  {
    std::set<std::size_t> groups;
    for (std::size_t i = begin; i < end; ++i)
      groups.insert(result_.sets[i]);
    return groups.size();
  }

  const Measured_piece& measured(std::size_t i)
  {
    if (!measured_[i]) measured_[i] = std::make_unique<Measured_piece>(pieces_[i], size_);
    return *measured_[i];
  }

  std::size_t largest(std::size_t begin, std::size_t end) const
  {
    const auto first = pieces_.begin();
    return std::size_t(std::max_element(first + std::ptrdiff_t(begin), first + std::ptrdiff_t(end),
                                        [](const Loose_piece& a, const Loose_piece& b) { return a.size < b.size; }) -
                       first);
  }

  bool holds_all_others(std::size_t largest, std::size_t begin, std::size_t end)
  {
    if (pieces_[largest].size > holder_size * size_) return false;
    for (std::size_t i = begin; i < end; ++i)
      if (i != largest && pieces_[i].size > (1 + alike) * pieces_[largest].size) return false;
    const double tolerance = hull_tolerance * size_;
    for (std::size_t i = begin; i < end; ++i)
      if (i != largest && measured(i).share_in(measured(largest), tolerance) < share_in_hull) return false;
    return true;
  }

  /// Whether an object is small and its pieces touch.
  bool is_assembly(std::size_t begin, std::size_t end)
  {
    Points points(3, 0);
    for (std::size_t i = begin; i < end; ++i) {
      const Points& samples = measured(i).samples();
      points.conservativeResize(Eigen::NoChange, points.cols() + samples.cols());
      points.rightCols(samples.cols()) = samples;
    }
    if (size_of(points, points.rowwise().mean()) > assembly_size * size_) return false;
    Disjoint_sets sets(end - begin);
    for (std::size_t i = begin; i < end; ++i)
      for (std::size_t j = begin; j < i; ++j)
        if (sets[i - begin] != sets[j - begin] && are_touching(i, j)) sets.unite(i - begin, j - begin);
    return sets.number_of_sets() == 1;
  }

  bool are_touching(std::size_t i, std::size_t other)
  {
    const double distance = options_.touching_distance * size_;
    return boxes_are_near(i, other, distance) && measured(i).is_within(measured(other), distance);
  }

  /// Whether a piece may join another one: smaller pieces join larger ones; of copies, the later joins the earlier.
  bool may_join(std::size_t i, std::size_t other) const
  {
    const double difference = pieces_[other].area - pieces_[i].area;
    return std::abs(difference) > alike * pieces_[i].area ? difference > 0 : other < i;
  }

  /// The piece of the same object that a piece joins, if any.
  std::optional<Join> join_of(std::size_t i, std::size_t begin, std::size_t end)
  {
    const bool is_small = pieces_[i].size < options_.small_size * size_;
    constexpr double rounding = 1e-9; // relative; a distance equal to its limit would be reported as infinite
    const double lying_limit = (1 + rounding) * options_.layer_distance * size_;
    std::optional<Join> best;
    for (std::size_t other = begin; other < end; ++other) {
      if (other == i || !may_join(i, other) || !boxes_are_near(i, other, lying_limit)) continue;
      const double limit = is_small ? unlimited : lying_limit;
      const double distance = measured(i).distance_to(measured(other), best ? best->distance : limit);
      if (!std::isfinite(distance)) continue;
      if (const char* reason = reason_to_join(i, other, distance, is_small)) best = Join{other, distance, reason};
    }
    return best;
  }

  /// Why a piece may join another one; null if it may not. \param distance one-sided Hausdorff distance
  const char* reason_to_join(std::size_t i, std::size_t other, double distance, bool is_small)
  {
    if (distance <= options_.layer_distance * size_) return "lies on";
    if (is_small && are_touching(i, other)) return "small, touches";
    return nullptr;
  }

  bool boxes_are_near(std::size_t i, std::size_t other, double distance)
  {
    return measured(i).tree().box().exteriorDistance(measured(other).tree().box()) <= distance;
  }

  void join_interlocked(std::size_t begin, std::size_t end)
  {
    for (std::size_t i = begin; i < end; ++i)
      for (std::size_t j = begin; j < i; ++j) {
        if (result_.sets[i] == result_.sets[j] || !are_touching(i, j)) continue;
        const double tolerance = hull_tolerance * size_;
        if (measured(i).share_in(measured(j), tolerance) < share_interlocked ||
            measured(j).share_in(measured(i), tolerance) < share_interlocked)
          continue;
        result_.sets.unite(i, j);
        if (result_.reasons[i].empty()) result_.reasons[i] = "interlocks with " + names_[j];
      }
  }

  const std::vector<Loose_piece>& pieces_;
  const std::vector<std::string>& names_;
  std::size_t objects_;
  double size_;
  const Part_splitting_options& options_;
  std::vector<std::unique_ptr<Measured_piece>> measured_; ///< indexed by piece; made on demand
  Piece_groups result_;
};

} // namespace

Piece_groups group_pieces(const std::vector<Loose_piece>& pieces, const std::vector<std::string>& names,
                          std::size_t objects, double size, const Part_splitting_options& options)
{
  return Grouping(pieces, names, objects, size, options).run();
}

} // namespace CGAL::Shape_correspondence::internal
