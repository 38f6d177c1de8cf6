// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

// Makes other libraries fail, in each command, where they are called with a surface: the result must report the
// replacement, or an error must name the file.

#include "base/library_call.h"
#include "cli/Command.h"
#include "model_files.h"

#include <CGAL/Shape_correspondence/Invalid_input.h>

#include <catch2/catch.hpp>

#include <iostream>
#include <sstream>

using namespace CGAL::Shape_correspondence;
using namespace model_files;
using Catch::Matchers::Contains;
using internal::failing_library_call;

namespace {

/// Makes the library calls of this name fail during its lifetime.
struct Failing_calls
{
  explicit Failing_calls(const std::string& name) { failing_library_call = name; }
  ~Failing_calls() { failing_library_call.clear(); }
};

/// Captures the output to a stream during its lifetime.
class Captured
{
public:
  explicit Captured(std::ostream& stream) : stream_(stream), before_(stream.rdbuf(text_.rdbuf())) {}
  ~Captured() { stream_.rdbuf(before_); }
  std::string text() const { return text_.str(); }

private:
  std::ostream& stream_;
  std::ostringstream text_;
  std::streambuf* before_;
};

/// The output of a command, or its error. Exceptions that the program does not report fail the test.
std::string outcome(const std::string& command, const std::vector<std::string>& arguments)
{
  const Captured out(std::cout), notes(std::cerr);
  try {
    cli::command_of(command)->run(arguments);
  } catch (const Invalid_input& error) {
    return error.what();
  }
  return out.text() + notes.text();
}

/// A box as OBJ polygons, whose four edges along x are split at their midpoints.
std::string box_text(const Point& low, const Point& high, int first)
{
  std::ostringstream text;
  for (const double share : {0., 0.5, 1.})
    for (int i = 0; i < 4; ++i)
      text << "v " << low.x() + share * (high.x() - low.x()) << ' ' << (i & 1 ? high : low).y() << ' '
           << (i & 2 ? high : low).z() << '\n';
  for (const std::vector<int>& face : std::vector<std::vector<int>>{{0, 2, 3, 1},
                                                                    {9, 11, 10, 8},
                                                                    {0, 4, 8, 10, 6, 2},
                                                                    {2, 6, 10, 11, 7, 3},
                                                                    {3, 7, 11, 9, 5, 1},
                                                                    {1, 5, 9, 8, 4, 0}}) {
    text << 'f';
    for (int corner : face)
      text << ' ' << corner + first;
    text << '\n';
  }
  return text.str();
}

std::string table_text()
{
  std::string text = "o top\n" + box_text({-1, 0.9, -1}, {1, 1, 1}, 1);
  for (int i = 0; i < 4; ++i) {
    const Point low(i & 1 ? 0.8 : -1, 0, i & 2 ? 0.8 : -1);
    text += "o leg_" + std::to_string(i) + '\n' + box_text(low, low + Point(0.2, 0.9, 0.2), 12 * (i + 1) + 1);
  }
  return text;
}

} // namespace

TEST_CASE("A box with corners on its edges, whose polygons give flat triangles, is one part")
{
  const Temporary_folder folder;
  const std::string box = folder.write("box.obj", "o box\n" + box_text({0, 0, 0}, {1, 2, 3}, 1));
  CHECK_THAT(outcome("parts", {box}), Contains("1 part"));
  for (const char* command : {"graph", "label"})
    CHECK_THAT(outcome(command, {box}), Contains("only one part"));
}

TEST_CASE("Where CGAL fails, the fallback is reported")
{
  const Temporary_folder folder;
  const std::string table = folder.write("table.obj", table_text());
  SECTION("repair of a surface")
  {
    const Failing_calls failing("repair");
    CHECK_THAT(outcome("graph", {table, "-v"}), Contains("bounding box"));
  }
  SECTION("mean curvature flow")
  {
    const Failing_calls failing("flow");
    CHECK_THAT(outcome("graph", {table, "-v", "--abstraction", "flow"}), Contains("bounding box"));
  }
  SECTION("a convex hull")
  {
    const Failing_calls failing("convex hull");
    CHECK_THAT(outcome("graph", {table, "-v"}), Contains("its convex hull could not be computed"));
  }
  SECTION("segmentation of a piece")
  {
    for (const char* call : {"components", "segments"}) {
      const Failing_calls failing(call);
      CHECK_THAT(outcome("parts", {table, "-v", "--parts", "segments"}), Contains("were not divided into segments"));
    }
  }
}

TEST_CASE("If a library fails, commands end with a result or with an error that names the file")
{
  const Temporary_folder folder;
  const std::string a = folder.write("a.obj", table_text()), b = folder.write("b.obj", table_text());
  fs::create_directory(folder.path("set"));
  for (const char* name : {"set/a.obj", "set/b.obj", "set/c.obj"})
    folder.write(name, table_text());
  const std::vector<std::vector<std::string>> commands = {
      {"parts", a, "--parts", "segments"},
      {"graph", a, "--html", folder.path("graph.html")},
      {"graph", a, "--abstraction", "flow"},
      {"label", a},
      {"match", a, b, "--html", folder.path("match.html")},
      {"match", a, b, "--paper"},
      {"blend", a, b, "-o", folder.path("blend.glb")},
      {"blend", a, b, "-o", folder.path("solid.obj"), "--at", "0.5", "--solid"},
      {"transfer", a, b, "-o", folder.path("transfer.ply"), "--labels", a},
      {"collection", folder.path("set"), "--skip-bad"}};
  for (const char* call : {"repair", "flow", "convex hull", "components", "segments", "simplification", "section",
                           "flat face", "wrap of a blend", "reading"}) {
    const Failing_calls failing(call);
    for (const std::vector<std::string>& words : commands) {
      CAPTURE(call, words[0]);
      CHECK_NOTHROW(outcome(words[0], {words.begin() + 1, words.end()}));
    }
  }
}

TEST_CASE("Without flat faces a surface keeps its triangles, and a blend without a wrap says what to do")
{
  const Temporary_folder folder;
  const std::string table = folder.write("table.obj", table_text());
  {
    const Failing_calls failing("flat face");
    CHECK_THAT(outcome("graph", {table}), Contains("leg_0") && !Contains("failed"));
  }
  const Failing_calls failing("wrap of a blend");
  CHECK_THAT(outcome("blend", {table, table, "-o", folder.path("solid.obj"), "--at", "0.5", "--solid"}),
             Contains("no closed surface around it; repair"));
}

TEST_CASE("A failure where a model is read is an error that names the file")
{
  const Temporary_folder folder;
  const std::string table = folder.write("table.obj", table_text());
  const Failing_calls failing("reading");
  for (const char* command : {"parts", "graph", "label"})
    CHECK_THAT(outcome(command, {table}),
               Contains("table.obj: a computation on its surface failed") && Contains("repair"));
}
