// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "model_files.h"

#include <CGAL/Shape_correspondence/IO/read_part_labels.h>
#include <CGAL/Shape_correspondence/Invalid_input.h>

#include <catch2/catch.hpp>

#include <string>

using namespace CGAL::Shape_correspondence;

TEST_CASE("The labels of a shape, of a folder, and of all of data/ are read")
{
  const std::string data = SHAPE_CORRESPONDENCE_DATA_DIR;
  const auto stool = IO::read_part_labels(data + "/stool/labels.json");
  REQUIRE(stool.size() == 1);
  CHECK(stool[0].name == "stool");
  REQUIRE_FALSE(stool[0].parts.empty());
  CHECK(stool[0].labels.size() == stool[0].parts.size());
  for (std::size_t part = 0; part < stool[0].parts.size(); ++part)
    CHECK(stool[0].index(stool[0].parts[part]) == part);
  CHECK(stool[0].index("no such part") == stool[0].parts.size());
  CHECK(IO::read_part_labels(data + "/stool")[0].parts == stool[0].parts);
  const auto all = IO::read_part_labels(data);
  CHECK(all.size() == 14);
  for (std::size_t i = 1; i < all.size(); ++i)
    CHECK(all[i - 1].file < all[i].file);
}

TEST_CASE("Shapes without labels are refused with their names")
{
  CHECK_THROWS_AS(IO::read_part_labels("no/such/folder"), Invalid_input);
  CHECK_THROWS_WITH(IO::read_part_labels("no/such/folder"), Catch::Contains("no/such/folder"));
}
