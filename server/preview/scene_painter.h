#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "render/bad_pixels.h"
#include "render/scene_view.h"
#include "render/worker_client.h"
#include "scene/scene_shader.h"

namespace texbrdf::preview {

/// What a preview of a scene is to show.
struct SceneShot {
  std::shared_ptr<const scene::SceneShader> shader;
  render::SceneState state;
  render::SceneLook look;
  render::SceneDisplay display;
  uint32_t width = 512;
  uint32_t height = 512;
  int64_t version = 0;     ///< of the document, as the client counts
  bool is_current = true;  ///< false: the files as they are cannot be drawn, this is what could be last
};

/// A picture for the client. One of a scene that was just changed may have fewer pixels than were asked for, in the
/// same proportion.
struct SceneFrame {
  int64_t preview = 0;
  int64_t version = 0;
  uint32_t width = 0;
  uint32_t height = 0;
  uint32_t samples = 0;      ///< so far, of each pixel
  uint32_t all_samples = 0;  ///< that there will be
  render::SceneView view = render::SceneView::Shaded;
  std::vector<uint8_t> png;
  double milliseconds = 0;  ///< from the shot's arrival to the encoded picture
  render::BadPixelCounts bad_pixels;
  bool is_current = true;
};

/// The shot cannot be drawn; the client keeps what it has.
struct SceneTrouble {
  int64_t preview = 0;
  int64_t version = 0;
  std::shared_ptr<const scene::SceneShader> shader;
  render::RenderFault fault;
};

using SceneEvent = std::variant<SceneFrame, SceneTrouble>;

inline constexpr uint32_t kMostPreviewSamples = 64;

/// Draws scenes of previews in a render worker, on a thread of its own: at first with as few pixels as can be had at
/// once, then with all of them, then with more and more samples until another shot is shown. At most one frame of a
/// preview is on its way to the client; what is drawn in the meantime waits, and only the last of it.
class ScenePainter {
 public:
  /// `wake` is called, on any thread, when `take_events` has something to give.
  explicit ScenePainter(std::function<void()> wake, render::WorkerOptions options = {});
  ~ScenePainter();
  ScenePainter(const ScenePainter&) = delete;
  ScenePainter& operator=(const ScenePainter&) = delete;

  void show(int64_t preview, SceneShot shot);
  /// The client has shown the frame that it got last.
  void acknowledge(int64_t preview);
  void close(int64_t preview);
  std::vector<SceneEvent> take_events();

 private:
  class Thread;
  std::unique_ptr<Thread> thread_;
};

}  // namespace texbrdf::preview
