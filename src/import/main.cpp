// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

// The program shape_correspondence_import FILE inside|outside: reads a model file with assimp, or glTF with compressed
// meshes with their codecs, and writes the content in the format of io/read/model_stream.h. It is a separate program
// since these libraries are not robust against damaged files: some crash them, some make them exhaust memory.

#include "import/beside_assimp.h"
#include "io/read/model_parts.h"
#include "io/read/model_stream.h"
#include "io/read/text_words.h"
#include "io/system/colours.h"
#include "io/system/input_file.h"

#include <assimp/DefaultIOSystem.h>
#include <assimp/Importer.hpp>
#include <assimp/config.h>
#include <assimp/material.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <iostream>
#include <iterator>
#include <new>
#include <sys/resource.h>
#include <unistd.h>
#ifdef __linux__
#include <csignal>
#include <sys/prctl.h>
#endif

// Sanitizers reserve terabytes of memory, so that memory cannot be limited then
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define SHAPE_CORRESPONDENCE_SHADOW_MEMORY
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define SHAPE_CORRESPONDENCE_SHADOW_MEMORY
#endif
#endif

// The tree of nodes and their names are kept as in the file: assimp's steps that merge nodes or meshes would lose the
// parts. COLLADA files give the upright axis; assimp's root node rotates them to y up.

namespace CGAL::Shape_correspondence::IO {
namespace {

using Transform = Eigen::Matrix4d;

Transform transform_of(const aiNode& node)
{
  const aiMatrix4x4& m = node.mTransformation;
  Transform result;
  result << m.a1, m.a2, m.a3, m.a4, m.b1, m.b2, m.b3, m.b4, m.c1, m.c2, m.c3, m.c4, m.d1, m.d2, m.d3, m.d4;
  return result;
}

class Scene_reader
{
public:
  /// \param bytes for `are_repeated_too_often()`: size of the file, or number of triangles of all meshes
  Scene_reader(const aiScene& scene, std::uint64_t bytes) : scene_(scene), bytes_(bytes) {}

  /// Reads the scene. \param are_linear whether colours are in linear light rather than sRGB
  Model_content read(bool are_linear)
  {
    for (unsigned i = 0; i < scene_.mNumMaterials; ++i)
      add_material(*scene_.mMaterials[i], are_linear);
    visit(*scene_.mRootNode, -1, Transform::Identity());
    name_parts_by_tree(tree_, node_of_part_, meshes_, content_.parts);
    if (!are_linear)
      for (Model_part& part : content_.parts)
        for (Eigen::Vector3f& colour : part.appearance.colours)
          colour = linear_colour(colour.cast<double>()).cast<float>();
    return std::move(content_);
  }

private:
  void add_material(const aiMaterial& of_file, bool is_linear)
  {
    Surface_material material;
    material.name = of_file.GetName().C_Str();
    channels_.push_back(0);
    aiColor4D colour;
    if (of_file.Get(AI_MATKEY_BASE_COLOR, colour) == AI_SUCCESS ||
        of_file.Get(AI_MATKEY_COLOR_DIFFUSE, colour) == AI_SUCCESS) {
      const Colour rgb(colour.r, colour.g, colour.b);
      material.colour.head<3>() = is_linear ? rgb : linear_colour(rgb);
      material.colour[3] = colour.a;
    }
    ai_real opacity = 1;
    if (!is_linear && of_file.Get(AI_MATKEY_OPACITY, opacity) == AI_SUCCESS) material.colour[3] = opacity;
    for (aiTextureType type : {aiTextureType_BASE_COLOR, aiTextureType_DIFFUSE}) {
      aiString path;
      if (of_file.GetTexture(type, 0, &path) != AI_SUCCESS || path.length == 0) continue;
      material.texture = add_texture(of_file, type, path);
      int channel = 0;
      if (of_file.Get(AI_MATKEY_UVWSRC(type, 0), channel) == AI_SUCCESS && channel > 0) channels_.back() = channel;
      if (!is_linear) material.colour.head<3>().setOnes(); // the texture replaces the colour, as in modelling programs
      break;
    }
    content_.materials.push_back(material);
  }

  int add_texture(const aiMaterial& material, aiTextureType type, const aiString& path)
  {
    Texture texture{path.C_Str(), "", {}};
    if (const aiTexture* inside = scene_.GetEmbeddedTexture(path.C_Str()); inside && inside->mHeight == 0)
      texture.bytes.assign(reinterpret_cast<const char*>(inside->pcData), inside->mWidth);
    const auto wrap = [&](const char* key) {
      int mode = aiTextureMapMode_Wrap;
      material.Get(key, type, 0, mode);
      return mode == aiTextureMapMode_Mirror  ? Texture_wrap::MIRROR
             : mode == aiTextureMapMode_Clamp ? Texture_wrap::CLAMP
                                              : Texture_wrap::REPEAT;
    };
    texture.wrap_u = wrap(_AI_MATKEY_MAPPINGMODE_U_BASE);
    texture.wrap_v = wrap(_AI_MATKEY_MAPPINGMODE_V_BASE);
    const auto is_same = [&](const Texture& other) {
      return other.name == texture.name && other.wrap_u == texture.wrap_u && other.wrap_v == texture.wrap_v;
    };
    const auto found = std::find_if(content_.textures.begin(), content_.textures.end(), is_same);
    if (found != content_.textures.end()) return int(found - content_.textures.begin());
    content_.textures.push_back(std::move(texture));
    return int(content_.textures.size()) - 1;
  }

  void visit(const aiNode& node, int parent, const Transform& of_parent)
  {
    const Transform to_world = of_parent * transform_of(node);
    const int number = int(tree_.size());
    tree_.push_back({parent, node.mName.C_Str()});
    Model_part part{node.mName.C_Str(), {}};
    for (unsigned i = 0; i < node.mNumMeshes; ++i)
      add_mesh(*scene_.mMeshes[node.mMeshes[i]], to_world, part);
    if (!part.corners.empty()) {
      content_.parts.push_back(std::move(part));
      node_of_part_.push_back(number);
      meshes_.push_back(scene_.mMeshes[node.mMeshes[0]]->mName.C_Str());
    } else if (node.mNumMeshes > 0) {
      content_.without_faces.push_back(part.name);
    }
    for (unsigned i = 0; i < node.mNumChildren; ++i)
      visit(*node.mChildren[i], number, to_world);
  }

  void add_mesh(const aiMesh& mesh, const Transform& to_world, Model_part& part)
  {
    triangles_ += mesh.mNumFaces;
    if (are_repeated_too_often(triangles_, bytes_)) throw Invalid_input(repeated_too_often);
    for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
      const aiFace& face = mesh.mFaces[f];
      if (face.mNumIndices != 3) { // points and lines; polygons are already triangulated
        ++content_.faces_left_out;
        continue;
      }
      for (unsigned k = 0; k < 3; ++k)
        part.corners.push_back(vertex(mesh, face.mIndices[k], to_world, part.name));
      add_appearance(mesh, face, part);
    }
  }

  /// Adds the texture coordinates and colours of the last triangle; earlier triangles without them get defaults.
  void add_appearance(const aiMesh& mesh, const aiFace& face, Model_part& part) const
  {
    Part_appearance& looks = part.appearance;
    const std::size_t before = part.corners.size() - 3;
    const bool has_material = mesh.mMaterialIndex < content_.materials.size() &&
                              content_.materials[mesh.mMaterialIndex].name != AI_DEFAULT_MATERIAL_NAME;
    looks.materials.push_back(has_material ? int(mesh.mMaterialIndex) : -1);
    int channel = mesh.mMaterialIndex < channels_.size() ? channels_[mesh.mMaterialIndex] : 0;
    if (!mesh.HasTextureCoords(unsigned(channel))) channel = 0;
    if (mesh.HasTextureCoords(unsigned(channel)) || !looks.coordinates.empty()) {
      looks.coordinates.resize(before, Eigen::Vector2f(0, 0));
      for (unsigned k = 0; k < 3; ++k) {
        const aiVector3D at =
            mesh.HasTextureCoords(unsigned(channel)) ? mesh.mTextureCoords[channel][face.mIndices[k]] : aiVector3D();
        looks.coordinates.emplace_back(at.x, 1 - at.y);
      }
    }
    if (mesh.HasVertexColors(0) || !looks.colours.empty()) {
      looks.colours.resize(before, Eigen::Vector3f(1, 1, 1));
      for (unsigned k = 0; k < 3; ++k) {
        const aiColor4D colour = mesh.HasVertexColors(0) ? mesh.mColors[0][face.mIndices[k]] : aiColor4D(1, 1, 1, 1);
        looks.colours.emplace_back(colour.r, colour.g, colour.b);
      }
    }
  }

  Point vertex(const aiMesh& mesh, unsigned index, const Transform& to_world, const std::string& name) const
  {
    if (index >= mesh.mNumVertices)
      throw Invalid_input("part '" + name + "' has a face that uses vertex " + std::to_string(index) + ", but only " +
                          std::to_string(mesh.mNumVertices) + " vertices");
    const aiVector3D& v = mesh.mVertices[index];
    return (to_world * Eigen::Vector4d(v.x, v.y, v.z, 1)).head<3>();
  }

  const aiScene& scene_;
  std::uint64_t bytes_, triangles_ = 0;
  Model_content content_;
  std::vector<int> channels_; ///< for each material, the index of its set of texture coordinates
  std::vector<Tree_node> tree_;
  std::vector<int> node_of_part_;
  std::vector<std::string> meshes_; ///< names of the parts' meshes
};

/// Opens regular files only, since a pipe named by a model may never end; by default, only those in the model's folder.
class Model_files : public Assimp::IOSystem
{
public:
  Model_files(const std::string& file, bool allows_outside) : file_(file), allows_outside_(allows_outside) {}

  bool Exists(const char* path) const override { return is_allowed(path) && system_.Exists(path); }
  char getOsSeparator() const override { return system_.getOsSeparator(); }
  void Close(Assimp::IOStream* stream) override { system_.Close(stream); }
  bool ComparePaths(const char* one, const char* other) const override { return system_.ComparePaths(one, other); }

  Assimp::IOStream* Open(const char* path, const char* mode) override
  {
    std::error_code error;
    if (missing_.empty() && !std::filesystem::exists(path, error)) missing_ = path;
    return is_allowed(path) && mode[0] == 'r' ? system_.Open(path, mode) : nullptr;
  }

  /// The first file that was missing when it was to be opened; empty: none.
  const std::string& missing() const { return missing_; }

private:
  bool is_allowed(const char* path) const
  {
    std::error_code error;
    return std::filesystem::is_regular_file(path, error) &&
           (allows_outside_ || path == file_ || is_in_folder_of(file_, path));
  }

  Assimp::DefaultIOSystem system_; // a member and not a base class, which assimp 6 declares final
  std::string file_, missing_;
  bool allows_outside_;
};

/// The number of faces of all meshes; the size of the file says little, as buffers may be compressed or in other files.
std::uint64_t triangles_of(const aiScene& scene)
{
  std::uint64_t result = 0;
  for (unsigned i = 0; i < scene.mNumMeshes; ++i)
    result += scene.mMeshes[i]->mNumFaces;
  return result;
}

std::string text_of(const std::string& file)
{
  std::ifstream in = open_input(file);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// The upright axis given by an FBX file; zero if it gives none and assimp only reports its default.
Point up_of_fbx(const aiScene& scene, const std::string& file)
{
  std::int32_t axis = 0, sign = 1;
  if (!scene.mMetaData || !scene.mMetaData->Get("UpAxis", axis) || axis < 0 || axis > 2) return Point::Zero();
  if (text_of(file).find("UpAxis") == std::string::npos) return Point::Zero();
  scene.mMetaData->Get("UpAxisSign", sign);
  return (sign < 0 ? -1 : 1) * Point::Unit(axis);
}

constexpr const char* not_readable =
    "it cannot be read as a model of the format that its extension says: it is damaged, or of another version or kind";

Model_content read_scene(const std::string& file, bool allows_outside)
{
  const std::string extension = lower_extension(file);
  const bool is_3mf = extension == ".3mf", is_gltf = extension == ".gltf" || extension == ".glb";
  const auto names = is_3mf ? names_in_3mf(file) : std::map<std::string, std::string>();
  Assimp::Importer importer;
  const auto files = new Model_files(file, allows_outside); // the importer deletes it
  importer.SetIOHandler(files);
  importer.SetPropertyInteger(AI_CONFIG_IMPORT_COLLADA_USE_COLLADA_NAMES, 1);
  importer.SetPropertyInteger(AI_CONFIG_IMPORT_FBX_PRESERVE_PIVOTS, 0); // pivots would become nodes
  const aiScene* const scene =
      importer.ReadFile(file, aiProcess_Triangulate | aiProcess_SortByPType | aiProcess_TransformUVCoords);
  if ((!scene || !scene->mRootNode) && !files->missing().empty())
    throw Invalid_input("the file " + cited_file(files->missing()) +
                        ", which it names, is not there; put it beside the model");
  if (!scene || !scene->mRootNode) {
    const std::string why = importer.GetErrorString();
    if (why.find(std::bad_alloc().what()) != std::string::npos) throw std::bad_alloc();
    throw Invalid_input(not_readable);
  }
  if (extension == ".fbx") scene->mRootNode->mTransformation = aiMatrix4x4(); // newer assimp rotates it to y up
  Model_content content =
      Scene_reader(*scene, is_gltf ? triangles_of(*scene) : std::filesystem::file_size(file)).read(is_gltf);
  for (Model_part& part : content.parts)
    if (const auto found = names.find(part.name); found != names.end()) part.name = found->second;
  if (content.parts.empty()) throw Invalid_input("there is no triangle in it; give every part a mesh");
  if (extension == ".fbx") content.up = up_of_fbx(*scene, file);
  if (is_3mf) content.up = Point::UnitZ(); // defined by the format
  return content;
}

/// The message without the name of the file, which the program that reads the message puts before it.
std::string without_file(const std::string& message, const std::string& file)
{
  return begins_with(message, file + ": ") ? message.substr(file.size() + 2) : message;
}

/// Reads the content of a model file. \param allows_outside whether files that it names may be outside its folder
Model_content read_model(const std::string& file, bool allows_outside)
{
  const std::string extension = lower_extension(file);
  if (extension != ".gltf" && extension != ".glb") return read_scene(file, allows_outside);
  try {
    const Gltf_codecs codecs = gltf_codecs();
    return read_gltf(text_of(file), file, Reading_options{allows_outside, {}}, &codecs);
  } catch (const Needs_import&) {
    return read_scene(file, allows_outside); // glTF 1.0
  } catch (const Invalid_input& error) {
    throw Invalid_input(without_file(error.what(), file));
  }
}

template <typename Resource>
void set_limit(Resource resource, rlim_t limit)
{
  rlimit own;
  getrlimit(resource, &own);
  own.rlim_cur = std::min(limit, own.rlim_max);
  setrlimit(resource, &own);
}

void set_limits()
{
  constexpr rlim_t bytes = rlim_t(2) << 30, seconds_of_processor = 60;
#ifndef SHAPE_CORRESPONDENCE_SHADOW_MEMORY
  set_limit(RLIMIT_DATA, bytes);
#endif
  set_limit(RLIMIT_CPU, seconds_of_processor);
  set_limit(RLIMIT_CORE, 0);
#ifdef __linux__
  prctl(PR_SET_PDEATHSIG, SIGKILL); // ends this program with the one that started it
#endif
}

void write(Model_content content)
{
  Value_bytes written;
  pass(written, content);
  std::cout << has_content << written.bytes;
}

} // namespace
} // namespace CGAL::Shape_correspondence::IO

int main(int argc, char* argv[])
{
  using namespace CGAL::Shape_correspondence;
  if (argc != 3) {
    std::cerr << "shape_correspondence_import: a part of shape_correspondence, which reads model files with it\n";
    return 2;
  }
  IO::set_limits();
  try {
    std::cout << IO::import_mark;
    try {
      IO::write(IO::read_model(argv[1], argv[2] == std::string("outside")));
    } catch (const Invalid_input& error) {
      std::cout << IO::has_complaint << error.what();
    } catch (const std::bad_alloc&) {
      throw;
    } catch (const std::exception&) { // assimp's messages address programmers
      std::cout << IO::has_complaint << IO::not_readable;
    }
  } catch (const std::bad_alloc&) {
    return IO::out_of_memory_status;
  }
  return std::cout.flush() ? 0 : 1;
}
