// Objects of a tree.
#include <fmt/format.h>

#include <algorithm>

#include "scene/check.h"
#include "scene_json/part_reader.h"
#include "scene_json/values.h"

namespace texbrdf::scene_json {

namespace {

constexpr std::string_view kModels = "Models/";
constexpr std::string_view kPrimitives = "Primitives/";

std::vector<std::string> all_types() {
  std::vector<std::string> names;
  for (const scene::ObjectEntry& entry : scene::object_entries()) names.emplace_back(entry.name);
  return names;
}

}  // namespace

/// Reads one object and, by PartReader::node, its children.
class NodeReader {
 public:
  NodeReader(PartReader& parts, FileReader& reader, const Scope& scope, JsonId id, Tree& tree, uint32_t depth)
      : parts_(parts), reader_(reader), scope_(scope), id_(id), tree_(tree), depth_(depth), object_(reader, id) {}

  std::optional<Placed> run() {
    if (!object_.valid()) return std::nullopt;
    const uint32_t errors = reader_.error_count();
    read_type();
    read_data();
    if (const auto transform = object_.member("transform")) node_.transform = read_transform(reader_, *transform);
    if (const auto material = object_.member("material_id")) read_material(*material);
    const std::string name = read_name();
    read_dynamic(name);
    if (model_ != nullptr) copy_model(name);
    if (const auto children = object_.member("children")) read_children(*children);
    object_.finish();
    check_children();
    if (reader_.error_count() != errors || !is_known_) return std::nullopt;
    return push();
  }

 private:
  void read_type() {
    const auto type_id = object_.member("type");
    const auto model_id = object_.member("model");
    if (type_id && model_id) reader_.fail(*model_id, "`model` is another word for `type`: one of them is enough");
    if (!type_id && !model_id) {
      reader_.fail(id_, "the key `type` is missing");
      return;
    }
    const JsonId id = type_id ? *type_id : *model_id;
    const auto name = reader_.text(id);
    if (!name) return;
    const Origin where{&reader_.file(), id};
    if (const scene::ObjectEntry* entry = scene::find_object(*name)) {
      node_.kind = entry->kind;
      entry_ = entry;
      is_known_ = true;
    } else if (name->starts_with(kModels)) {
      const auto part = find(PartKind::Model, name->substr(kModels.size()), where);
      if (part) model_ = parts_.model(*part);
      is_known_ = model_ != nullptr;
      is_model_ = true;
    } else if (name->starts_with(kPrimitives) && is_of_user(name->substr(kPrimitives.size()))) {
      const auto part = find(PartKind::Primitive, name->substr(kPrimitives.size()), where);
      const auto primitive = part ? parts_.primitive(*part) : std::nullopt;
      node_.kind = scene::ObjectKind::UserPrimitive;
      if (primitive) node_.user_primitive = *primitive;
      is_known_ = primitive.has_value();
    } else {
      reader_.fail(id, fmt::format("there is no object `{}`{}", *name, reader_.is_full() ? "" : what_was_meant(*name)));
    }
  }

  std::optional<Origin> find(PartKind kind, std::string_view name, const Origin& where) {
    return find_part(scope_, kind, name, where, parts_.table_, parts_.problems_);
  }

  bool is_declared(PartKind kind, const std::string& name) const {
    const auto& declared = scope_.parts[static_cast<std::size_t>(kind)];
    return std::ranges::any_of(declared, [&](const auto& part) { return part && part->name == name; });
  }

  /// Often what stands before the slash is forgotten.
  std::string what_was_meant(const std::string& name) const {
    const std::vector<std::string> types = all_types();
    const auto whole = std::ranges::find_if(types, [&](const auto& type) { return type.ends_with("/" + name); });
    if (whole != types.end()) return fmt::format(" (did you mean `{}`?)", *whole);
    if (is_declared(PartKind::Model, name)) return fmt::format(" (did you mean `{}{}`?)", kModels, name);
    if (is_declared(PartKind::Primitive, name)) return fmt::format(" (did you mean `{}{}`?)", kPrimitives, name);
    return suggestion(name, types);
  }

  /// Names of no file and no list are rather misspelt ones of ours.
  bool is_of_user(const std::string& name) {
    if (is_declared(PartKind::Primitive, name)) return true;
    const std::string path = FileTable::resolve(reader_.file(), name + ".primitive.json");
    return parts_.table_.may_read(path) && parts_.table_.exists(path);
  }

  void read_data() {
    const auto id = object_.member("data");
    std::vector<double> numbers;
    const std::size_t most = entry_ != nullptr ? entry_->data_count : is_model_ ? 0 : scene::kMaxData;
    if (id) {
      const auto read = reader_.numbers(*id, 0, most);
      if (read) numbers = *read;
    }
    if (entry_ == nullptr) {
      std::ranges::copy(numbers, node_.data.begin());
      return;
    }
    node_.data = scene::with_defaults(*entry_, numbers);
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      const scene::Datum& datum = entry_->data[i];
      const std::string_view rule = scene::broken_rule(datum.domain, numbers[i]);
      if (!rule.empty())
        reader_.fail(reader_[*id].elements[i],
                     fmt::format("`{}` of {} must be {}, but is {}", datum.name, entry_->name, rule, numbers[i]));
    }
  }

  void read_material(JsonId id) {
    const auto& materials = scope_.parts[static_cast<std::size_t>(PartKind::Material)];
    std::optional<Origin> part;
    if (reader_[id].kind == JsonKind::Number) {
      const auto index = reader_.whole(id, 0, INT32_MAX);
      if (!index) return;
      if (static_cast<std::size_t>(*index) >= materials.size()) {
        reader_.fail(id, fmt::format("there is no material {}: `materials` here has {}, counted from 0", *index,
                                     materials.size()));
        return;
      }
      const auto& declared = materials[static_cast<std::size_t>(*index)];
      if (declared) part = declared->where;
    } else if (const auto name = reader_.text_that_is_not_empty(id)) {
      part = find(PartKind::Material, *name, {&reader_.file(), id});
    }
    const auto material = part ? parts_.material(*part) : std::nullopt;
    if (material) node_.material = *material;
  }

  std::string read_name() {
    const auto id = object_.member("name");
    const auto name = id ? reader_.text_that_is_not_empty(*id) : std::nullopt;
    return name.value_or(reader_.file().tree.path(id_));
  }

  void read_dynamic(const std::string& name) {
    const auto id = object_.member("dynamic");
    if (!id) return;
    scene::Dynamic dynamic{name, {}};
    if (reader_[*id].kind == JsonKind::Object) {
      ObjectReader object(reader_, *id);
      if (const auto keys = object.member("keys")) dynamic.keys = read_keys(reader_, *keys);
      object.finish();
      node_.dynamic = std::move(dynamic);
    } else if (reader_.boolean(*id).value_or(false)) {
      node_.dynamic = std::move(dynamic);
    }
  }

  /// The model's nodes become children of this one.
  void copy_model(const std::string& name) {
    const Tree& tree = model_->tree;
    if (tree_.nodes.size() + tree.nodes.size() > scene::kMaxNodes) {
      reader_.fail(id_, fmt::format("with this model the scene has more than {} objects", scene::kMaxNodes));
      return;
    }
    node_.kind = scene::ObjectKind::Union;
    const auto first = static_cast<uint32_t>(tree_.nodes.size());
    for (const scene::Node& each : tree.nodes) {
      scene::Node copy = each;
      for (scene::NodeId& child : copy.children) child.value += first;
      if (copy.dynamic) copy.dynamic->name = name + "/" + copy.dynamic->name;
      tree_.nodes.push_back(std::move(copy));
    }
    tree_.origins.insert(tree_.origins.end(), tree.origins.begin(), tree.origins.end());
    node_.children.push_back({model_->root.node.value + first});
    height_ = std::max(height_, model_->root.height);
  }

  void read_children(JsonId list) {
    if (depth_ >= scene::kMaxDepth) {
      reader_.fail(list, fmt::format("objects are nested more than {} deep", scene::kMaxDepth));
      return;
    }
    for (const JsonId id : reader_.list(list)) {
      const std::optional<Placed> child = parts_.node(reader_, scope_, id, tree_, depth_ + 1);
      if (!child) continue;
      height_ = std::max(height_, child->height);
      node_.children.push_back(child->node);
    }
  }

  void check_children() {
    if (entry_ == nullptr || entry_->object_class == scene::ObjectClass::Primitive ||
        entry_->object_class == scene::ObjectClass::Primitive2d) {
      return;
    }
    const auto list = object_.member("children");
    if (!list || reader_[*list].elements.empty()) reader_.fail(id_, fmt::format("{} has no children", entry_->name));
  }

  std::optional<Placed> push() {
    if (tree_.nodes.size() >= scene::kMaxNodes) {
      reader_.fail(id_, fmt::format("a scene has at most {} objects", scene::kMaxNodes));
      return std::nullopt;
    }
    if (depth_ + height_ > scene::kMaxDepth) {
      reader_.fail(id_, fmt::format("with their models, objects are nested more than {} deep", scene::kMaxDepth));
      return std::nullopt;
    }
    tree_.nodes.push_back(std::move(node_));
    tree_.origins.push_back({&reader_.file(), id_});
    return Placed{scene::NodeId{static_cast<uint32_t>(tree_.nodes.size() - 1)}, height_ + 1};
  }

  PartReader& parts_;
  FileReader& reader_;
  const Scope& scope_;
  JsonId id_;
  Tree& tree_;
  uint32_t depth_;
  ObjectReader object_;
  scene::Node node_;
  const scene::ObjectEntry* entry_ = nullptr;
  const ModelTree* model_ = nullptr;
  bool is_model_ = false;
  bool is_known_ = false;
  uint32_t height_ = 0;  // of the children
};

std::optional<Placed> PartReader::node(FileReader& reader, const Scope& scope, JsonId id, Tree& tree, uint32_t depth) {
  return NodeReader(*this, reader, scope, id, tree, depth).run();
}

}  // namespace texbrdf::scene_json
