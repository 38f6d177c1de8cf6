// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "io/write/part_labels.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <set>

using namespace CGAL::Shape_correspondence;

using Names = std::vector<std::string>;

TEST_CASE("Labels leave out what exporters and modellers add to the names of parts")
{
  CHECK(IO::part_labels({"front_left_leg", "seat", "star_1", "star_2"}) ==
        Names{"front_left_leg", "seat", "star_1", "star_2"});
  CHECK(IO::part_labels({"Office_CH_arms_Office_CH_arms_Office_CH_plastic",
                         "Office_CH_seat_Office_CH_seat_Office_CH_fabric",
                         "Office_CH_wheels_Office_CH_wheels_Office_CH_plastic",
                         "Office_CH_wheels_Office_CH_wheels_Office_CH_plastic#2"}) ==
        Names{"arms", "seat", "wheels 1", "wheels 2"});
  CHECK(IO::part_labels({"Zitting_Plane.082", "Zitting_Plane.082#2", "glass_Cylinder.001", "Leuning_Torus"}) ==
        Names{"Zitting 1", "Zitting 2", "glass", "Leuning"});
  CHECK(IO::part_labels({"Cube.001", "Cube.002", "7"}) == Names{"Cube 1", "Cube 2", "7"});
}

TEST_CASE("A name that says nothing about its part becomes the role")
{
  CHECK(IO::part_labels({"Object_4", "mesh17", "part_02", "backrest"}, {"leg", "leg", "seat_frame", "back"}) ==
        Names{"leg 1", "leg 2", "seat frame", "backrest"});
  CHECK(IO::part_labels({"mesh1", "mesh2", "mesh3"}, {"h_stab", "h_stab", "v_stab"}) ==
        Names{"tailplane 1", "tailplane 2", "fin"}); // words for roles that are abbreviated
  // Pieces of an object with several roles, and of an object with one role
  CHECK(IO::part_labels({"midcentury", "midcentury#2", "arm", "arm#2"}, {"leg", "seat", "armrest", "armrest"}) ==
        Names{"leg", "seat", "arm 1", "arm 2"});
  // Foreign words, abbreviations, materials and words for the whole shape give way to roles; words for parts, and roles
  // that only other models have, do not
  CHECK(IO::part_labels({"chair_sop", "silla_pata.001", "SeatBack", "frontleg", "Chrome", "tentacles_L"},
                        {"leg", "leg", "back", "leg", "stretcher", "tentacle"}) ==
        Names{"leg 1", "leg 2", "SeatBack", "frontleg", "stretcher", "tentacles_L"});
  // A part whose role is not known keeps its name
  CHECK(IO::part_labels({"mesh17", "Object_4"}, {"", "leg"}) == Names{"mesh17", "leg"});
  CHECK(IO::part_labels({"leg", "Object_4"}, {"leg", "leg"}) == Names{"leg 1", "leg 2"});
}

TEST_CASE("Labels are short and all different")
{
  Names names{"leg 1",
              "leg",
              "leg#2",
              "",
              "",
              std::string(80, 'a'),
              std::string(79, 'a') + "b",
              "an_extremely_long_name_of_a_front_leg"};
  for (int i = 0; i < 30; ++i)
    names.push_back("sweethome3d_window_mirror_Plane.002#" + std::to_string(i));
  const Names labels = IO::part_labels(names);
  CHECK(std::set<std::string>(labels.begin(), labels.end()).size() == names.size());
  CHECK(labels[7] == "name_of_a_front_leg");
  CHECK(labels[8] == "window_mirror 1");
  for (const std::string& label : labels)
    CHECK(std::count_if(label.begin(), label.end(), [](unsigned char c) { return (c & 0xC0) != 0x80; }) <= 24);
}
