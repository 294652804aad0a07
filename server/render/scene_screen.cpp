#include "render/scene_screen.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>

namespace texbrdf::render {

namespace {

/// What a picture may take while something moves, and what one of fewer pixels is to take.
constexpr double kLongMilliseconds = 60;
constexpr double kWantedMilliseconds = 40;
constexpr double kLeastSide = 64;

uint32_t scaled(uint32_t pixels, double part) {
  return std::max(static_cast<uint32_t>(std::lround(pixels * part)), 1U);
}

GLint pixels(uint32_t count) {
  return static_cast<GLint>(count);
}

}  // namespace

SceneScreen::SceneScreen(const Gl& gl, SceneTracer& tracer) : gl_(gl), tracer_(tracer) {
  gl_.glGenFramebuffers(1, &framebuffer_);
  gl_.glGenRenderbuffers(1, &renderbuffer_);
}

SceneScreen::~SceneScreen() {
  gl_.glDeleteFramebuffers(1, &framebuffer_);
  gl_.glDeleteRenderbuffers(1, &renderbuffer_);
}

double SceneScreen::part_of(uint32_t width, uint32_t height) const {
  const double expected = milliseconds_a_pixel_ * width * height;
  if (expected <= kLongMilliseconds) return 1;
  const double least = kLeastSide / std::max(std::min(width, height), 1U);
  return std::min(std::max(std::sqrt(kWantedMilliseconds / expected), least), 1.0);
}

void SceneScreen::resize(uint32_t width, uint32_t height) {
  if (width == width_ && height == height_) return;
  width_ = width;
  height_ = height;
  gl_.glBindRenderbuffer(GL_RENDERBUFFER, renderbuffer_);
  gl_.glRenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, pixels(width), pixels(height));
  gl_.glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
  gl_.glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, renderbuffer_);
}

void SceneScreen::stretch(uint32_t from_width, uint32_t from_height, uint32_t width, uint32_t height) const {
  gl_.glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer_);
  gl_.glBindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
  gl_.glBlitFramebuffer(0, 0, pixels(from_width), pixels(from_height), 0, 0, pixels(width), pixels(height),
                        GL_COLOR_BUFFER_BIT, GL_LINEAR);
  gl_.glBindFramebuffer(GL_FRAMEBUFFER, 0);
}

Result<SceneScreen::Drawn> SceneScreen::draw(const std::string& source, const SceneState& state, const SceneLook& look,
                                             uint32_t width, uint32_t height, const SceneDisplay& display,
                                             bool is_moving) {
  using Clock = std::chrono::steady_clock;
  const double part = is_moving ? part_of(width, height) : 1;
  const bool is_whole = part >= 1;
  const SceneTile tile{scaled(width, part), scaled(height, part), 0, 0, scaled(width, part), scaled(height, part)};
  if (!is_whole) resize(tile.width, tile.height);
  gl_.glBindFramebuffer(GL_FRAMEBUFFER, is_whole ? 0 : framebuffer_);
  const Clock::time_point begin = Clock::now();
  const auto drawn = tracer_.draw(source, state, look, tile, scene_sample(0), &display);
  if (!drawn) return Failure{drawn.error()};
  std::array<uint8_t, 4> pixel{};  // reading one waits for all
  gl_.glReadPixels(0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel.data());
  const double milliseconds = std::chrono::duration<double, std::milli>(Clock::now() - begin).count();
  if (!drawn->compiled) milliseconds_a_pixel_ = milliseconds / static_cast<double>(tile.pixel_count());
  if (!is_whole) stretch(tile.width, tile.height, width, height);
  return Drawn{is_whole};
}

}  // namespace texbrdf::render
