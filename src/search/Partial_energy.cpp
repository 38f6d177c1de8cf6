// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "search/Partial_energy.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>

namespace CGAL::Shape_correspondence::internal {

namespace {

// The index of the sample of a piece that is nearest to a sample of its part; none if that is not on the piece.
std::optional<std::size_t> sample_on_piece(const Piece& piece, std::size_t sample)
{
  constexpr int last = samples_per_side - 1;
  if (piece.is_segment()) return sample * std::size_t(piece.count) - std::size_t(piece.index * last);
  if (!piece.is_rectangle()) return sample;
  std::size_t result = 0;
  const std::array<std::size_t, 2> station{sample / samples_per_side, sample % samples_per_side};
  for (std::size_t axis : {0, 1}) {
    const double place = double(station[axis]) / last;
    if (place < piece.low[axis] || place > piece.high[axis]) return std::nullopt;
    const double on_piece = (place - piece.low[axis]) / (piece.high[axis] - piece.low[axis]);
    result = result * samples_per_side + std::size_t(std::lround(on_piece * last));
  }
  return result;
}

} // namespace

Partial_energy::Partial_energy(const Matching_problem& problem)
    : problem_(problem),
      shape_(problem.source()),
      preserve_structure_(shape_, problem.options().hard_proximity),
      contacts_of_(shape_.number_of_groups()),
      piece_rods_(shape_.contacts.size()),
      order_(shape_.contacts.size()),
      rating_{std::vector<Part_motion>(shape_.parts.size()), std::vector<Rod_energy>(shape_.contacts.size())},
      matched_(shape_.number_of_groups()),
      contact_displacement_(shape_.contacts.size()),
      keeps_place_(shape_.parts.size()),
      moved_by_(rating_.motions)
{
  std::iota(order_.begin(), order_.end(), std::size_t(0));
  for (std::size_t contact = 0; contact < shape_.contacts.size(); ++contact) {
    const auto groups = problem.groups_of_contact(contact);
    for (std::size_t side : {0, 1}) {
      std::vector<std::size_t>& contacts = contacts_of_[groups[side]];
      if (contacts.empty() || contacts.back() != contact) contacts.push_back(contact);
      contact_movement_.emplace_back();
      for (std::size_t label = 0; label < problem.number_of_labels(groups[side]); ++label)
        contact_movement_.back().push_back(contact_movement(contact, side, label));
    }
  }
  for (const Sampled_part& part : shape_.parts)
    moved_.emplace_back(part.samples);
}

void Partial_energy::set_parent(const Assignment& assignment, const Rating& rating)
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

double Partial_energy::lower_bound(const Assignment& assignment, std::size_t group)
{
  for (std::size_t contact : contacts_of_[group])
    assigned_energies_[contact] =
        is_assigned(contact, assignment) ? problem_.contact_energy(contact, assignment) : Rod_energy();
  return deformation_energy(problem_.terms(assignment, assigned_energies_), problem_.options().weights);
}

double Partial_energy::operator()(const Assignment& assignment, std::size_t group, double least, double greatest)
{
  assign(group, assignment);
  const double energy = rate(assignment, least, greatest);
  assign(group, parent_);
  return energy;
}

// Updates `matched_` and `contact_displacement_` for the label of a group.
void Partial_energy::assign(std::size_t group, const Assignment& assignment)
{
  matched_[group] = assignment[group] != unassigned && !problem_.is_unmatched(group, std::size_t(assignment[group]));
  if (!matched_[group]) return;
  for (std::size_t contact : contacts_of_[group])
    for (std::size_t side : {0, 1})
      if (problem_.groups_of_contact(contact)[side] == group)
        contact_displacement_[contact][side] = contact_movement_[2 * contact + side][std::size_t(assignment[group])];
}

double Partial_energy::rate(const Assignment& assignment, double least, double greatest)
{
  preserve_structure_(matched_, contact_displacement_, rating_.motions);
  for (std::size_t part = 0; part < rating_.motions.size(); ++part) {
    const std::size_t group = shape_.group_of[part];
    keeps_place_[part] = assignment[group] == parent_[group] &&
                         (matched_[group] || rating_.motions[part] == parent_rating_.motions[part]);
  }
  // The pooled E_d is not a sum over contacts
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

// Displacement of the contact point of a matched part, averaged over its clones.
Point Partial_energy::contact_movement(std::size_t contact, std::size_t side, std::size_t label) const
{
  const Points& samples = shape_.parts[shape_.contacts[contact].parts[side]].samples;
  const std::size_t at = shape_.contacts[contact].samples[side];
  Point sum = Point::Zero();
  int count = 0;
  for (std::size_t clone : problem_.touching(contact, side, label)) {
    const Fitted_piece& fitted = problem_.fitted()[clone];
    const std::optional<std::size_t> on_piece = sample_on_piece(fitted.source, at);
    if (!on_piece) continue;
    sum += problem_.fitted().points(fitted).col(Eigen::Index(*on_piece) * fitted.repeats);
    ++count;
  }
  if (count == 0) return Point::Zero();
  return sum / double(count) - samples.col(Eigen::Index(at));
}

double Partial_energy::cost(const Rod_energy& energy) const
{
  const Energy_weights& weights = problem_.options().weights;
  return weights.distortion * energy.distortion + weights.connectedness * energy.connectedness;
}

bool Partial_energy::is_assigned(std::size_t contact, const Assignment& assignment) const
{
  const auto [first, second] = problem_.groups_of_contact(contact);
  return assignment[first] != unassigned && assignment[second] != unassigned;
}

const Sample_lanes& Partial_energy::moved_samples(std::size_t part)
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

Rod_energy Partial_energy::contact_energy(std::size_t contact, const Assignment& assignment)
{
  const auto& parts = shape_.contacts[contact].parts;
  const auto groups = problem_.groups_of_contact(contact);
  if (matched_[groups[0]] && matched_[groups[1]]) return problem_.contact_energy(contact, assignment);
  for (std::size_t group : groups)
    if (!matched_[group] && assignment[group] != unassigned) return {}; // left unmatched, which has a cost of its own

  if (!matched_[groups[0]] && !matched_[groups[1]]) {
    // Rods between parts that are displaced alike and not stretched do not change
    const Part_motion &first = rating_.motions[parts[0]], &second = rating_.motions[parts[1]];
    if ((first.shift - second.shift).squaredNorm() + first.stretch.squaredNorm() + second.stretch.squaredNorm() <
        zero_rod)
      return {};
    return shape_.rods(contact, 1, 1).energy(moved_samples(parts[0]), moved_samples(parts[1]));
  }

  // The unassigned part stays connected to the nearest clone of the matched one
  const std::size_t side = matched_[groups[0]] ? 0 : 1;
  const Sample_lanes& unassigned_part = moved_samples(parts[1 - side]);
  Rod_energy best;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t clone : problem_.touching(contact, side, std::size_t(assignment[groups[side]]))) {
    const Fitted_piece& fitted = problem_.fitted()[clone];
    const Sample_lanes& matched_part = problem_.fitted().samples(fitted);
    const Structural_rods& before = rods(contact, side, fitted);
    const Rod_energy energy =
        side == 0 ? before.energy(matched_part, unassigned_part) : before.energy(unassigned_part, matched_part);
    if (cost(energy) < least) best = energy, least = cost(energy);
  }
  return best;
}

// The rods of a contact between a piece of the matched part at a side and the whole part at the other side.
const Structural_rods& Partial_energy::rods(std::size_t contact, std::size_t side, const Fitted_piece& fitted)
{
  const std::array<int, 2> repeats{side == 0 ? fitted.repeats : 1, side == 1 ? fitted.repeats : 1};
  if (fitted.source.is_whole()) return shape_.rods(contact, repeats[0], repeats[1]);
  for (const Piece_rods& known : piece_rods_[contact])
    if (known.side == side && known.piece == fitted.source_index && known.repeats == fitted.repeats) return known.rods;
  const Points& piece = problem_.fitted().source_piece(fitted.source_index).samples;
  const Points& other = shape_.parts[shape_.contacts[contact].parts[1 - side]].samples;
  piece_rods_[contact].push_back({side, fitted.source_index, fitted.repeats,
                                  side == 0 ? Structural_rods(piece, other, repeats[0], repeats[1])
                                            : Structural_rods(other, piece, repeats[0], repeats[1])});
  return piece_rods_[contact].back().rods;
}

} // namespace CGAL::Shape_correspondence::internal
