#include "render/gpu_renderer.h"

#include <algorithm>
#include <chrono>
#include <optional>
#include <utility>

#include "render/program_cache.h"
#include "render/scene_target.h"
#include "render/scene_tracer.h"
#include "render/tile_target.h"

namespace texbrdf::render {

namespace {

/// The texture unit of each vector is its place in kTextureNames; this is where EvaluateRequest has it.
constexpr std::array<std::size_t, 5> kVectorOfUnit{2, 0, 1, 3, 4};

PointVectors slice(const PointVectors& vectors, std::size_t begin, std::size_t count) {
  return {vectors[0].subspan(begin, count), vectors[1].subspan(begin, count), vectors[2].subspan(begin, count)};
}

Refusal shader_refusal(const std::string& message) {
  return {RefusalKind::Shader, message};
}

}  // namespace

struct GpuRenderer::State {
  State(EglContext egl, std::unique_ptr<const GlslChecker> glslang, TileTarget tiles, SceneTracer tracer)
      : context(std::move(egl)),
        checker(std::move(glslang)),
        target(std::move(tiles)),
        programs(context.gl(), *checker),
        scenes(std::move(tracer)),
        scene_target(context.gl()) {}

  EglContext context;
  std::unique_ptr<const GlslChecker> checker;
  TileTarget target;
  ProgramCache programs;
  SceneTracer scenes;
  SceneTarget scene_target;
  SphereCache sphere;
  std::optional<SphereView> uploaded;  ///< whose normals, all of them, are in the texture

  const Gl& gl() const { return context.gl(); }
  GLint location(const ProgramCache::Program& program, std::string_view name) const;
  void set_uniforms(const ProgramCache::Program& program, const std::vector<Uniform>& uniforms) const;
  void set_direction(const ProgramCache::Program& program, std::string_view name,
                     const std::array<float, 3>& direction) const;
  void bind_textures(const ProgramCache::Program& program, std::size_t count) const;
  std::vector<float> shade_sphere(const ProgramCache::Program& program, const SphereView& view,
                                  const SphereGeometry& geometry);
};

GLint GpuRenderer::State::location(const ProgramCache::Program& program, std::string_view name) const {
  return gl().glGetUniformLocation(program.id, (program.text.prefix + std::string(name)).c_str());
}

/// What the driver found unused has the location -1, which is ignored.
void GpuRenderer::State::set_uniforms(const ProgramCache::Program& program,
                                      const std::vector<Uniform>& uniforms) const {
  for (const Uniform& uniform : uniforms) {
    const GLint where = gl().glGetUniformLocation(program.id, uniform.name.c_str());
    const auto& [x, y, z] = uniform.value;
    if (uniform.components == 1) {
      gl().glProgramUniform1f(program.id, where, x);
    } else {
      gl().glProgramUniform3f(program.id, where, x, y, z);
    }
  }
}

void GpuRenderer::State::set_direction(const ProgramCache::Program& program, std::string_view name,
                                       const std::array<float, 3>& direction) const {
  gl().glProgramUniform3f(program.id, location(program, name), direction[0], direction[1], direction[2]);
}

void GpuRenderer::State::bind_textures(const ProgramCache::Program& program, std::size_t count) const {
  for (std::size_t unit = 0; unit < count; ++unit) {
    gl().glProgramUniform1i(program.id, location(program, kTextureNames[unit]), static_cast<GLint>(unit));
  }
}

std::vector<float> GpuRenderer::State::shade_sphere(const ProgramCache::Program& program, const SphereView& view,
                                                    const SphereGeometry& geometry) {
  const std::size_t total = geometry.point_count();
  const PointVectors normals{geometry.normals[0], geometry.normals[1], geometry.normals[2]};
  const bool fits = total <= kTilePoints;
  const bool is_uploaded = fits && uploaded && same_geometry(*uploaded, view);
  std::vector<float> values;
  values.reserve((total + kTileWidth) * 4);
  for (std::size_t begin = 0; begin < total; begin += kTilePoints) {
    const std::size_t count = std::min(kTilePoints, total - begin);
    if (!is_uploaded) target.upload(0, slice(normals, begin, count));
    target.draw(program.id, count);
    target.read(count, values);
  }
  uploaded = fits ? std::optional(view) : std::nullopt;
  return values;
}

GpuRenderer::GpuRenderer(std::unique_ptr<State> state) : state_(std::move(state)) {}
GpuRenderer::GpuRenderer(GpuRenderer&&) noexcept = default;
GpuRenderer& GpuRenderer::operator=(GpuRenderer&&) noexcept = default;
GpuRenderer::~GpuRenderer() = default;

Result<GpuRenderer> GpuRenderer::create(EglContext context, std::unique_ptr<const GlslChecker> checker) {
  Result<TileTarget> target = TileTarget::create(context.gl());
  if (!target) return Failure{target.error()};
  Result<SceneTracer> scenes = SceneTracer::create(context.gl(), *checker);
  if (!scenes) return Failure{scenes.error()};
  return GpuRenderer(
      std::make_unique<State>(std::move(context), std::move(checker), *std::move(target), *std::move(scenes)));
}

const std::string& GpuRenderer::description() const {
  return state_->context.description();
}

std::variant<DrawAnswer, Refusal> GpuRenderer::answer(const DrawRequest& request) {
  const auto start = std::chrono::steady_clock::now();
  if (const auto fault = find_fault(request.view)) return Refusal{RefusalKind::Request, *fault};
  const auto found = state_->programs.find_or_compile(request.model.source, GeometrySource::Sphere);
  if (!found) return shader_refusal(found.error());
  const ProgramCache::Program& program = *found->program;
  state_->target.bind();
  const SphereGeometry& geometry = state_->sphere.geometry(request.view);
  state_->set_uniforms(program, request.model.uniforms);
  state_->set_direction(program, kLightName, geometry.light);
  state_->set_direction(program, kViewName, geometry.view);
  state_->bind_textures(program, 1);
  const std::vector<float> values = state_->shade_sphere(program, request.view, geometry);
  if (const auto error = state_->target.take_error()) return Refusal{RefusalKind::Renderer, *error};

  DrawAnswer answer;
  const float* first = values.data();
  answer.picture = tone_map(geometry, request.view, {{first, first + 1, first + 2}, 4});
  answer.compiled = found->compiled;
  answer.milliseconds = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
  return answer;
}

std::variant<EvaluateAnswer, Refusal> GpuRenderer::answer(const EvaluateRequest& request) {
  const auto found = state_->programs.find_or_compile(request.model.source, GeometrySource::Table);
  if (!found) return shader_refusal(found.error());
  const ProgramCache::Program& program = *found->program;
  state_->target.bind();
  state_->set_uniforms(program, request.model.uniforms);
  state_->bind_textures(program, kVectorOfUnit.size());
  state_->uploaded.reset();

  const std::size_t total = request.geometry[0].size();
  std::vector<float> values;
  for (std::size_t begin = 0; begin < total; begin += kTilePoints) {
    const std::size_t count = std::min(kTilePoints, total - begin);
    for (uint32_t unit = 0; unit < kVectorOfUnit.size(); ++unit) {
      const auto* lists = &request.geometry[kVectorOfUnit[unit] * 3];
      state_->target.upload(unit, slice({lists[0], lists[1], lists[2]}, begin, count));
    }
    state_->target.draw(program.id, count);
    state_->target.read(count, values);
  }
  if (const auto error = state_->target.take_error()) return Refusal{RefusalKind::Renderer, *error};

  EvaluateAnswer answer;
  answer.values.reserve(total * 3);
  for (std::size_t i = 0; i < total; ++i) answer.values.insert(answer.values.end(), &values[i * 4], &values[i * 4] + 3);
  return answer;
}

std::variant<SceneAnswer, Refusal> GpuRenderer::answer(const SceneRequest& request) {
  const auto start = std::chrono::steady_clock::now();
  if (const auto fault = find_fault(request)) return Refusal{RefusalKind::Request, *fault};
  if (const auto failure = state_->scene_target.bind(request.tile))
    return Refusal{RefusalKind::Renderer, failure->message};
  const auto drawn = state_->scenes.draw(request.source, request.state, request.look, request.tile, request.sample);
  if (!drawn) return shader_refusal(drawn.error());
  SceneAnswer answer;
  answer.values = state_->scene_target.read(request.tile);
  if (const auto error = state_->target.take_error()) return Refusal{RefusalKind::Renderer, *error};
  answer.compiled = drawn->compiled;
  answer.milliseconds = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
  return answer;
}

}  // namespace texbrdf::render
