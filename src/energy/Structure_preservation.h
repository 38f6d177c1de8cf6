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
  Point shift = Point::Zero();                       ///< displacement of the part's centroid
  Eigen::Matrix3d stretch = Eigen::Matrix3d::Zero(); ///< a point x moves by stretch * (x - centroid) in addition

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
/// `tolerance`. Finally the representatives are stretched, so that a part that spans several others keeps its contacts:
/// by the affine map nearest to a translation that displaces the contact points as required.
class Structure_preservation
{
public:
  static constexpr double tolerance = 1e-3; ///< convergence threshold, over the shape's height
  static constexpr int maximum_sweeps = 20; ///< limit for the rounds in which all unmatched groups are placed again
  /// Weight of the scatter of a part's samples relative to that of its contact points (weight 1): its resistance to
  /// stretching. A bar with contacts at its two ends follows them to within 2 % of their relative displacement.
  static constexpr double stiffness = 0.1;
  /// The same weight if contacts are hard constraints (`Energy_options::hard_proximity`): just enough for a unique map.
  static constexpr double least_stiffness = 1e-9;

  explicit Structure_preservation(const Aligned_shape& shape, bool has_hard_contacts = false);

  /// Moves the parts of unmatched groups.
  /// \param matched for each group, whether it is matched
  /// \param contact_displacement by contact, the displacements of the contact point on the first and on the second
  /// part, defined where these are matched
  /// \param motions by part; entries of matched parts are left unchanged
  void operator()(const std::vector<char>& matched, const std::vector<std::array<Point, 2>>& contact_displacement,
                  std::vector<Part_motion>& motions);

private:
  /// A contact between a part of a group and a part of another group.
  struct Touch
  {
    std::size_t contact, part, other, other_group;
    int other_side;
  };

  // The contacts of a group's representative, by which the group is stretched.
  struct Handles
  {
    std::size_t representative = 0, begin = 0, end = 0; // range of its contacts in `touches_`
    Point middle = Point::Zero();                       // mean of the contact points, relative to the part's centroid
    std::vector<Point> slopes;               // indexed by contact; the stretch is the sum of displacement × slope^T
    std::vector<Eigen::Matrix3d> directions; // for each member, the linear map from the representative to it
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
  std::vector<std::vector<Touch>> touches_; // indexed by group, ordered by part
  std::vector<Handles> handles_;            // indexed by group
  Points displacement_;                     // indexed by part
  std::vector<char> placed_;                // whether a group is placed
  std::vector<std::size_t> order_;          // the unmatched groups connected to a matched one, breadth-first
  // The displacements that the representatives follow, by group in `order_` and contact of its representative
  std::vector<const double*> followed_;
};

} // namespace CGAL::Shape_correspondence
