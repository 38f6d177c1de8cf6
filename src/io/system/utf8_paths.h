// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <clocale>
#include <filesystem>
#include <string_view>

#ifdef _GLIBCXX_FILESYSTEM_IS_WINDOWS
// Makes texts UTF-8 paths, as on other systems. On Windows libstdc++ converts paths to UTF-8, but interprets texts in
// the code page of the C library, which cannot be UTF-8. All sources that make paths of texts need this.
template <>
inline auto std::filesystem::path::_S_convert<char>(const char* begin, const char* end)
{
  return std::filesystem::__detail::__wstr_from_utf8(std::string_view(begin, std::size_t(end - begin)));
}
#endif

namespace CGAL::Shape_correspondence::IO {

/// Sets the encoding of the C library's locale, in which Visual C++ interprets paths, to UTF-8.
inline void set_utf8_paths()
{
#ifdef _MSC_VER
  std::setlocale(LC_CTYPE, ".UTF-8");
#endif
}

} // namespace CGAL::Shape_correspondence::IO
