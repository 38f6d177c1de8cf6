// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <clocale>
#include <filesystem>

#ifdef _GLIBCXX_FILESYSTEM_IS_WINDOWS
// Texts are paths in UTF-8, as they are elsewhere. On Windows libstdc++ makes UTF-8 of paths, but takes texts for those
// of the C library's code page, which cannot be that of UTF-8. All sources that make paths of texts need this; the
// precompiled header has it.
template <>
inline auto std::filesystem::path::_S_convert<char>(const char* begin, const char* end)
{
  return std::filesystem::__detail::__wstr_from_utf8(std::string_view(begin, std::size_t(end - begin)));
}
#endif

namespace CGAL::Shape_correspondence::IO {

/// The library of Visual C++ takes texts for paths in the encoding of the C library's locale.
inline void set_utf8_paths()
{
#ifdef _MSC_VER
  std::setlocale(LC_CTYPE, ".UTF-8");
#endif
}

} // namespace CGAL::Shape_correspondence::IO
