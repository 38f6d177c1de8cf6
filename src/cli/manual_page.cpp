// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "cli/manual_page.h"
#include "cli/commands.h"

#include <CGAL/Shape_correspondence/version.h>

#include <boost/algorithm/string/case_conv.hpp>
#include <boost/algorithm/string/replace.hpp>

#include <ostream>
#include <sstream>

namespace CGAL::Shape_correspondence::cli {
namespace {

/// A line of text as troff shows it unchanged.
std::string escaped(std::string line)
{
  boost::replace_all(line, "\\", "\\e");
  boost::replace_all(line, "-", "\\-");
  if (!line.empty() && (line[0] == '.' || line[0] == '\'')) line = "\\&" + line; // else a request
  return line;
}

/// A text with its lines and indentation kept.
void write_as_it_is(std::ostream& out, const std::string& text)
{
  out << ".nf\n";
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);)
    out << escaped(line) << '\n';
  out << ".fi\n";
}

} // namespace

void write_manual_page(std::ostream& out)
{
  out << ".TH SHAPE_CORRESPONDENCE 1 \"\" \"shape_correspondence " CGAL_SHAPE_CORRESPONDENCE_VERSION "\"\n"
      << ".SH NAME\nshape_correspondence \\- part correspondences of segmented 3D shapes\n.SH SYNOPSIS\n";
  std::ostringstream help;
  write_help(help);
  write_as_it_is(out, help.str());
  for (const Command& command : commands()) {
    out << ".SH " << boost::to_upper_copy(std::string(command.name)) << '\n';
    std::ostringstream text;
    write_help(text, command);
    write_as_it_is(out, text.str());
  }
}

} // namespace CGAL::Shape_correspondence::cli
