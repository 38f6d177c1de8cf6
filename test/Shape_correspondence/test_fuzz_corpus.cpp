// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

// Runs the seeds and findings of the fuzz targets in every build, and matches random structural graphs.

#include "fuzz/file_readers.h"
#include "io/read/model_parts.h"
#include "model_files.h"
#include "random_graph.h"

#include <CGAL/Shape_correspondence/IO/structural_graph_json.h>
#include <CGAL/Shape_correspondence/find_correspondence.h>

#include <catch2/catch.hpp>

#include <functional>
#include <map>

using namespace CGAL::Shape_correspondence;
using namespace model_files;

TEST_CASE("Every file of the corpus is read or refused")
{
  const fs::path tests = fs::path(SHAPE_CORRESPONDENCE_DATA_DIR).parent_path() / "test" / "Shape_correspondence";
  const fs::path corpus = tests / "fuzz" / "corpus";
  using Reader = std::function<void(const std::string&)>;
  const auto model = [](auto reader) -> Reader { return [reader](const std::string& text) { reader(text, "input"); }; };
  const std::map<std::string, Reader> readers = {
      {"obj", model(IO::read_obj_parts)},
      {"off", model(IO::read_off_part)},
      {"ply", model(IO::read_ply_part)},
      {"stl", model(IO::read_stl_parts)},
      {"gltf", [](const std::string& text) { IO::read_gltf_parts(text, "input"); }},
      {"labels", file_readers::labels},
      {"result", file_readers::result},
      {"pieces", file_readers::pieces},
      {"roles", file_readers::roles},
      {"image", file_readers::image},
      {"features", file_readers::features},
      {"graph_json", [](const std::string& text) {
         std::istringstream in(text);
         std::stringstream again;
         IO::write_structural_graph_json(again, IO::read_structural_graph_json(in, "input"));
         IO::read_structural_graph_json(again, "again");
       }}};
  for (const fs::directory_entry& folder : fs::directory_iterator(corpus)) {
    INFO(folder.path());
    CHECK((readers.count(folder.path().filename().string()) == 1 || folder.path().filename() == "match"));
  }
  for (const auto& [folder, reader] : readers) {
    std::size_t good = 0;
    bool are_images_known = true;
    for (const auto& entry : fs::directory_iterator(corpus / folder)) {
      INFO(entry.path());
      const std::string text = text_of(entry.path().string());
      const std::string message = complaint([&, &read = reader] { read(text); });
      good += message.empty();
      are_images_known = are_images_known && message.find("built without libpng") == std::string::npos;
    }
    INFO(folder);
    CHECK((good > 0 || !are_images_known));
  }
}

TEST_CASE("A match of random graphs is an error that says why, or pairs of parts and numbers")
{
  std::size_t matched = 0;
  for (unsigned seed = 0; seed < 300; ++seed) {
    CAPTURE(seed);
    std::mt19937 random(seed);
    const std::string message = complaint([&] {
      const Structural_graph source = random_graph::graph(random, 12), target = random_graph::graph(random, 12);
      const Correspondence found = find_correspondence(source, target);
      for (const Part_correspondence& pair : found.pairs)
        REQUIRE((pair.source < structure(source).parts.size() && pair.target < structure(target).parts.size()));
      CHECK(std::isfinite(found.energy));
      ++matched;
    });
    CHECK((message.empty() || message.size() > 20));
  }
  CHECK(matched > 200);
}
