// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Shape_correspondence developers

#ifndef CGAL_SHAPE_CORRESPONDENCE_IO_CORRESPONDENCE_JSON_H
#define CGAL_SHAPE_CORRESPONDENCE_IO_CORRESPONDENCE_JSON_H

#include <CGAL/Shape_correspondence/Correspondence.h>
#include <CGAL/Shape_correspondence/Structural_graph.h>

#include <iosfwd>
#include <limits>
#include <map>
#include <string>
#include <vector>

namespace CGAL::Shape_correspondence::IO {

/// \ingroup PkgShapeCorrespondenceIO
/// Seconds of each phase of a match, as written to the result file.
struct Match_seconds
{
  double read = 0;        ///< seconds for reading both models
  double abstraction = 0; ///< seconds for abstracting their parts
  double structure = 0;   ///< seconds for finding symmetry groups and contacts
  double search = 0;      ///< seconds for finding the correspondence
};

/// \ingroup PkgShapeCorrespondenceIO
/// Writes a correspondence in the JSON format `shape_correspondence/match`, version 1.
/// `source_file` and `target_file` are the inputs as the user named them.
void write_correspondence_json(std::ostream& out, const Correspondence& correspondence, const Structural_graph& source,
                               const Structural_graph& target, const std::string& source_file,
                               const std::string& target_file, const Match_seconds& seconds);

/// \ingroup PkgShapeCorrespondenceIO
/// Writes ranked correspondences (`Correspondence_finder::ranked()`) in the same format: the first is the result, and
/// if there are more, `solutions` lists all with their energies and pairs.
/// \pre `ranked` is not empty
void write_correspondences_json(std::ostream& out, const std::vector<Correspondence>& ranked,
                                const Structural_graph& source, const Structural_graph& target,
                                const std::string& source_file, const std::string& target_file,
                                const Match_seconds& seconds);

/// \ingroup PkgShapeCorrespondenceIO
/// Two parts that correspond, by their names.
struct Named_part_correspondence
{
  std::string source; ///< the source part
  std::string target; ///< the target part
  /// Probability that the pair is right; NaN if the method does not compute it.
  double confidence = std::numeric_limits<double>::quiet_NaN();
};

/// \ingroup PkgShapeCorrespondenceIO
/// A correspondence by the names of parts, as read from a file.
struct Named_correspondence
{
  std::string source;                              ///< the source as the user named it
  std::string target;                              ///< the target as the user named it
  std::vector<Named_part_correspondence> pairs;    ///< corresponding parts, in the order of the file
  bool complete = false;                           ///< see `Correspondence::complete`
  int target_quarter_turns = 0;                    ///< see `Correspondence::target_quarter_turns`
  std::string category;                            ///< category of both shapes; empty if the method does not use roles
  std::map<std::string, std::string> source_roles; ///< roles of source parts, by name; empty without a category
  std::map<std::string, std::string> target_roles; ///< roles of target parts, by name; empty without a category
};

/// \ingroup PkgShapeCorrespondenceIO
/// Reads a result in the JSON format `shape_correspondence/match`; of ranked solutions, the first.
/// \throw Invalid_input if the file cannot be read or is not a result; the message gives the file and the error
Named_correspondence read_correspondence_json(const std::string& file);

/// \ingroup PkgShapeCorrespondenceIO
/// Converts a result read from a file to indices of parts in the graphs: pairs, roles, category, completeness and
/// alignment. Messages name `file`.
/// \throw Invalid_input if a shape does not have one of the parts
Correspondence correspondence_of(const Named_correspondence& named, const Structural_graph& source,
                                 const Structural_graph& target, const std::string& file);

/// \ingroup PkgShapeCorrespondenceIO
/// Whether a JSON file is a result in the format `shape_correspondence/match`.
/// \throw Invalid_input if it is not JSON
bool is_correspondence_json(const std::string& file);

} // namespace CGAL::Shape_correspondence::IO

#endif // CGAL_SHAPE_CORRESPONDENCE_IO_CORRESPONDENCE_JSON_H
