// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "structure/align_shapes.h"

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL::Shape_correspondence {

/// The affine map by which an unmatched part is displaced and deformed.
struct Part_motion
{
  Point shift = Point::Zero();                       ///< of the part's centroid
  Eigen::Matrix3d stretch = Eigen::Matrix3d::Zero(); ///< x - centroid moves by stretch (x - centroid), too

  friend bool operator==(const Part_motion& a, const Part_motion& b)
  {
    return a.shift == b.shift && a.stretch == b.stretch;
  }
};

/// Structure preservation (paper, sections 4.2 and 5): displaces and deforms the parts of unmatched groups.
///
/// Breadth-first from the matched groups, proximity is propagated: the representative of a group, its member with most
/// contacts, follows their mean displacement. Symmetry is propagated: the other members follow it by the group's
/// generator. Then every unmatched group is placed again by all its contacts, until no part moves by more than
/// `tolerance`. In the end the representatives are stretched, so that a part that spans several others keeps its
/// contacts: by the affine map nearest to a translation that moves the contact points as they should.
class Structure_preservation
{
public:
  static constexpr double tolerance = 1e-3; ///< of the shape's height
  static constexpr int maximum_sweeps = 20;
  /// Weight of the scatter of a part's samples against that of its contact points (weight 1): how much it resists being
  /// stretched. A bar with two contacts at its ends follows them to within 2 % of what they move apart.
  static constexpr double stiffness = 0.1;
  /// The same where contacts are hard constraints: just enough for a unique map.
  static constexpr double least_stiffness = 1e-9;

  explicit Structure_preservation(const Aligned_shape& shape, bool has_hard_contacts = false);

  /// Moves the parts of unmatched groups.
  /// \param matched by group
  /// \param contact_displacement by contact, the displacements of the contact point on the first and on the second part,
  /// where these are matched
  /// \param motions by part; those of matched parts are not changed
  void operator()(const std::vector<char>& matched, const std::vector<std::array<Point, 2>>& contact_displacement,
                  std::vector<Part_motion>& motions);

private:
  /// A contact of a group with a part of another.
  struct Touch
  {
    std::size_t contact, part, other, other_group;
    int other_side;
  };

  // The contacts of a group's representative, by which the group is stretched.
  struct Handles
  {
    std::size_t representative = 0, begin = 0, end = 0; // its contacts in `touches_`
    Point middle = Point::Zero();                       // mean of the contact points, from the part's centroid
    std::vector<Point> slopes;                          // by contact: the stretch is the sum of displacement × slope
    std::vector<Eigen::Matrix3d> directions;            // by member, the linear map from the representative
  };

  Handles handles(std::size_t group) const;
  bool touches_placed(std::size_t group) const;
  void place(std::size_t group, const std::vector<char>& matched,
             const std::vector<std::array<Point, 2>>& contact_displacement);
  void gather(const std::vector<char>& matched, const std::vector<std::array<Point, 2>>& contact_displacement);
  double sweep();
  void displace(std::size_t group, const Point& moved);
  void stretch(std::size_t group, const std::vector<char>& matched,
               const std::vector<std::array<Point, 2>>& contact_displacement, std::vector<Part_motion>& motions) const;

  const Aligned_shape& shape_;
  double stiffness_;
  std::vector<std::vector<Touch>> touches_; // by group, ordered by part
  std::vector<Handles> handles_;            // by group
  Points displacement_;                     // by part
  std::vector<char> placed_;                // by group
  std::vector<std::size_t> order_;          // the unmatched groups connected to a matched one, breadth-first
  std::vector<const double*> followed_;     // displacements, by group in `order_` and contact of its representative
};

} // namespace CGAL::Shape_correspondence
