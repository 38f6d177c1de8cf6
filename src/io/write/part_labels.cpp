// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "io/write/part_labels.h"

#include <boost/algorithm/string/case_conv.hpp>

#include <algorithm>
#include <cctype>
#include <locale>
#include <map>
#include <set>

namespace CGAL::Shape_correspondence::IO {
namespace {

constexpr double common_share = .75;      // least share of names with a common prefix for it to be dropped
constexpr std::size_t longest_number = 6; // most digits at the end of a name that are read as a number
constexpr std::size_t longest_label = 24; // limit for the characters of a label

// Names that modelling programs give to parts, and those of the solids that modelling starts from
const std::set<std::string> meaningless = {
    "bezier",  "box",         "circle",  "component", "cone",      "cube",      "curve",   "cylinder",  "default",
    "element", "entity",      "geo",     "geom",      "geometry",  "group",     "grp",     "icosphere", "instance",
    "item",    "jpg",         "line",    "mat",       "material",  "mesh",      "model",   "node",      "nurbs",
    "obj",     "object",      "part",    "path",      "pcube",     "pcylinder", "piece",   "plane",     "png",
    "polygon", "polysurface", "pplane",  "psphere",   "rectangle", "root",      "scene",   "segment",   "shape",
    "solid",   "sphere",      "submesh", "surface",   "torus",     "unnamed",   "untitled"};

// English words for parts, without the plural's s; names without one are foreign, abbreviated, or of the whole shape
const std::set<std::string> words_for_parts = {
    "apron",      "arm",        "armrest",    "axle",     "back",       "backrest",  "band",      "bar",
    "base",       "basket",     "beam",       "bed",      "bedding",    "bell",      "belt",      "blade",
    "blanket",    "board",      "body",       "bolt",     "bonnet",     "bottom",    "bow",       "bowl",
    "box",        "brace",      "bracket",    "brake",    "branch",     "bulb",      "bumper",    "burner",
    "button",     "cabin",      "cabinet",    "cable",    "cage",       "canard",    "canopy",    "cap",
    "cargo",      "caster",     "castor",     "ceiling",  "chain",      "chassis",   "clamp",     "cockpit",
    "column",     "cornice",    "cowling",    "crank",    "crossbar",   "crown",     "cup",       "cushion",
    "dashboard",  "desk",       "disc",       "disk",     "divider",    "door",      "drawer",    "drivetrain",
    "elevator",   "engine",     "exhaust",    "fan",      "feet",       "fender",    "fin",       "flame",
    "flap",       "foot",       "footboard",  "footrest", "fork",       "frame",     "fuselage",  "gear",
    "globe",      "grille",     "grip",       "guard",    "handle",     "handlebar", "head",      "headboard",
    "headlight",  "headrest",   "hinge",      "hood",     "hook",       "hub",       "interior",  "jet",
    "joint",      "keyboard",   "knob",       "ladder",   "lantern",    "leave",     "leg",       "lens",
    "lever",      "lid",        "light",      "loop",     "mast",       "mattress",  "mirror",    "motor",
    "mount",      "mudguard",   "nacelle",    "neck",     "nose",       "nut",       "pad",       "pane",
    "panel",      "pedal",      "pedestal",   "pillow",   "pin",        "pipe",      "plate",     "platform",
    "plinth",     "plug",       "pole",       "post",     "propeller",  "rack",      "radiator",  "rail",
    "rib",        "rim",        "ring",       "rod",      "roof",       "rotor",     "rudder",    "rung",
    "saddle",     "screw",      "seat",       "seatpost", "shade",      "shaft",     "shelf",     "shell",
    "shelve",     "sill",       "sink",       "slat",     "sling",      "socket",    "spindle",   "spinner",
    "spoiler",    "spoke",      "spring",     "sprocket", "stabilizer", "stair",     "stand",     "star",
    "stay",       "steering",   "stem",       "step",     "strap",      "stretcher", "string",    "strip",
    "strut",      "support",    "switch",     "swivel",   "tabletop",   "tail",      "taillight", "tank",
    "tire",       "top",        "tower",      "track",    "tray",       "trim",      "trunk",     "tube",
    "tyre",       "underbody",  "upholstery", "vase",     "vent",       "wall",      "wheel",     "window",
    "windscreen", "windshield", "wing",       "winglet",  "wire",       "yoke"};

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

std::string without_separators(std::string text)
{
  while (!text.empty() && is_separator(text.back()))
    text.pop_back();
  return text;
}

/// A word of a name, in small letters and without digits at its end, and the range of its characters in the name.
struct Word
{
  std::size_t begin, end;
  std::string text;
};

std::vector<Word> words_of(const std::string& name)
{
  std::vector<Word> result;
  for (std::size_t begin = 0, end; begin < name.size(); begin = end + 1) {
    end = begin;
    while (end < name.size() && !is_separator(name[end]))
      ++end;
    const std::string word = numbered(name.substr(begin, end - begin)).first;
    if (end > begin) result.push_back({begin, end, boost::algorithm::to_lower_copy(word, std::locale::classic())});
  }
  return result;
}

bool is_meaningless(const Word& word) { return word.text.size() < 2 || meaningless.count(word.text) > 0; }

bool says_nothing(const std::string& name)
{
  const std::vector<Word> words = words_of(name);
  return std::all_of(words.begin(), words.end(), is_meaningless);
}

/// The words of a name, also where capitals begin them (BackRest), in small letters, without numbers and the plural's
/// s.
std::set<std::string> plain_words(const std::string& name)
{
  std::set<std::string> result;
  std::string word;
  const auto finish = [&] {
    if (word.size() > 2 && word.back() == 's' && word[word.size() - 2] != 's') word.pop_back();
    if (!word.empty()) result.insert(word);
    word.clear();
  };
  for (std::size_t i = 0; i < name.size(); ++i) {
    const unsigned char c = static_cast<unsigned char>(name[i]);
    const bool is_letter = std::isalpha(c) || c >= 0x80;
    if (!is_letter || (std::isupper(c) && i > 0 && std::islower(static_cast<unsigned char>(name[i - 1])))) finish();
    if (is_letter) word += boost::algorithm::to_lower_copy(std::string(1, name[i]), std::locale::classic());
  }
  finish();
  return result;
}

/// Whether a name tells in English what a part is. \param known further words for parts, such as roles
bool tells_part(const std::string& name, const std::set<std::string>& known)
{
  const std::set<std::string> words = plain_words(name);
  return std::any_of(words.begin(), words.end(), [&](const std::string& word) {
    for (std::size_t size = 3; size <= word.size(); ++size) // size of the last word of a compound such as seatback
      if (const std::string last = word.substr(word.size() - size); words_for_parts.count(last) || known.count(last))
        return true;
    return false;
  });
}

/// A name without what modelling programs add at its ends: meaningless words, and numbers of copies such as .001.
std::string without_words_of_modellers(const std::string& name)
{
  std::vector<Word> words = words_of(name);
  const auto is_copy = [&](const Word& word) { // .001
    return word.text.empty() && word.begin > 0 && name[word.begin - 1] == '.' && word.end - word.begin == 3;
  };
  if (says_nothing(name)) {
    return words.size() > 1 && is_copy(words.back()) ? name.substr(0, words.back().begin - 1) : name;
  }
  while (is_copy(words.back()) || meaningless.count(words.back().text) > 0)
    words.pop_back();
  std::size_t first = 0;
  while (meaningless.count(words[first].text) > 0)
    ++first;
  return name.substr(words[first].begin, words.back().end - words[first].begin);
}

/// At most `longest` characters of a text in UTF-8: its last words, or else the beginning of the last one.
std::string shortened(const std::string& label, std::size_t longest)
{
  const auto length = [](const std::string& text) {
    return std::size_t(std::count_if(text.begin(), text.end(), [](unsigned char c) { return (c & 0xC0) != 0x80; }));
  };
  std::string result = label;
  for (const Word& word : words_of(label)) {
    if (length(result) <= longest) return result;
    result = label.substr(word.begin);
  }
  if (length(result) <= longest) return result;
  while (length(result) >= longest)
    do
      result.pop_back();
    while (!result.empty() && (static_cast<unsigned char>(result.back()) & 0xC0) == 0x80);
  return result + "…";
}

/// The names without meaningless words and without numbers of pieces; several may be equal.
std::vector<std::string> stems(const std::vector<std::string>& names)
{
  std::vector<Divided_name> pieces;
  std::map<std::string, std::set<std::string>> materials;
  for (const std::string& name : names) {
    pieces.push_back(divided(name));
    materials[pieces.back().object].insert(pieces.back().material);
  }
  std::vector<std::string> result;
  for (const Divided_name& name : pieces)
    result.push_back(name.object + (materials[name.object].size() > 1 ? name.material : ""));
  const std::string prefix = common_prefix(result);
  for (std::string& label : result) {
    const std::string rest = without_prefix(label, prefix);
    label = without_words_of_modellers(says_nothing(rest) ? label : rest);
  }
  return result;
}

} // namespace

std::vector<std::string> part_labels(const std::vector<std::string>& names, const std::vector<std::string>& roles)
{
  std::vector<std::string> result = stems(names);
  std::map<std::string, std::set<std::string>> roles_of_stem, roles_of_series;
  std::map<std::string, std::size_t> size_of_series;
  std::set<std::string> known;
  std::vector<std::string> series; // for each part, its stem without number
  for (std::size_t i = 0; i < roles.size(); ++i) {
    series.push_back(without_separators(numbered(result[i]).first));
    ++size_of_series[series[i]];
    if (roles[i].empty()) continue;
    roles_of_stem[result[i]].insert(roles[i]);
    roles_of_series[series[i]].insert(roles[i]);
    known.merge(plain_words(roles[i]));
  }
  for (std::size_t i = 0; i < roles.size(); ++i)
    if (!roles[i].empty() &&
        (says_nothing(result[i]) || !tells_part(result[i], known) || roles_of_stem[result[i]].size() > 1 ||
         (2 * size_of_series[series[i]] > names.size() && roles_of_series[series[i]].size() > 1)))
      series[i] = role_text(roles[i]);
    else
      series[i] = result[i];
  if (!roles.empty()) result = std::move(series);
  std::map<std::string, std::size_t> counts, numbers;
  for (std::string& label : result) {
    label = shortened(label, longest_label - 4); // leaves place for a separator and three digits
    if (label.empty()) label = "part";
    ++counts[label];
  }
  for (std::string& label : result)
    if (counts[label] > 1) {
      std::string next;
      do
        next = label + ' ' + std::to_string(++numbers[label]);
      while (counts.count(next));
      label = next;
    }
  return result;
}

std::string role_text(std::string role)
{
  if (role == "h_stab") return "tailplane";
  if (role == "v_stab") return "fin";
  std::replace(role.begin(), role.end(), '_', ' ');
  return role;
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
