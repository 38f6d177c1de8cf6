// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "textures.h"

#include <cstdint>

namespace CGAL::Shape_correspondence::generator {

namespace {

// A PNG file, not compressed, of rows of red, green and blue (PNG specification, sections 5 and 10; RFC 1950 and
// 1951).
std::string png_text(int width, int height, const std::string& pixels)
{
  const auto big_endian = [](std::uint32_t number) {
    std::string bytes;
    for (int shift = 24; shift >= 0; shift -= 8)
      bytes += char(number >> shift & 255);
    return bytes;
  };
  const auto chunk = [&](const std::string& type, const std::string& content) {
    std::uint32_t sum = ~std::uint32_t(0); // cyclic redundancy check
    for (char c : type + content) {
      sum ^= static_cast<unsigned char>(c);
      for (int bit = 0; bit < 8; ++bit)
        sum = sum & 1 ? sum >> 1 ^ 0xEDB88320u : sum >> 1;
    }
    return big_endian(std::uint32_t(content.size())) + type + content + big_endian(~sum);
  };
  std::string stream("\x78\x01", 2);
  std::uint32_t a = 1, b = 0; // Adler's checksum
  for (int row = 0; row < height; ++row) {
    const std::string line = std::string(1, '\0') + pixels.substr(std::size_t(3 * row * width), std::size_t(3 * width));
    const auto size = std::uint16_t(line.size()), inverse = std::uint16_t(~size);
    stream += row + 1 == height ? '\x01' : '\0'; // whether it is the last block
    for (std::uint16_t number : {size, inverse})
      for (int shift : {0, 8})
        stream += char(number >> shift & 255);
    stream += line;
    for (char c : line) {
      a = (a + static_cast<unsigned char>(c)) % 65521;
      b = (b + a) % 65521;
    }
  }
  stream += big_endian(b << 16 | a);
  return "\x89PNG\r\n\x1a\n" +
         chunk("IHDR", big_endian(std::uint32_t(width)) + big_endian(std::uint32_t(height)) +
                           std::string("\x08\x02\x00\x00\x00", 5)) +
         chunk("IDAT", stream) + chunk("IEND", "");
}

// Texture coordinates that show the whole picture, upright, on each of the six sides of a part's box.
Eigen::Vector2d side_coordinates(const Mesh& mesh, const std::array<int, 3>& face, const Point& p)
{
  Point low = mesh.points[0], high = low;
  for (const Point& q : mesh.points) {
    low = low.cwiseMin(q);
    high = high.cwiseMax(q);
  }
  const Point a = mesh.points[std::size_t(face[0])], b = mesh.points[std::size_t(face[1])];
  const Point normal = (b - a).cross(mesh.points[std::size_t(face[2])] - a);
  int axis = 0;
  normal.cwiseAbs().maxCoeff(&axis);
  const int across = axis == 0 ? 2 : 0, up = axis == 1 ? 2 : 1;
  const auto share = [&](int i) { return high[i] > low[i] ? (p[i] - low[i]) / (high[i] - low[i]) : 0.5; };
  return {share(across), up == 2 ? 1 - share(up) : share(up)};
}

} // namespace

std::string test_picture()
{
  constexpr int size = 128, square = 16, corner = 7;
  std::string pixels;
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x) {
      const int column = x / square, row = y / square;
      const bool is_dark = x % square + y % square < corner;
      pixels += char(is_dark ? 20 : 60 + 25 * column);
      pixels += char(is_dark ? 20 : 60 + 25 * row);
      pixels += char(is_dark ? 20 : (column + row) % 2 ? 230 : 60);
    }
  return png_text(size, size, pixels);
}

Files textured_file(const Assembly& shape)
{
  std::string text = "mtllib " + shape.name + ".mtl\nusemtl test_picture\n";
  int vertices = 0, coordinates = 0;
  for (const Part& part : shape.parts) {
    const Mesh& mesh = part.solid.mesh;
    text += "o " + part.name + '\n';
    for (const Point& p : mesh.points)
      text += "v " + number(p.x()) + ' ' + number(p.y()) + ' ' + number(p.z()) + '\n';
    for (const auto& face : mesh.faces)
      for (int v : face) {
        const Eigen::Vector2d at = side_coordinates(mesh, face, mesh.points[std::size_t(v)]);
        text += "vt " + number(at.x()) + ' ' + number(at.y()) + '\n';
      }
    for (const auto& face : mesh.faces) {
      text += 'f';
      for (int v : face)
        text += ' ' + std::to_string(v + 1 + vertices) + '/' + std::to_string(++coordinates);
      text += '\n';
    }
    vertices += int(mesh.points.size());
  }
  return {{shape.name + ".obj", text},
          {shape.name + ".mtl", "newmtl test_picture\nKd 1 1 1\nmap_Kd test_picture.png\n"},
          {"test_picture.png", test_picture()}};
}

} // namespace CGAL::Shape_correspondence::generator
