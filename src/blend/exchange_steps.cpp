// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "blend/schedules.h"

#include "base/Disjoint_sets.h"
#include "base/quantized.h"
#include "blend/Blend_structure.h"

#include <CGAL/Shape_correspondence/Structural_graph.h>

#include <boost/dynamic_bitset.hpp>

#include <algorithm>
#include <array>
#include <bitset>
#include <cstddef>
#include <iterator>
#include <limits>
#include <map>
#include <numeric>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL::Shape_correspondence::internal {
namespace {

using Cell = std::array<int, 3>;

/// The cells whose centres are near a surface, in lexicographic order. Cells beside its box are tested as well, so that
/// rounding of the box does not matter.
std::vector<Cell> cells_of(const contacts::Triangle_tree& tree, double side)
{
  const double squared_radius = 0.7 * side * side; // a sphere slightly smaller than that through a cell's corners
  const Eigen::Array3i low = (tree.box().min() / side).array().floor().cast<int>() - 1,
                       high = (tree.box().max() / side).array().floor().cast<int>() + 1;
  std::vector<Cell> result;
  for (int x = low[0]; x <= high[0]; ++x)
    for (int y = low[1]; y <= high[1]; ++y)
      for (int z = low[2]; z <= high[2]; ++z)
        if (tree.is_near(side * Point(x + 0.5, y + 0.5, z + 0.5), squared_radius)) result.push_back({x, y, z});
  return result;
}

/// The overlap of two surfaces by their cells, in [0, 1].
double shared_cells(const std::vector<Cell>& a, const std::vector<Cell>& b)
{
  constexpr double beside = 0.4; // share of the smaller surface's cells up to which the surfaces count as side by side
  std::vector<Cell> shared;
  std::set_intersection(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(shared));
  if (shared.empty()) return 0;
  const double share = double(shared.size()) / double(std::min(a.size(), b.size()));
  return std::max(0., (share - beside) / (1 - beside));
}

/// The share of a surface that is hidden inside another one; 0 unless that is most of it.
double hidden(const Seen_surface& a, const Seen_surface& b)
{
  constexpr double most = 0.65; // share above which a surface counts as hidden
  const double share = share_inside(a, b);
  return share > most ? share : 0;
}

/// Gap, over the height, from which on a part that was in contact counts as fully detached.
constexpr double off = 0.04;

/// An old part and a new part that occupy the same place.
struct Rivals
{
  std::size_t old_part, new_part;
  double size; ///< size of the smaller part times the overlap
};

/// A contact of an unmatched part with another part.
struct Hold
{
  std::size_t part, holder;
  double size; ///< size of the part over the number of its contacts
  Point place;
  std::vector<std::pair<std::size_t, double>> near; ///< other parts and their distances from the place
};

/// Assigns exchanged parts to the first or the second step.
class Exchange_search
{
public:
  explicit Exchange_search(const Blend_structure& blend)
      : blend_(blend),
        seen_(In_between_shape(blend, {}, Part_morph::change).seen()),
        groups_(blend.parts.size()),
        always_joined_(groups_)
  {
    find_holds();
    unite_groups();
    unite_what_is_held_alike();
    const std::vector<std::vector<Cell>> cells = this->cells();
    find_rivals(cells);
    find_exchanged();
    find_filled_cells(cells);
    find_joined();
  }

  std::vector<Exchange> steps(const std::function<bool(double)>& progress) const
  {
    const Parts is_there = best(progress);
    std::vector<Exchange> result(seen_.size());
    for (std::size_t i = 0; i < result.size(); ++i)
      if (is_exchanged(i)) result[i].step = is_there[i] != old_[i] ? Exchange_step::FIRST : Exchange_step::SECOND;
    for (Exchange_step step : {Exchange_step::FIRST, Exchange_step::SECOND}) {
      std::vector<std::size_t> places; // the places where parts change in this step, from the ground up
      for (const Parts& group : exchanged_)
        if (const std::size_t part = group.find_first(); result[part].step == step)
          if (std::find(places.begin(), places.end(), places_[part]) == places.end()) places.push_back(places_[part]);
      for (std::size_t i = 0; i < result.size() && places.size() > 1; ++i) {
        if (result[i].step != step) continue;
        const auto at = std::find(places.begin(), places.end(), places_[i]) - places.begin();
        result[i].order = double(at) / double(places.size() - 1);
      }
    }
    return result;
  }

private:
  using Parts = boost::dynamic_bitset<>; ///< a set of parts

  bool is_matched(std::size_t part) const { return blend_.parts[part].is_matched(); }
  std::size_t end(std::size_t part) const { return std::size_t(blend_.parts[part].end()); }
  /// The size of a part: its diagonal, since a thin part is as visible as a solid one.
  double size(std::size_t part) const { return blend_.parts[part].size; }
  double distance(const Point& place, std::size_t part) const
  {
    std::size_t triangle = 0;
    return (seen_[part].tree.nearest(place, triangle) - place).norm();
  }
  bool is_exchanged(std::size_t part) const { return ends_[places_[part]].all(); }
  /// For each set, the ends of its unmatched parts.
  std::vector<std::bitset<2>> ends_of(const Disjoint_sets& sets) const
  {
    std::vector<std::bitset<2>> result(sets.size());
    for (std::size_t i = 0; i < sets.size(); ++i)
      if (!is_matched(i)) result[sets[i]].set(end(i));
    return result;
  }
  void unite(Disjoint_sets& sets, std::size_t a, std::size_t b) const
  {
    if (!is_matched(a) && !is_matched(b)) sets.unite(a, b); // matched parts change by themselves
  }

  void find_holds()
  {
    std::vector<int> count(seen_.size(), 0); // number of contacts, by part
    for (const Touch& touch : blend_.touches)
      for (std::size_t part : touch)
        ++count[part];
    for (const Touch& touch : blend_.touches)
      for (std::size_t i : {0u, 1u}) {
        const std::size_t part = touch[i], holder = touch[1 - i];
        if (is_matched(part)) continue;
        const Point place = seen_[part].tree.nearly_closest(seen_[holder].tree).first;
        Hold hold{part, holder, size(part) / count[part], place, {}};
        for (std::size_t other = 0; other < seen_.size(); ++other)
          if (other != part && other != holder && seen_[other].tree.box().exteriorDistance(place) < off)
            hold.near.emplace_back(other, distance(place, other));
        holds_.push_back(std::move(hold));
      }
  }

  void unite_groups()
  {
    const auto part_of = [&](int end, std::size_t given) { return parts_of(blend_.parts, end, given).front(); };
    for (const auto& [s, t] : blend_.unlike)
      unite(groups_, part_of(0, s), part_of(1, t));
    const std::array<std::vector<std::size_t>, 2> symmetric = {group_of_parts(blend_.stage.graphs[0]),
                                                               group_of_parts(blend_.stage.graphs[1])};
    std::map<std::pair<std::size_t, std::size_t>, std::size_t> unlike; // by end and symmetry group, the first such part
    std::optional<std::size_t> standing;
    for (std::size_t i = 0; i < groups_.size(); ++i) {
      if (is_matched(i)) continue;
      const Blend_part& part = blend_.parts[i];
      if (part.task.obstacle != Blend_obstacle::NONE)
        unite(groups_, i, unlike.try_emplace({end(i), symmetric[end(i)][part.given(part.end())]}, i).first->second);
      if (const auto image = blend_.stage.images[end(i)][part.given(part.end())])
        unite(groups_, i, part_of(part.end(), *image));
      if (part.end_tree(part.end()).box().min().y() > Blend_part::on_ground) continue;
      if (!standing) standing = i;
      groups_.unite(i, *standing);
    }
  }

  /// Unites old and new parts without counterpart that are attached to the same place, as a cactus and leaves in a pot.
  void unite_what_is_held_alike()
  {
    constexpr double near = 0.1; // distance, over the height, below which two places of contact are the same
    const Disjoint_sets groups = groups_;
    const std::vector<std::bitset<2>> ends = ends_of(groups);
    const auto is_alone = [&](const Hold& hold) { return !ends[groups[hold.part]].all(); };
    const auto have_one_place = [&](const Hold& a, const Hold& b) {
      return quantized(std::min(distance(a.place, b.part), distance(b.place, a.part))) < quantized(near);
    };
    for (const Hold& a : holds_)
      for (const Hold& b : holds_)
        if (end(a.part) < end(b.part) && is_alone(a) && is_alone(b) && groups[a.holder] == groups[b.holder] &&
            groups_[a.part] != groups_[b.part] && have_one_place(a, b))
          groups_.unite(a.part, b.part);
  }

  std::vector<std::vector<Cell>> cells() const
  {
    constexpr double least_side = 0.06, most_cells = 64; // least side, over the height; most cells along an axis
    const contacts::Box whole = blend_.stage.boxes[0].merged(blend_.stage.boxes[1]);
    const double side = std::max(least_side, whole.sizes().maxCoeff() / most_cells);
    std::vector<std::vector<Cell>> result;
    for (const Seen_surface& seen : seen_)
      result.push_back(cells_of(seen.tree, side));
    return result;
  }

  void find_rivals(const std::vector<std::vector<Cell>>& cells)
  {
    for (std::size_t a = 0; a < seen_.size(); ++a)
      for (std::size_t b = a + 1; b < seen_.size(); ++b) {
        if (is_matched(a) || is_matched(b) || end(a) == end(b)) continue;
        const double shared =
            std::max({shared_cells(cells[a], cells[b]), hidden(seen_[a], seen_[b]), hidden(seen_[b], seen_[a])});
        // Parts of the source have lower indices
        if (shared > 0) rivals_.push_back({a, b, shared * std::min(size(a), size(b))});
      }
  }

  void find_filled_cells(const std::vector<std::vector<Cell>>& cells)
  {
    std::map<Cell, Parts> parts_at;
    for (std::size_t i = 0; i < seen_.size(); ++i)
      for (const Cell& cell : cells[i])
        parts_at.try_emplace(cell, seen_.size()).first->second.set(i);
    for (const auto& [cell, parts] : parts_at) {
      if (!parts.intersects(old_) || !parts.intersects(new_)) continue;
      Parts near = parts;
      for (std::size_t axis : {0u, 1u, 2u})
        for (int step : {-1, 1}) {
          Cell beside = cell;
          beside[axis] += step;
          if (const auto found = parts_at.find(beside); found != parts_at.end()) near |= found->second;
        }
      std::vector<std::size_t> numbers;
      for (std::size_t i = near.find_first(); i != Parts::npos; i = near.find_next(i))
        numbers.push_back(i);
      ++filled_cells_[numbers];
    }
  }

  /// Finds the groups that are exchanged, sorted from the ground up.
  void find_exchanged()
  {
    places_ = groups_;
    for (const Touch& touch : blend_.touches)
      unite(places_, touch[0], touch[1]);
    for (const Rivals& rivals : rivals_)
      places_.unite(rivals.old_part, rivals.new_part);
    ends_ = ends_of(places_);
    std::map<std::size_t, Parts> exchanged; // indexed by the smallest part of the group
    for (std::size_t i = 0; i < groups_.size(); ++i) {
      old_.push_back(is_matched(i) || (is_exchanged(i) && end(i) == 0));
      new_.push_back(is_matched(i) || (is_exchanged(i) && end(i) == 1));
      if (!is_exchanged(i)) continue;
      exchanged.try_emplace(groups_[i], groups_.size()).first->second.set(i);
      size_ += size(i);
    }
    for (const auto& [number, group] : exchanged)
      exchanged_.push_back(group);
    const auto key = [&](const Parts& group) {
      Eigen::Vector4d sum = Eigen::Vector4d::Zero(); // homogeneous sum of centres, weighted by size
      for (std::size_t i = group.find_first(); i != Parts::npos; i = group.find_next(i))
        sum += size(i) * seen_[i].tree.box().center().homogeneous();
      const Point place = sum.hnormalized();
      return std::tuple(quantized(place.y()), quantized(sum[3]), quantized(place.x()), quantized(place.z()));
    };
    std::stable_sort(exchanged_.begin(), exchanged_.end(),
                     [&](const Parts& a, const Parts& b) { return key(a) < key(b); });
  }

  void find_joined()
  {
    constexpr double near = 0.02; // largest gap, over the height, of parts that count as joined
    const auto join = [&](std::size_t a, std::size_t b) {
      if (is_matched(a) && is_matched(b))
        always_joined_.unite(a, b);
      else
        joined_.push_back({a, b});
    };
    for (const Touch& touch : blend_.touches) // contacts at the ends
      join(touch[0], touch[1]);
    for (std::size_t a = 0; a < seen_.size(); ++a)
      for (std::size_t b = a + 1; b < seen_.size(); ++b)
        if (seen_[a].tree.is_within(seen_[b].tree, near * near)) join(a, b);
  }

  /// Total size of the rivals that are both present or both absent.
  double rivalry(const Parts& is_there) const
  {
    double result = 0;
    for (const auto& [old_part, new_part, size] : rivals_)
      if (is_there[old_part] == is_there[new_part]) result += size;
    return result;
  }

  /// The share of empty cells among those that both shapes fill.
  double holes(const Parts& is_there) const
  {
    double empty = 0, covered = 0;
    const auto is_there_too = [&](std::size_t part) { return is_there[part]; };
    for (const auto& [near, cells] : filled_cells_)
      (std::any_of(near.begin(), near.end(), is_there_too) ? covered : empty) += cells;
    return empty > 0 ? empty / (covered + empty) : 0;
  }

  /// Total size of present parts that touched absent ones, as far as no other part is near the place of contact.
  double come_off(const Parts& is_there) const
  {
    double result = 0;
    for (const Hold& hold : holds_) {
      if (!is_there[hold.part] || is_there[hold.holder]) continue;
      double gap = off;
      for (const auto& [other, distance] : hold.near)
        if (is_there[other]) gap = std::min(gap, distance);
      result += hold.size * gap / off;
    }
    return result;
  }

  /// Total size of the present parts that are not in the largest connected component.
  double hanging(const Parts& is_there) const
  {
    Disjoint_sets components = always_joined_;
    for (const auto& [a, b] : joined_)
      if (is_there[a] && is_there[b]) components.unite(a, b);
    std::vector<double> sizes(components.size(), 0);
    for (std::size_t i = 0; i < sizes.size(); ++i)
      if (is_there[i]) sizes[components[i]] += size(i);
    return std::accumulate(sizes.begin(), sizes.end(), 0.) - *std::max_element(sizes.begin(), sizes.end());
  }

  /// The cost of a mixed shape. \param limit a cost that reaches it may be inexact: the expensive terms are left out
  double cost(const Parts& is_there, double limit = std::numeric_limits<double>::infinity()) const
  {
    constexpr double of_rivals = 2, of_holes = 3; // weights of rivalry and holes; the others have weight 1
    constexpr double worth = 0.3;                 // weight of the gain, the share that changes in the smaller step
    constexpr double least = 0.15;                // least share of the smaller step
    constexpr double too_little = 1000;           // cost above all others, of steps below this share
    double first = 0;                             // size of what changes in the first step
    for (std::size_t i = 0; i < seen_.size(); ++i)
      if (is_there[i] != old_[i]) first += size(i);
    const double lesser = std::min(first, size_ - first) / size_; // 0 if everything changes at once
    // The cost falls with the share, so that the search leaves this region
    if (lesser > 0 && quantized(lesser) < quantized(least)) return too_little - lesser;
    double result = of_rivals * rivalry(is_there) / size_ - worth * lesser;
    if (result < limit) result += come_off(is_there) / size_;
    if (result < limit) result += hanging(is_there) / size_;
    if (result < limit) result += of_holes * holes(is_there);
    return result;
  }

  /// Moves groups to the other step as long as the cost falls. \return the cost
  double improve(Parts& is_there) const
  {
    double least = cost(is_there);
    for (bool is_better = true; is_better;) {
      is_better = false;
      for (const Parts& group : exchanged_) {
        is_there ^= group;
        const double value = cost(is_there, least);
        if (quantized(value) < quantized(least))
          least = value, is_better = true;
        else
          is_there ^= group;
      }
    }
    return least;
  }

  /// The best mixed shape, or `old_` if none is better than both ends.
  Parts best(const std::function<bool(double)>& progress) const
  {
    constexpr std::size_t starts = 8; // one more than the number of starts of the search from either end
    const std::size_t count = exchanged_.size();
    if (count < 2) return old_;
    Parts result = old_;
    double least = std::min(cost(old_), cost(new_)); // least cost without a mixed shape
    for (std::size_t from : {0u, 1u})                // starts from the old and from the new shape
      for (std::size_t i = 1; i < starts; ++i) {
        if (!progress(double(from * starts + i) / double(2 * starts))) return result;
        // Number of groups moved, from the ground up
        const std::size_t moved = std::clamp(i * count / starts, std::size_t(1), count - 1);
        Parts is_there = from == 0 ? old_ : new_;
        for (std::size_t k = 0; k < moved; ++k)
          is_there ^= exchanged_[k];
        const double value = improve(is_there);
        if (quantized(value) < quantized(least)) least = value, result = is_there;
      }
    return result;
  }

  const Blend_structure& blend_;
  const std::vector<Seen_surface> seen_; ///< all parts, at the time when the surfaces of matched parts change
  std::vector<Hold> holds_;
  Disjoint_sets groups_;
  std::vector<Rivals> rivals_;
  /// Numbers of cells filled by both shapes, by the set of parts in the cell or beside it.
  std::map<std::vector<std::size_t>, int> filled_cells_;
  Disjoint_sets places_;             ///< sets of parts joined by groups, contacts and rivals
  std::vector<std::bitset<2>> ends_; ///< for each set of `places_`, the ends of its unmatched parts
  std::vector<Parts> exchanged_;     ///< the exchanged groups, from the ground up
  Parts old_, new_;                  ///< the present parts when nothing is exchanged, and when everything is
  double size_ = 0;                  ///< total size of the exchanged parts
  Disjoint_sets always_joined_;      ///< components of matched parts in contact, at an end or in the mixed shape
  std::vector<std::array<std::size_t, 2>> joined_; ///< other pairs of parts in contact
};

} // namespace

std::vector<Exchange> exchange_steps(const Blend_structure& blend, const std::function<bool(double)>& progress)
{
  return Exchange_search(blend).steps(progress);
}

} // namespace CGAL::Shape_correspondence::internal
