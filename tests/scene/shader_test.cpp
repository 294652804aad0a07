#include <cstdlib>
#include <fstream>

#include "render/glsl_check.h"
#include "render/shader_text.h"
#include "scene/check.h"
#include "scene_json/code_mistake.h"
#include "support.h"
#include "support/random_scene.h"

namespace texbrdf {
namespace {

std::string whole_shader(const scene::SceneShader& shader) {
  return "#version 330 core\nout vec4 trace_value;\n" + shader.source +
         "void main() {\n"
         "  vec2 trace_d = scene_distance(gl_FragCoord.xyz);\n"
         "  int trace_leaf = int(trace_d.y);\n"
         "  int trace_material = scene_material(trace_leaf);\n"
         "  vec3 trace_o = scene_origin(trace_leaf);\n"
         "  FragmentProperties trace_p = FragmentProperties(trace_o, trace_o, trace_o, trace_o, 1.0);\n"
         "  trace_value = vec4(scene_is_lit(trace_material) ? scene_brdf(trace_material, trace_o, trace_o, trace_o, "
         "trace_o, trace_o)\n"
         "                                                  : scene_shade(trace_material, trace_p), 1.0);\n"
         "}\n";
}

TEST(SceneShader, ThatOfEveryExampleIsLegal) {
  const render::GlslChecker glslang;
  for (const std::string& name : test::example_scenes()) {
    const std::string text = whole_shader(make_scene_shader(test::load_example(name)));
    EXPECT_EQ(glslang.find_fault(text).value_or(""), "") << name;
    if (const char* folder = std::getenv("KEEP_SHADERS")) std::ofstream(std::string(folder) + "/" + name) << text;
  }
}

TEST(SceneShader, ThatOfRandomTreesIsLegal) {
  const render::GlslChecker glslang;
  for (uint64_t seed = 1; seed <= 300; ++seed) {
    const scene::Scene scene = test::RandomScene(seed, true).make();
    ASSERT_EQ(glslang.find_fault(whole_shader(make_scene_shader(scene))).value_or(""), "") << "seed " << seed;
  }
}

/// Linking in glslang grows with the square of the functions: the most objects that a scene may have take 10 s.
TEST(SceneShader, OfManyObjectsIsLegal) {
  scene::Scene scene;
  for (uint32_t i = 0; i < 1024; ++i) {
    const auto entries = scene::object_entries();
    scene::Node node;
    node.kind = entries[i % 18].kind;
    node.data = with_defaults(entries[i % 18], {});
    node.transform.position = {i % 16 * 2.0, i / 16 % 16 * 2.0, i / 256 * 2.0};
    scene.nodes.push_back(node);
    scene.roots.push_back({i});
  }
  ASSERT_FALSE(find_fault(scene));
  EXPECT_EQ(render::GlslChecker().find_fault(whole_shader(make_scene_shader(scene))).value_or(""), "");
}

scene::Scene scene_of_shaders(const std::vector<std::string>& codes) {
  scene::Scene scene;
  for (uint32_t i = 0; i < codes.size(); ++i) {
    scene.shaders.push_back({"s", scene::ShaderKind::Shade, {}, codes[i], {"s.shader.json", "code", 7}});
    scene.materials.push_back({"m", {i}, {}});
    scene::Node node;
    node.kind = scene::ObjectKind::Sphere;
    node.data[0] = 0.5;
    node.material = {i};
    scene.nodes.push_back(node);
    scene.roots.push_back({i});
  }
  return scene;
}

TEST(SceneShader, TwoShadersWithTheSameNamesDoNotMeet) {
  const std::string code = R"(#define SIZE 3
#ifdef SIZE
struct Part { float3 shade; float SIZE_; };
#endif
const float weights[SIZE] = float[SIZE](1.0, 2.0, 3.0);
float3 state;
float node_0(float x) { return saturate(frac(x)) + weights[1]; }  // ours is called so too
void main() { state = float3(0.0, 0.0, 0.0); }
float3 shade(FragmentProperties properties) {
  main();
  Part part;
  part.shade = lerp(state, properties.world_normal, node_0(0.5));
  part.SIZE_ = rsqrt(atan2(1.0, 2.0)) + fmod(3.0, 2.0);
  return part.shade * part.SIZE_;
})";
  const scene::Scene scene = scene_of_shaders({code, code, code});
  ASSERT_FALSE(find_fault(scene)) << find_fault(scene)->message;
  EXPECT_EQ(render::GlslChecker().find_fault(whole_shader(make_scene_shader(scene))).value_or(""), "");
}

TEST(SceneShader, ACompilersComplaintIsToldWhereTheCodeStands) {
  const scene::Scene scene =
      scene_of_shaders({"float3 shade(FragmentProperties p) { return p.world_normal; }",
                        "\nfloat3 blend;\nfloat3 shade(FragmentProperties p) {\n  return blend * missing;\n}"});
  const scene::SceneShader shader = make_scene_shader(scene);
  EXPECT_EQ(render::GlslChecker().find_fault(whole_shader(shader)).value_or("").substr(0, 5), "2:10:");
  EXPECT_EQ(scene_json::describe_code_mistake(shader, 2, 10, "'" + shader.prefixes[1] + "blend' : wrong"),
            "s.shader.json(10) error: code: 'blend' : wrong");
  EXPECT_FALSE(scene_json::describe_code_mistake(shader, 0, 10, "ours"));
  EXPECT_FALSE(scene_json::describe_code_mistake(shader, 3, 10, "nobody's"));
}

TEST(SceneShader, ADynamicObjectIsWhereItsTransformIs) {
  scene::Scene scene = scene_of_shaders({"float3 shade(FragmentProperties p) { return p.object_position; }"});
  scene.nodes[0].dynamic = scene::Dynamic{"a", {}};
  const std::string source = make_scene_shader(scene).source;
  scene.nodes[0].transform = {{1, 2, 3}, {0.1, 0.2, 0.3}, {2, 2, 2}};
  EXPECT_EQ(make_scene_shader(scene).source, source);
  const std::vector<float> frames = scene_frames(scene);
  ASSERT_EQ(frames.size(), 28U);
  EXPECT_EQ(frames[12], 2.0F);
  EXPECT_EQ((std::array{frames[19], frames[23], frames[27]}), (std::array{1.0F, 2.0F, 3.0F}));
}

}  // namespace
}  // namespace texbrdf
