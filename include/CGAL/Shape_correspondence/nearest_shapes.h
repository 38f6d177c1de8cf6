// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Shape_correspondence developers

#ifndef CGAL_SHAPE_CORRESPONDENCE_NEAREST_SHAPES_H
#define CGAL_SHAPE_CORRESPONDENCE_NEAREST_SHAPES_H

#include <CGAL/Shape_correspondence/Part_map.h>
#include <CGAL/Shape_correspondence/energy_matrix.h>

#include <CGAL/tags.h>

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace CGAL::Shape_correspondence {

/// \ingroup PkgShapeCorrespondenceSets
/// A shape of a set that is near a query.
struct Near_shape
{
  std::size_t shape = 0; ///< index of the shape
  double distance = 0;   ///< mean of the `distance_energy()` of both directions
  Part_map map;          ///< part map from the query to the shape
  std::string category;  ///< `Correspondence_finder::source_category()` of the shape
};

/// \ingroup PkgShapeCorrespondenceSets
/// The result of `nearest_shapes()`.
struct Nearest_shapes
{
  std::vector<Near_shape> shapes; ///< the nearest first; equally near ones by index
  std::size_t evaluations = 0;    ///< number of shapes that were matched with the query
  std::string category;           ///< `Correspondence_finder::source_category()` of the query
};

/// \ingroup PkgShapeCorrespondenceSets
/// The `k` shapes of a set that are nearest to a query. If `Search_options::roles` has the category of the query,
/// shapes of this category come first, then shapes of no known category, then those of other categories; within each,
/// the distance decides. Not all shapes are matched: distances are bounded from below
/// (`Correspondence_finder::lower_bound()`) and computed in the order of these bounds until no bound is less than the
/// k-th distance. The result is the same as with all shapes matched, bitwise identical sequentially and in parallel.
/// \tparam ConcurrencyTag `CGAL::Sequential_tag` or `CGAL::Parallel_tag`
/// \param query the structural graph of the query
/// \param number_of_shapes number of shapes in the set
/// \param graph returns the graph of a shape by its index; called once for each shape, and again for those that are
/// matched; from several threads at a time with `CGAL::Parallel_tag`. \pre the graphs are valid
/// \param k number of shapes to find
/// \param options options of the matches and the distance
/// \throw Invalid_input if an option is out of its range
template <typename ConcurrencyTag = CGAL::Sequential_tag>
Nearest_shapes nearest_shapes(const Structural_graph& query, std::size_t number_of_shapes,
                              const std::function<Structural_graph(std::size_t)>& graph, std::size_t k,
                              const Energy_matrix_options& options = {});

/// \ingroup PkgShapeCorrespondenceSets
/// The same for shapes in memory.
template <typename ConcurrencyTag = CGAL::Sequential_tag>
Nearest_shapes nearest_shapes(const Structural_graph& query, const std::vector<Structural_graph>& shapes, std::size_t k,
                              const Energy_matrix_options& options = {})
{
  return nearest_shapes<ConcurrencyTag>(
      query, shapes.size(), [&](std::size_t i) { return shapes[i]; }, k, options);
}

} // namespace CGAL::Shape_correspondence

#endif // CGAL_SHAPE_CORRESPONDENCE_NEAREST_SHAPES_H
