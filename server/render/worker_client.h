#pragma once

#include <array>
#include <chrono>
#include <memory>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "eval/evaluate.h"
#include "render/geometry_table.h"
#include "render/scene_protocol.h"
#include "render/shader_model.h"
#include "render/sphere.h"
#include "render/tone_map.h"

namespace texbrdf::render {

enum class RenderFaultKind : uint8_t {
  NoRenderer,  ///< this machine offers no OpenGL 3.3 through EGL, or the worker cannot be started
  Request,     ///< the request itself is wrong (a view out of range, too large a source)
  Shader,      ///< glslang or the driver rejects the shader
  Crash,       ///< the worker ended by itself, or OpenGL failed in it
  Deadline,    ///< no answer in time; the worker was killed
  Protocol,    ///< the worker said something that is no answer; it was killed
};

/// Why there is no picture. The next request starts a fresh worker where the old one is gone.
struct RenderFault {
  RenderFaultKind kind;
  std::string message;  ///< one line for a person
};

struct GpuPicture {
  Picture picture;
  double milliseconds = 0;  ///< in the worker: compilation, drawing, reading back, tone mapping
  bool compiled = false;    ///< false where the program came from the worker's cache
};

struct WorkerOptions {
  std::string executable = "/proc/self/exe";
  std::vector<std::string> arguments = {"render-worker"};
  std::vector<std::string> environment;        ///< "NAME=value", beside this process's own
  std::chrono::milliseconds deadline{10'000};  ///< of one request, the start of the worker included
};

/// The renderer as its users see it: a child process that is started when needed, killed when it misses a deadline or
/// talks nonsense, and started again, more slowly each time it fails in a row. No call blocks longer than the deadline
/// (and the half second that a kill may take). One thread at a time.
class RenderWorker {
 public:
  explicit RenderWorker(WorkerOptions options = {});
  RenderWorker(RenderWorker&&) noexcept;
  RenderWorker& operator=(RenderWorker&&) noexcept;
  ~RenderWorker();  ///< ends the child

  /// Starts the child, so that it warms up while the caller does something else. Optional; never blocks.
  void warm_up();

  std::variant<GpuPicture, RenderFault> draw(const ShaderModel& model, const SphereView& view);
  /// The raw value of the model at each geometry, in single precision.
  std::variant<std::vector<std::array<float, 3>>, RenderFault> evaluate(const ShaderModel& model,
                                                                        std::span<const eval::Geometry> geometries);
  /// One sample of each pixel of a tile of a scene.
  std::variant<SceneAnswer, RenderFault> trace(const SceneRequest& request);
  /// The same for geometries as lists (EvaluateRequest), in one request: red, green and blue of each.
  std::variant<std::vector<float>, RenderFault> evaluate_table(const ShaderModel& model,
                                                               const GeometryTable& geometries);
  /// All faults since the last call, also those found between requests (an idle worker that died): for a log.
  std::vector<RenderFault> take_faults();
  /// What draws, for logs: GL_RENDERER and GL_VERSION. Empty before the first answer.
  const std::string& renderer() const;
  /// The child's process id, -1 while there is none.
  int process_id() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace texbrdf::render
