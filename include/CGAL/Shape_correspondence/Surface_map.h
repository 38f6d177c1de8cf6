// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Shape_correspondence developers

#ifndef CGAL_SHAPE_CORRESPONDENCE_SURFACE_MAP_H
#define CGAL_SHAPE_CORRESPONDENCE_SURFACE_MAP_H

#include <CGAL/Shape_correspondence/Correspondence.h>
#include <CGAL/Shape_correspondence/Segmented_shape.h>
#include <CGAL/Shape_correspondence/Structural_graph.h>

#include <CGAL/assertions.h>

#include <cstddef>
#include <optional>
#include <type_traits>
#include <vector>

namespace CGAL::Shape_correspondence {

/// \ingroup PkgShapeCorrespondenceMaps
/// A location on the surface of a part.
struct Surface_place
{
  std::size_t part = 0;             ///< index of the part
  Eigen::Index triangle = 0;        ///< index in the part's mesh
  Eigen::Vector3d weights{0, 0, 0}; ///< barycentric coordinates
  Point point{0, 0, 0};             ///< the location in world coordinates
};

/// \ingroup PkgShapeCorrespondenceMaps
/// The map between the surfaces of two shapes. A point is described by its parameters on the abstraction of its part
/// and by coordinates in the local frame, relative to the extents of the part's cross-section. It is mapped to the same
/// coordinates on the other part, and then to the nearest point of its surface with a similar normal. Splits and merges
/// are those of the `Correspondence_map`.
class Surface_map
{
public:
  /// \param source,target the structural graphs
  /// \param source_shape,target_shape the models that the graphs were built from
  /// \param correspondence correspondence of the graphs
  /// \throw Invalid_input if a model does not have the parts of its graph
  Surface_map(const Structural_graph& source, const Segmented_shape& source_shape, const Structural_graph& target,
              const Segmented_shape& target_shape, const Correspondence& correspondence);

  /// The location on the source's surface for a vertex of the target; none if its part has no counterpart.
  /// \throw Invalid_input if there is no such part or vertex, as for `target_of()`
  std::optional<Surface_place> source_of(std::size_t target_part, Eigen::Index vertex) const;
  /// The location on the target's surface for a vertex of the source; none if its part has no counterpart.
  std::optional<Surface_place> target_of(std::size_t source_part, Eigen::Index vertex) const;

  /// Transfers values from the source's vertices to the target's, interpolated over triangles; labels (integral and
  /// enumerated types) are taken from the nearest corner.
  /// \param values by source part and vertex
  /// \param none value for vertices without a counterpart
  /// \pre values other than labels can be added and multiplied by a number; every vertex of the source has a value
  template <typename Value>
  std::vector<std::vector<Value>> transferred(const std::vector<std::vector<Value>>& values, const Value& none) const;

private:
  using Places = std::vector<std::vector<std::optional<Surface_place>>>; ///< indexed by part and vertex

  static std::optional<Surface_place> place_of(const Places& places, std::size_t part, Eigen::Index vertex);

  Places sources_, targets_;
  std::vector<Eigen::Matrix3Xi> triangles_; ///< triangles of the source's parts
};

template <typename Value>
std::vector<std::vector<Value>> Surface_map::transferred(const std::vector<std::vector<Value>>& values,
                                                         const Value& none) const
{
  CGAL_precondition(values.size() == targets_.size());
  for (std::size_t part = 0; part < targets_.size(); ++part)
    CGAL_precondition(values[part].size() == targets_[part].size());
  std::vector<std::vector<Value>> result;
  for (const auto& places : sources_) {
    result.emplace_back();
    for (const std::optional<Surface_place>& place : places) {
      if (!place) {
        result.back().push_back(none);
        continue;
      }
      const auto corner = [&](Eigen::Index i) -> const Value& {
        return values[place->part][std::size_t(triangles_[place->part](i, place->triangle))];
      };
      Eigen::Index nearest;
      place->weights.maxCoeff(&nearest);
      if constexpr (std::is_integral<Value>::value || std::is_enum<Value>::value)
        result.back().push_back(corner(nearest));
      else
        result.back().push_back(
            Value(corner(0) * place->weights[0] + corner(1) * place->weights[1] + corner(2) * place->weights[2]));
    }
  }
  return result;
}

} // namespace CGAL::Shape_correspondence

#endif // CGAL_SHAPE_CORRESPONDENCE_SURFACE_MAP_H
