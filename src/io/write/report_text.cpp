// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "io/write/report_text.h"

namespace CGAL::Shape_correspondence::IO {

const char* name_of(Abstraction_report::Method method)
{
  using Method = Abstraction_report::Method;
  switch (method) {
  case Method::SKELETON:
    return "skeleton";
  case Method::MESO_SKELETON:
    return "meso_skeleton";
  case Method::MEDIAL_AXIS:
    return "medial_axis";
  case Method::AXIS:
    return "axis";
  case Method::PRISM:
    return "prism";
  case Method::BOUNDING_BOX:
    return "bounding_box";
  case Method::COPY:
    return "copy";
  case Method::GIVEN:
    return "given";
  }
  return "given";
}

const char* name_of(Abstraction_report::Repair repair)
{
  using Repair = Abstraction_report::Repair;
  switch (repair) {
  case Repair::NONE:
    return "none";
  case Repair::SOUP:
    return "soup";
  case Repair::HOLES:
    return "holes";
  case Repair::WRAP:
    return "wrap";
  }
  return "none";
}

std::vector<std::string> flags_of(const Abstraction_report& report)
{
  std::vector<std::string> result;
  if (report.tube) result.push_back("tube");
  if (report.blob) result.push_back("blob");
  if (report.branching) result.push_back("branching");
  if (report.several_components) result.push_back("several_components");
  if (report.time_limit) result.push_back("time_limit");
  if (report.is_fallback()) result.push_back("bounding_box");
  return result;
}

const char* name_of(Symmetry_type type)
{
  switch (type) {
  case Symmetry_type::NONE:
    return "none";
  case Symmetry_type::SELF:
    return "self";
  case Symmetry_type::REFLECTION:
    return "reflection";
  case Symmetry_type::ROTATION:
    return "rotation";
  case Symmetry_type::TRANSLATION:
    return "translation";
  }
  return "none";
}

std::string name_of(const Symmetry& symmetry)
{
  const std::string name = name_of(symmetry.type);
  return symmetry.type == Symmetry_type::ROTATION ? name + ", " + std::to_string(symmetry.order) + "-fold" : name;
}

std::string kind_of(const Part_abstraction& part)
{
  return part.is_sheet() ? "sheet" : part.is_closed_curve() ? "closed curve" : "curve";
}

} // namespace CGAL::Shape_correspondence::IO
