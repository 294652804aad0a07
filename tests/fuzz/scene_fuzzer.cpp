// Any bytes as the files of a scene: what every path gives, so that a file that names others reads itself. A scene
// without an error keeps what scene/scene.h promises.
#include <cstdint>
#include <string>
#include <string_view>

#include "scene/check.h"
#include "scene/distance.h"
#include "scene/lipschitz.h"
#include "scene/scene_shader.h"
#include "scene_json/load_scene.h"
#include "source/internal_error.h"

namespace {

using namespace texbrdf;

constexpr std::size_t kMaxInput = 1 << 14;

class OneText final : public files::FileSource {
 public:
  explicit OneText(std::string_view text) : text_(text) {}
  bool may_read(std::string_view) const override { return true; }
  bool exists(const std::string&) const override { return true; }
  std::optional<SourceText> text(const std::string& path) override {
    if (path.ends_with(".tex")) return SourceText("\\begin{equation}f = 0.3\\end{equation}");
    return text_;
  }

 private:
  SourceText text_;
};

/// What has no fault can be compiled, bounded and evaluated.
void exercise(const scene::Scene& scene) {
  const scene::SceneShader shader = make_scene_shader(scene);
  require(!shader.source.empty() && shader.places.size() == shader.prefixes.size(), "a shader without code");
  require(shader.source.find("nan") == std::string::npos || !scene.shaders.empty() || !scene.user_primitives.empty(),
          "a number that GLSL does not have");
  require(scene_frames(scene).size() % 4 == 0, "incomplete frames");
  require(lipschitz_bounds(scene).size() == scene.nodes.size(), "a node without a bound");
  if (scene.nodes.size() > 64) return;
  const scene::Distances distances(scene);
  for (const double x : {0.0, 0.7, -13.0}) static_cast<void>(distances.at({x, 0.3, -x}));
}

void check(const scene_json::LoadedScene& loaded) {
  for (const scene_json::Problem& problem : loaded.problems) {
    require(!problem.message.empty() && !scene_json::describe(problem).empty(), "a problem without a message");
  }
  if (!loaded.scene) {
    require(!loaded.problems.empty(), "no scene, and no reason");
    return;
  }
  const scene::Scene& scene = *loaded.scene;
  require(scene.nodes.size() <= scene::kMaxNodes, "too many nodes");
  for (uint32_t i = 0; i < scene.nodes.size(); ++i) {
    for (const scene::NodeId child : scene.nodes[i].children) require(child.value < i, "a child above its parent");
    const scene::MaterialId material = scene.nodes[i].material;
    require(!material.valid() || material.value < scene.materials.size(), "no such material");
  }
  for (const scene::Material& material : scene.materials) {
    require(material.values.size() == scene.shaders.at(material.shader.value).properties.size(),
            "values of a material");
  }
  require(!scene::find_fault(scene), "a scene with a fault");
  exercise(scene);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, std::size_t size) {
  if (size > kMaxInput) return 0;
  OneText files(std::string_view(reinterpret_cast<const char*>(data), size));
  for (const char* name :
       {"/s.scene.json", "/s.model.json", "/s.material.json", "/s.shader.json", "/s.primitive.json"}) {
    check(scene_json::load_scene(name, files));
  }
  return 0;
}
