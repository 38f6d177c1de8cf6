// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "base/limits.h"
#include "io/read/document.h"
#include "io/read/model_parts.h"
#include "io/read/text_words.h"
#include "io/system/colours.h"
#include "io/system/input_file.h"

#include <CGAL/Shape_correspondence/Invalid_input.h>

#include <Eigen/Geometry>
#include <boost/property_tree/ptree.hpp>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>

namespace CGAL::Shape_correspondence::IO {
namespace {

namespace fs = std::filesystem;
using Element = boost::property_tree::ptree;
using Transform = Eigen::Affine3d;

constexpr int round_sides = 32;                                      // number of sides of a cylinder or a sphere
constexpr double angle_of_side = double(2 * EIGEN_PI) / round_sides; // angle in radians
constexpr double largest_value = 1e9;                                // largest coordinate in metres, beyond any robot

std::string attribute(const Element& element, const std::string& name)
{
  const auto all = element.find("<xmlattr>");
  if (all == element.not_found()) return "";
  const auto found = all->second.find(name);
  return found == all->second.not_found() ? "" : found->second.data();
}

const Element* child(const Element& element, const std::string& name)
{
  const auto found = element.find(name);
  return found == element.not_found() ? nullptr : &found->second;
}

/// Finds meshes of robots. Only the folder of the file is searched or, if allowed, folders above it.
class Mesh_finder
{
public:
  /// \param all folder of all meshes; empty: that of the file
  Mesh_finder(const std::string& file, const std::string& all, const Reading_options& options)
      : all_(all.empty() ? file : (fs::path(all) / "file").string()),
        folder_(fs::absolute(file).lexically_normal().parent_path()),
        options_(options)
  {}

  /// The path of a mesh; empty if it is not found. \param uri its name in the document
  std::string path_of(std::string uri) const
  {
    std::string package;
    const bool is_packaged = begins_with(uri, "package://") || begins_with(uri, "model://");
    if (const std::size_t scheme = uri.find("://"); scheme != std::string::npos) uri.erase(0, scheme + 3);
    if (const std::size_t slash = uri.find('/'); is_packaged && slash != std::string::npos) {
      package = uri.substr(0, slash);
      uri.erase(0, slash + 1);
    }
    for (fs::path folder = folder_;; folder = folder.parent_path()) {
      for (const fs::path& candidate : {folder / fs::path(package) / uri, folder / fs::path(uri)})
        if (is_usable(candidate)) return candidate.string();
      if (!is_packaged || folder == folder.parent_path()) break;
    }
    const fs::path beside = folder_ / fs::path(uri).filename();
    return is_usable(beside) ? beside.string() : "";
  }

private:
  bool is_usable(const fs::path& path) const
  {
    std::error_code error;
    return fs::is_regular_file(path, error) && (options_.allow_outside_files || is_in_folder_of(all_, path.string()));
  }

  std::string all_; ///< a file, which need not exist, in the folder of all meshes
  fs::path folder_;
  const Reading_options& options_;
};

void add_triangle(const Point& a, const Point& b, const Point& c, std::vector<Point>& corners)
{
  corners.insert(corners.end(), {a, b, c});
}

std::vector<Point> box(const Point& size)
{
  const auto at = [&](int corner) {
    return Point(size.cwiseProduct(Point(corner & 1, corner >> 1 & 1, corner >> 2) - Point::Constant(0.5)));
  };
  std::vector<Point> result;
  const int faces[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  for (const auto& f : faces) {
    add_triangle(at(f[0]), at(f[1]), at(f[2]), result);
    add_triangle(at(f[0]), at(f[2]), at(f[3]), result);
  }
  return result;
}

/// The surface of revolution of a polyline about the z axis. \param line points (radius, z), from the lower end upwards
std::vector<Point> turned(const std::vector<Eigen::Vector2d>& line)
{
  const auto at = [&](std::size_t i, int side) {
    const double angle = angle_of_side * (side % round_sides);
    return Point(line[i][0] * std::cos(angle), line[i][0] * std::sin(angle), line[i][1]);
  };
  std::vector<Point> result;
  for (std::size_t i = 0; i + 1 < line.size(); ++i)
    for (int side = 0; side < round_sides; ++side) {
      if (line[i][0] > 0) add_triangle(at(i, side), at(i, side + 1), at(i + 1, side), result);
      if (line[i + 1][0] > 0) add_triangle(at(i, side + 1), at(i + 1, side + 1), at(i + 1, side), result);
    }
  return result;
}

std::vector<Point> sphere(double radius)
{
  std::vector<Eigen::Vector2d> line{{0, -radius}};
  for (int i = 1; i < round_sides / 2; ++i) {
    const double angle = angle_of_side * i;
    line.emplace_back(radius * std::sin(angle), -radius * std::cos(angle));
  }
  line.emplace_back(0, radius);
  return turned(line);
}

/// Inverts assimp's rotation of COLLADA meshes to y up: URDF uses their coordinates as they are in the files.
Eigen::Matrix3d turn_back(const std::string& mesh)
{
  Eigen::Matrix3d result = Eigen::Matrix3d::Identity();
  if (lower_extension(mesh) != ".dae") return result;
  std::ifstream in = open_input(mesh);
  const std::string text{std::istreambuf_iterator<char>(in), {}};
  const std::size_t tag = text.find("<up_axis>");
  if (tag == std::string::npos) return result;
  const std::string_view axis = trimmed(std::string_view(text).substr(tag + 9, text.find('<', tag + 9) - tag - 9));
  if (axis == "Z_UP") result << 1, 0, 0, 0, 0, -1, 0, 1, 0;
  if (axis == "X_UP") result << 0, 1, 0, -1, 0, 0, 0, 0, 1;
  return result;
}

class Urdf_reader
{
public:
  Urdf_reader(const std::string& file, std::uint64_t bytes, const Mesh_finder& finder, const Mesh_reader& read)
      : file_(file), bytes_(bytes), finder_(finder), read_(read)
  {}

  Model_content read(const Element& robot)
  {
    for (const auto& [kind, element] : robot) {
      if (begins_with(kind, "xacro:"))
        throw Invalid_input(file_ + ": it is a xacro file; make a URDF of it by the program xacro, and give that");
      if (kind == "visual" || kind == "geometry" || kind == "mesh")
        throw Invalid_input(file_ + ": <" + kind + "> is in no link; put it into the <link> that it belongs to");
      if (kind == "link" && attribute(element, "name").empty())
        throw Invalid_input(file_ + ": a <link> has no name; write <link name=\"...\">, and name it in its joint");
      if (kind == "link" && !links_.emplace(attribute(element, "name"), &element).second)
        fail_at(attribute(element, "name"), "is there twice; give it another name");
      if (kind == "material") add_material(element, "");
    }
    for (const auto& [kind, element] : robot)
      if (kind == "joint") add_joint(element);
    for (const auto& [kind, element] : robot)
      if (kind == "link") add_link(attribute(element, "name"), element);
    if (content_.parts.empty())
      throw Invalid_input(file_ + ": no link of it has something visible; add <visual> to its links");
    content_.up = Point::UnitZ();
    return std::move(content_);
  }

private:
  struct Joint
  {
    std::string parent;
    Transform origin;
  };

  [[noreturn]] void fail_at(const std::string& link, const std::string& what) const
  {
    throw Invalid_input(file_ + (links_.count(link) > 0 ? ": link " : ": ") + cited(link) + " " + what);
  }

  /// The numbers in an attribute. \param element an element named `kind`
  template <int size>
  Eigen::Matrix<double, size, 1> numbers(const Element& element, const std::string& kind, const std::string& name,
                                         const std::string& link) const
  {
    const std::string text = attribute(element, name),
                      wanted = size == 1 ? "a number" : std::to_string(size) + " numbers";
    if (trimmed(text).empty())
      fail_at(link, "has a <" + kind + "> without " + name + "; write " + name + "=\"...\" with " + wanted + " in it");
    Eigen::Matrix<double, size, 1> result;
    std::string_view rest = text;
    bool are_numbers = true;
    for (double& number : result)
      // NaN fails as well
      are_numbers = are_numbers && parse(next_word(rest), number) && std::abs(number) <= largest_value;
    if (!are_numbers || !trimmed(rest).empty())
      fail_at(link, "has a <" + kind + "> with " + name + "=" + cited(text) + ", which is not " + wanted +
                        " of at most 1e9; correct it or, if this is a xacro file, run the program xacro first");
    return result;
  }

  /// The numbers in an attribute, or `otherwise` if it is missing.
  template <int size>
  Eigen::Matrix<double, size, 1> numbers(const Element& element, const std::string& kind, const std::string& name,
                                         double otherwise, const std::string& link) const
  {
    if (attribute(element, name).empty()) return Eigen::Matrix<double, size, 1>::Constant(otherwise);
    return numbers<size>(element, kind, name, link);
  }

  /// The numbers in an attribute, which must be positive.
  template <int size>
  Eigen::Matrix<double, size, 1> lengths(const Element& element, const std::string& kind, const std::string& name,
                                         const std::string& link) const
  {
    const Eigen::Matrix<double, size, 1> result = numbers<size>(element, kind, name, link);
    if (result.minCoeff() <= 0)
      fail_at(link, "has a <" + kind + "> with " + name + "=" + cited(attribute(element, name)) +
                        ", which has no surface; write lengths over 0, in metres");
    return result;
  }

  Transform origin_of(const Element& element, const std::string& link) const
  {
    Transform result = Transform::Identity();
    const Element* const origin = child(element, "origin");
    if (!origin) return result;
    const Point turns = numbers<3>(*origin, "origin", "rpy", 0, link);
    result.translate(numbers<3>(*origin, "origin", "xyz", 0, link));
    for (int axis : {2, 1, 0})
      result.rotate(Eigen::AngleAxisd(turns[axis], Point(Point::Unit(axis))));
    return result;
  }

  void add_joint(const Element& joint)
  {
    const auto link_of = [&](const char* end) {
      const Element* const named = child(joint, end);
      const std::string name = named ? attribute(*named, "link") : "";
      if (links_.count(name) == 0)
        throw Invalid_input(file_ + ": joint " + cited(attribute(joint, "name")) + " has the " + end + " " +
                            cited(name) + ", which is no link; name one of the links");
      return name;
    };
    const std::string parent = link_of("parent"), link = link_of("child");
    if (!joints_.emplace(link, Joint{parent, origin_of(joint, link)}).second)
      fail_at(link, "is the child of two joints; remove one of them");
  }

  /// The pose of a link with all joints at 0.
  const Transform& place_of(const std::string& link)
  {
    std::vector<std::string> chain; // links from this one up to the first whose pose is known
    std::string at = link;
    while (places_.count(at) == 0) {
      const auto joint = joints_.find(at);
      if (joint == joints_.end()) {
        if (!places_.empty()) fail_at(link, "is not joined to all other links; add a joint");
        places_[at] = Transform::Identity();
        break;
      }
      chain.push_back(at);
      if (chain.size() > joints_.size())
        fail_at(link, "is the child of itself, by joints in a circle; remove one of them");
      at = joint->second.parent;
    }
    for (auto of_chain = chain.rbegin(); of_chain != chain.rend(); ++of_chain) {
      const Joint& joint = joints_.at(*of_chain);
      places_[*of_chain] = places_.at(joint.parent) * joint.origin;
    }
    return places_.at(link);
  }

  /// Adds a material, or refers to one of the robot by name. \return its index; -1: none
  /// \param link the link that has it; empty: the robot
  int add_material(const Element& element, const std::string& link)
  {
    const std::string name = attribute(element, "name");
    const Element* const colour = child(element, "color");
    if (!colour) {
      const auto found = materials_.find(name);
      if (found != materials_.end()) return found->second;
      if (!link.empty())
        content_.appearance_warnings.push_back("Link " + cited(link) + " has the material " + cited(name) +
                                               ", which has no <color>; it has no colour.");
      return -1;
    }
    const Eigen::Vector4d rgba = numbers<4>(*colour, "color", "rgba", link.empty() ? "material " + name : link);
    Surface_material material;
    material.name = name;
    material.colour << linear_colour(rgba.head<3>()), rgba[3];
    content_.materials.push_back(material);
    return materials_[name] = int(content_.materials.size()) - 1;
  }

  void add_link(const std::string& name, const Element& link)
  {
    Model_part part{name, {}};
    const Transform place = place_of(name);
    for (const auto& [kind, visual] : link) {
      if (kind != "visual") continue;
      const Element* const geometry = child(visual, "geometry");
      if (!geometry) fail_at(name, "has a <visual> without <geometry>; add one, or remove the <visual>");
      const Element* const of_visual = child(visual, "material");
      add_geometry(*geometry, place * origin_of(visual, name), of_visual ? add_material(*of_visual, name) : -1, part);
    }
    if (!part.corners.empty()) content_.parts.push_back(std::move(part));
  }

  void add_geometry(const Element& geometry, const Transform& place, int material, Model_part& part)
  {
    const std::string& link = part.name;
    if (const Element* const mesh = child(geometry, "mesh"))
      add_mesh(*mesh, place, material, part);
    else if (const Element* const brick = child(geometry, "box"))
      add_corners(box(lengths<3>(*brick, "box", "size", link)), place, {}, material, part);
    else if (const Element* const ball = child(geometry, "sphere"))
      add_corners(sphere(lengths<1>(*ball, "sphere", "radius", link)[0]), place, {}, material, part);
    else if (const Element* const roll = child(geometry, "cylinder")) {
      const double radius = lengths<1>(*roll, "cylinder", "radius", link)[0],
                   half = lengths<1>(*roll, "cylinder", "length", link)[0] / 2;
      add_corners(turned({{0, -half}, {radius, -half}, {radius, half}, {0, half}}), place, {}, material, part);
    } else
      fail_at(link, "has a <geometry> that is neither mesh, box, cylinder nor sphere; replace it by a mesh");
  }

  void add_corners(const std::vector<Point>& corners, const Transform& place, Part_appearance looks, int material,
                   Model_part& part)
  {
    triangles_ += corners.size() / 3;
    if (are_repeated_too_often(triangles_, bytes_)) throw Invalid_input(file_ + ": " + repeated_too_often);
    looks.materials.resize(corners.size() / 3, -1);
    for (int& of_triangle : looks.materials)
      if (of_triangle < 0) of_triangle = material;
    add_appearance(looks, corners.size() / 3, part.corners.size() / 3, part.appearance);
    for (const Point& corner : corners)
      part.corners.push_back(place * corner);
  }

  void add_mesh(const Element& mesh, const Transform& place, int material, Model_part& part)
  {
    const std::string uri = attribute(mesh, "filename");
    if (trimmed(uri).empty())
      fail_at(part.name, "has a <mesh> without filename; write filename=\"...\" with the mesh file in it");
    const Point scale = numbers<3>(mesh, "mesh", "scale", 1, part.name);
    if (scale.cwiseAbs().minCoeff() == 0)
      fail_at(part.name, "has a <mesh> with scale=" + cited(attribute(mesh, "scale")) +
                             ", which leaves no surface; write numbers other than 0");
    const std::string path = finder_.path_of(uri);
    if (path.empty())
      fail_at(part.name,
              "has the mesh " + cited_file(uri) +
                  ", which is not in the folder of the file or below; put it there, name the folder that has "
                  "all of the robot or, if it is elsewhere, set `Reading_options::allow_outside_files`");
    Transform scaled = place;
    scaled.scale(scale);
    for (const Model_part& object : mesh_of(path, part.name))
      add_corners(object.corners, scaled, object.appearance, material, part);
  }

  /// The objects of a file, which several links may use; its materials are added to the model's.
  const std::vector<Model_part>& mesh_of(const std::string& path, const std::string& link)
  {
    if (const auto found = meshes_.find(path); found != meshes_.end()) return found->second;
    if (!is_model_file(path) || lower_extension(path) == ".urdf")
      fail_at(link, "has the mesh " + cited_file(path) + ", of a format that is not read; save it as STL, OBJ or GLB");
    Model_content content;
    try {
      content = read_(path);
    } catch (const Invalid_input& error) {
      throw Invalid_input(file_ + ": link " + cited(link) + ": " + error.what());
    }
    bytes_ += fs::file_size(path);
    const Eigen::Matrix3d turn = turn_back(path);
    for (Model_part& part : content.parts)
      for (Point& corner : part.corners)
        corner = turn * corner;
    content_.faces_left_out += content.faces_left_out;
    append_appearance(content, content_);
    return meshes_[path] = std::move(content.parts);
  }

  const std::string& file_;
  std::uint64_t bytes_, triangles_ = 0;
  const Mesh_finder& finder_;
  const Mesh_reader& read_;
  Model_content content_;
  std::map<std::string, const Element*> links_;
  std::map<std::string, Joint> joints_; ///< indexed by child link
  std::map<std::string, int> materials_;
  std::map<std::string, std::vector<Model_part>> meshes_;
  std::map<std::string, Transform> places_;
};

} // namespace

Model_content read_urdf_parts(const std::string& text, const std::string& file, const std::string& folder,
                              const Reading_options& options, const Mesh_reader& read)
{
  if (text.size() > internal::largest_document)
    throw Invalid_input(file + ": it is longer than " + std::to_string(internal::largest_document >> 20) +
                        " MB; remove the links that are not needed");
  const Element document = parse_xml(text, file);
  const Element* const robot = child(document, "robot");
  if (!robot) throw Invalid_input(file + ": it has no <robot>; give a URDF file");
  const Mesh_finder finder(file, folder, options);
  return Urdf_reader(file, text.size(), finder, read).read(*robot);
}

} // namespace CGAL::Shape_correspondence::IO
