// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "base/limits.h"
#include "io/read/model_parts.h"
#include "io/read/text_words.h"

#include <CGAL/Shape_correspondence/Invalid_input.h>

#include <map>
#include <set>

namespace CGAL::Shape_correspondence::IO {
namespace {

/// Collects labels of faces by their texts.
class Label_collector
{
public:
  explicit Label_collector(std::size_t faces) { labels_.of_faces.reserve(faces); }

  int index_of(std::string_view text)
  {
    const auto [known, is_new] = known_.emplace(text, int(labels_.names.size()));
    double number = 0;
    if (is_new) labels_.names.push_back((parse(text, number) ? "label_" : "") + known->first);
    return known->second;
  }

  void add(std::string_view text) { labels_.of_faces.push_back(index_of(text)); }

  Face_labels& labels() { return labels_; }

private:
  std::map<std::string, int> known_;
  Face_labels labels_;
};

/// The lines of a list that are more than blanks and a comment.
std::vector<std::string_view> lines_of(std::string_view text)
{
  std::vector<std::string_view> result;
  while (!text.empty())
    if (const std::string_view line = trimmed(without_comment(next_line(text))); !line.empty()) result.push_back(line);
  return result;
}

std::vector<std::string_view> words_of(const std::vector<std::string_view>& lines)
{
  std::vector<std::string_view> result;
  for (std::string_view line : lines)
    for (std::string_view word = next_word(line); !word.empty(); word = next_word(line))
      result.push_back(word);
  return result;
}

/// Reads a list that has a line with a name, and then lines with the numbers of its faces, for each part.
/// \return whether it is such a list, of each face once
bool read_numbers_by_name(const std::vector<std::string_view>& lines, std::size_t faces, Label_collector& collector)
{
  std::vector<int>& labels = collector.labels().of_faces;
  labels.assign(faces, -1);
  int label = -1;
  std::size_t labelled = 0;
  for (std::string_view line : lines) {
    std::string_view rest = line;
    std::size_t number = 0;
    if (!parse(next_word(rest), number)) {
      label = collector.index_of(line);
      continue;
    }
    for (std::string_view word = next_word(line); !word.empty(); word = next_word(line)) {
      if (label < 0 || !parse(word, number) || number < 1 || number > faces || labels[number - 1] >= 0) return false;
      labels[number - 1] = label;
      ++labelled;
    }
  }
  return labelled == faces;
}

} // namespace

Face_labels read_face_labels(std::string_view text, const std::string& name, std::size_t number_of_faces)
{
  const std::vector<std::string_view> lines = lines_of(text), words = words_of(lines);
  Label_collector collector(number_of_faces);
  const bool has_lines = lines.size() == number_of_faces;
  if (has_lines || words.size() == number_of_faces)
    for (std::string_view label : has_lines ? lines : words)
      collector.add(label);
  else if (!read_numbers_by_name(lines, number_of_faces, collector))
    throw Invalid_input(name + ": it has " + std::to_string(words.size()) + " labels, but the model has " +
                        std::to_string(number_of_faces) +
                        " faces; a list has a label for each face, in the order of the model file, not for vertices, "
                        "edges or points");
  return std::move(collector.labels());
}

void divide_by_labels(const Face_labels& labels, Model_content& content)
{
  const std::size_t number = std::set<int>(labels.of_faces.begin(), labels.of_faces.end()).size();
  if (number > internal::most_parts)
    content.warnings.push_back("The labels of faces make no parts, since there are " +
                               internal::too_many_parts(number) + ".");
  if (number == 1 && content.parts.size() == 1) content.parts[0].name = labels.names[std::size_t(labels.of_faces[0])];
  if (number < 2 || number > internal::most_parts) return;
  std::vector<Model_part> parts(labels.names.size());
  for (const Model_part& part : content.parts) {
    std::map<int, std::vector<std::size_t>> triangles; // by label
    for (std::size_t t = 0; t < part.faces.size(); ++t)
      triangles[labels.of_faces[part.faces[t]]].push_back(t);
    for (const auto& [label, list] : triangles) {
      Model_part& of_label = parts[std::size_t(label)];
      add_looks(looks_of(part.appearance, list), list.size(), of_label.faces.size(), of_label.appearance);
      for (std::size_t t : list) {
        of_label.faces.push_back(part.faces[t]);
        of_label.corners.insert(of_label.corners.end(), &part.corners[3 * t], &part.corners[3 * t] + 3);
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
