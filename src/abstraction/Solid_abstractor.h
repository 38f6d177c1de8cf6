// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "abstraction/fit_curve.h"
#include "abstraction/fit_sheet.h"
#include "abstraction/repair.h"

#include <CGAL/Shape_correspondence/abstract_part.h>

#include <variant>

namespace CGAL::Shape_correspondence::internal {

/// Sets the convex hull of a part and its volume. \param points of its surface
void measure_hull(const Points& points, Part_abstraction& part);

/// Repairs and remeshes the surface of a part to a closed solid, from which derived classes find the curve or sheet.
/// Parts for which this fails are abstracted by their bounding box.
class Solid_abstractor
{
public:
  Solid_abstractor(const Shape_part& part, const Abstraction_options& options);
  virtual ~Solid_abstractor() = default;

  /// The abstraction; its report names any failure.
  Part_abstraction run();

protected:
  using Method = Abstraction_report::Method;

  /// Calls `use_prism()` if the part is a prism. \param repaired a part of one component \return whether it is a prism
  virtual bool find_geometry_from_faces(const Repaired_part& /*repaired*/) { return false; }
  /// Finds the geometry and calls `use_curve()`, `use_axis()` or `use_sheet()`. \throw Flow_failure if there is none
  virtual void find_geometry(const Part_mesh& solid) = 0;

  /// Makes a curve the result. \throw Flow_failure if `is_point(fitted)`
  void use_curve(const Fitted_curve& fitted, Method method);
  void use_axis(const Curve& axis);
  void use_sheet(const Fitted_sheet& fitted, Method method);
  void use_prism(std::variant<Curve, Sheet> geometry);

  /// Whether the curve is too short to represent the part.
  bool is_point(const Fitted_curve& fitted) const;

  const Part_mesh& mesh() const { return part_.mesh; }
  const Abstraction_options& options() const { return options_; }
  Abstraction_kind wanted_kind() const { return wanted_kind_; }
  const Deadline& deadline() const { return deadline_; }
  double diagonal_of_part() const { return diagonal_; }
  /// Volume enclosed by the part.
  double volume() const { return result_.volume; }
  /// Volume of the part's convex hull, which the result keeps.
  double hull_volume();
  double edge_length() const { return edge_length_; }
  Abstraction_report& report() { return result_.report; }
  const Abstraction_report& report() const { return result_.report; }
  /// Milliseconds since the last call.
  double lap() { return watch_.lap(); }

private:
  /// Finds the abstraction. \throw Flow_failure, Out_of_time or any exception of the algorithms
  void try_to_run();
  /// The share of the points that are inside a solid or near its surface.
  double share_in_part(const Points& points, const Part_mesh& solid) const;
  /// The abstraction by the bounding box. \param failure why it is used \param time_limit whether time was up
  Part_abstraction bounding_box(const std::string& failure, bool time_limit) const;

  const Shape_part& part_;
  const Abstraction_options& options_;
  Abstraction_kind wanted_kind_;
  Deadline deadline_;
  double diagonal_;
  double edge_length_ = 0;
  Stop_watch watch_;
  Part_abstraction result_;
};

} // namespace CGAL::Shape_correspondence::internal
