// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "io/read/report_text.h"

namespace CGAL::Shape_correspondence::IO {

const Words<Abstraction_report::Method>& method_words()
{
  using Method = Abstraction_report::Method;
  static const Words<Method> words = {{"skeleton", Method::SKELETON},
                                      {"meso_skeleton", Method::MESO_SKELETON},
                                      {"medial_axis", Method::MEDIAL_AXIS},
                                      {"axis", Method::AXIS},
                                      {"prism", Method::PRISM},
                                      {"bounding_box", Method::BOUNDING_BOX},
                                      {"copy", Method::COPY},
                                      {"given", Method::GIVEN}};
  return words;
}

const Words<Abstraction_report::Repair>& repair_words()
{
  using Repair = Abstraction_report::Repair;
  static const Words<Repair> words = {
      {"none", Repair::NONE}, {"soup", Repair::SOUP}, {"holes", Repair::HOLES}, {"wrap", Repair::WRAP}};
  return words;
}

const Words<bool Abstraction_report::*>& flag_words()
{
  using Report = Abstraction_report;
  static const Words<bool Report::*> words = {{"tube", &Report::tube},
                                              {"blob", &Report::blob},
                                              {"branching", &Report::branching},
                                              {"several_components", &Report::several_components},
                                              {"time_limit", &Report::time_limit}};
  return words;
}

const Words<Symmetry_type>& symmetry_words()
{
  static const Words<Symmetry_type> words = {{"none", Symmetry_type::NONE},
                                             {"self", Symmetry_type::SELF},
                                             {"reflection", Symmetry_type::REFLECTION},
                                             {"rotation", Symmetry_type::ROTATION},
                                             {"translation", Symmetry_type::TRANSLATION}};
  return words;
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
