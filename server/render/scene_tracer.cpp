#include "render/scene_tracer.h"

#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <utility>

#include "render/program_cache.h"
#include "render/scene_text.h"
#include "render/shader_text.h"
#include "scene/frame.h"

namespace texbrdf::render {

namespace {

using Vector = std::array<float, 3>;

Vector in_single_precision(const scene::Triple& triple) {
  return {static_cast<float>(triple[0]), static_cast<float>(triple[1]), static_cast<float>(triple[2])};
}

/// Sets uniforms of one program; those that the driver found unused have the location -1, which is ignored.
class Uniforms {
 public:
  Uniforms(const Gl& gl, GLuint program) : gl_(gl), program_(program) {}

  void set(const char* name, GLint value) const { gl_.glProgramUniform1i(program_, at(name), value); }
  void set(const char* name, double value) const {
    gl_.glProgramUniform1f(program_, at(name), static_cast<float>(value));
  }
  void set(const char* name, float x, float y) const { gl_.glProgramUniform2f(program_, at(name), x, y); }
  void set(const char* name, const Vector& v) const { gl_.glProgramUniform3f(program_, at(name), v[0], v[1], v[2]); }
  void set_triples(const char* name, const std::vector<float>& values) const {
    gl_.glProgramUniform3fv(program_, at(name), static_cast<GLsizei>(values.size() / 3), values.data());
  }
  void set_quadruples(const char* name, const std::vector<float>& values) const {
    gl_.glProgramUniform4fv(program_, at(name), static_cast<GLsizei>(values.size() / 4), values.data());
  }

 private:
  GLint at(const char* name) const { return gl_.glGetUniformLocation(program_, name); }
  const Gl& gl_;
  GLuint program_;
};

/// Towards a directional light with a fourth component of 0, or the place of a point light with 1.
std::array<float, 4> light_place(const scene::Light& light) {
  if (const auto* directional = std::get_if<scene::DirectionalLight>(&light)) {
    const glm::dvec3 towards = -glm::normalize(scene::to_vector(directional->direction));
    return {static_cast<float>(towards.x), static_cast<float>(towards.y), static_cast<float>(towards.z), 0};
  }
  const Vector place = in_single_precision(std::get<scene::PointLight>(light).position);
  return {place[0], place[1], place[2], 1};
}

void set_lights(const Uniforms& uniforms, const std::vector<scene::Light>& lights) {
  std::vector<float> places;
  std::vector<float> colours;
  for (const scene::Light& light : lights) {
    const std::array<float, 4> place = light_place(light);
    const Vector colour = in_single_precision(std::visit([](const auto& kind) { return kind.colour; }, light));
    places.insert(places.end(), place.begin(), place.end());
    colours.insert(colours.end(), colour.begin(), colour.end());
  }
  uniforms.set("trace_light_count", static_cast<GLint>(lights.size()));
  if (lights.empty()) return;
  uniforms.set_quadruples("trace_light_places", places);
  uniforms.set_triples("trace_light_colours", colours);
}

void set_camera(const Uniforms& uniforms, const scene::Camera& camera, const SceneTile& tile) {
  const double width = tile.picture_width;
  const double height = tile.picture_height;
  const CameraAxes axes = camera_axes(camera, width / height);
  uniforms.set("trace_eye", axes.eye);
  uniforms.set("trace_forward", axes.forward);
  uniforms.set("trace_right", axes.right);
  uniforms.set("trace_up", axes.up);
  uniforms.set("trace_corner", static_cast<float>(tile.x),
               static_cast<float>(tile.picture_height - tile.y - tile.height));
  uniforms.set("trace_size", static_cast<float>(width), static_cast<float>(height));
  uniforms.set("trace_depth", glm::distance(scene::to_vector(camera.position), scene::to_vector(camera.target)));
}

void set_state(const Uniforms& uniforms, const SceneState& state) {
  set_lights(uniforms, state.lights);
  uniforms.set("trace_background", in_single_precision(state.environment.background));
  uniforms.set("trace_ambient", in_single_precision(state.environment.ambient));
  uniforms.set("trace_max_steps", static_cast<GLint>(state.settings.max_steps));
  uniforms.set("trace_max_distance", state.settings.max_distance);
  uniforms.set("trace_threshold", state.settings.surface_threshold);
  if (!state.frames.empty()) uniforms.set_quadruples("scene_frames", state.frames);
}

void set_look(const Uniforms& uniforms, const SceneLook& look, const SceneSample& sample, const SceneDisplay* display) {
  uniforms.set("trace_zero", 0);
  uniforms.set("trace_view", static_cast<GLint>(look.view));
  uniforms.set("trace_light_width", std::tan(look.light_size * std::numbers::pi / 360));
  uniforms.set("trace_occlusion_radius", look.occlusion_radius);
  uniforms.set("trace_jitter", sample.pixel[0], sample.pixel[1]);
  uniforms.set("trace_ambient_jitter", sample.ambient[0], sample.ambient[1]);
  const double scale = display == nullptr ? 0 : std::exp2(display->exposure);
  const double power = display == nullptr ? 1 : 1 / display->gamma;
  uniforms.set("trace_display", static_cast<float>(scale), static_cast<float>(power));
}

}  // namespace

struct SceneTracer::State {
  State(const Gl& context_gl, const GlslChecker& checker) : gl(context_gl), programs(context_gl, checker) {}
  ~State() {
    gl.glDeleteProgramPipelines(1, &pipeline);
    gl.glDeleteVertexArrays(1, &vertex_array);
    gl.glDeleteProgram(vertex_program);
  }
  State(const State&) = delete;
  State& operator=(const State&) = delete;

  Result<ProgramCache::Found> find(const std::string& source, const SceneEffects& effects) {
    return programs.find_or_compile({scene_fragment_text(source, effects), "trace_"});
  }

  const Gl& gl;
  ProgramCache programs;
  GLuint vertex_program = 0;
  GLuint vertex_array = 0;
  GLuint pipeline = 0;
};

SceneTracer::SceneTracer(std::unique_ptr<State> state) : state_(std::move(state)) {}
SceneTracer::SceneTracer(SceneTracer&&) noexcept = default;
SceneTracer& SceneTracer::operator=(SceneTracer&&) noexcept = default;
SceneTracer::~SceneTracer() = default;

Result<SceneTracer> SceneTracer::create(const Gl& gl, const GlslChecker& checker) {
  const Result<GLuint> vertex_program = compile_program(gl, GL_VERTEX_SHADER, vertex_shader_text());
  if (!vertex_program) return Failure{vertex_program.error()};
  auto state = std::make_unique<State>(gl, checker);
  state->vertex_program = *vertex_program;
  gl.glGenVertexArrays(1, &state->vertex_array);
  gl.glGenProgramPipelines(1, &state->pipeline);
  gl.glBindProgramPipeline(state->pipeline);
  gl.glUseProgramStages(state->pipeline, GL_VERTEX_SHADER_BIT, state->vertex_program);
  return SceneTracer(std::move(state));
}

Result<SceneTracer::Drawn> SceneTracer::prepare(const std::string& source, const SceneEffects& effects) {
  const auto found = state_->find(source, effects);
  if (!found) return Failure{found.error()};
  return Drawn{found->compiled};
}

Result<SceneTracer::Drawn> SceneTracer::draw(const std::string& source, const SceneState& state, const SceneLook& look,
                                             const SceneTile& tile, const SceneSample& sample,
                                             const SceneDisplay* display) {
  const auto found = state_->find(source, look.effects());
  if (!found) return Failure{found.error()};
  const Uniforms uniforms(state_->gl, found->program->id);
  set_camera(uniforms, state.camera, tile);
  set_state(uniforms, state);
  set_look(uniforms, look, sample, display);
  const Gl& gl = state_->gl;
  gl.glUseProgram(0);
  gl.glBindProgramPipeline(state_->pipeline);
  gl.glUseProgramStages(state_->pipeline, GL_FRAGMENT_SHADER_BIT, found->program->id);
  gl.glBindVertexArray(state_->vertex_array);
  gl.glViewport(0, 0, static_cast<GLsizei>(tile.width), static_cast<GLsizei>(tile.height));
  gl.glDrawArrays(GL_TRIANGLES, 0, 3);
  return Drawn{found->compiled};
}

}  // namespace texbrdf::render
