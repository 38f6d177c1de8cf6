// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Shape_correspondence developers

#ifndef CGAL_SHAPE_CORRESPONDENCE_STRUCTURAL_GRAPH_H
#define CGAL_SHAPE_CORRESPONDENCE_STRUCTURAL_GRAPH_H

#include <CGAL/Shape_correspondence/Part_abstraction.h>
#include <CGAL/Shape_correspondence/Shape_frame.h>

#include <boost/graph/adjacency_list.hpp>

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace CGAL::Shape_correspondence {

/// \ingroup PkgShapeCorrespondenceGraph
/// Kinds of symmetry groups.
enum class Symmetry_type {
  NONE,       ///< a single part without a mirror plane of its own
  SELF,       ///< a single part that is its own mirror image
  REFLECTION, ///< parts that a reflection in a plane maps to each other
  ROTATION,   ///< parts that rotations about an axis map to each other
  TRANSLATION ///< parts in a row
};

/// \ingroup PkgShapeCorrespondenceGraph
/// The generator of a symmetry group, in world coordinates.
struct Symmetry
{
  Symmetry_type type = Symmetry_type::NONE; ///< kind of the symmetry
  Point point{0, 0, 0};                     ///< point on the mirror plane or the rotation axis
  Point direction{0, 0, 0}; ///< by type: unit normal of the plane, unit axis, or translation from member to member
  int order = 1;            ///< order n of an n-fold rotation
  double residual = 0;      ///< mean distance of members from their images, over the height of the shape
};

/// \ingroup PkgShapeCorrespondenceGraph
/// A vertex of the structural graph: a symmetry group of parts (paper, section 3).
struct Part_group
{
  std::vector<std::size_t> parts; ///< indices into `Shape_structure::parts`, in the order along the generator
  Symmetry symmetry;              ///< the generator of the group
  double volume = 0;              ///< volume, summed over the parts
  double hull_volume = 0;         ///< volume of the convex hull of all parts
};

/// \ingroup PkgShapeCorrespondenceGraph
/// Two parts in contact, with the locations of the contact as parameters on both abstractions.
struct Contact
{
  /// For each of the two parts, the parameters of a point of its curve, (t, 0), or of its sheet, (u, v).
  using Parameters = std::array<Eigen::Vector2d, 2>;

  std::array<std::size_t, 2> parts; ///< indices into `Shape_structure::parts`
  Parameters parameters;            ///< location of the contact region; of the largest if there are several
  std::vector<Parameters> further;  ///< locations of the other regions, as of an arm that touches the back twice
};

/// \ingroup PkgShapeCorrespondenceGraph
/// An edge of the structural graph: two groups with parts in contact.
struct Group_contact
{
  std::vector<std::size_t> contacts; ///< indices into `Shape_structure::contacts`
};

/// \ingroup PkgShapeCorrespondenceGraph
/// The parts of a shape, their contacts, and what is known of the shape as a whole: the data that the graph refers to.
struct Shape_structure
{
  std::string name;                    ///< name of the shape in messages and files
  Shape_frame frame;                   ///< the frame in which shapes are compared
  std::vector<Part_abstraction> parts; ///< the parts, in the order of the input
  std::vector<Contact> contacts;       ///< contacts of parts, including those within a group, which are in no edge
  std::vector<std::string> warnings;   ///< sentences on approximations made and limits reached
  bool automatic_parts = false;        ///< whether the parts come from an automatic segmentation
  std::string content;                 ///< hash of the meshes and options of the graph; empty: unknown
  Eigen::MatrixXd features; ///< `features_of_parts()`, one column for each part; empty: none. Not saved in files
};

/// \ingroup PkgShapeCorrespondenceGraph
/// The structural graph (paper, section 3), a Boost graph: vertices are symmetry groups, edges are contacts between
/// groups; `graph[boost::graph_bundle]`, or `structure(graph)`, is the shape.
using Structural_graph =
    boost::adjacency_list<boost::vecS, boost::vecS, boost::undirectedS, Part_group, Group_contact, Shape_structure>;

/// \ingroup PkgShapeCorrespondenceGraph
/// The data of the whole shape.
inline const Shape_structure& structure(const Structural_graph& graph) { return graph[boost::graph_bundle]; }
/// \ingroup PkgShapeCorrespondenceGraph
/// The data of the whole shape.
inline Shape_structure& structure(Structural_graph& graph) { return graph[boost::graph_bundle]; }

/// \ingroup PkgShapeCorrespondenceGraph
/// The vertex of every part's group, by part.
std::vector<std::size_t> group_of_parts(const Structural_graph& graph);

/// \ingroup PkgShapeCorrespondenceGraph
/// Builds the graph: one vertex for each group, one edge for every two groups with contacts between them.
/// \pre the groups partition the parts
Structural_graph make_structural_graph(Shape_structure shape, std::vector<Part_group> groups);

/// \ingroup PkgShapeCorrespondenceGraph
/// Checks that the groups partition the parts, that edges and contacts agree, that all numbers are finite, and that
/// every group has an edge unless there is only one. With `verbose`, it prints errors to `std::cerr`.
bool is_valid_structural_graph(const Structural_graph& graph, bool verbose = false);

} // namespace CGAL::Shape_correspondence

#endif // CGAL_SHAPE_CORRESPONDENCE_STRUCTURAL_GRAPH_H
