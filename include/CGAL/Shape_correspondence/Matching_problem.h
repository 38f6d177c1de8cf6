// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SHAPE_CORRESPONDENCE_MATCHING_PROBLEM_H
#define CGAL_SHAPE_CORRESPONDENCE_MATCHING_PROBLEM_H

#include <CGAL/Shape_correspondence/Deformation_energy.h>
#include <CGAL/Shape_correspondence/Geotopo_transform.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Shape_correspondence {

/// A label index by group; `unassigned` where a group has none yet.
using Assignment = std::vector<int>;
constexpr int unassigned = -1;

/// The most labels that a group has, which bounds time and memory for shapes of hundreds of groups.
constexpr std::size_t maximum_labels = 64;

/// The matching graph of a source and a target shape (paper, section 5) with its energies as tables. Once every group
/// has a label, a matched part is its target part up to resampling, so that E is a sum over groups and over pairs of
/// groups in contact of terms that depend on their labels alone; each is computed once. Label h of a group is target
/// group h.
class Matching_problem
{
public:
  /// Two groups in contact and the cost of every pair of their labels: E_d + w_c E_c, summed over contacts.
  struct Edge
  {
    std::size_t first, second;         ///< groups
    std::vector<std::size_t> contacts; ///< of the source shape
    Eigen::MatrixXd cost;              ///< label of first × label of second
  };

  /// \param maximum_parts takes only the most prominent groups of at most that many parts in all (at least one group);
  /// 0 takes all
  Matching_problem(Aligned_shape source, Aligned_shape target, const Energy_weights& weights, int maximum_parts = 0);

  const Aligned_shape& source() const { return source_; }
  const Aligned_shape& target() const { return target_; }
  const Energy_weights& weights() const { return weights_; }
  /// As many for every group.
  std::size_t number_of_labels() const { return std::min(target_.groups.size(), maximum_labels); }
  /// Whether the labels of a group are fewer than the target groups, so that no search proves an optimum.
  bool has_shortlists() const { return target_.groups.size() > maximum_labels; }
  /// The groups that take part, ascending.
  const std::vector<std::size_t>& active_groups() const { return active_groups_; }
  /// The contacts between parts that take part, ascending.
  const std::vector<std::size_t>& active_contacts() const { return active_contacts_; }
  const Group_label& label(std::size_t group, std::size_t label) const { return labels_[group][label]; }
  /// Cost of the contacts inside a group, by label.
  const Eigen::VectorXd& unary_cost(std::size_t group) const { return unary_[group]; }
  const std::vector<Edge>& edges() const { return edges_; }
  /// The rods of a contact before the deformation, for so many samples on its first and on its second part (e or e ×
  /// e).
  const Structural_rods& rods(std::size_t contact, Eigen::Index first_samples, Eigen::Index second_samples) const;

  /// Samples of a source part after it was fitted to a target part.
  const Points& deformed(std::size_t part, std::size_t target_part) const
  {
    return deformed_[part * target_.parts.size() + target_part];
  }
  /// E_d and E_c of a contact whose two groups have labels; clones are paired with their nearest counterparts, and the
  /// pairs averaged.
  Rod_energy contact_energy(std::size_t contact, std::size_t first_label, std::size_t second_label) const
  {
    return contact_energies_[contact][first_label * number_of_labels() + second_label];
  }

  /// The terms of a complete assignment.
  Energy_terms terms(const Assignment& assignment) const;
  /// E of a complete assignment.
  double energy(const Assignment& assignment) const { return weighted_sum(terms(assignment), weights_); }
  /// No complete assignment has a lower energy: the sum of the least costs of every group and edge.
  double lower_bound() const;

private:
  void choose_groups(int maximum_parts);
  void choose_labels();
  void fit_parts();
  void fill_contact_energies(std::size_t contact);
  void add_up_tables();
  Rod_energy clone_energy(std::size_t contact, std::size_t first_image, std::size_t second_image) const;
  std::vector<std::pair<std::size_t, std::size_t>> clone_pairs(const std::vector<std::size_t>& first,
                                                               const std::vector<std::size_t>& second) const;

  Aligned_shape source_, target_;
  Energy_weights weights_;
  std::vector<std::size_t> active_groups_, active_contacts_;
  std::vector<std::vector<Group_label>> labels_;
  std::vector<Points> deformed_;
  std::vector<std::vector<Structural_rods>> rods_; // by contact; see rods()
  Eigen::MatrixXd target_distance_;                // least distance of the samples of two target parts
  std::vector<std::vector<Rod_energy>> contact_energies_;
  std::vector<Eigen::VectorXd> unary_;
  std::vector<Edge> edges_;
};

/// What a search found.
struct Search_result
{
  Assignment assignment; ///< complete
  double energy = 0;     ///< E of Eq. 1
  bool optimal = false;  ///< no assignment has a lower energy
  Search_summary summary;
};

} // namespace Shape_correspondence
} // namespace CGAL

#ifndef CGAL_SHAPE_CORRESPONDENCE_COMPILED
#include <CGAL/Shape_correspondence/internal/Matching_problem_impl.h>
#endif

#endif // CGAL_SHAPE_CORRESPONDENCE_MATCHING_PROBLEM_H
