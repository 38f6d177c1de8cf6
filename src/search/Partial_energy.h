// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "energy/Matching_problem.h"
#include "energy/Structure_preservation.h"

#include <array>
#include <cstddef>
#include <deque>
#include <vector>

namespace CGAL::Shape_correspondence::internal {

// The deformation of the shape under a partial solution, and the energies of its contacts.
struct Rating
{
  std::vector<Part_motion> motions; // indexed by part; defined for unmatched parts
  std::vector<Rod_energy> energies; // indexed by contact
};

// The energy of a partial solution: that of the whole shape, with the parts of unassigned groups moved by structure
// preservation (paper, section 5). Contacts between assigned groups are looked up in the tables of the problem.
// Solutions are rated as expansions of a parent: contacts whose parts do not move keep their energies.
class Partial_energy
{
public:
  explicit Partial_energy(const Matching_problem& problem);

  // The rating of the last solution; initially that of the empty one.
  const Rating& rating() const { return rating_; }

  // Sets the solution whose expansions are rated next.
  void set_parent(const Assignment& assignment, const Rating& rating);

  // The energy of the parent with one more group assigned, without the contacts of unassigned groups, which only add
  // energy.
  double lower_bound(const Assignment& assignment, std::size_t group);

  // The energy of the parent with one more group assigned. \param least its `lower_bound()` \param greatest rating
  // stops early, with some value above `greatest`, once the energy exceeds it
  double operator()(const Assignment& assignment, std::size_t group, double least, double greatest);

private:
  // The rods from a piece of a matched part to a whole part.
  struct Piece_rods
  {
    std::size_t side, piece; // side of the contact, index of the source piece
    int repeats;
    Structural_rods rods;
  };

  void assign(std::size_t group, const Assignment& assignment);
  double rate(const Assignment& assignment, double least, double greatest);
  Point contact_movement(std::size_t contact, std::size_t side, std::size_t label) const;
  double cost(const Rod_energy& energy) const;
  bool is_assigned(std::size_t contact, const Assignment& assignment) const;
  const Sample_lanes& moved_samples(std::size_t part);
  Rod_energy contact_energy(std::size_t contact, const Assignment& assignment);
  const Structural_rods& rods(std::size_t contact, std::size_t side, const Fitted_piece& fitted);

  const Matching_problem& problem_;
  const Deformable_shape& shape_;
  Structure_preservation preserve_structure_;
  std::vector<std::vector<std::size_t>> contacts_of_; // indexed by group
  // Displacement of a contact point by a label of its part's group, by 2 contact + side, and label
  std::vector<std::vector<Point>> contact_movement_;
  std::vector<std::deque<Piece_rods>> piece_rods_; // indexed by contact

  Assignment parent_;
  Rating parent_rating_;
  std::vector<Rod_energy> assigned_energies_; // indexed by contact; 0 if one of its groups is not assigned
  std::vector<std::size_t> order_;            // contacts by their energy in the parent, the highest first

  // The state of the solution that is being rated
  Rating rating_;
  std::vector<char> matched_; // indexed by group
  std::vector<std::array<Point, 2>> contact_displacement_;
  std::vector<char> keeps_place_; // for each part, whether it has the same place as in the parent

  // Samples of unmatched parts after a motion, cached since most motions recur
  std::vector<Sample_lanes> moved_;
  std::vector<Part_motion> moved_by_;
};

} // namespace CGAL::Shape_correspondence::internal
