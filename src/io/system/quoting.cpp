// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "io/system/quoting.h"

#include <boost/algorithm/string/case_conv.hpp>
#include <boost/algorithm/string/replace.hpp>
#include <boost/locale/utf.hpp>

#include <cctype>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <functional>
#include <iterator>
#include <locale>
#include <set>

namespace CGAL::Shape_correspondence::IO {
namespace {

using Utf8 = boost::locale::utf::utf_traits<char>;

constexpr std::uint32_t no_character = boost::locale::utf::illegal;

/// A character of a UTF-8 text, or `no_character` for an invalid byte, and its number of bytes.
struct Utf8_character
{
  std::uint32_t code;
  std::size_t size;
};

Utf8_character character_at(const std::string& text, std::size_t at)
{
  const char *const begin = text.data() + at, *place = begin;
  const std::uint32_t code = Utf8::decode(place, text.data() + text.size());
  if (code == no_character || code == boost::locale::utf::incomplete) return {no_character, 1};
  return {code, std::size_t(place - begin)};
}

bool is_utf8(const std::string& text)
{
  for (std::size_t at = 0; at < text.size();) {
    const Utf8_character c = character_at(text, at);
    if (c.code == no_character) return false;
    at += c.size;
  }
  return true;
}

bool is_control(std::uint32_t code) { return code < 0x20 || (code >= 0x7F && code < 0xA0); }

/// Whether a character changes the direction of writing, or ends a line or paragraph.
bool is_layout(std::uint32_t code)
{
  return (code >= 0x200E && code <= 0x200F) || (code >= 0x2028 && code <= 0x202E) || (code >= 0x2066 && code <= 0x2069);
}

std::string hexadecimal(const char* format, std::uint32_t code)
{
  char result[16];
  std::snprintf(result, sizeof result, format, static_cast<unsigned>(code));
  return result;
}

std::string percent(const std::string& bytes)
{
  std::string result;
  for (char byte : bytes)
    result += hexadecimal("%%%02X", static_cast<unsigned char>(byte));
  return result;
}

bool is_percent_code(const std::string& text, std::size_t at)
{
  const auto is_digit = [&](std::size_t i) {
    return i < text.size() && std::isxdigit(static_cast<unsigned char>(text[i])) != 0;
  };
  return text[at] == '%' && is_digit(at + 1) && is_digit(at + 2);
}

/// A UTF-8 text with every character replaced. \param replaced gives the replacement by code, position and bytes
template <typename Function>
std::string replace_characters(const std::string& text, const Function& replaced)
{
  std::string result;
  for (std::size_t at = 0; at < text.size();) {
    const Utf8_character c = character_at(text, at);
    result += replaced(c.code, at, text.substr(at, c.size));
    at += c.size;
  }
  return result;
}

/// Encodes characters that a format cannot represent. \param text in UTF-8
/// \param is_special whether a character, given by code and position, must be encoded
std::string with_percent_codes(const std::string& text,
                               const std::function<bool(std::uint32_t code, std::size_t at)>& is_special)
{
  return replace_characters(text, [&](std::uint32_t code, std::size_t at, const std::string& bytes) {
    return is_percent_code(text, at) || is_special(code, at) ? percent(bytes) : bytes;
  });
}

/// A text as one line. Outer blanks are encoded, since readers drop them. \param is_special further characters to
/// encode
std::string one_line(const std::string& text, const std::function<bool(std::uint32_t code, std::size_t at)>& is_special)
{
  return with_percent_codes(text, [&](std::uint32_t code, std::size_t at) {
    const bool is_outer_blank = code == ' ' && (at == 0 || at + 1 == text.size());
    return is_control(code) || is_layout(code) || is_outer_blank || is_special(code, at);
  });
}

} // namespace

std::string utf8_text(const std::string& bytes)
{
  if (is_utf8(bytes)) return bytes;
  std::string result;
  for (char byte : bytes)
    Utf8::encode(static_cast<unsigned char>(byte), std::back_inserter(result));
  return result;
}

std::string quote_obj(const std::string& name)
{
  const std::string text = utf8_text(name);
  return one_line(text, [&](std::uint32_t code, std::size_t at) {
    const bool begins_comment = code == '#' && (at == 0 || text[at - 1] == ' ');
    const bool continues_line = code == '\\' && at + 1 == text.size();
    return begins_comment || continues_line;
  });
}

std::string quote_ply(const std::string& name)
{
  return one_line(utf8_text(name), [](std::uint32_t, std::size_t) { return false; });
}

std::string file_name(const std::string& name)
{
  constexpr std::size_t longest = 200; // length in bytes; a number and an extension keep it below 255
  const std::set<std::string> reserved{"con", "prn", "aux", "nul"};
  std::string result =
      replace_characters(utf8_text(name), [](std::uint32_t code, std::size_t at, const std::string& bytes) {
        const bool is_forbidden = code < 0x80 && std::strchr("/\\:*?\"<>|", int(code)) != nullptr;
        return is_control(code) || is_layout(code) || is_forbidden || (code == '.' && at == 0) ? "_" : bytes;
      });
  if (result.size() > longest) {
    std::size_t end = longest;
    while ((static_cast<unsigned char>(result[end]) & 0xC0) == 0x80) // within a character
      --end;
    result.resize(end);
  }
  while (!result.empty() && (result.back() == ' ' || result.back() == '.'))
    result.back() = '_';
  const std::string stem = boost::algorithm::to_lower_copy(result.substr(0, result.find('.')), std::locale::classic());
  const bool is_port = stem.size() == 4 && (stem.rfind("com", 0) == 0 || stem.rfind("lpt", 0) == 0);
  return result.empty() || is_port || reserved.count(stem) > 0 ? "_" + result : result;
}

std::string percent_decoded(const std::string& text)
{
  std::string result;
  for (std::size_t at = 0; at < text.size(); ++at)
    if (is_percent_code(text, at)) {
      result += char(std::stoi(text.substr(at + 1, 2), nullptr, 16));
      at += 2;
    } else
      result += text[at];
  return result;
}

std::string quote_dot(const std::string& name)
{
  const auto is_illegal = [](std::uint32_t code, std::size_t) { return is_control(code) && code != '\n'; };
  std::string result = "\"";
  for (char c : with_percent_codes(utf8_text(name), is_illegal))
    result += c == '"' ? "\\\"" : c == '\\' ? "\\\\" : c == '\n' ? "\\n" : std::string(1, c);
  return result + '"';
}

std::string quote_graphml(const std::string& name)
{
  return with_percent_codes(utf8_text(name), [](std::uint32_t code, std::size_t) {
    return (is_control(code) && code != '\t' && code != '\n') || code == 0xFFFE || code == 0xFFFF;
  });
}

std::string quote_csv(const std::string& field)
{
  std::string text = utf8_text(field);
  if (!text.empty() && std::string("=+-@\t\r").find(text[0]) != std::string::npos) text.insert(0, "'");
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  return '"' + boost::replace_all_copy(text, "\"", "\"\"") + '"';
}

std::string quote_terminal(const std::string& text, bool keeps_lines)
{
  return replace_characters(utf8_text(text), [&](std::uint32_t code, std::size_t, const std::string& bytes) {
    if (is_layout(code)) return hexadecimal("\\u{%04X}", code);
    return is_control(code) && !(keeps_lines && code == '\n') ? hexadecimal("\\x%02X", code) : bytes;
  });
}

} // namespace CGAL::Shape_correspondence::IO
