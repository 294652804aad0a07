#include "scene_json/load_scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <string_view>
#include <utility>

#include "scene_json/part_reader.h"
#include "scene_json/values.h"

namespace texbrdf::scene_json {
namespace {

/// Reads the file of a scene, or makes a scene that shows what another file holds.
class SceneReader {
 public:
  explicit SceneReader(files::FileSource& files) : table_(files, problems_), parts_(table_, problems_, scene_) {}

  LoadedScene run(const std::string& path) {
    const std::string real = files::real_path(path);
    if (const JsonFile* file = table_.open(real, nullptr)) read(*file);
    scene_.nodes = std::move(tree_.nodes);
    check_names();
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

  void check_names() {
    std::set<std::string_view> names;
    for (std::size_t i = 0; i < scene_.nodes.size(); ++i) {
      const auto& dynamic = scene_.nodes[i].dynamic;
      if (!dynamic || names.insert(dynamic->name).second) continue;
      const Origin& origin = tree_.origins[i];
      problems_.add(*origin.file, origin.id, fmt::format("two dynamic objects have the name `{}`", dynamic->name));
    }
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
