// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "io/write/part_labels.h"

#include <algorithm>
#include <cctype>
#include <map>
#include <set>

namespace CGAL::Shape_correspondence::IO {
namespace {

constexpr double common_share = .75;      // share of the names from which on a common prefix is dropped
constexpr std::size_t longest_number = 6; // in digits

bool is_separator(char c) { return c == '_' || c == '-' || c == '.' || c == ' ' || c == ':'; }

bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// A name divided into components; `material` and `number` start with their separators, or are empty.
struct Divided_name
{
  std::string object, material, number;
};

Divided_name divided(const std::string& name)
{
  Divided_name result;
  const std::size_t hash = std::min(name.rfind('#'), name.size());
  const std::string stem = name.substr(0, hash);
  result.number = name.substr(hash);
  for (std::size_t length = stem.size() / 2; length >= 2; --length)
    if (is_separator(stem[length]) && stem.compare(length + 1, length, stem, 0, length) == 0 &&
        (stem.size() == 2 * length + 1 || is_separator(stem[2 * length + 1]))) {
      result.object = stem.substr(0, length);
      result.material = stem.substr(2 * length + 1);
      return result;
    }
  result.object = stem;
  return result;
}

/// The longest prefix, up to a separator, of most names; empty if there is none.
std::string common_prefix(const std::vector<std::string>& names)
{
  std::map<std::string, std::size_t> counts;
  for (const std::string& name : names)
    for (std::size_t i = 1; i + 1 < name.size(); ++i)
      if (is_separator(name[i]) && std::isalpha(static_cast<unsigned char>(name[i + 1])))
        ++counts[name.substr(0, i + 1)];
  std::string result;
  for (const auto& [prefix, count] : counts)
    if (count > 1 && double(count) >= common_share * double(names.size()) && prefix.size() > result.size())
      result = prefix;
  return result;
}

/// A label without the prefix, which is also removed from the material.
std::string without_prefix(std::string label, const std::string& prefix)
{
  for (std::size_t at = 0; !prefix.empty() && (at = label.find(prefix, at)) != std::string::npos;)
    if ((at == 0 || is_separator(label[at - 1])) && label.size() > prefix.size())
      label.erase(at, prefix.size());
    else
      ++at;
  return label;
}

/// A label divided into the text before its number and the digits; without a number, no digits.
std::pair<std::string, std::string> numbered(const std::string& label)
{
  std::size_t begin = label.size();
  while (begin > 0 && is_digit(label[begin - 1]))
    --begin;
  if (label.size() - begin > longest_number) return {label, ""};
  return {label.substr(0, begin), label.substr(begin)};
}

/// Whether the number of `next` follows that of `label`.
bool follows(const std::string& next, const std::string& label)
{
  const auto [stem, digits] = numbered(label);
  const auto [next_stem, next_digits] = numbered(next);
  return stem == next_stem && !digits.empty() && !next_digits.empty() &&
         std::stoi(next_digits) == std::stoi(digits) + 1;
}

} // namespace

std::vector<std::string> part_labels(const std::vector<std::string>& names)
{
  std::vector<Divided_name> pieces;
  std::map<std::string, std::set<std::string>> materials;
  for (const std::string& name : names) {
    pieces.push_back(divided(name));
    materials[pieces.back().object].insert(pieces.back().material);
  }
  std::vector<std::string> result;
  for (const Divided_name& name : pieces)
    result.push_back(name.object + (materials[name.object].size() > 1 ? name.material : "") + name.number);
  const std::string prefix = common_prefix(result);
  for (std::string& label : result)
    label = without_prefix(label, prefix);
  return std::set<std::string>(result.begin(), result.end()).size() == result.size() ? result : names;
}

std::vector<std::string> with_ranges(const std::vector<std::string>& labels)
{
  std::vector<std::string> result;
  for (std::size_t begin = 0, end; begin < labels.size(); begin = end) {
    end = begin + 1;
    while (end < labels.size() && follows(labels[end], labels[end - 1]))
      ++end;
    if (end - begin < 3)
      result.insert(result.end(), labels.begin() + std::ptrdiff_t(begin), labels.begin() + std::ptrdiff_t(end));
    else
      result.push_back(labels[begin] + "–" + numbered(labels[end - 1]).second);
  }
  return result;
}

} // namespace CGAL::Shape_correspondence::IO
