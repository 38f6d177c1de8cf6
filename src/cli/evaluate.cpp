// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "cli/Command.h"
#include "cli/jobs.h"
#include "cli/run.h"
#include "io/system/input_file.h"
#include "io/write/Json.h"

#include <CGAL/Shape_correspondence/IO/correspondence_json.h>
#include <CGAL/Shape_correspondence/IO/read_part_labels.h>
#include <CGAL/Shape_correspondence/Invalid_input.h>
#include <CGAL/Shape_correspondence/evaluate_correspondence.h>

#include <algorithm>
#include <filesystem>
#include <iostream>

namespace CGAL::Shape_correspondence::cli {

namespace fs = std::filesystem;

namespace {

const char* const evaluate_help =
    R"(Usage: shape_correspondence evaluate RESULT... --ground-truth LABELS [options]

Scores the correspondences that `match --json` wrote against labelled parts: precision, recall and F1 of pairs of parts. It
prints means by category and over categories.

RESULT is a result of `match`, or a folder that is searched for results, with its subfolders. LABELS is a labels.json, or
a folder with SHAPE/labels.json or CATEGORY/SHAPE/labels.json. A result is assigned to its labelled shapes by the paths
of its source and target, such as CATEGORY/SHAPE/parts or SHAPE.obj.

Two parts correspond if their coarse labels are equal and, where every part of both shapes with that coarse label has a
fine label and the two sets of fine labels share at least half of the smaller one, their fine labels are equal, too. An
incomplete result counts as having no pairs.

Example: shape_correspondence match shapes/chair/a/parts shapes/chair/b/parts --json results/a--b.json
         shape_correspondence evaluate results --ground-truth shapes

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

/// The given files, and the results in given folders; other JSON files in folders are ignored.
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

/// The labelled shape named by the last component of the path that is the name of a labelled shape. Of several shapes
/// with this name, the one whose parent folders match the path.
const IO::Labelled_shape& shape_of(const std::string& path, const std::vector<IO::Labelled_shape>& shapes,
                                   const std::string& result_file)
{
  const auto complaint = [&](const std::string& what) {
    return Invalid_input(result_file + ": its shape '" + path + "' " + what);
  };
  const auto folder_above = [](const IO::Labelled_shape& shape) {
    return fs::absolute(shape.file).lexically_normal().parent_path().parent_path().filename();
  };
  for (fs::path rest = fs::path(path).lexically_normal(); rest.has_relative_path(); rest = rest.parent_path()) {
    std::vector<const IO::Labelled_shape*> named, in_this_folder;
    for (const IO::Labelled_shape& shape : shapes) {
      if (shape.name != rest.filename() && shape.name != rest.stem()) continue;
      named.push_back(&shape);
      if (folder_above(shape) == rest.parent_path().filename()) in_this_folder.push_back(&shape);
    }
    if (named.empty()) continue;
    if (named.size() > 1) named = in_this_folder;
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

IO::Json json_of(const Judged_result& r)
{
  IO::Json result = {{"file", r.file},           {"category", r.source->category},   {"source", r.source->name},
                     {"target", r.target->name}, {"precision", r.score.precision()}, {"recall", r.score.recall()},
                     {"f1", r.score.f1()}};
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

/// Scored results, and their means.
struct Judged
{
  std::vector<Judged_result> results;
  Evaluation means;

  Judged(const std::vector<Named_result>& named, const std::vector<IO::Labelled_shape>& shapes)
  {
    std::vector<Scored_correspondence> scores;
    for (const Named_result& result : named) {
      results.push_back(judge(result, shapes));
      const auto& judged = results.back();
      scores.push_back({judged.source->category, judged.source->file, judged.target->file, judged.score});
    }
    means = mean_scores(scores);
  }

  void write_json(std::ostream& out) const
  {
    const auto of_mean = [](IO::Json result, const Mean_score& score) {
      result["results"] = score.correspondences;
      result["precision"] = score.precision;
      result["recall"] = score.recall;
      result["f1"] = score.f1;
      return result;
    };
    const auto of_category = [&](const auto& mean) { return of_mean({{"category", mean.first}}, mean.second); };
    const auto of_result = [](const Judged_result& result) { return json_of(result); };
    const IO::Json document = {{"format", "shape_correspondence/evaluation"},
                               {"version", 2},
                               {"categories", mapped(means.categories, of_category)},
                               {"mean", of_mean({}, means.mean)},
                               {"results", mapped(results, of_result)}};
    document.write(out);
  }

  void print() const
  {
    std::vector<std::vector<std::string>> rows{{"category", "results", "precision", "recall", "F1"}};
    const auto add = [&](const std::string& name, const Mean_score& score) {
      rows.push_back({name, std::to_string(score.correspondences), decimals(score.precision), decimals(score.recall),
                      decimals(score.f1)});
    };
    for (const auto& [category, score] : means.categories)
      add(category, score);
    add("mean", means.mean);
    write_table(std::cout, rows);
  }
};

class Evaluate_command : public Command
{
public:
  Evaluate_command() : Command(evaluate_help, 1, any_number)
  {
    Option_table::Group add = table.group("Options of evaluate");
    add("ground-truth", "LABELS", &labels_, "labels of the parts; can be repeated").required();
    add("output,o", "FILE", output_by_ending({{".json", &common.json}}), "the same as --json");
    add("json", "FILE", &common.json,
        "write all scores as JSON, with the right, wrong and missed pairs of every result; - is standard output")
        .output();
    add_common_options(table, common);
  }

private:
  void work() override
  {
    const std::vector<IO::Labelled_shape> shapes = read_labels(labels_);
    const Judged judged(read_results(inputs), shapes);
    write_output(common.json, [&](std::ostream& out) { judged.write_json(out); });
    if (common.prints_table()) judged.print();
  }

  std::vector<std::string> labels_;
};

} // namespace

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
                           const std::vector<IO::Labelled_shape>& shapes)
{
  Judged(results, shapes).write_json(out);
}

std::unique_ptr<Command> evaluate_command() { return std::make_unique<Evaluate_command>(); }

} // namespace CGAL::Shape_correspondence::cli
