#include "render/scene_target.h"

#include <algorithm>

namespace texbrdf::render {

SceneTarget::~SceneTarget() {
  gl_.glDeleteFramebuffers(1, &framebuffer_);
  gl_.glDeleteRenderbuffers(1, &renderbuffer_);
}

std::optional<Failure> SceneTarget::bind(const SceneTile& tile) {
  if (framebuffer_ == 0) gl_.glGenFramebuffers(1, &framebuffer_);
  if (renderbuffer_ == 0) gl_.glGenRenderbuffers(1, &renderbuffer_);
  gl_.glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
  gl_.glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  if (tile.width <= width_ && tile.height <= height_) return std::nullopt;
  width_ = std::max(width_, tile.width);
  height_ = std::max(height_, tile.height);
  gl_.glBindRenderbuffer(GL_RENDERBUFFER, renderbuffer_);
  gl_.glRenderbufferStorage(GL_RENDERBUFFER, GL_RGBA32F, static_cast<GLsizei>(width_), static_cast<GLsizei>(height_));
  gl_.glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, renderbuffer_);
  if (gl_.glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE) return std::nullopt;
  return Failure{"this OpenGL cannot draw into 32-bit floats"};
}

std::vector<float> SceneTarget::read(const SceneTile& tile) const {
  std::vector<float> rgba(tile.pixel_count() * 4);
  gl_.glReadPixels(0, 0, static_cast<GLsizei>(tile.width), static_cast<GLsizei>(tile.height), GL_RGBA, GL_FLOAT,
                   rgba.data());
  std::vector<float> values(tile.pixel_count() * 3);
  for (std::size_t row = 0; row < tile.height; ++row) {
    const float* from = &rgba[(tile.height - 1 - row) * tile.width * 4];
    float* to = &values[row * tile.width * 3];
    for (std::size_t column = 0; column < tile.width; ++column) std::copy_n(from + column * 4, 3, to + column * 3);
  }
  return values;
}

}  // namespace texbrdf::render
