// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

/// \concept PartAbstractor
///
/// What turns the mesh of one part into a curve or a sheet. `Abstraction_options::abstractor` holds a model; all of
/// `abstract_part()`, `abstract_parts()` and `build_structural_graph()` go through it. Copies of a part are not passed:
/// they get the abstraction of their original, moved. Hull, area and surface samples are added by the caller.
///
/// Refines `CopyConstructible`. A model is used by several threads at once; what it returns may depend on its arguments
/// only.
///
/// \hasModel `Skeleton_abstraction`, the default
/// \hasModel `Bounding_box_abstraction`
class PartAbstractor
{
public:
  /// Returns an abstraction whose `geometry` is a curve of two or more points or a sheet of two or more rows and
  /// columns, all of them finite, in the coordinates of the mesh. `volume`, of the enclosed solid, may be left 0:
  /// unknown. `report` says how it was made; `report.fallback` is a reason to warn the user, or empty.
  ///
  /// \param part its mesh is in the frame of the shape (of unit height, y up, or of the part alone in
  /// `abstract_part()`), with equal vertices merged, no triangle twice, at least one of positive area; it may be open,
  /// non-manifold, of several components, and intersect itself
  /// \param options of the call, among them the kind to make, `options.kind_of(part.name)`
  Part_abstraction operator()(const Shape_part& part, const Abstraction_options& options) const;
};
