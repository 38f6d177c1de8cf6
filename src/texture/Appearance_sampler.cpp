// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "texture/Appearance_sampler.h"
#include "io/system/colours.h"

#include <algorithm>
#include <cmath>

namespace CGAL::Shape_correspondence::internal {
namespace {

/// The pixel, within the image, that a texture repeats at a pixel outside of it.
int wrapped(int pixel, int size, Texture_wrap wrap)
{
  const int period = wrap == Texture_wrap::MIRROR ? 2 * size : size;
  if (wrap == Texture_wrap::CLAMP) return std::clamp(pixel, 0, size - 1);
  const int inside = (pixel % period + period) % period;
  return inside < size ? inside : 2 * size - 1 - inside;
}

} // namespace

Appearance_sampler::Appearance_sampler(const Shape_appearance& appearance, const Eigen::Vector3d& neutral)
    : appearance_(appearance), neutral_(neutral)
{
  for (std::size_t byte = 0; byte < linear_.size(); ++byte)
    linear_[byte] = linear_of_srgb(double(byte) / 255);
}

bool Appearance_sampler::is_known(std::size_t part) const
{
  if (part >= appearance_.parts.size()) return false;
  const Part_appearance& looks = appearance_.parts[part];
  return !looks.colours.empty() ||
         std::any_of(looks.materials.begin(), looks.materials.end(), [](int material) { return material >= 0; });
}

Eigen::Vector3d Appearance_sampler::texture_at(const Texture& texture, const Eigen::Vector2d& at) const
{
  const Image& image = texture.image;
  const Eigen::Vector2d pixel(at.x() * image.width - 0.5, at.y() * image.height - 0.5);
  const int x = int(std::floor(pixel.x())), y = int(std::floor(pixel.y()));
  Eigen::Vector3d result = Eigen::Vector3d::Zero();
  for (int dy : {0, 1})
    for (int dx : {0, 1}) {
      const double weight = (dx ? pixel.x() - x : 1 - (pixel.x() - x)) * (dy ? pixel.y() - y : 1 - (pixel.y() - y));
      const auto column = std::size_t(wrapped(x + dx, image.width, texture.wrap_u));
      const auto row = std::size_t(wrapped(y + dy, image.height, texture.wrap_v));
      const std::uint8_t* const bytes = image.pixels.data() + 4 * (row * std::size_t(image.width) + column);
      result += weight * Eigen::Vector3d(linear_[bytes[0]], linear_[bytes[1]], linear_[bytes[2]]);
    }
  return result;
}

Eigen::Vector3d Appearance_sampler::operator()(std::size_t part, std::size_t triangle,
                                               const Eigen::Vector3d& weights) const
{
  if (!is_known(part)) return neutral_;
  const Part_appearance& looks = appearance_.parts[part];
  Eigen::Vector3d result = looks.colours.empty() ? neutral_ : Eigen::Vector3d(Eigen::Vector3d::Ones());
  const int number = looks.materials.empty() ? -1 : looks.materials[triangle];
  if (number >= 0) {
    const Surface_material& material = appearance_.materials[std::size_t(number)];
    result = material.colour.head<3>();
    if (material.texture >= 0 && !looks.coordinates.empty()) {
      const Texture& texture = appearance_.textures[std::size_t(material.texture)];
      if (!texture.image.empty())
        result = result.cwiseProduct(texture_at(texture, value_at<double>(looks.coordinates, triangle, weights)));
    }
  }
  return looks.colours.empty() ? result : result.cwiseProduct(value_at<double>(looks.colours, triangle, weights));
}

} // namespace CGAL::Shape_correspondence::internal
