// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "cli/evaluate.h"
#include "cli/Command.h"
#include "cli/run.h"
#include "cli/text.h"
#include "io/system/input_file.h"

#include <CGAL/Shape_correspondence/IO/correspondence_json.h>
#include <CGAL/Shape_correspondence/IO/read_part_labels.h>
#include <CGAL/Shape_correspondence/Invalid_input.h>
#include <CGAL/Shape_correspondence/evaluate_correspondence.h>

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <map>
#include <numeric>

namespace CGAL::Shape_correspondence::cli {

namespace fs = std::filesystem;

namespace {

constexpr int most_resamples = 1'000'000; // all are kept

const char* const evaluate_help =
    R"(Usage: shape_correspondence evaluate RESULT... --ground-truth LABELS [options]

Scores the correspondences that `match --json` wrote against labelled parts: precision, recall, F1, and coarse precision
(the share of pairs with equal coarse labels). It prints means by category and over categories, with confidence
intervals from a bootstrap over shapes.

RESULT is a result of `match`, or a folder that is searched for results, with its subfolders. LABELS is a labels.json, or
a folder with SHAPE/labels.json or CATEGORY/SHAPE/labels.json. A result is assigned to its labelled shapes by the paths
of its source and target, such as CATEGORY/SHAPE/parts or SHAPE.obj.

Two parts correspond if their coarse labels are equal and, where every part of both shapes with that coarse label has a
fine label and the two sets of fine labels share at least half of the smaller one, their fine labels are equal, too. An
incomplete result counts as having no pairs.

Example: shape_correspondence match shapes/chair/a/parts shapes/chair/b/parts --json results/a--b.json
         shape_correspondence evaluate results --ground-truth shapes --worst 5

)";

/// A result file with its score.
struct Judged_result
{
  std::string file;
  const IO::Labelled_shape *source, *target;
  Part_pairs pairs;
  Ground_truth truth;
  Correspondence_score score;
};

/// The files themselves, and the results in folders; other JSON files in folders are ignored.
std::vector<std::string> result_files(const std::vector<std::string>& inputs)
{
  std::vector<std::string> files;
  for (const std::string& input : inputs) {
    if (!fs::is_directory(input)) {
      files.push_back(input);
      continue;
    }
    const std::size_t before = files.size();
    for (const std::string& file : IO::files_under(input))
      if (fs::path(file).extension() == ".json" && IO::is_correspondence_json(file)) files.push_back(file);
    if (files.size() == before)
      throw Invalid_input(input +
                          ": there is no result of `match --json` in this folder; give the folder that has them");
  }
  return files;
}

/// The one shape that is named like the component of the path nearest to its end that names any; among shapes of one
/// name, the one whose folder is in a folder of the same name.
const IO::Labelled_shape& shape_of(const std::string& path, const std::vector<IO::Labelled_shape>& shapes,
                                   const std::string& result_file)
{
  const auto complaint = [&](const std::string& what) {
    return Invalid_input(result_file + ": its shape '" + path + "' " + what);
  };
  for (fs::path rest = fs::path(path).lexically_normal(); rest.has_relative_path(); rest = rest.parent_path()) {
    std::vector<const IO::Labelled_shape*> named;
    for (const IO::Labelled_shape& shape : shapes)
      if (shape.name == rest.filename() || shape.name == rest.stem()) named.push_back(&shape);
    if (named.empty()) continue;
    if (named.size() > 1) {
      const fs::path around = rest.parent_path().filename();
      named.erase(std::remove_if(named.begin(), named.end(),
                                 [&](const IO::Labelled_shape* shape) {
                                   const fs::path folder = fs::absolute(shape->file).lexically_normal().parent_path();
                                   return folder.parent_path().filename() != around;
                                 }),
                  named.end());
    }
    if (named.size() != 1) throw complaint("has the name of several labelled shapes; give the labels of one of them");
    return *named[0];
  }
  throw complaint("has no labels among those given; give them, in a folder of its name");
}

std::size_t part_index(const std::string& part, const IO::Labelled_shape& shape, const std::string& result_file)
{
  const std::size_t index = shape.index(part);
  if (index == shape.parts.size())
    throw Invalid_input(result_file + ": its part '" + part + "' is not in " + shape.file +
                        "; give the labels of these parts");
  return index;
}

Judged_result judge(const Named_result& judged, const std::vector<IO::Labelled_shape>& shapes)
{
  const auto& [file, named] = judged;
  Judged_result result;
  result.file = file;
  result.source = &shape_of(named.source, shapes, file);
  result.target = &shape_of(named.target, shapes, file);
  if (result.source->category != result.target->category)
    throw Invalid_input(file + ": its source is of category '" + result.source->category + "', its target of '" +
                        result.target->category + "', whose labels cannot be compared; leave this result out");
  for (const IO::Named_part_correspondence& pair : named.pairs)
    result.pairs.emplace_back(part_index(pair.source, *result.source, file),
                              part_index(pair.target, *result.target, file));
  if (!named.complete) result.pairs.clear();
  result.truth = ground_truth(result.source->labels, result.target->labels);
  result.score = evaluate_correspondence(result.pairs, result.truth);
  return result;
}

/// All results; each pair of shapes may have one.
std::vector<Judged_result> judge(const std::vector<Named_result>& named, const std::vector<IO::Labelled_shape>& shapes)
{
  std::vector<Judged_result> results;
  std::map<std::pair<const IO::Labelled_shape*, const IO::Labelled_shape*>, std::string> first;
  for (const Named_result& result : named) {
    results.push_back(judge(result, shapes));
    const auto [entry, is_new] = first.emplace(std::pair(results.back().source, results.back().target), result.file);
    if (!is_new)
      throw Invalid_input(result.file + ": it is of the same two shapes as " + entry->second +
                          "; evaluate the results of one method at a time");
  }
  return results;
}

Evaluation mean_scores(const std::vector<Judged_result>& results, const Evaluation_options& options)
{
  const auto scored = [](const Judged_result& r) {
    return Scored_correspondence{r.source->category, r.source->file, r.target->file, r.score};
  };
  return Shape_correspondence::mean_scores(mapped(results, scored), options);
}

/// A mean with its interval; of a single result, without.
std::string text_of(const Estimate& e, std::size_t results)
{
  return decimals(e.mean) + (results > 1 ? " [" + decimals(e.low) + ", " + decimals(e.high) + "]" : "");
}

std::vector<std::string> row(const std::string& name, const Mean_score& score)
{
  return {name,
          std::to_string(score.correspondences),
          text_of(score.precision, score.correspondences),
          text_of(score.recall, score.correspondences),
          text_of(score.f1, score.correspondences),
          text_of(score.coarse_precision, score.correspondences),
          std::to_string(score.empty)};
}

void print(const Evaluation& evaluation, const std::vector<Judged_result>& results, std::size_t worst)
{
  std::vector<std::vector<std::string>> rows{
      {"category", "results", "precision", "recall", "F1", "coarse precision", "empty"}};
  for (const auto& [category, score] : evaluation.categories)
    rows.push_back(row(category, score));
  rows.push_back(row("mean", evaluation.mean));
  write_table(std::cout, rows);
  worst = std::min(worst, results.size());
  if (worst == 0) return;
  std::vector<std::size_t> order(results.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return results[a].score.f1() < results[b].score.f1(); });
  std::cout << '\n';
  rows = {{"worst", "source", "target", "precision", "recall", "F1"}};
  for (std::size_t i = 0; i < worst; ++i) {
    const Judged_result& r = results[order[i]];
    rows.push_back({r.source->category, r.source->name, r.target->name, decimals(r.score.precision()),
                    decimals(r.score.recall()), decimals(r.score.f1())});
  }
  write_table(std::cout, rows);
}

IO::Json json_of(const std::string& category, const Mean_score& score)
{
  IO::Json result;
  if (!category.empty()) result["category"] = category;
  result["results"] = score.correspondences;
  result["empty"] = score.empty;
  result["precision"] = estimate_json(score.precision);
  result["recall"] = estimate_json(score.recall);
  result["f1"] = estimate_json(score.f1);
  result["coarse_precision"] = estimate_json(score.coarse_precision);
  return result;
}

IO::Json json_of(const Judged_result& r)
{
  IO::Json result = {{"file", r.file},
                     {"category", r.source->category},
                     {"source", r.source->name},
                     {"target", r.target->name},
                     {"precision", r.score.precision()},
                     {"recall", r.score.recall()},
                     {"f1", r.score.f1()},
                     {"coarse_precision", r.score.coarse_precision()}};
  const auto contains = [](const Part_pairs& pairs, const auto& pair) {
    return std::find(pairs.begin(), pairs.end(), pair) != pairs.end();
  };
  const auto names = [&](const auto& pair) {
    return IO::Json{r.source->parts[pair.first], r.target->parts[pair.second]};
  };
  for (const char* key : {"right", "wrong", "missed"})
    result[key] = IO::Json::array();
  for (const auto& pair : r.pairs)
    result[contains(r.truth.pairs, pair) ? "right" : "wrong"].push_back(names(pair));
  for (const auto& pair : r.truth.pairs)
    if (!contains(r.pairs, pair)) result["missed"].push_back(names(pair));
  return result;
}

void write_evaluation_json(std::ostream& out, const Evaluation& evaluation, const std::vector<Judged_result>& results)
{
  const auto of_category = [](const auto& category) { return json_of(category.first, category.second); };
  const auto of_result = [](const Judged_result& result) { return json_of(result); };
  const IO::Json document = {{"format", "shape_correspondence/evaluation"},
                             {"version", 1},
                             {"categories", mapped(evaluation.categories, of_category)},
                             {"mean", json_of("", evaluation.mean)},
                             {"results", mapped(results, of_result)}};
  document.write(out);
}

} // namespace

IO::Json estimate_json(const Estimate& e) { return {{"mean", e.mean}, {"low", e.low}, {"high", e.high}}; }

std::vector<IO::Labelled_shape> read_labels(const std::vector<std::string>& paths)
{
  std::vector<IO::Labelled_shape> shapes;
  for (const std::string& path : paths)
    append(shapes, IO::read_part_labels(path));
  return shapes;
}

std::vector<Named_result> read_results(const std::vector<std::string>& inputs)
{
  return mapped(result_files(inputs), [](const std::string& file) {
    return Named_result{file, IO::read_correspondence_json(file)};
  });
}

void write_evaluation_json(std::ostream& out, const std::vector<Named_result>& results,
                           const std::vector<IO::Labelled_shape>& shapes, const Evaluation_options& options)
{
  const std::vector<Judged_result> judged = judge(results, shapes);
  write_evaluation_json(out, mean_scores(judged, options), judged);
}

void add_evaluate_options(Option_table& table, Evaluate_options& options, Common_options& common)
{
  Option_table::Group add = table.group("Options of evaluate");
  add("ground-truth", "LABELS", &options.labels, "labels of the parts; can be repeated").required();
  add("output,o", "FILE", output_by_ending({{".json", &common.json}}), "the same as --json");
  add("json", "FILE", &common.json,
      "write all scores as JSON, with the right, wrong and missed pairs of every result; - is standard output")
      .output();
  add("worst", "N", &options.worst, "also list the N results of lowest F1");
  add("resamples", "N", &options.evaluation.resamples, "bootstrap samples for the confidence intervals")
      .between(1, most_resamples)
      .in_python();
  add("confidence", "P", &options.evaluation.confidence, "confidence level of the intervals, between 0 and 1")
      .strictly_between(0, 1)
      .in_python();
}

namespace {

class Evaluate_command : public Command
{
public:
  Evaluate_command() : Command(evaluate_help, 1, any_number)
  {
    add_evaluate_options(table, options_, common);
    add_common_options(table, common);
  }

private:
  void work() override
  {
    options_.evaluation.seed = std::uint64_t(common.seed);
    const std::vector<IO::Labelled_shape> shapes = read_labels(options_.labels);
    const std::vector<Judged_result> results = judge(read_results(inputs), shapes);
    const Evaluation evaluation = mean_scores(results, options_.evaluation);
    write_output(common.json, [&](std::ostream& out) { write_evaluation_json(out, evaluation, results); });
    if (common.prints_table()) print(evaluation, results, options_.worst);
  }

  Evaluate_options options_;
};

} // namespace

std::unique_ptr<Command> evaluate_command() { return std::make_unique<Evaluate_command>(); }

} // namespace CGAL::Shape_correspondence::cli
