// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "io/system/bytes.h"
#include "model_files.h"

#include <CGAL/Shape_correspondence/IO/read_segmented_shape.h>

#include <catch2/catch.hpp>

#include <cstdint>

using namespace CGAL::Shape_correspondence;
using namespace model_files;
using Catch::Matchers::Contains;

namespace {

std::uint32_t crc_of(const std::string& bytes)
{
  std::uint32_t crc = ~0u;
  for (char c : bytes) {
    crc ^= std::uint8_t(c);
    for (int bit = 0; bit < 8; ++bit)
      crc = crc >> 1 ^ (crc & 1 ? 0xEDB88320u : 0);
  }
  return ~crc;
}

/// A ZIP archive of uncompressed files.
std::string zip(const std::vector<std::pair<std::string, std::string>>& files)
{
  std::string result, directory;
  for (const auto& [name, bytes] : files) {
    const auto append_entry = [&, &name = name, &bytes = bytes](std::string& to, bool is_in_directory) {
      const auto append = [&](auto number) { IO::append_little_endian(to, number); };
      to += is_in_directory ? std::string("PK\1\2\x14\0", 6) : std::string("PK\3\4");
      to += std::string("\x14\0\0\0\0\0\0\0\0\0", 10); // version, uncompressed, no date
      append(crc_of(bytes));
      append(std::uint32_t(bytes.size()));
      append(std::uint32_t(bytes.size()));
      append(std::uint16_t(name.size()));
      append(std::uint16_t(0));
    };
    const auto at = std::uint32_t(result.size());
    append_entry(result, false);
    append_entry(directory, true);
    directory += std::string(10, '\0');
    IO::append_little_endian(directory, at);
    result += name + bytes;
    directory += name;
  }
  const auto begin = std::uint32_t(result.size());
  result += directory + std::string("PK\5\6\0\0\0\0", 8);
  for (int i = 0; i < 2; ++i)
    IO::append_little_endian(result, std::uint16_t(files.size()));
  IO::append_little_endian(result, std::uint32_t(directory.size()));
  IO::append_little_endian(result, begin);
  return result + std::string(2, '\0');
}

std::string package(const std::string& resources, const std::string& items)
{
  return zip(
      {{"_rels/.rels", "<?xml version=\"1.0\"?><Relationships "
                       "xmlns=\"http://schemas.openxmlformats.org/package/2006/relationships\"><Relationship "
                       "Target=\"/3D/3dmodel.model\" Id=\"r\" "
                       "Type=\"http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel\"/></Relationships>"},
       {"3D/3dmodel.model", "<?xml version=\"1.0\"?><model unit=\"millimeter\" "
                            "xmlns=\"http://schemas.microsoft.com/3dmanufacturing/core/2015/02\"><resources>" +
                                resources + "</resources><build>" + items + "</build></model>"}});
}

std::string object(int id, const std::string& name, const std::string& content)
{
  return "<object id=\"" + std::to_string(id) + "\"" + name + " type=\"model\">" + content + "</object>";
}

std::string use(const std::string& kind, int id, const std::string& place = "0 0 0")
{
  return "<" + kind + " objectid=\"" + std::to_string(id) + "\" transform=\"1 0 0 0 1 0 0 0 1 " + place + "\"/>";
}

const std::string mesh =
    "<mesh><vertices><vertex x=\"0\" y=\"0\" z=\"0\"/><vertex x=\"1\" y=\"0\" z=\"0\"/><vertex x=\"0\" y=\"1\" "
    "z=\"0\"/><vertex x=\"0\" y=\"0\" z=\"1\"/></vertices><triangles><triangle v1=\"0\" v2=\"2\" v3=\"1\"/>"
    "<triangle v1=\"0\" v2=\"1\" v3=\"3\"/><triangle v1=\"0\" v2=\"3\" v3=\"2\"/><triangle v1=\"1\" v2=\"2\" "
    "v3=\"3\"/></triangles></mesh>";

} // namespace

TEST_CASE("Objects of 3MF are parts, as often and where the items and components of the file use them, with z up")
{
  const Temporary_folder folder;
  const std::string leg = object(1, " name=\"leg &amp; foot\"", mesh), top = object(2, "", mesh);
  const std::string pair = object(
      3, " name=\"pair\"", "<components>" + use("component", 1) + use("component", 1, "9 0 0") + "</components>");
  const Segmented_shape shape = IO::read_segmented_shape(
      folder.write("table.3mf", package(leg + top + pair, use("item", 3, "0 0 5") + use("item", 2) + use("item", 3))));
  CHECK(shape.up() == Point::UnitZ());
  REQUIRE(shape.parts().size() == 5);
  std::vector<std::string> names;
  std::vector<Point> lowest;
  for (const Shape_part& part : shape.parts()) {
    names.push_back(part.name);
    lowest.push_back(part.mesh.points.rowwise().minCoeff());
  }
#ifdef SHAPE_CORRESPONDENCE_WITH_MINIZIP
  CHECK(names == std::vector<std::string>{"leg & foot", "leg & foot#2", "Object_2", "leg & foot#3", "leg & foot#4"});
#endif
  CHECK(lowest == std::vector<Point>{{0, 0, 5}, {9, 0, 5}, {0, 0, 0}, {0, 0, 0}, {9, 0, 0}});
}

TEST_CASE("A 3MF file that is damaged, repeats too much or has other files with objects is refused")
{
  const Temporary_folder folder;
  const auto refused = [&](const std::string& bytes) {
    const std::string file = folder.write("a.3mf", bytes);
    return complaint([&] { IO::read_segmented_shape(file); });
  };
  const std::string good = package(object(1, "", mesh), use("item", 1));
  CHECK(refused(good).empty());
  for (std::size_t size : {std::size_t(1), std::size_t(100), good.size() / 2, good.size() - 30})
    CHECK_THAT(refused(good.substr(0, size)), Contains("a.3mf"));
  CHECK_THAT(refused(package(object(1, "", mesh), "")), Contains("no triangle"));
  std::string many = object(1, "", mesh);
  for (int id = 2; id < 12; ++id) {
    std::string components;
    for (int k = 0; k < 10; ++k)
      components += use("component", id - 1);
    many += object(id, "", "<components>" + components + "</components>");
  }
  CHECK_THAT(refused(package(many, use("item", 11))), Contains("a.3mf"));
#ifdef SHAPE_CORRESPONDENCE_WITH_MINIZIP
  CHECK_THAT(
      refused(package(object(1, "", "<components><component p:path=\"/3D/b.model\" objectid=\"1\"/></components>"),
                      use("item", 1))),
      Contains("production extension") && Contains("save it"));
#endif
}
