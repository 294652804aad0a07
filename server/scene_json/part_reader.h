#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "scene/scene.h"
#include "scene_json/scope.h"

namespace texbrdf::scene_json {

/// Trees of objects, with the place of each node.
struct Tree {
  std::vector<scene::Node> nodes;
  std::vector<Origin> origins;
};

struct Placed {
  scene::NodeId node;
  uint32_t height = 1;  ///< levels
};

/// A model with all that it uses, ready to be copied.
struct ModelTree {
  Tree tree;
  Placed root;
};

/// Reads primitives, shaders, materials and models, each once, and puts them into a scene.
class PartReader {
 public:
  PartReader(FileTable& table, Problems& problems, scene::Scene& scene)
      : table_(table), problems_(problems), scene_(scene) {}

  // Nothing where there is an error, which has been reported; so everywhere here.
  std::optional<scene::UserPrimitiveId> primitive(const Origin& part);
  std::optional<scene::ShaderId> shader(const Origin& part);
  /// The BRDF that `root` names in the document, or the one that the document says where it is empty.
  std::optional<scene::ShaderId> document(const std::string& path, const std::string& root, const Origin& where);
  std::optional<scene::MaterialId> material(const Origin& part);
  /// nullptr where there is an error.
  const ModelTree* model(const Origin& part);

  /// Reads the lists and all that they declare.
  Scope scope(FileReader& reader, ObjectReader& object);
  /// A tree of objects; nodes go to `tree`.
  std::optional<Placed> node(FileReader& reader, const Scope& scope, JsonId id, Tree& tree, uint32_t depth);

 private:
  friend class NodeReader;
  template <typename T>
  using Known = std::map<Origin, std::optional<T>>;

  std::optional<scene::UserPrimitiveId> read_primitive(const Origin& part);
  std::optional<scene::ShaderId> read_shader(const Origin& part);
  std::optional<scene::ShaderId> read_document(const std::string& path, const std::string& root, const Origin& where);
  std::optional<scene::MaterialId> read_material(const Origin& part);
  std::optional<scene::ShaderId> base_shader(FileReader& reader, const Origin& part, JsonId id,
                                             const std::string& root);
  /// The lists of the file that the part stands in; none where the part is the whole file.
  const Scope& scope_of_file(const Origin& part);
  void read_values(FileReader& reader, JsonId list, scene::Material& material);
  std::optional<ModelTree> read_model(const Origin& part);

  FileTable& table_;
  Problems& problems_;
  scene::Scene& scene_;
  std::map<const JsonFile*, Scope> scopes_;
  Known<scene::UserPrimitiveId> primitives_;
  Known<scene::ShaderId> shaders_;
  Known<scene::MaterialId> materials_;
  std::map<std::pair<std::string, std::string>, std::optional<scene::ShaderId>> documents_;
  std::map<Origin, std::optional<ModelTree>> models_;
  std::vector<Origin> inside_;                              // the models that are being read
  std::map<uint32_t, Origin> primitive_ids_;                // by id
  std::map<uint32_t, std::vector<std::string>> spellings_;  // of a document's constants, by shader and property
};

}  // namespace texbrdf::scene_json
