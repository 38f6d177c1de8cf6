// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "search/beam_search.h"
#include "base/quantized.h"
#include "energy/Structure_preservation.h"

#include <CGAL/Shape_correspondence/Invalid_input.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <limits>
#include <numeric>
#include <optional>
#include <tuple>
#include <utility>

namespace CGAL::Shape_correspondence {
using namespace internal;

namespace {

// The order of assignment: the group with most contacts first, then always the one with most contacts to those before.
std::vector<std::size_t> assignment_order(const Aligned_shape::Graph& graph)
{
  const std::size_t n = num_vertices(graph);
  std::vector<std::size_t> degree(n, 0), to_placed(n, 0), order;
  for (const auto& edge : boost::make_iterator_range(edges(graph)))
    for (std::size_t group : {source(edge, graph), target(edge, graph)})
      degree[group] += graph[edge].contacts.size();

  std::vector<char> placed(n, 0);
  while (order.size() < n) {
    std::size_t best = n;
    for (std::size_t g = 0; g < n; ++g) {
      if (placed[g]) continue;
      if (best == n || std::make_pair(to_placed[g], degree[g]) > std::make_pair(to_placed[best], degree[best]))
        best = g;
    }
    order.push_back(best);
    placed[best] = 1;
    for (const auto& edge : boost::make_iterator_range(out_edges(best, graph)))
      to_placed[target(edge, graph)] += graph[edge].contacts.size();
  }
  return order;
}

// The sample of a piece at a sample of its part; none if that is on another piece.
std::optional<std::size_t> sample_on_piece(const Piece& piece, std::size_t at)
{
  constexpr int last = samples_per_side - 1;
  if (piece.is_segment()) return at * std::size_t(piece.count) - std::size_t(piece.index * last);
  if (!piece.is_rectangle()) return at;
  std::size_t result = 0;
  const std::array<std::size_t, 2> station{at / samples_per_side, at % samples_per_side};
  for (std::size_t axis : {0, 1}) {
    const double place = double(station[axis]) / last;
    if (place < piece.low[axis] || place > piece.high[axis]) return std::nullopt;
    const double on_piece = (place - piece.low[axis]) / (piece.high[axis] - piece.low[axis]);
    result = result * samples_per_side + std::size_t(std::lround(on_piece * last));
  }
  return result;
}

// What was found when a partial solution was rated.
struct Rating
{
  std::vector<Part_motion> motions; // by part, those that are not matched
  std::vector<Rod_energy> energies; // by contact
};

// Rates the expansions of partial solutions: contacts between assigned groups by the tables, others by rods with
// propagated parts. What an expansion leaves alone keeps the energy that it has in the parent.
class Partial_energy
{
public:
  explicit Partial_energy(const Matching_problem& problem)
      : problem_(problem),
        shape_(problem.source()),
        piece_rods_(shape_.contacts.size()),
        preserve_structure_(shape_),
        rating_{std::vector<Part_motion>(shape_.parts.size()), std::vector<Rod_energy>(shape_.contacts.size())},
        contact_displacement_(shape_.contacts.size()),
        matched_(shape_.number_of_groups()),
        moved_by_(rating_.motions),
        keeps_place_(shape_.parts.size()),
        order_(shape_.contacts.size()),
        contacts_of_(shape_.number_of_groups())
  {
    std::iota(order_.begin(), order_.end(), std::size_t(0));
    for (std::size_t contact = 0; contact < shape_.contacts.size(); ++contact)
      for (std::size_t part : shape_.contacts[contact].parts) {
        std::vector<std::size_t>& contacts = contacts_of_[shape_.group_of[part]];
        if (contacts.empty() || contacts.back() != contact) contacts.push_back(contact);
      }
    for (const Sampled_part& part : shape_.parts)
      moved_.emplace_back(part.samples);
    for (std::size_t contact = 0; contact < shape_.contacts.size(); ++contact)
      for (std::size_t side : {0, 1}) {
        const std::size_t group = shape_.group_of[shape_.contacts[contact].parts[side]];
        contact_movement_.emplace_back();
        for (std::size_t label = 0; label < problem.number_of_labels(group); ++label)
          contact_movement_.back().push_back(contact_movement(contact, int(side), label));
      }
  }

  // Of the solution that was rated last; at first of that in which nothing is assigned.
  const Rating& rating() const { return rating_; }

  // The solution whose expansions are rated next.
  void set_parent(const Assignment& assignment, const Rating& rating)
  {
    parent_ = assignment;
    parent_rating_ = rating_ = rating;
    assigned_energies_.assign(shape_.contacts.size(), Rod_energy());
    for (std::size_t contact = 0; contact < shape_.contacts.size(); ++contact)
      if (is_assigned(contact, assignment)) assigned_energies_[contact] = rating.energies[contact];
    for (std::size_t group = 0; group < matched_.size(); ++group)
      assign(group, assignment);
    std::sort(order_.begin(), order_.end(), [&](std::size_t a, std::size_t b) {
      const double first = cost(rating.energies[a]), second = cost(rating.energies[b]);
      return first > second || (first == second && a < b);
    });
  }

  // The energy, without the contacts that a propagated part is at, of the parent with a group assigned.
  double lower_bound(const Assignment& assignment, std::size_t group)
  {
    for (std::size_t contact : contacts_of_[group])
      assigned_energies_[contact] =
          is_assigned(contact, assignment) ? assigned_energy(contact, assignment) : Rod_energy();
    return deformation_energy(problem_.terms(assignment, assigned_energies_), problem_.options().weights);
  }

  // The energy of the parent with a group assigned; more than `greatest`, without all contacts being rated, where it is
  // that. `least` is its lower bound.
  double operator()(const Assignment& assignment, std::size_t group, double least, double greatest)
  {
    assign(group, assignment);
    const double energy = rate(assignment, least, greatest);
    assign(group, parent_);
    return energy;
  }

private:
  void assign(std::size_t group, const Assignment& assignment)
  {
    matched_[group] = assignment[group] != unassigned && !problem_.is_unmatched(group, std::size_t(assignment[group]));
    if (!matched_[group]) return;
    for (std::size_t contact : contacts_of_[group])
      for (std::size_t side : {0, 1})
        if (shape_.group_of[shape_.contacts[contact].parts[side]] == group)
          contact_displacement_[contact][side] = contact_movement_[2 * contact + side][std::size_t(assignment[group])];
  }

  double rate(const Assignment& assignment, double least, double greatest)
  {
    preserve_structure_(matched_, contact_displacement_, rating_.motions);
    for (std::size_t part = 0; part < rating_.motions.size(); ++part) {
      const std::size_t group = shape_.group_of[part];
      keeps_place_[part] = assignment[group] == parent_[group] &&
                           (matched_[group] || rating_.motions[part] == parent_rating_.motions[part]);
    }
    // Contacts add up, but for a pooled E_d
    const bool adds_up = problem_.options().norm != Energy_norm::POOLED;
    for (std::size_t contact : order_) {
      const auto& parts = shape_.contacts[contact].parts;
      const bool is_known = keeps_place_[parts[0]] && keeps_place_[parts[1]];
      rating_.energies[contact] = is_known ? parent_rating_.energies[contact] : contact_energy(contact, assignment);
      if (!adds_up || is_assigned(contact, assignment)) continue;
      least += cost(rating_.energies[contact]);
      if (least > greatest) return least;
    }
    return deformation_energy(problem_.terms(assignment, rating_.energies), problem_.options().weights);
  }

  // How far the contact point of a matched part moves; that of a part with clones by their mean.
  Point contact_movement(std::size_t contact, int side, std::size_t label) const
  {
    const Points& samples = shape_.parts[shape_.contacts[contact].parts[std::size_t(side)]].samples;
    const std::size_t at = shape_.contacts[contact].samples[std::size_t(side)];
    Point sum = Point::Zero();
    int count = 0;
    for (std::size_t clone : problem_.touching(contact, side, label)) {
      const Fitted_piece& fitted = problem_.fitted()[clone];
      const std::optional<std::size_t> on_piece = sample_on_piece(fitted.source, at);
      if (!on_piece) continue;
      const Points& target = problem_.fitted().target_piece(fitted.target_index).samples;
      const std::size_t size = fitted.order->size();
      const std::size_t from = *on_piece * (size / std::size_t(samples.cols()));
      sum += target.col((*fitted.order)[from] / int(size / std::size_t(target.cols())));
      ++count;
    }
    if (count == 0) return Point::Zero();
    return sum / double(count) - samples.col(Eigen::Index(at));
  }

  double cost(const Rod_energy& energy) const
  {
    const Energy_weights& weights = problem_.options().weights;
    return weights.distortion * energy.distortion + weights.connectedness * energy.connectedness;
  }

  bool is_assigned(std::size_t contact, const Assignment& assignment) const
  {
    const auto& parts = shape_.contacts[contact].parts;
    return assignment[shape_.group_of[parts[0]]] != unassigned && assignment[shape_.group_of[parts[1]]] != unassigned;
  }

  // The samples of an unmatched part, moved; often they were moved like that before.
  const Sample_lanes& moved(std::size_t part)
  {
    const Part_motion& motion = rating_.motions[part];
    if (moved_by_[part] == motion) return moved_[part];
    const Points& samples = shape_.parts[part].samples;
    for (Eigen::Index i = 0; i < samples.cols(); ++i) {
      const Point sample = samples.col(i);
      const Point to = sample + motion.shift + motion.stretch * (sample - shape_.parts[part].centroid);
      for (Eigen::Index axis = 0; axis < 3; ++axis)
        moved_[part].coordinates[axis][i] = float(to[axis]);
    }
    moved_by_[part] = motion;
    return moved_[part];
  }

  Rod_energy assigned_energy(std::size_t contact, const Assignment& assignment) const
  {
    const auto& parts = shape_.contacts[contact].parts;
    return problem_.contact_energy(contact, std::size_t(assignment[shape_.group_of[parts[0]]]),
                                   std::size_t(assignment[shape_.group_of[parts[1]]]));
  }

  Rod_energy contact_energy(std::size_t contact, const Assignment& assignment)
  {
    const auto& parts = shape_.contacts[contact].parts;
    const std::size_t g = shape_.group_of[parts[0]], h = shape_.group_of[parts[1]];
    if (matched_[g] && matched_[h]) return assigned_energy(contact, assignment);
    for (std::size_t group : {g, h})
      if (!matched_[group] && assignment[group] != unassigned) return {}; // left unmatched, has its own cost

    if (!matched_[g] && !matched_[h]) {
      // Parts that are displaced alike and not stretched keep their rods
      const Part_motion &first = rating_.motions[parts[0]], &second = rating_.motions[parts[1]];
      if ((first.shift - second.shift).squaredNorm() + first.stretch.squaredNorm() + second.stretch.squaredNorm() <
          zero_rod)
        return {};
      return shape_.rods(contact, 1, 1).energy(moved(parts[0]), moved(parts[1]));
    }

    // One side is assigned: the propagated part keeps to the nearest of its clones
    const int side = matched_[g] ? 0 : 1;
    const std::size_t matched_part = parts[std::size_t(side)], moved_part = parts[std::size_t(1 - side)];
    const Sample_lanes& other = moved(moved_part);
    Rod_energy best;
    double best_cost = std::numeric_limits<double>::infinity();
    for (std::size_t clone : problem_.touching(contact, side, std::size_t(assignment[shape_.group_of[matched_part]]))) {
      const Fitted_piece& fitted = problem_.fitted()[clone];
      const Sample_lanes& taken = problem_.fitted().samples(fitted);
      const Structural_rods& before = rods(contact, side, fitted);
      const Rod_energy energy = side == 0 ? before.energy(taken, other) : before.energy(other, taken);
      if (cost(energy) < best_cost) best = energy, best_cost = cost(energy);
    }
    return best;
  }

  // The rods of a contact of which one side is a piece of a matched part, the other a whole part.
  const Structural_rods& rods(std::size_t contact, int side, const Fitted_piece& fitted)
  {
    const std::array<int, 2> repeats{side == 0 ? fitted.repeats : 1, side == 1 ? fitted.repeats : 1};
    if (fitted.source.is_whole()) return shape_.rods(contact, repeats[0], repeats[1]);
    for (const Piece_rods& known : piece_rods_[contact])
      if (known.side == side && known.piece == fitted.source_index && known.repeats == fitted.repeats)
        return known.rods;
    const Points& piece = problem_.fitted().source_piece(fitted.source_index).samples;
    const Points& other = shape_.parts[shape_.contacts[contact].parts[std::size_t(1 - side)]].samples;
    piece_rods_[contact].push_back({side, fitted.source_index, fitted.repeats,
                                    side == 0 ? Structural_rods(piece, other, repeats[0], repeats[1])
                                              : Structural_rods(other, piece, repeats[0], repeats[1])});
    return piece_rods_[contact].back().rods;
  }

  struct Piece_rods
  {
    int side;
    std::size_t piece;
    int repeats;
    Structural_rods rods;
  };

  const Matching_problem& problem_;
  const Deformable_shape& shape_;
  std::vector<std::deque<Piece_rods>> piece_rods_; // by contact
  Structure_preservation preserve_structure_;
  std::vector<std::vector<Point>> contact_movement_; // by side of contact and label
  Rating rating_;                                    // of the solution that is being rated
  std::vector<std::array<Point, 2>> contact_displacement_;
  std::vector<char> matched_;
  std::vector<Rod_energy> assigned_energies_;
  std::vector<Sample_lanes> moved_; // by part, its samples moved by
  std::vector<Part_motion> moved_by_;
  Assignment parent_;
  Rating parent_rating_;
  std::vector<char> keeps_place_;                     // by part, whether it is where it is in the parent
  std::vector<std::size_t> order_;                    // of contacts, those that cost most in the parent first
  std::vector<std::vector<std::size_t>> contacts_of_; // by group
};

struct Expansion
{
  long energy; // quantized, so that ties are settled by the indices
  std::size_t parent;
  int label;
  std::size_t rating; // of the expander

  bool operator<(const Expansion& other) const
  {
    return std::tie(energy, parent, label) < std::tie(other.energy, other.parent, other.label);
  }
};

// Rates the expansions of a parent by all labels of a group and appends the `count` best ones, but for some that `most`
// others in the level are better than. Those of the least lower bounds come first, so that most need no full rating.
class Expander
{
public:
  Expander(Partial_energy& energy, std::size_t count, std::size_t most) : energy_(energy), count_(count), most_(most) {}

  // Gives up the ratings of the level before.
  void start_level()
  {
    spare_.resize(ratings_.size());
    std::iota(spare_.begin(), spare_.end(), std::size_t(0));
  }

  Rating& rating(const Expansion& expansion) { return ratings_[expansion.rating]; }

  void operator()(std::size_t parent, Assignment& assignment, std::size_t group, int labels,
                  std::vector<Expansion>& level)
  {
    bounds_.clear();
    for (int label = 0; label < labels; ++label) {
      assignment[group] = label;
      bounds_.emplace_back(energy_.lower_bound(assignment, group), label);
    }
    std::sort(bounds_.begin(), bounds_.end());
    const std::size_t begin = level.size();
    const long kept_before = begin < most_ ? std::numeric_limits<long>::max() : nth_energy(level);
    for (const auto& [bound, label] : bounds_) {
      long worst = kept_before;
      if (level.size() == begin + count_) worst = std::min(worst, level.back().energy);
      // A step more than the worst, for roundings
      const double greatest = worst == std::numeric_limits<long>::max() ? std::numeric_limits<double>::infinity()
                                                                        : double(worst + 1) * comparison_grid;
      if (bound > greatest) break;
      assignment[group] = label;
      const double energy = energy_(assignment, group, bound, greatest);
      if (energy > greatest) continue;
      level.push_back({quantized(energy), parent, label, keep(energy_.rating())});
      std::sort(level.begin() + std::ptrdiff_t(begin), level.end());
      if (level.size() <= begin + count_) continue;
      spare_.push_back(level.back().rating);
      level.pop_back();
    }
    assignment[group] = unassigned;
  }

private:
  std::size_t keep(const Rating& rating)
  {
    if (spare_.empty()) {
      ratings_.push_back(rating);
      return ratings_.size() - 1;
    }
    const std::size_t place = spare_.back();
    spare_.pop_back();
    ratings_[place] = rating;
    return place;
  }

  // Of the `most_` best expansions, the energy of the last one.
  long nth_energy(const std::vector<Expansion>& level)
  {
    sorted_ = level;
    const auto nth = sorted_.begin() + std::ptrdiff_t(most_ - 1);
    std::nth_element(sorted_.begin(), nth, sorted_.end());
    return nth->energy;
  }

  Partial_energy& energy_;
  std::size_t count_, most_;
  std::vector<std::pair<double, int>> bounds_; // and their labels
  std::vector<Expansion> sorted_;
  std::vector<Rating> ratings_; // of the expansions of a level
  std::vector<std::size_t> spare_;
};

struct Partial_solution
{
  Assignment assignment;
  Rating rating;
};

} // namespace

Search_result beam_search(const Matching_problem& problem, const Beam_options& options)
{
  if (options.beam_width < 1 || options.expansions < 1)
    throw Invalid_input("beam search: the beam width K and the number of expansions k must be at least 1");

  Search_result result;
  Partial_energy partial_energy(problem);
  Expander expand(partial_energy, std::size_t(options.expansions), std::size_t(options.beam_width));
  std::vector<Partial_solution> beam(1), next;
  beam[0] = {Assignment(problem.source().number_of_groups(), unassigned), partial_energy.rating()};
  std::vector<Expansion> level;
  for (std::size_t group : assignment_order(problem.source().graph)) {
    level.clear();
    expand.start_level();
    for (std::size_t parent = 0; parent < beam.size(); ++parent) {
      partial_energy.set_parent(beam[parent].assignment, beam[parent].rating);
      const int labels = int(problem.number_of_labels(group));
      expand(parent, beam[parent].assignment, group, labels, level);
      result.summary.evaluations += std::size_t(labels);
    }
    std::sort(level.begin(), level.end());
    level.resize(std::min(level.size(), std::size_t(options.beam_width)));
    result.summary.states += level.size();
    next.resize(level.size());
    for (std::size_t i = 0; i < level.size(); ++i) {
      next[i].assignment = beam[level[i].parent].assignment;
      next[i].assignment[group] = level[i].label;
      std::swap(next[i].rating, expand.rating(level[i]));
    }
    beam.swap(next);
  }
  for (Partial_solution& solution : beam)
    result.solutions.push_back({problem.energy()(solution.assignment), std::move(solution.assignment)});
  result.summary.lower_bound = std::min(problem.energy().lower_bound(), result.best().energy);
  result.optimal = result.best().energy <= result.summary.lower_bound;
  return result;
}

} // namespace CGAL::Shape_correspondence
