#include <cstdlib>
#include <fstream>

#include "render/glsl_check.h"
#include "render/shader_text.h"
#include "support.h"

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

}  // namespace
}  // namespace texbrdf
