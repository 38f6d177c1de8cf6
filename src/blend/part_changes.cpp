// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "blend/part_changes.h"

#include "base/Disjoint_sets.h"
#include "base/quantized.h"
#include "blend/In_between_shape.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <map>
#include <numeric>
#include <optional>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL::Shape_correspondence::internal {
namespace {

using Cell = std::array<int, 3>;

/// All parts of both ends, where they are when surfaces of matched parts change.
In_between_shape all_parts(const Blend_structure& blend)
{
  const double t = Part_morph::change;
  std::vector<Blend_task> tasks;
  for (const Blend_part& part : blend.parts) {
    tasks.push_back(part.task);
    tasks.back().begin = part.is_at(0) ? t : 0;
    tasks.back().end = part.is_at(0) ? 1 : t;
  }
  return {blend, tasks, t};
}

/// The side of the cells in which places are compared, over the height.
double side_of_cells(const Blend_structure& blend)
{
  constexpr double least = 0.06, most_cells = 64; // along an axis
  return std::max(least, blend.stage.boxes[0].merged(blend.stage.boxes[1]).sizes().maxCoeff() / most_cells);
}

/// The cells whose middles a surface is near, in order. Those beside its box are looked at, too, so that rounding of
/// the box does not matter.
std::vector<Cell> cells_of(const contacts::Triangle_tree& tree, double side)
{
  const double squared_radius = 0.7 * side * side; // of a sphere around a cell, not quite to its corners
  const auto cell = [&](const Point& p) -> Cell {
    return {int(std::floor(p.x() / side)), int(std::floor(p.y() / side)), int(std::floor(p.z() / side))};
  };
  const Cell low = cell(tree.box().min()), high = cell(tree.box().max());
  std::vector<Cell> result;
  for (int x = low[0] - 1; x <= high[0] + 1; ++x)
    for (int y = low[1] - 1; y <= high[1] + 1; ++y)
      for (int z = low[2] - 1; z <= high[2] + 1; ++z)
        if (tree.is_near(side * Point(x + 0.5, y + 0.5, z + 0.5), squared_radius)) result.push_back({x, y, z});
  return result;
}

/// How much two surfaces are in one place, from 0 to 1.
double shared_cells(const std::vector<Cell>& a, const std::vector<Cell>& b)
{
  constexpr double beside = 0.4; // of the cells of the smaller one: what shares no more is beside the other one
  std::vector<Cell> shared;
  std::set_intersection(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(shared));
  if (shared.empty()) return 0;
  const double share = double(shared.size()) / double(std::min(a.size(), b.size()));
  return std::max(0., (share - beside) / (1 - beside));
}

/// Over the height: what is farther from all else, where something held it, has come off.
constexpr double off = 0.04;

/// An old part and a new one that are in one place.
struct Rivals
{
  std::size_t old_part, new_part;
  double size; ///< as much of the smaller one as is in the place
};

/// Where an exchanged part touches another one.
struct Hold
{
  std::size_t part, holder;
  double size;                                         ///< of the part, its share of all that it touches
  std::vector<std::pair<double, std::size_t>> nearest; ///< distances of others from the place, the nearest first
};

/// Finds out what to exchange first.
class Exchange_search
{
public:
  explicit Exchange_search(const Blend_structure& blend)
      : blend_(blend),
        seen_(all_parts(blend).seen()),
        groups_(blend.parts.size()),
        places_(groups_),
        always_joined_(groups_)
  {
    unite_groups();
    unite_what_is_held_alike();
    find_rivals();
    number_groups();
    find_holds();
    find_joined();
  }

  std::vector<Part_change> changes() const;

private:
  using Is_first = std::vector<char>;    ///< by group that is exchanged, whether it changes in the first step
  using Parts_there = std::vector<char>; ///< by part, whether the mixed shape has it

  bool is_matched(std::size_t part) const { return blend_.parts[part].is_matched(); }
  /// The end of an unmatched part.
  std::size_t end(std::size_t part) const { return std::size_t(blend_.parts[part].end()); }
  /// How much of the shape a part is: its diagonal, as a thin part is seen as well as a solid one.
  double size(std::size_t part) const { return blend_.parts[part].size; }
  double distance(const Point& place, std::size_t part) const
  {
    std::size_t triangle = 0;
    return (seen_[part].tree.nearest(place, triangle) - place).norm();
  }
  /// Where a part touches another one.
  Point place_of_touch(std::size_t part, std::size_t other) const
  {
    return seen_[part].tree.nearly_closest(seen_[other].tree).first;
  }
  /// By part, whether the mixed shape has it.
  Parts_there parts_there(const Is_first& is_first) const
  {
    Parts_there result(seen_.size());
    for (std::size_t i = 0; i < result.size(); ++i)
      result[i] = is_matched(i) || (numbers_[i] && (end(i) == 1) == bool(is_first[*numbers_[i]]));
    return result;
  }

  /// By set, the ends that have parts of it.
  std::vector<std::array<bool, 2>> ends_of(const Disjoint_sets& sets) const;
  void unite_groups();
  void unite_what_is_held_alike();
  void find_rivals();
  void number_groups();
  void find_holds();
  void find_joined();
  double rivalry(const Parts_there& is_there) const;
  double come_off(const Parts_there& is_there) const;
  double hanging(const Parts_there& is_there) const;
  double cost(const Is_first& is_first) const;
  void improve(Is_first& is_first, const std::vector<std::size_t>& order) const;
  std::vector<std::size_t> groups_from_the_ground() const;
  Is_first best() const;

  const Blend_structure& blend_;
  const std::vector<Seen_surface> seen_; ///< all parts
  Disjoint_sets groups_;
  Disjoint_sets places_;                            ///< what groups, touches and rivals join
  std::vector<std::optional<std::size_t>> numbers_; ///< by part that is exchanged, of its group
  std::vector<double> sizes_;                       ///< by number of a group
  double size_ = 0;                                 ///< of all of them
  std::vector<Rivals> rivals_;
  std::vector<Hold> holds_;
  Disjoint_sets always_joined_;                    ///< matched parts that touch, at an end or in the mixed shape
  std::vector<std::array<std::size_t, 2>> joined_; ///< others that do
};

std::vector<std::array<bool, 2>> Exchange_search::ends_of(const Disjoint_sets& sets) const
{
  std::vector<std::array<bool, 2>> result(sets.size(), {false, false});
  for (std::size_t i = 0; i < sets.size(); ++i)
    if (!is_matched(i)) result[sets[i]][end(i)] = true;
  return result;
}

void Exchange_search::unite_groups()
{
  const auto unite = [&](std::size_t a, std::size_t b) { // parts that morph change by themselves
    if (!is_matched(a) && !is_matched(b)) groups_.unite(a, b);
  };
  const auto part_of = [&](int end, std::size_t given) { return parts_of(blend_.parts, end, given).front(); };
  for (const auto& [s, t] : blend_.unlike)
    unite(part_of(0, s), part_of(1, t));
  std::optional<std::size_t> standing;
  for (std::size_t i = 0; i < groups_.size(); ++i) {
    if (is_matched(i)) continue;
    const Blend_part& part = blend_.parts[i];
    if (const auto image = blend_.stage.images[end(i)][part.given(part.end())]) unite(i, part_of(part.end(), *image));
    if (part.end_tree(part.end()).box().min().y() > Blend_part::on_ground) continue;
    if (!standing) standing = i;
    unite(i, *standing);
  }
}

/// Unites old and new parts without counterpart that hold on to one place: a cactus and leaves in a pot.
void Exchange_search::unite_what_is_held_alike()
{
  constexpr double near = 0.1; // over the height
  const std::vector<std::array<bool, 2>> ends = ends_of(groups_);
  struct Foot
  {
    std::size_t part, holder; // the latter is a group
    Point place;
  };
  std::array<std::vector<Foot>, 2> feet; // by end
  for (const Touch& touch : blend_.touches)
    for (std::size_t i : {0u, 1u}) {
      const std::size_t part = touch.parts[i], holder = touch.parts[1 - i];
      if (is_matched(part) || (ends[groups_[part]][0] && ends[groups_[part]][1])) continue;
      feet[end(part)].push_back({part, groups_[holder], place_of_touch(part, holder)});
    }
  for (const Foot& a : feet[0])
    for (const Foot& b : feet[1])
      if (a.holder == b.holder && groups_[a.part] != groups_[b.part] &&
          quantized(std::min(distance(a.place, b.part), distance(b.place, a.part))) < quantized(near))
        groups_.unite(a.part, b.part);
}

void Exchange_search::find_rivals()
{
  const double side = side_of_cells(blend_);
  std::array<std::vector<std::pair<std::size_t, std::vector<Cell>>>, 2> cells; // by end, of its unmatched parts
  for (std::size_t i = 0; i < seen_.size(); ++i)
    if (!is_matched(i)) cells[end(i)].emplace_back(i, cells_of(seen_[i].tree, side));
  for (const auto& [old_part, old_cells] : cells[0])
    for (const auto& [new_part, new_cells] : cells[1]) {
      const double shared = shared_cells(old_cells, new_cells);
      if (shared > 0 && groups_[old_part] != groups_[new_part])
        rivals_.push_back({old_part, new_part, shared * std::min(size(old_part), size(new_part))});
    }
}

void Exchange_search::number_groups()
{
  places_ = groups_;
  for (const Touch& touch : blend_.touches)
    if (!is_matched(touch.parts[0]) && !is_matched(touch.parts[1])) places_.unite(touch.parts[0], touch.parts[1]);
  for (const Rivals& rivals : rivals_)
    places_.unite(rivals.old_part, rivals.new_part);
  const std::vector<std::array<bool, 2>> ends = ends_of(places_);
  std::map<std::size_t, std::size_t> numbers;
  numbers_.resize(groups_.size());
  for (std::size_t i = 0; i < groups_.size(); ++i) {
    if (is_matched(i) || !ends[places_[i]][0] || !ends[places_[i]][1]) continue;
    numbers_[i] = numbers.emplace(groups_[i], numbers.size()).first->second;
    sizes_.resize(numbers.size(), 0);
    sizes_[*numbers_[i]] += size(i);
    size_ += size(i);
  }
}

void Exchange_search::find_joined()
{
  constexpr double near = 0.02;                  // over the height
  std::set<std::array<std::size_t, 2>> touching; // at an end
  for (const Touch& touch : blend_.touches)
    touching.insert(touch.parts);
  const auto is_never_there = [&](std::size_t part) { return !is_matched(part) && !numbers_[part]; };
  for (std::size_t a = 0; a < seen_.size(); ++a)
    for (std::size_t b = a + 1; b < seen_.size(); ++b) {
      if (is_never_there(a) || is_never_there(b)) continue;
      if (touching.count({a, b}) == 0 && !seen_[a].tree.is_within(seen_[b].tree, near * near)) continue;
      if (is_matched(a) && is_matched(b))
        always_joined_.unite(a, b);
      else
        joined_.push_back({a, b});
    }
}

void Exchange_search::find_holds()
{
  std::vector<int> count(seen_.size(), 0); // of touches
  for (const Touch& touch : blend_.touches)
    for (std::size_t part : touch.parts)
      ++count[part];
  for (const Touch& touch : blend_.touches)
    for (std::size_t i : {0u, 1u}) {
      const std::size_t part = touch.parts[i], holder = touch.parts[1 - i];
      if (!numbers_[part] || !numbers_[holder] || numbers_[part] == numbers_[holder]) continue;
      const Point place = place_of_touch(part, holder);
      Hold hold{part, holder, size(part) / count[part], {}};
      for (std::size_t other = 0; other < seen_.size(); ++other)
        if (other != part && other != holder && seen_[other].tree.box().exteriorDistance(place) < off)
          hold.nearest.emplace_back(distance(place, other), other);
      std::sort(hold.nearest.begin(), hold.nearest.end());
      holds_.push_back(std::move(hold));
    }
}

/// Sizes of what is in one place with something else, and of places where there is nothing any more.
double Exchange_search::rivalry(const Parts_there& is_there) const
{
  double result = 0;
  for (const auto& [old_part, new_part, size] : rivals_)
    if (is_there[old_part] == is_there[new_part]) result += size;
  return result;
}

/// Sizes of what has come off what it touched, as far as nothing else is in its place.
double Exchange_search::come_off(const Parts_there& is_there) const
{
  double result = 0;
  for (const Hold& hold : holds_) {
    if (!is_there[hold.part] || is_there[hold.holder]) continue;
    const auto found = std::find_if(hold.nearest.begin(), hold.nearest.end(),
                                    [&](const auto& other) { return is_there[other.second]; });
    const double gap = found == hold.nearest.end() ? off : std::min(found->first, off);
    result += hold.size * gap / off;
  }
  return result;
}

/// Sizes of all that does not hang together with the largest part of the shape.
double Exchange_search::hanging(const Parts_there& is_there) const
{
  Disjoint_sets components = always_joined_;
  for (const auto& [a, b] : joined_)
    if (is_there[a] && is_there[b]) components.unite(a, b);
  std::vector<double> sizes(components.size(), 0);
  for (std::size_t i = 0; i < sizes.size(); ++i)
    if (is_there[i]) sizes[components[i]] += size(i);
  return std::accumulate(sizes.begin(), sizes.end(), 0.) - *std::max_element(sizes.begin(), sizes.end());
}

double Exchange_search::cost(const Is_first& is_first) const
{
  constexpr double worth = 0.18; // of the share that changes in the lesser step
  constexpr double least = 0.15; // such a share
  const Parts_there is_there = parts_there(is_first);
  double share = 0; // that changes first
  for (std::size_t group = 0; group < sizes_.size(); ++group)
    if (is_first[group]) share += sizes_[group] / size_;
  const double lesser = std::min(share, 1 - share);
  const auto count = std::size_t(std::count(is_first.begin(), is_first.end(), true));
  const bool is_mixed = count > 0 && count < is_first.size();
  // Too little is as bad as can be, and the worse the less it is, so that the search finds out of there.
  if (is_mixed && quantized(lesser) < quantized(least)) return 1 - lesser;
  return (rivalry(is_there) + come_off(is_there) + hanging(is_there)) / size_ - (is_mixed ? worth * lesser : 0);
}

std::vector<std::size_t> Exchange_search::groups_from_the_ground() const
{
  std::vector<Point> places(sizes_.size(), Point::Zero()); // middles times sizes
  for (std::size_t i = 0; i < seen_.size(); ++i)
    if (numbers_[i]) places[*numbers_[i]] += size(i) * seen_[i].tree.box().center();
  std::vector<std::size_t> result(sizes_.size());
  std::iota(result.begin(), result.end(), std::size_t(0));
  const auto key = [&](std::size_t group) {
    const Point place = places[group] / sizes_[group];
    return std::tuple(quantized(place.y()), quantized(sizes_[group]), quantized(place.x()), quantized(place.z()));
  };
  std::stable_sort(result.begin(), result.end(), [&](std::size_t a, std::size_t b) { return key(a) < key(b); });
  return result;
}

/// Moves groups to the other step, as long as that is better.
void Exchange_search::improve(Is_first& is_first, const std::vector<std::size_t>& order) const
{
  double least = cost(is_first);
  for (bool is_better = true; is_better;) {
    is_better = false;
    for (std::size_t group : order) {
      is_first[group] = !is_first[group];
      const double value = cost(is_first);
      if (quantized(value) < quantized(least))
        least = value, is_better = true;
      else
        is_first[group] = !is_first[group];
    }
  }
}

Exchange_search::Is_first Exchange_search::best() const
{
  constexpr std::size_t starts = 8; // of the search, in one direction
  const std::size_t count = sizes_.size();
  Is_first result(count, false);
  if (count < 2) return result;
  const std::vector<std::size_t> order = groups_from_the_ground();
  double least = std::min(cost(result), cost(Is_first(count, true))); // of no mixed shape
  for (bool from_the_ground : {true, false})
    for (std::size_t i = 1, last = 0; i < starts; ++i) {
      const std::size_t cut = std::clamp(i * count / starts, std::size_t(1), count - 1);
      if (std::exchange(last, cut) == cut) continue;
      Is_first is_first(count, !from_the_ground);
      for (std::size_t k = 0; k < cut; ++k)
        is_first[order[k]] = from_the_ground;
      improve(is_first, order);
      if (const double value = cost(is_first); quantized(value) < quantized(least)) least = value, result = is_first;
    }
  return result;
}

std::vector<Part_change> Exchange_search::changes() const
{
  const Is_first is_first = best();
  std::vector<Part_change> result;
  for (std::size_t i = 0; i < seen_.size(); ++i) {
    const Exchange_step step = !numbers_[i]             ? Exchange_step::NONE
                               : is_first[*numbers_[i]] ? Exchange_step::FIRST
                                                        : Exchange_step::SECOND;
    result.push_back({step, places_[i]});
  }
  return result;
}

} // namespace

std::vector<Part_change> part_changes(const Blend_structure& blend) { return Exchange_search(blend).changes(); }

} // namespace CGAL::Shape_correspondence::internal
