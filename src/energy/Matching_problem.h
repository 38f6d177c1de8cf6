// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "base/deadline.h"
#include "energy/Fitted_pieces.h"
#include "energy/match_groups.h"

#include <CGAL/Shape_correspondence/Energy_options.h>
#include <CGAL/Shape_correspondence/Pairwise_energy.h>

#include <array>
#include <cstddef>
#include <memory>
#include <stdexcept>
#include <vector>

namespace CGAL::Shape_correspondence {

/// Largest number of labels of a group, without those for which curves are cut; bounds time and memory for shapes of
/// hundreds of groups.
constexpr std::size_t maximum_labels = 64;

/// For each source group, the target groups that it may be matched to, ascending; empty: all.
using Group_candidates = std::vector<std::vector<std::size_t>>;

/// Memory, in bytes, that the tables of a search may take; exact search may take as much again. The tables of the best
/// search so far are kept in addition.
constexpr std::size_t most_bytes_of_tables = std::size_t(1) << 29;

/// The tables of the energies would take too much memory; the message says how much.
class Too_large : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

/// Checks the size of tables. \throw Too_large if `bytes` are more than `most_bytes_of_tables`
void check_bytes_of_tables(double bytes);

/// The matching graph of a source and a target shape (paper, section 5) with its energies as tables. A part that is
/// deformed to fit depends on itself and on its target part alone. Once every group has a label, E is therefore a sum
/// over groups and over pairs of groups in contact of terms that depend on their labels alone; each is computed once.
/// The labels of a group are the target groups (the nearest `maximum_labels`) in their order, then, once more, those
/// for which curves are cut (`cut_curves()`), and last, where allowed, none.
class Matching_problem
{
public:
  using Shared_shape = std::shared_ptr<const Deformable_shape>;

  /// \param allowed candidates of each source group; empty: all groups \throw Too_large, internal::Out_of_time
  Matching_problem(const Shared_shape& source, const Shared_shape& target, const Energy_options& options = {},
                   const Group_candidates& allowed = {}, const internal::Deadline& deadline = internal::Deadline());
  Matching_problem(Aligned_shape source, Aligned_shape target, const Energy_options& options = {});
  /// Takes the labels as given, by source group, to rate a mapping found by other means. Members of a group may have no
  /// image; their contacts add no energy. \pre every group has a label, with a list of images per member
  /// \throw Too_large, internal::Out_of_time
  Matching_problem(Shared_shape source, Shared_shape target, std::vector<std::vector<Group_label>> labels,
                   const Energy_options& options = {}, const internal::Deadline& deadline = internal::Deadline());

  const Deformable_shape& source() const { return *source_; }
  const Deformable_shape& target() const { return *target_; }
  const Energy_options& options() const { return options_; }
  std::size_t number_of_labels(std::size_t group) const { return labels_[group].size(); }
  const Group_label& label(std::size_t group, std::size_t label) const { return labels_[group][label]; }
  bool is_unmatched(std::size_t group, std::size_t label) const
  {
    return labels_[group][label].target_group == Group_label::no_group;
  }
  /// Whether labels were dropped because a group had more than `maximum_labels`: then no search proves an optimum.
  bool has_shortlists() const { return has_shortlists_; }

  /// E of Eq. 1 of complete assignments of labels to groups.
  const Pairwise_energy& energy() const { return energy_; }
  /// The terms of E of a complete assignment.
  Energy_terms terms(const Assignment& assignment) const;
  /// The terms of E of a partial assignment. \param contacts energies of all contacts; 0 for those of unmatched groups
  Energy_terms terms(const Assignment& assignment, const std::vector<Rod_energy>& contacts) const;

  std::array<std::size_t, 2> groups_of_contact(std::size_t contact) const
  {
    const auto& parts = source_->contacts[contact].parts;
    return {source_->group_of[parts[0]], source_->group_of[parts[1]]};
  }
  /// E_d and E_c of a contact under labels of its two groups: the mean over pairs of clones, each clone paired with its
  /// nearest counterpart. Of a cut part, the segment at the contact is used.
  Rod_energy contact_energy(std::size_t contact, std::size_t first_label, std::size_t second_label) const
  {
    const std::size_t second = groups_of_contact(contact)[1];
    return contact_energies_[contact_begin_[contact] + first_label * number_of_labels(second) + second_label];
  }
  /// E_d and E_c of a contact under a complete assignment.
  Rod_energy contact_energy(std::size_t contact, const Assignment& assignment) const
  {
    const auto [first, second] = groups_of_contact(contact);
    return contact_energy(contact, std::size_t(assignment[first]), std::size_t(assignment[second]));
  }
  /// What a group's label adds to the energy besides E_s and contacts with other groups: E_d and E_c between
  /// neighbouring segments of its cut parts, and role costs (`Energy_options::role_costs`).
  const Energy_terms& group_terms(std::size_t group, std::size_t label) const { return group_terms_[group][label]; }

  /// The source parts and pieces after the deformation, for every label.
  const internal::Fitted_pieces& fitted() const { return fitted_; }
  /// The fitted pieces that touch at a side of a contact: all clones of the part there, or the one segment.
  internal::Fitted_range touching(std::size_t contact, std::size_t side, std::size_t label) const
  {
    const Aligned_shape::Contact& c = source_->contacts[contact];
    return fitted_.touching(c.parts[side], c.samples[side], label);
  }

private:
  void fill_contact_energies(const internal::Deadline& deadline);
  void fill_group_terms();
  void add_cut_energy(std::size_t group, std::size_t label);
  void add_role_costs();
  void add_up_energy();
  bool pools_rods() const { return options_.norm == Energy_norm::POOLED; }
  double number_of_rods(std::size_t contact) const;
  double kept_rods(std::size_t contact, const Rod_energy& energy) const;

  Shared_shape source_, target_;
  Energy_options options_;
  bool has_shortlists_ = false;
  std::vector<std::vector<Group_label>> labels_; // indexed by source group
  internal::Fitted_pieces fitted_;
  std::vector<std::size_t> contact_begin_;             // for each contact, the index of its first energy
  std::vector<Rod_energy> contact_energies_;           // indexed by contact and the labels of its two groups
  std::vector<std::vector<Energy_terms>> group_terms_; // indexed by group and label
  Pairwise_energy energy_;
};

} // namespace CGAL::Shape_correspondence
