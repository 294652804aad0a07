#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "preview/scene.h"
#include "render/worker_client.h"

namespace texbrdf::preview {

/// Draws the scenes of previews on threads of its own: at once on the CPU (up to 512² pixels), then on the GPU. A newer
/// scene takes the place of one that waits. At most one frame of a preview is on its way to the client; what is drawn
/// in the meantime waits, and only the last of it.
class PreviewService {
 public:
  /// `wake` is called, on any thread, when `take_events` has something to give.
  explicit PreviewService(std::function<void()> wake, render::WorkerOptions options = {});
  ~PreviewService();
  PreviewService(const PreviewService&) = delete;
  PreviewService& operator=(const PreviewService&) = delete;

  /// Of a new preview, or of one that shows something else now.
  void show(int64_t preview, Scene scene);
  /// The client has shown the frame that it got last.
  void acknowledge(int64_t preview);
  void close(int64_t preview);

  /// What is to be sent now.
  std::vector<Event> take_events();
  /// What went wrong with the GPU since the last call: lines for a log.
  std::vector<std::string> take_faults();

 private:
  class Painter;
  std::unique_ptr<Painter> painter_;
};

}  // namespace texbrdf::preview
