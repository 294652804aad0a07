// Any bytes as the files of a scene: what every path gives, so that a file that names others reads itself. A scene
// without an error keeps what scene/scene.h promises.
#include <cstdint>
#include <string>
#include <string_view>

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
