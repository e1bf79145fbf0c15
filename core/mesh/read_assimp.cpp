// Formats that are not ours (glTF, Collada, 3DS, FBX ...), by Assimp, and its answer checked like any file's.
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <assimp/Importer.hpp>
#include <cmath>

#include "core/base/error.h"
#include "core/mesh/mesh_readers.h"
#include "core/mesh/text_lines.h"

namespace seesaw {

namespace {

class SceneWalk {
 public:
  SceneWalk(const aiScene& scene, const std::string& name) : scene_(scene), name_(name) {}

  PolygonSoup soup() {
    if (scene_.mRootNode) walk(*scene_.mRootNode, aiMatrix4x4());
    return std::move(soup_);
  }

 private:
  void walk(const aiNode& node, const aiMatrix4x4& parent) {
    const aiMatrix4x4 to_world = parent * node.mTransformation;
    for (unsigned i = 0; i < node.mNumMeshes; ++i) add(*scene_.mMeshes[node.mMeshes[i]], to_world);
    for (unsigned i = 0; i < node.mNumChildren; ++i) walk(*node.mChildren[i], to_world);
  }

  void add(const aiMesh& mesh, const aiMatrix4x4& to_world) {
    const auto first = static_cast<long long>(soup_.vertices());
    const std::string what = "mesh " + in_quotes(mesh.mName.C_Str());
    for (unsigned v = 0; v < mesh.mNumVertices; ++v) {
      const aiVector3D p = to_world * mesh.mVertices[v];
      for (const float x : {p.x, p.y, p.z}) {
        if (!std::isfinite(x))
          throw FileError(name_, what + ": vertex " + std::to_string(v) + " is not finite");
        soup_.coordinates.push_back(x);
      }
    }
    // A mirroring node turns every face inside out.
    const bool mirrored = to_world.Determinant() < 0;
    for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
      const aiFace& face = mesh.mFaces[f];
      for (unsigned k = 0; k < face.mNumIndices; ++k) {
        const unsigned v = face.mIndices[mirrored ? face.mNumIndices - 1 - k : k];
        if (v >= mesh.mNumVertices)
          throw FileError(name_, what + ": face " + std::to_string(f) + " refers to vertex " +
                                     std::to_string(v) + " of " + std::to_string(mesh.mNumVertices));
        soup_.corners.push_back(static_cast<int>(first + v));
      }
      soup_.end_polygon();
    }
  }

  const aiScene& scene_;
  const std::string& name_;
  PolygonSoup soup_;
};

}  // namespace

bool assimp_reads(const std::string& ending) { return Assimp::Importer().IsExtensionSupported(ending); }

PolygonSoup read_by_assimp(const std::filesystem::path& path) {
  const std::string name = path.string();
  Assimp::Importer importer;
  const aiScene* scene = importer.ReadFile(name, 0);
  if (!scene || (scene->mFlags & AI_SCENE_FLAGS_INCOMPLETE)) {
    std::string why = importer.GetErrorString();
    for (char& c : why)
      if (c < ' ' || c > '~') c = ' ';
    throw FileError(name,
                    "cannot be read" + (why.empty() ? std::string(": it holds no meshes") : ": " + why));
  }
  return SceneWalk(*scene, name).soup();
}

}  // namespace seesaw
