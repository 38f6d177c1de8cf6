// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "import/beside_assimp.h"

#ifdef SHAPE_CORRESPONDENCE_WITH_MINIZIP
#include "io/system/input_file.h"

#include <CGAL/Shape_correspondence/Invalid_input.h>

#include <boost/property_tree/xml_parser.hpp>
#include <minizip/unzip.h>

#include <memory>
#include <sstream>
#include <string_view>
#include <type_traits>
#endif

namespace CGAL::Shape_correspondence::IO {

#ifdef SHAPE_CORRESPONDENCE_WITH_MINIZIP

namespace {

using Archive = std::remove_pointer_t<unzFile>;

/// Moves to the archive's document with the objects: 3D/3dmodel.model, or else the first file with this extension.
bool go_to_model(Archive* archive)
{
  constexpr int any_case = 2;
  if (unzLocateFile(archive, "3D/3dmodel.model", any_case) == UNZ_OK) return true;
  for (int found = unzGoToFirstFile(archive); found == UNZ_OK; found = unzGoToNextFile(archive)) {
    char name[256] = "";
    unzGetCurrentFileInfo64(archive, nullptr, name, sizeof name - 1, nullptr, 0, nullptr, 0);
    if (lower_extension(name) == ".model") return true;
  }
  return false;
}

/// The document with the objects. \throw Invalid_input if it is damaged
std::string model_of_package(const std::string& file)
{
  const std::unique_ptr<Archive, int (*)(unzFile)> archive(unzOpen64(file.c_str()), unzClose);
  std::string result, buffer(std::size_t(1) << 16, '\0');
  if (!archive || !go_to_model(archive.get()) || unzOpenCurrentFile(archive.get()) != UNZ_OK)
    throw Invalid_input("it is no archive with a model, or is damaged; save it again");
  int size = 0;
  while ((size = unzReadCurrentFile(archive.get(), buffer.data(), unsigned(buffer.size()))) > 0)
    result.append(buffer, 0, std::size_t(size));
  if (size < 0 || unzCloseCurrentFile(archive.get()) != UNZ_OK)
    throw Invalid_input("its archive is damaged; save it again");
  return result;
}

void add_name(const std::string& tag, std::map<std::string, std::string>& names)
{
  std::istringstream element(tag + "/>");
  boost::property_tree::ptree tree;
  try {
    boost::property_tree::read_xml(element, tree);
  } catch (const boost::property_tree::xml_parser_error&) {
    return;
  }
  const std::string name = tree.get("object.<xmlattr>.name", "");
  if (!name.empty()) names["Object_" + tree.get("object.<xmlattr>.id", "")] = name;
}

} // namespace

std::map<std::string, std::string> names_in_3mf(const std::string& file)
{
  std::map<std::string, std::string> result;
  const std::string text = model_of_package(file);
  if (text.find(":path=") != std::string::npos)
    throw Invalid_input("its objects are in several files of the archive, as the production extension of 3MF has it, "
                        "which is not read; save it as a 3MF without this extension, as STL or OBJ");
  constexpr std::string_view beginning = "<object ";
  for (std::size_t at = text.find(beginning); at != std::string::npos; at = text.find(beginning, at + 1))
    if (const std::size_t end = text.find_first_of("<>", at + 1); end != std::string::npos && text[end] == '>')
      add_name(text.substr(at, end - at - (text[end - 1] == '/')), result);
  return result;
}

#else

std::map<std::string, std::string> names_in_3mf(const std::string&) { return {}; }

#endif

} // namespace CGAL::Shape_correspondence::IO
