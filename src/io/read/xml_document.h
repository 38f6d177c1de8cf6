// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "io/read/document.h"
#include "io/system/remedies.h"

#include <CGAL/Shape_correspondence/Invalid_input.h>

#include <boost/property_tree/xml_parser.hpp>

#include <sstream>
#include <string>

namespace CGAL::Shape_correspondence::IO {

/// Parses an XML document. \throw Invalid_input if it is invalid or nested too deeply; names `file`
inline boost::property_tree::ptree parse_xml(const std::string& text, const std::string& file)
{
  check_xml_depth(text, file);
  boost::property_tree::ptree result;
  std::istringstream in(text);
  try {
    boost::property_tree::read_xml(in, result);
  } catch (const boost::property_tree::xml_parser_error& error) {
    refuse(file + ": it is not an XML document (line " + std::to_string(error.line()) + ": " + error.message() + ")",
           remedy::correct_text);
  }
  return result;
}

} // namespace CGAL::Shape_correspondence::IO
