// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "io/read/assimp_functions.h"
#include "io/system/colours.h"
#include "io/system/input_file.h"
#include "io/system/isolated.h"
#include "io/read/model_parts.h"

#include <CGAL/Shape_correspondence/Invalid_input.h>

#include <assimp/cfileio.h>
#include <assimp/config.h>
#include <assimp/material.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <memory>
#include <type_traits>

// What is left as it is in the file: the tree of nodes with their names. Steps of assimp that merge nodes or meshes
// would lose the parts. COLLADA files say which way is up; assimp's root node turns them to y up.

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
  Scene_reader(const std::string& file, const Assimp_functions& assimp, const aiScene& scene)
      : file_(file), assimp_(assimp), scene_(scene)
  {}

  /// \param are_linear whether colours are linear light, not as screens have them
  Model_content read(bool are_linear)
  {
    for (unsigned i = 0; i < scene_.mNumMaterials; ++i)
      add_material(*scene_.mMaterials[i], are_linear);
    visit(*scene_.mRootNode, Transform::Identity());
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
    aiString name;
    if (assimp_.material_string(&of_file, AI_MATKEY_NAME, &name) == AI_SUCCESS) material.name = name.C_Str();
    aiColor4D colour;
    if (assimp_.material_colour(&of_file, AI_MATKEY_BASE_COLOR, &colour) == AI_SUCCESS ||
        assimp_.material_colour(&of_file, AI_MATKEY_COLOR_DIFFUSE, &colour) == AI_SUCCESS) {
      const Colour rgb(colour.r, colour.g, colour.b);
      material.colour.head<3>() = is_linear ? rgb : linear_colour(rgb);
      material.colour[3] = colour.a;
    }
    ai_real opacity = 1;
    if (!is_linear && assimp_.material_numbers(&of_file, AI_MATKEY_OPACITY, &opacity, nullptr) == AI_SUCCESS)
      material.colour[3] = opacity;
    for (aiTextureType type : {aiTextureType_BASE_COLOR, aiTextureType_DIFFUSE}) {
      aiString path;
      const aiReturn found =
          assimp_.material_texture(&of_file, type, 0, &path, nullptr, nullptr, nullptr, nullptr, nullptr, nullptr);
      if (found != AI_SUCCESS || path.length == 0) continue;
      material.texture = add_texture(of_file, type, path);
      if (!is_linear) material.colour.head<3>().setOnes(); // as programs for modelling take it
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
      assimp_.material_integers(&material, key, type, 0, &mode, nullptr);
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

  void visit(const aiNode& node, const Transform& parent)
  {
    const Transform to_world = parent * transform_of(node);
    Model_part part{node.mName.C_Str(), {}};
    for (unsigned i = 0; i < node.mNumMeshes; ++i)
      add_mesh(*scene_.mMeshes[node.mMeshes[i]], to_world, part);
    if (!part.corners.empty()) content_.parts.push_back(std::move(part));
    for (unsigned i = 0; i < node.mNumChildren; ++i)
      visit(*node.mChildren[i], to_world);
  }

  void add_mesh(const aiMesh& mesh, const Transform& to_world, Model_part& part)
  {
    for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
      const aiFace& face = mesh.mFaces[f];
      if (face.mNumIndices != 3) { // points and lines; polygons are triangles by now
        ++content_.faces_left_out;
        continue;
      }
      for (unsigned k = 0; k < 3; ++k)
        part.corners.push_back(vertex(mesh, face.mIndices[k], to_world, part.name));
      add_looks(mesh, face, part);
    }
  }

  /// Of the last triangle; those before it that have none get some where it is the first that has.
  void add_looks(const aiMesh& mesh, const aiFace& face, Model_part& part) const
  {
    Part_appearance& looks = part.appearance;
    const std::size_t before = part.corners.size() - 3;
    const bool has_material = mesh.mMaterialIndex < content_.materials.size() &&
                              content_.materials[mesh.mMaterialIndex].name != AI_DEFAULT_MATERIAL_NAME;
    looks.materials.push_back(has_material ? int(mesh.mMaterialIndex) : -1);
    if (mesh.HasTextureCoords(0) || !looks.coordinates.empty()) {
      looks.coordinates.resize(before, Eigen::Vector2f(0, 0));
      for (unsigned k = 0; k < 3; ++k) {
        const aiVector3D at = mesh.HasTextureCoords(0) ? mesh.mTextureCoords[0][face.mIndices[k]] : aiVector3D();
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
      throw Invalid_input(file_ + ": part '" + name + "' has a face that uses vertex " + std::to_string(index) +
                          ", but only " + std::to_string(mesh.mNumVertices) + " vertices");
    const aiVector3D& v = mesh.mVertices[index];
    return (to_world * Eigen::Vector4d(v.x, v.y, v.z, 1)).head<3>();
  }

  std::string file_;
  const Assimp_functions& assimp_;
  const aiScene& scene_;
  Model_content content_;
};

// How assimp gets at files

struct Opened_file : aiFile
{
  std::FILE* stream;
};

std::FILE* stream_of(aiFile* file) { return static_cast<Opened_file*>(file)->stream; }

std::size_t size_of(aiFile* file)
{
  const long place = std::ftell(stream_of(file));
  std::fseek(stream_of(file), 0, SEEK_END);
  const long size = std::ftell(stream_of(file));
  std::fseek(stream_of(file), place, SEEK_SET);
  return std::size_t(size);
}

/// Knows regular files only: a pipe that a model names may never end.
aiFile* open_for_assimp(aiFileIO*, const char* path, const char* mode)
{
  std::error_code error;
  std::FILE* const stream = std::filesystem::is_regular_file(path, error) ? std::fopen(path, mode) : nullptr;
  if (!stream) return nullptr;
  auto file = std::make_unique<Opened_file>();
  file->stream = stream;
  file->ReadProc = [](aiFile* from, char* to, std::size_t size, std::size_t count) {
    return std::fread(to, size, count, stream_of(from));
  };
  file->WriteProc = [](aiFile*, const char*, std::size_t, std::size_t) { return std::size_t(0); };
  file->TellProc = [](aiFile* of) { return std::size_t(std::ftell(stream_of(of))); };
  file->FileSizeProc = size_of;
  file->SeekProc = [](aiFile* in, std::size_t offset, aiOrigin origin) {
    const int from = origin == aiOrigin_SET ? SEEK_SET : origin == aiOrigin_CUR ? SEEK_CUR : SEEK_END;
    return std::fseek(stream_of(in), long(offset), from) == 0 ? aiReturn_SUCCESS : aiReturn_FAILURE;
  };
  file->FlushProc = [](aiFile*) {};
  return file.release();
}

void close_for_assimp(aiFileIO*, aiFile* file)
{
  const std::unique_ptr<Opened_file> closed(static_cast<Opened_file*>(file));
  std::fclose(closed->stream);
}

Model_content read_scene(const std::string& file, const Assimp_functions& assimp)
{
  const std::unique_ptr<aiPropertyStore, decltype(assimp.release_property_store)> properties(
      assimp.create_property_store(), assimp.release_property_store);
  assimp.set_property(properties.get(), AI_CONFIG_IMPORT_COLLADA_USE_COLLADA_NAMES, 1);
  assimp.set_property(properties.get(), AI_CONFIG_IMPORT_FBX_PRESERVE_PIVOTS, 0); // they would be nodes of their own
  aiFileIO files{open_for_assimp, close_for_assimp, nullptr};
  const std::unique_ptr<const aiScene, decltype(assimp.release_import)> scene(
      assimp.import_file(file.c_str(), aiProcess_Triangulate | aiProcess_SortByPType, &files, properties.get()),
      assimp.release_import);
  if (!scene || !scene->mRootNode)
    throw Invalid_input(file + ": it cannot be read as a model of the format that its extension says (" +
                        assimp.error_string() + ")");
  const std::string extension = lower_extension(file);
  Model_content content = Scene_reader(file, assimp, *scene).read(extension == ".gltf" || extension == ".glb");
  if (content.parts.empty())
    throw Invalid_input(file + ": there is no triangle in it; a model needs a mesh for every part");
  return content;
}

// The content in bytes, from one process to the other

void append(std::uint64_t number, std::string& bytes)
{
  bytes.append(reinterpret_cast<const char*>(&number), sizeof number);
}

template <typename Values>
void append_values(const Values& values, std::string& bytes)
{
  append(values.size(), bytes);
  bytes.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(*values.data()));
}

std::string encoded(const Model_content& content)
{
  std::string bytes;
  append(content.faces_left_out, bytes);
  append(content.materials.size(), bytes);
  for (const Surface_material& material : content.materials) {
    append_values(material.name, bytes);
    append_values(std::array<double, 4>{material.colour[0], material.colour[1], material.colour[2], material.colour[3]},
                  bytes);
    append(std::uint64_t(std::int64_t(material.texture) + 1), bytes);
  }
  append(content.textures.size(), bytes);
  for (const Texture& texture : content.textures) {
    append_values(texture.name, bytes);
    append_values(texture.bytes, bytes);
    append(std::uint64_t(texture.wrap_u), bytes);
    append(std::uint64_t(texture.wrap_v), bytes);
  }
  for (const Model_part& part : content.parts) {
    append_values(part.name, bytes);
    append_values(part.corners, bytes);
    append_values(part.appearance.materials, bytes);
    append_values(part.appearance.coordinates, bytes);
    append_values(part.appearance.colours, bytes);
  }
  return bytes;
}

/// Throws where the bytes are not those of a content.
class Decoder
{
public:
  Decoder(const std::string& bytes, const std::string& file) : bytes_(bytes), file_(file) {}

  Model_content operator()()
  {
    Model_content content;
    content.faces_left_out = number();
    content.materials.resize(number());
    for (Surface_material& material : content.materials) {
      std::vector<double> colour;
      take(material.name);
      take(colour);
      if (colour.size() != 4) fail();
      material.colour = Eigen::Vector4d(colour.data());
      material.texture = int(number()) - 1;
    }
    content.textures.resize(number());
    for (Texture& texture : content.textures) {
      take(texture.name);
      take(texture.bytes);
      texture.wrap_u = wrap();
      texture.wrap_v = wrap();
    }
    while (at_ < bytes_.size()) {
      Model_part part;
      take(part.name);
      take(part.corners);
      take(part.appearance.materials);
      take(part.appearance.coordinates);
      take(part.appearance.colours);
      content.parts.push_back(std::move(part));
    }
    return content;
  }

private:
  [[noreturn]] void fail() const { throw Invalid_input(file_ + ": it makes its reader crash; it is damaged"); }

  std::uint64_t number()
  {
    std::uint64_t result = 0;
    take(&result, sizeof result);
    if (result > bytes_.size()) fail();
    return result;
  }

  Texture_wrap wrap()
  {
    const std::uint64_t result = number();
    if (result > std::uint64_t(Texture_wrap::CLAMP)) fail();
    return Texture_wrap(result);
  }

  template <typename Values>
  void take(Values& values)
  {
    using Value = std::remove_reference_t<decltype(*values.data())>;
    const std::uint64_t size = number();
    if (size > (bytes_.size() - at_) / sizeof(Value)) fail();
    values.resize(size);
    take(values.data(), size * sizeof(Value));
  }

  void take(void* place, std::size_t size)
  {
    if (size > bytes_.size() - at_) fail();
    if (size > 0) std::memcpy(place, bytes_.data() + at_, size); // an empty vector may have no place
    at_ += size;
  }

  const std::string& bytes_;
  const std::string& file_;
  std::size_t at_ = 0;
};

const Assimp_functions& assimp_of(const std::string& file)
{
  try {
    return assimp_functions();
  } catch (const Invalid_input& error) {
    throw Invalid_input(file + ": " + error.what());
  }
}

} // namespace

Model_content read_parts_with_assimp(const std::string& file)
{
  const Assimp_functions& assimp = assimp_of(file); // here, such that the processes have it loaded
  // assimp is not made for damaged files: some end it, some make it take all memory
  const std::string bytes = run_isolated(file, [&] { return encoded(read_scene(file, assimp)); });
  return Decoder(bytes, file)();
}

} // namespace CGAL::Shape_correspondence::IO
