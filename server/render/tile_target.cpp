#include "render/tile_target.h"

#include <fmt/format.h>

#include "render/program_cache.h"
#include "render/shader_text.h"

namespace texbrdf::render {

namespace {

GLsizei rows_of(std::size_t points) {
  return static_cast<GLsizei>((points + kTileWidth - 1) / kTileWidth);
}

GLuint bind_float_target(const Gl& gl) {
  GLuint renderbuffer = 0;
  gl.glGenRenderbuffers(1, &renderbuffer);
  gl.glBindRenderbuffer(GL_RENDERBUFFER, renderbuffer);
  gl.glRenderbufferStorage(GL_RENDERBUFFER, GL_RGBA32F, kTileWidth, kTileHeight);
  GLuint framebuffer = 0;
  gl.glGenFramebuffers(1, &framebuffer);
  gl.glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  gl.glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, renderbuffer);
  return gl.glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE ? framebuffer : 0;
}

}  // namespace

Result<TileTarget> TileTarget::create(const Gl& gl) {
  TileTarget target(gl);
  target.framebuffer_ = bind_float_target(gl);
  if (target.framebuffer_ == 0) return Failure{"this OpenGL cannot draw into 32-bit floats"};
  // With alpha written once and masked from then on, llvmpipe compiles one variant of a shader instead of two.
  gl.glClearColor(0, 0, 0, 1);
  gl.glClear(GL_COLOR_BUFFER_BIT);
  gl.glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_FALSE);

  gl.glGenVertexArrays(1, &target.vertex_array_);
  gl.glBindVertexArray(target.vertex_array_);
  gl.glGenTextures(static_cast<GLsizei>(target.textures_.size()), target.textures_.data());
  gl.glPixelStorei(GL_UNPACK_ALIGNMENT, 4);

  const Result<GLuint> vertex_program = compile_program(gl, GL_VERTEX_SHADER, vertex_shader_text());
  if (!vertex_program) return Failure{vertex_program.error()};
  target.vertex_program_ = *vertex_program;
  gl.glGenProgramPipelines(1, &target.pipeline_);
  gl.glBindProgramPipeline(target.pipeline_);
  gl.glUseProgramStages(target.pipeline_, GL_VERTEX_SHADER_BIT, target.vertex_program_);
  if (const auto error = target.take_error()) return Failure{*error};
  return target;
}

void TileTarget::bind() {
  gl_->glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
  gl_->glBindVertexArray(vertex_array_);
  gl_->glBindProgramPipeline(pipeline_);
  gl_->glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_FALSE);
}

void TileTarget::upload(uint32_t unit, const PointVectors& vectors) {
  const std::size_t points = vectors[0].size();
  const GLsizei rows = rows_of(points);
  staging_.assign(static_cast<std::size_t>(rows) * kTileWidth * 3, 0.0F);
  for (std::size_t i = 0; i < points; ++i) {
    for (std::size_t c = 0; c < 3; ++c) staging_[i * 3 + c] = vectors[c][i];
  }
  gl_->glActiveTexture(GL_TEXTURE0 + unit);
  gl_->glBindTexture(GL_TEXTURE_2D, textures_[unit]);
  gl_->glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  gl_->glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  gl_->glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
  gl_->glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB32F, kTileWidth, rows, 0, GL_RGB, GL_FLOAT, staging_.data());
}

void TileTarget::draw(GLuint fragment_program, std::size_t points) {
  gl_->glUseProgramStages(pipeline_, GL_FRAGMENT_SHADER_BIT, fragment_program);
  gl_->glViewport(0, 0, kTileWidth, rows_of(points));
  gl_->glDrawArrays(GL_TRIANGLES, 0, 3);
}

void TileTarget::read(std::size_t points, std::vector<float>& out) {
  const GLsizei rows = rows_of(points);
  const std::size_t before = out.size();
  out.resize(before + static_cast<std::size_t>(rows) * kTileWidth * 4);
  gl_->glReadPixels(0, 0, kTileWidth, rows, GL_RGBA, GL_FLOAT, &out[before]);
  out.resize(before + points * 4);
}

std::optional<std::string> TileTarget::take_error() {
  constexpr int kMaxErrors = 16;  // a lost context reports errors without end
  std::optional<std::string> first;
  for (int i = 0; i < kMaxErrors; ++i) {
    const GLenum error = gl_->glGetError();
    if (error == GL_NO_ERROR) break;
    if (!first) first = fmt::format("OpenGL error 0x{:04x}", error);
  }
  return first;
}

}  // namespace texbrdf::render
