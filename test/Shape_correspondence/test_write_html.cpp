// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "box_shapes.h"
#include "hand_made_graphs.h"
#include "page_documents.h"

#include <CGAL/Shape_correspondence/IO/correspondence_json.h>
#include <CGAL/Shape_correspondence/IO/structural_graph_json.h>
#include <CGAL/Shape_correspondence/IO/write_glb.h>
#include <CGAL/Shape_correspondence/IO/write_html.h>
#include <CGAL/Shape_correspondence/find_correspondence.h>

#include <catch2/catch.hpp>

#include <nlohmann/json.hpp>

#include <sstream>

using namespace CGAL::Shape_correspondence;
using namespace page_documents;
using nlohmann::json;

namespace {

template <typename Write>
std::string written(const Write& write)
{
  std::ostringstream out;
  write(out);
  return out.str();
}

std::string graph_page(const Structural_graph& graph)
{
  return written([&](std::ostream& out) { IO::write_structural_graph_html(out, graph); });
}

std::size_t count(const std::string& text, const std::string& what)
{
  std::size_t result = 0;
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1))
    ++result;
  return result;
}

} // namespace

// browser/test_pages.py tests in a browser that the pages work

TEST_CASE("A page needs no network, and allows no script but its own")
{
  const std::string page = graph_page(hand_made::chair());
  CHECK(page.find("<!DOCTYPE html>") == 0);
  CHECK(page.find("<script src=") == std::string::npos);
  CHECK(page.find("<link") == std::string::npos);
  CHECK(count(page, "<script>") == 1);
  CHECK(count(page, "default-src 'none'; style-src 'unsafe-inline'; script-src 'sha256-") == 1);
  for (const char* place : {"@HASH@", "@TITLE@", "@STYLE@", "@DOCUMENTS@", "@SCRIPT@"})
    CHECK(page.find(place) == std::string::npos);
  CHECK(page.find("Copyright (c) 2010-2019 three.js authors") != std::string::npos);
}

TEST_CASE("The page of a graph holds the same JSON and GLB as the files")
{
  const Structural_graph graph = hand_made::chair();
  const std::string page = graph_page(graph);
  CHECK(document_of(page, "graph") == written([&](std::ostream& out) { IO::write_structural_graph_json(out, graph); }));
  CHECK(from_base64(document_of(page, "graph.glb")) ==
        written([&](std::ostream& out) { IO::write_structural_graph_glb(out, graph); }));
}

TEST_CASE("Names and warnings cannot break out of the page")
{
  Structural_graph graph = hand_made::chair();
  const std::string evil = "</script><script>alert('\"&\")</script>@SCRIPT@";
  structure(graph).name = structure(graph).parts[0].name = evil;
  structure(graph).warnings = {evil};
  const std::string page = graph_page(graph);
  CHECK(page.find("<script>alert") == std::string::npos);
  CHECK(count(page, "<script>") == 1);
  const json document = json::parse(document_of(page, "graph"));
  CHECK(document["name"] == evil);
  CHECK(document["warnings"][0] == evil);
}

TEST_CASE("The page of a correspondence holds the same JSON and GLB as the files")
{
  const Structural_graph graph = hand_made::chair();
  const Correspondence correspondence = find_correspondence(graph, graph);
  const std::string page =
      written([&](std::ostream& out) { IO::write_correspondence_html(out, correspondence, graph, graph); });
  const std::string name = structure(graph).name;
  CHECK(document_of(page, "match") == written([&](std::ostream& out) {
          IO::write_correspondence_json(out, correspondence, graph, graph, name, name, {});
        }));
  CHECK(from_base64(document_of(page, "match.glb")) ==
        written([&](std::ostream& out) { IO::write_correspondence_glb(out, correspondence, graph, graph); }));
}

TEST_CASE("Large surfaces are simplified, so that a page stays small")
{
  const Structural_graph graph = hand_made::chair();
  Segmented_shape shape("chair");
  for (const Part_abstraction& part : structure(graph).parts)
    shape.add_part(part.name, box_shapes::box(Point::Zero(), Point::Ones(), 0, 60));
  const std::string page = written([&](std::ostream& out) {
    IO::write_correspondence_html(out, find_correspondence(graph, graph), graph, graph, &shape, &shape);
  });
  CHECK(page.size() < 8 << 20);
}
