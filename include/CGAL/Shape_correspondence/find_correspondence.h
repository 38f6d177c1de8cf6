// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Shape_correspondence developers

#ifndef CGAL_SHAPE_CORRESPONDENCE_FIND_CORRESPONDENCE_H
#define CGAL_SHAPE_CORRESPONDENCE_FIND_CORRESPONDENCE_H

#include <CGAL/Shape_correspondence/Correspondence.h>
#include <CGAL/Shape_correspondence/Search_options.h>
#include <CGAL/Shape_correspondence/Structural_graph.h>
#include <CGAL/Shape_correspondence/evaluate_correspondence.h>

#include <array>
#include <memory>
#include <vector>

namespace CGAL::Shape_correspondence {

class Prepared_shape;

namespace internal {
struct Alignments;
struct Match_source;
Alignments& alignments_of(const Prepared_shape& shape);
} // namespace internal

/// \ingroup PkgShapeCorrespondenceFunctions
/// A shape to be matched repeatedly: its alignments, by quarter turns, are computed once, also for copies. Thread-safe.
class Prepared_shape
{
public:
  /// Keeps a reference to the graph.
  explicit Prepared_shape(const Structural_graph& graph);
  explicit Prepared_shape(const Structural_graph&&) = delete;

  /// Predicts the roles of the parts now rather than at the first match with this model.
  void read_roles(const std::shared_ptr<const Role_model>& model) const;

  /// The graph from which the object was constructed.
  const Structural_graph& graph() const { return graph_; }

private:
  friend internal::Alignments& internal::alignments_of(const Prepared_shape& shape);

  const Structural_graph& graph_;
  std::shared_ptr<internal::Alignments> alignments_;
};

/// \ingroup PkgShapeCorrespondenceCorrespondence
/// A label transferred from a part of the source to a part of a target.
struct Transferred_label
{
  Part_label label;      ///< label of the source part; empty if the target part is excluded
  double confidence = 0; ///< probability that the two parts correspond; 0: the source part of least cost was used
};

/// \ingroup PkgShapeCorrespondenceFunctions
/// Finds correspondences of one source with many targets; data that depend on the source alone are computed once.
class Correspondence_finder
{
public:
  /// Keeps a reference to the graph.
  /// \pre the graph is valid (`is_valid_structural_graph()`)
  /// \throw Invalid_input if an option is out of its range
  explicit Correspondence_finder(const Structural_graph& source, const Search_options& options = {});
  explicit Correspondence_finder(const Structural_graph&&, const Search_options& = {}) = delete;
  /// Constructs a finder from a prepared shape, whose cached alignments are used.
  explicit Correspondence_finder(const Prepared_shape& source, const Search_options& options = {});

  /// The correspondence with a target, see `CGAL::Shape_correspondence::find_correspondence()`.
  Correspondence operator()(const Structural_graph& target) const;
  /// The correspondence with a prepared target.
  Correspondence operator()(const Prepared_shape& target) const;
  /// The correspondences of the source with the target, and of the target with the source, with the same options.
  /// `Search_method::PARTS`, which is symmetric, matches them only once.
  std::array<Correspondence, 2> both_orders(const Prepared_shape& target) const;
  /// The best `Search_options::solutions` in ascending order of energy. `PARTS` finds one; `EXACT` proves all.
  std::vector<Correspondence> ranked(const Structural_graph& target) const;
  /// The best solutions for a prepared target.
  std::vector<Correspondence> ranked(const Prepared_shape& target) const;

  /// Transfers the labels of the source's parts to the parts of a target. Each gets the label of the source part to
  /// which it corresponds most probably: by roles and geometry if `Search_options::roles` knows the category, otherwise
  /// by geometry.
  /// \param labels labels by part of the source
  /// \param target the shape whose parts get labels
  /// \throw Invalid_input if there is not one label for every part, or the method is not `Search_method::PARTS`
  std::vector<Transferred_label> transfer_labels(const std::vector<Part_label>& labels,
                                                 const Prepared_shape& target) const;

  /// The category of the source predicted by the roles of its parts, or `Search_options::category`; empty if there is
  /// none or `Search_options::roles` is null.
  std::string source_category() const;

  /// A lower bound of the `distance_energy()` of the correspondence, without a search: the sum of the least values of
  /// the terms of one and of two groups or, for `Search_method::PARTS`, with all pairs of parts allowed, of one and of
  /// two parts; 0 if no bound is known.
  /// \param target the other shape
  /// \param unmatched_energy see `distance_energy()`
  double lower_bound(const Prepared_shape& target, double unmatched_energy) const;

private:
  std::shared_ptr<const internal::Match_source> source_;
};

/// \ingroup PkgShapeCorrespondenceFunctions
/// Finds the part correspondence of two shapes.
///
/// By default, parts are matched by their costs (`Part_cost_weights`), and the result is rated by the deformation
/// energy of the source under the paper's GeoTopo transform (sections 4 and 5). `Search_method::BEAM` and `EXACT`
/// search for the correspondence of least deformation energy: the source is deformed into the target and, by default,
/// the target into the source; the direction with the lower energy per pair of connected parts is taken, so that the
/// simpler shape is not preferred for having fewer pairs. Deterministic; the result does not depend on part order,
/// position, scale or a rotation by less than 45° about the up axis. If `Search_options::progress` ends the search, the
/// best result so far is returned with a warning, and `complete` is false.
/// \param source,target the structural graphs of the shapes
/// \param options options of the method, the search and the energy
/// \pre both graphs are valid (`is_valid_structural_graph()`)
/// \throw Invalid_input if an option is out of its range, pinned and forbidden pairs contradict each other, or a shape
/// to be deformed has more than 150 groups of parts with `Search_method::BEAM` or 500 with `EXACT`
Correspondence find_correspondence(const Structural_graph& source, const Structural_graph& target,
                                   const Search_options& options = {});

} // namespace CGAL::Shape_correspondence

#endif // CGAL_SHAPE_CORRESPONDENCE_FIND_CORRESPONDENCE_H
