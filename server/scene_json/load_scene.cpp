#include "scene_json/load_scene.h"

#include <fmt/format.h>

#include <optional>
#include <string_view>
#include <utility>

#include "scene/check.h"
#include "scene_json/part_reader.h"
#include "scene_json/values.h"

namespace texbrdf::scene_json {
namespace {

/// Where an object has what a fault is about; empty: the object as a whole.
std::string_view key_of(scene::Part part) {
  switch (part) {
    case scene::Part::NodeKind:
      return "type";
    case scene::Part::NodeData:
      return "data";
    case scene::Part::NodeTransform:
      return "transform";
    case scene::Part::NodeMaterial:
      return "material_id";
    case scene::Part::NodeChildren:
      return "children";
    case scene::Part::Camera:
      return "camera";
    case scene::Part::LightSource:
      return "lights";
    case scene::Part::Environment:
      return "environment";
    case scene::Part::Settings:
      return "render";
    case scene::Part::Scene:
    case scene::Part::NodeDynamic:
    case scene::Part::UserPrimitive:
    case scene::Part::Shader:
    case scene::Part::Property:
    case scene::Part::Material:
    case scene::Part::MaterialValue:
      return {};
  }
  return {};
}

std::optional<JsonId> member_of(const Origin& object, std::string_view key) {
  for (const JsonId id : object.file->tree[object.id].elements) {
    if (object.file->tree[id].key == key && !key.empty()) return id;
  }
  return std::nullopt;
}

/// Reads the file of a scene, or makes a scene that shows what another file holds.
class SceneReader {
 public:
  explicit SceneReader(files::FileSource& files) : table_(files, problems_), parts_(table_, problems_, scene_) {}

  LoadedScene run(const std::string& path) {
    const std::string real = files::real_path(path);
    if (const JsonFile* file = table_.open(real, nullptr)) read(*file);
    scene_.nodes = std::move(tree_.nodes);
    if (!problems_.has_error()) check(real);
    LoadedScene loaded;
    if (!problems_.has_error()) loaded.scene = std::move(scene_);
    loaded.problems = problems_.take();
    loaded.files = table_.paths();
    return loaded;
  }

 private:
  void read(const JsonFile& file) {
    const Origin whole{&file, JsonId{0}};
    if (file.path.ends_with(".model.json")) {
      show_model(whole);
    } else if (file.path.ends_with(".material.json")) {
      show_on_sphere(parts_.material(whole));
    } else if (file.path.ends_with(".shader.json")) {
      show_on_sphere(material_of(parts_.shader(whole)));
    } else if (file.path.ends_with(".primitive.json")) {
      show_primitive(whole);
    } else {
      read_scene(file);
    }
  }

  void read_scene(const JsonFile& file) {
    FileReader reader(file, problems_);
    ObjectReader object(reader, JsonId{0});
    object.member("$schema");
    if (const auto id = object.member("name")) scene_.name = reader.text_that_is_not_empty(*id).value_or("");
    const Scope scope = parts_.scope(reader, object);
    if (const auto list = object.required("scene")) {
      for (const JsonId id : reader.list(*list)) {
        if (const auto root = parts_.node(reader, scope, id, tree_, 1)) scene_.roots.push_back(root->node);
      }
    }
    if (const auto id = object.member("camera")) scene_.camera = read_camera(reader, *id);
    if (const auto id = object.member("lights")) scene_.lights = read_lights(reader, *id);
    if (const auto id = object.member("environment")) scene_.environment = read_environment(reader, *id);
    if (const auto id = object.member("render")) scene_.settings = read_settings(reader, *id);
    object.finish();
  }

  void show_model(const Origin& part) {
    const ModelTree* model = parts_.model(part);
    if (model == nullptr) return;
    tree_ = model->tree;
    scene_.roots = {model->root.node};
  }

  void show_primitive(const Origin& part) {
    const auto primitive = parts_.primitive(part);
    if (!primitive) return;
    scene::Node node;
    node.kind = scene::ObjectKind::UserPrimitive;
    node.user_primitive = *primitive;
    show(std::move(node), part);
  }

  std::optional<scene::MaterialId> material_of(std::optional<scene::ShaderId> shader) {
    if (!shader) return std::nullopt;
    scene::Material material{"", *shader, {}};
    for (const scene::Property& property : scene_.shaders[shader->value].properties) {
      material.values.push_back(property.default_value);
    }
    scene_.materials.push_back(std::move(material));
    return scene::MaterialId{static_cast<uint32_t>(scene_.materials.size() - 1)};
  }

  void show_on_sphere(std::optional<scene::MaterialId> material) {
    if (!material) return;
    scene::Node node;
    const scene::ObjectEntry& sphere = scene::object_entry(scene::ObjectKind::Sphere);
    node.kind = sphere.kind;
    node.data = scene::with_defaults(sphere, {});
    node.transform.scale = {2, 2, 2};
    node.material = *material;
    show(std::move(node), {});
  }

  void show(scene::Node node, const Origin& origin) {
    tree_.nodes.push_back(std::move(node));
    tree_.origins.push_back(origin);
    scene_.roots = {scene::NodeId{0}};
  }

  /// What the parts alone do not tell.
  void check(const std::string& path) {
    const auto fault = find_fault(scene_);
    if (!fault) return;
    const Origin where = place_of(*fault, path);
    problems_.add(*where.file, where.id, fault->message);
  }

  Origin place_of(const scene::SceneFault& fault, const std::string& path) {
    const bool is_of_node = fault.part >= scene::Part::NodeKind && fault.part <= scene::Part::NodeDynamic;
    const Origin whole{table_.open(path, nullptr), JsonId{0}};
    const Origin object = is_of_node && tree_.origins[fault.index].file != nullptr ? tree_.origins[fault.index] : whole;
    const std::optional<JsonId> member = member_of(object, key_of(fault.part));
    if (!member) return object;
    const JsonValue& value = object.file->tree[*member];
    const bool is_number = fault.part == scene::Part::NodeData && value.kind == JsonKind::Array;
    if (is_number && fault.item < value.elements.size()) return {object.file, value.elements[fault.item]};
    return {object.file, *member};
  }

  Problems problems_;
  scene::Scene scene_;
  Tree tree_;
  FileTable table_;
  PartReader parts_;
};

}  // namespace

LoadedScene load_scene(const std::string& path, files::FileSource& files) {
  return SceneReader(files).run(path);
}

}  // namespace texbrdf::scene_json
