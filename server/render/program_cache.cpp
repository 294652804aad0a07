#include "render/program_cache.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace texbrdf::render {

namespace {

constexpr std::size_t kMaxPrograms = 32;

std::string first_line(std::string text) {
  text.resize(std::min(text.size(), text.find('\n')));
  return text;
}

}  // namespace

Result<GLuint> compile_program(const Gl& gl, GLenum stage, const char* text) {
  const GLuint id = gl.glCreateShaderProgramv(stage, 1, &text);
  GLint linked = GL_FALSE;
  if (id != 0) gl.glGetProgramiv(id, GL_LINK_STATUS, &linked);
  if (linked == GL_TRUE) return id;
  std::array<char, 1024> log{};
  if (id != 0) gl.glGetProgramInfoLog(id, log.size(), nullptr, log.data());
  gl.glDeleteProgram(id);
  return Failure{fmt::format("the driver rejects the shader: {}", first_line(log.data()))};
}

ProgramCache::~ProgramCache() {
  for (const Program& program : programs_) gl_.glDeleteProgram(program.id);
}

Result<ProgramCache::Found> ProgramCache::find_or_compile(const std::string& source, GeometrySource geometry) {
  return find_or_compile(shader_text(source, geometry));
}

Result<ProgramCache::Found> ProgramCache::find_or_compile(ShaderText text) {
  const auto known = std::find_if(programs_.begin(), programs_.end(),
                                  [&](const Program& program) { return program.text.fragment == text.fragment; });
  if (known != programs_.end()) {
    programs_.splice(programs_.begin(), programs_, known);
    return Found{&programs_.front(), false};
  }
  if (const auto fault = checker_.find_fault(text.fragment)) {
    return Failure{fmt::format("glslang rejects the shader: {}", *fault)};
  }
  const Result<GLuint> id = compile_program(gl_, GL_FRAGMENT_SHADER, text.fragment.c_str());
  if (!id) return Failure{id.error()};
  programs_.push_front({std::move(text), *id});
  if (programs_.size() > kMaxPrograms) {
    gl_.glDeleteProgram(programs_.back().id);
    programs_.pop_back();
  }
  return Found{&programs_.front(), true};
}

}  // namespace texbrdf::render
