// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "base/limits.h"
#include "io/read/model_parts.h"
#include "io/read/text_words.h"
#include "io/system/quoting.h"

#include <CGAL/Shape_correspondence/Invalid_input.h>

#include <algorithm>
#include <map>
#include <set>
#include <utility>

namespace CGAL::Shape_correspondence::IO {
namespace {

struct Line
{
  std::size_t number;
  std::string_view text;
};

/// Reads a list of labels; errors name the list, the line, and what to write.
class Label_list
{
public:
  Label_list(std::string_view text, const std::string& name, std::size_t faces) : name_(name), faces_(faces)
  {
    for (std::size_t number = 1; !text.empty(); ++number) {
      const std::string_view line = trimmed(next_line(text));
      if (begins_with(line, "#"))
        read_comment(line.substr(1));
      else if (const std::string_view label = trimmed(without_comment(line)); !label.empty())
        lines_.push_back({number, label});
    }
  }

  Face_labels read()
  {
    if (lines_.empty()) throw Invalid_input(name_ + ": it has no labels; " + wanted());
    if (!begins_with_number(lines_[0].text))
      read_names();
    else if (lines_.size() == 1)
      for (std::string_view rest = lines_[0].text; !trimmed(rest).empty();)
        add_number({lines_[0].number, next_word(rest)});
    else
      for (const Line& line : lines_)
        add_number(line);
    if (const std::size_t labels = labels_.of_faces.size(); labels != faces_)
      throw Invalid_input(name_ + ": it has " + std::to_string(labels) + " labels, but the model has " +
                          std::to_string(faces_) + " faces" + blank_line() + "; " + wanted());
    return std::move(labels_);
  }

private:
  std::string wanted() const
  {
    return "write one whole number for each of the model's " + std::to_string(faces_) +
           " faces, a line each, in the order of the model file";
  }

  [[noreturn]] void fail(const Line& line, const std::string& what) const
  {
    throw Invalid_input(name_ + ", line " + std::to_string(line.number) + ": " + what + "; " + wanted());
  }

  /// The end of an error message: the first blank line between labels, if any.
  std::string blank_line() const
  {
    for (std::size_t i = 1; i < lines_.size(); ++i)
      if (lines_[i].number != lines_[i - 1].number + 1)
        return ", and line " + std::to_string(lines_[i - 1].number + 1) + " has none";
    return "";
  }

  /// Reads a comment that the command `parts` writes after the labels: "faces of MODEL" or "part NUMBER NAME".
  void read_comment(std::string_view comment)
  {
    const std::string_view keyword = next_word(comment);
    if (keyword == "faces" && next_word(comment) == "of")
      labels_.model = percent_decoded(std::string(trimmed(comment)));
    if (keyword != "part") return;
    const std::string number(next_word(comment));
    names_.emplace(number, percent_decoded(std::string(trimmed(comment))));
  }

  static bool begins_with_number(std::string_view text)
  {
    double number = 0;
    return parse(next_word(text), number);
  }

  int index_of(const std::string& name)
  {
    const auto [known, is_new] = known_.emplace(name, int(labels_.names.size()));
    if (is_new) labels_.names.push_back(name);
    return known->second;
  }

  void add_number(const Line& line)
  {
    long long number = 0;
    const bool is_whole = parse(line.text, number) && std::to_string(number) == line.text;
    if (!is_whole) fail(line, cited(line.text) + " is not a whole number");
    const auto name = names_.find(std::string(line.text));
    labels_.of_faces.push_back(index_of(name == names_.end() ? "label_" + std::string(line.text) : name->second));
  }

  void read_names()
  {
    const bool are_names =
        std::none_of(lines_.begin(), lines_.end(), [](const Line& line) { return begins_with_number(line.text); });
    if (!are_names) return read_numbers_by_name();
    for (const Line& line : lines_)
      labels_.of_faces.push_back(index_of(std::string(line.text)));
  }

  void read_numbers_by_name()
  {
    std::vector<int> labels(faces_, -1);
    int label = -1;
    for (const Line& line : lines_) {
      if (!begins_with_number(line.text)) {
        label = index_of(std::string(line.text));
        continue;
      }
      std::string_view rest = line.text;
      for (std::string_view word = next_word(rest); !word.empty(); word = next_word(rest)) {
        std::size_t face = 0;
        if (!parse(word, face) || face < 1 || face > faces_) fail(line, cited(word) + " is not the number of a face");
        if (std::exchange(labels[face - 1], label) >= 0) fail(line, "face " + cited(word) + " has a label already");
      }
    }
    const auto missing = std::find(labels.begin(), labels.end(), -1);
    if (missing != labels.end())
      throw Invalid_input(name_ + ": face " + std::to_string(missing - labels.begin() + 1) + " of the model's " +
                          std::to_string(faces_) + " faces has no label; give each face one");
    labels_.of_faces = std::move(labels);
  }

  const std::string& name_;
  std::size_t faces_;
  std::vector<Line> lines_;
  std::map<std::string, std::string> names_; ///< names of parts, by number
  std::map<std::string, int> known_;         ///< index of a name in `Face_labels::names`
  Face_labels labels_;
};

} // namespace

Face_labels read_face_labels(std::string_view text, const std::string& name, std::size_t number_of_faces)
{
  return Label_list(text, name, number_of_faces).read();
}

void divide_by_labels(const Face_labels& labels, Model_content& content)
{
  const std::size_t number = std::set<int>(labels.of_faces.begin(), labels.of_faces.end()).size();
  if (number > internal::most_parts)
    content.warnings.push_back("The labels of faces make no parts, since there are " +
                               internal::too_many_parts(number) + ".");
  const std::string& only = labels.names[std::size_t(labels.of_faces[0])];
  if (number == 1 && content.parts.size() == 1) content.parts[0].name = only;
  if (number == 1 && content.parts.size() > 1)
    content.warnings.push_back("The labels of faces make no parts, since all faces have the label " + cited(only) +
                               ".");
  if (number < 2 || number > internal::most_parts) return;
  std::vector<Model_part> parts(labels.names.size());
  for (const Model_part& part : content.parts) {
    std::map<int, std::vector<std::size_t>> triangles; // indexed by label
    for (std::size_t t = 0; t < part.faces.size(); ++t)
      triangles[labels.of_faces[part.faces[t]]].push_back(t);
    for (const auto& [label, list] : triangles) {
      Model_part& of_label = parts[std::size_t(label)];
      add_appearance(appearance_of(part.appearance, list), list.size(), of_label.faces.size(), of_label.appearance);
      for (std::size_t t : list) {
        of_label.faces.push_back(part.faces[t]);
        of_label.corners.insert(of_label.corners.end(), &part.corners[3 * t], &part.corners[3 * t] + 3);
        if (!part.vertices.empty())
          of_label.vertices.insert(of_label.vertices.end(), &part.vertices[3 * t], &part.vertices[3 * t] + 3);
      }
    }
  }
  content.parts.clear();
  for (std::size_t i = 0; i < parts.size(); ++i) {
    parts[i].name = labels.names[i];
    if (!parts[i].faces.empty()) content.parts.push_back(std::move(parts[i]));
  }
  content.are_labelled = true;
}

} // namespace CGAL::Shape_correspondence::IO
