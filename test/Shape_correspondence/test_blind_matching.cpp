// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "generated_shapes.h"
#include "generator/benchmark/random.h"
#include "generator/models.h"
#include "generator/writer.h"
#include "program.h"

#include <CGAL/Shape_correspondence/IO/correspondence_json.h>
#include <CGAL/Shape_correspondence/build_structural_graph.h>
#include <CGAL/Shape_correspondence/find_correspondence.h>

#include <catch2/catch.hpp>

#include <map>
#include <set>

// The matcher sees nothing but geometry: no labels, no names of parts or shapes, no order of files, no category.

using namespace CGAL::Shape_correspondence;
namespace gen = CGAL::Shape_correspondence::generator;
using model_files::Temporary_folder;

namespace {

using Named_pairs = std::map<std::pair<std::string, std::string>, double>; // the confidences of pairs

gen::Assembly made(const std::string& name)
{
  for (const gen::Model& model : gen::models())
    if (model.name == name) return model.make();
  throw std::logic_error(name);
}

/// The same parts with other names and labels, in another order.
gen::Assembly disguised(const gen::Assembly& shape, std::uint64_t seed, std::map<std::string, std::string>& real_names)
{
  gen::Random random(seed);
  gen::Assembly result("x" + std::to_string(seed), "thing");
  std::vector<gen::Part> parts = shape.parts;
  for (std::size_t i = parts.size(); i > 1; --i)
    std::swap(parts[i - 1], parts[random.below(i)]);
  for (gen::Part& part : parts) {
    const std::string name = "p" + std::to_string(1000 + real_names.size());
    real_names[name] = part.name;
    part.name = name;
    part.label = {"part", ""};
  }
  result.parts = parts;
  return result;
}

Named_pairs named(const Correspondence& c, const Structural_graph& source, const Structural_graph& target)
{
  Named_pairs result;
  for (const Part_correspondence& pair : c.pairs)
    result[{structure(source).parts[pair.source].name, structure(target).parts[pair.target].name}] =
        pair.has_confidence() ? pair.confidence : 1;
  return result;
}

Named_pairs with_real_names(const Named_pairs& pairs, const std::map<std::string, std::string>& source,
                            const std::map<std::string, std::string>& target)
{
  Named_pairs result;
  for (const auto& [pair, confidence] : pairs)
    result[{source.at(pair.first), target.at(pair.second)}] = confidence;
  return result;
}

void write_folder(const Temporary_folder& folder, const std::string& name, const gen::Assembly& shape)
{
  for (const gen::Part& part : shape.parts)
    folder.write(name + "/" + gen::part_file(part), gen::obj_text(part));
}

/// Checks that pairs are the same. The first of several congruent parts is abstracted, and the others are copies, so
/// that numbers may change slightly with the order.
void check_same(const Named_pairs& a, const Named_pairs& b)
{
  for (const auto& [pair, confidence] : a) {
    INFO(pair.first << " - " << pair.second);
    const auto found = b.find(pair);
    REQUIRE(found != b.end());
    CHECK(found->second == Approx(confidence).margin(.02));
  }
  CHECK(a.size() == b.size());
}

} // namespace

TEST_CASE("Renamed and shuffled parts match as before, by every method")
{
  const gen::Assembly source_shape = made("chair_slatted"), target_shape = made("chair_spindle");
  const Structural_graph source = build_structural_graph(generated_shapes::shape_of(source_shape)),
                         target = build_structural_graph(generated_shapes::shape_of(target_shape));
  for (std::uint64_t seed : {1, 2}) {
    std::map<std::string, std::string> source_names, target_names;
    const Structural_graph other_source = build_structural_graph(
                               generated_shapes::shape_of(disguised(source_shape, seed, source_names))),
                           other_target = build_structural_graph(
                               generated_shapes::shape_of(disguised(target_shape, seed + 10, target_names)));
    for (const Search_method method : {Search_method::PARTS, Search_method::BEAM, Search_method::EXACT}) {
      Search_options options;
      options.method = method;
      const Correspondence c = find_correspondence(source, target, options),
                           other = find_correspondence(other_source, other_target, options);
      INFO("seed " << seed << ", method " << int(method));
      CHECK(c.energy == Approx(other.energy).epsilon(1e-3));
      check_same(with_real_names(named(other, other_source, other_target), source_names, target_names),
                 named(c, source, target));
    }
  }
}

TEST_CASE("The program finds the same pairs whatever files are called, and beside wrong labels")
{
  const Temporary_folder folder;
  const gen::Assembly source = made("chair_spindle"), target = made("chair_slatted");
  std::map<std::string, std::string> source_names, target_names;
  const gen::Assembly other_source = disguised(source, 3, source_names),
                      other_target = disguised(target, 4, target_names);
  write_folder(folder, "table/a", source);
  write_folder(folder, "table/b", target);
  write_folder(folder, "thing/q", other_source);
  write_folder(folder, "thing/c", other_target);
  folder.write("thing/q/labels.json", gen::labels_text(other_source));
  folder.write("thing/c/labels.json", gen::labels_text(other_target));
  const auto match = [&](const std::string& a, const std::string& b) {
    const std::string file = folder.path("r.json");
    REQUIRE(run("match " + quoted(folder.path(a)) + " " + quoted(folder.path(b)) + " --quiet --json " + quoted(file))
                .status == 0);
    Named_pairs pairs;
    const IO::Named_correspondence result = IO::read_correspondence_json(file);
    for (const IO::Named_part_correspondence& pair : result.pairs)
      pairs[{pair.source, pair.target}] = pair.confidence;
    return pairs;
  };
  const Named_pairs pairs = match("table/a/parts", "table/b/parts");
  CHECK(pairs.size() >= 4);
  check_same(with_real_names(match("thing/q/parts", "thing/c/parts"), source_names, target_names), pairs);
}
