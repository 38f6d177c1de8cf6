// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>

/// Access to the data in web pages.
namespace page_documents {

/// The text of the script element with an id.
inline std::string document_of(const std::string& page, const std::string& id)
{
  const std::string begin = "id=\"" + id + "\">";
  const std::size_t at = page.find(begin);
  if (at == std::string::npos) throw std::runtime_error("the page has no document " + id);
  return page.substr(at + begin.size(), page.find("</script>", at) - at - begin.size());
}

inline std::string from_base64(const std::string& text)
{
  const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string result;
  std::uint32_t bits = 0;
  int count = 0;
  for (char c : text) {
    if (c == '=') break;
    bits = bits << 6 | std::uint32_t(digits.find(c));
    count += 6;
    if (count < 8) continue;
    count -= 8;
    result.push_back(char(bits >> count & 0xff));
  }
  return result;
}

} // namespace page_documents
