// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SHAPE_CORRESPONDENCE_TEST_PROGRAM_H
#define SHAPE_CORRESPONDENCE_TEST_PROGRAM_H

#include "model_files.h"

#include <CGAL/Shape_correspondence/IO/structural_graph_json.h>

#include <catch2/catch.hpp>

#include <sys/wait.h>

#include <cstdlib>
#include <sstream>
#include <string>

struct Run
{
  int status;
  std::string out;
  std::string error;
};

/// The word, quoted for the shell. It is taken by value, so that overload resolution prefers this to std::quoted().
inline std::string quoted(std::string word) { return "'" + word + "'"; }

/// Runs the program. \param arguments in the syntax of the shell
inline Run run(const std::string& arguments)
{
  const model_files::Temporary_folder folder;
  const int status = std::system((quoted(SHAPE_CORRESPONDENCE_PROGRAM) + " " + arguments + " >" +
                                  quoted(folder.path("out")) + " 2>" + quoted(folder.path("error")))
                                     .c_str());
  REQUIRE(WIFEXITED(status));
  return {WEXITSTATUS(status), model_files::text_of(folder.path("out")), model_files::text_of(folder.path("error"))};
}

/// The text of a graph file. \param name name of the shape; empty: the graph keeps its own
inline std::string graph_text(CGAL::Shape_correspondence::Structural_graph graph, const std::string& name = "")
{
  if (!name.empty()) structure(graph).name = name;
  std::ostringstream text;
  CGAL::Shape_correspondence::IO::write_structural_graph_json(text, graph);
  return text.str();
}

inline std::string graph_file(const model_files::Temporary_folder& folder, const std::string& name,
                              const CGAL::Shape_correspondence::Structural_graph& graph)
{
  return folder.write(name, graph_text(graph));
}

#endif // SHAPE_CORRESPONDENCE_TEST_PROGRAM_H
