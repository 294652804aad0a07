#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <variant>
#include <vector>

#include "analysis/snapshot.h"
#include "ir/program.h"
#include "preview/object_look.h"
#include "render/bad_pixels.h"
#include "render/sphere.h"
#include "source/result.h"

namespace texbrdf::preview {

/// What a preview is to show.
struct Scene {
  Snapshot snapshot;
  uint64_t model = 0;   ///< another number where the equations, the root or the values are others
  int64_t version = 0;  ///< of the document, as the client counts
  std::string root;     ///< canonical; empty: the document's own
  render::SphereView view;
  std::map<std::string, std::vector<double>> values = {};  ///< of parameters, in the place of those in the document
  ObjectLook object = {};
};

/// All that the scene's BRDF needs, with the scene's values; or why it cannot be drawn.
Result<ir::Program> scene_program(const Scene& scene);

enum class Device : uint8_t { Cpu, Gpu };

/// A picture for the client.
struct Frame {
  int64_t preview = 0;
  int64_t version = 0;
  Device device = Device::Cpu;
  uint32_t size = 0;  ///< pixels, width and height
  std::vector<uint8_t> png;
  double milliseconds = 0;  ///< from the scene's arrival to the encoded picture
  render::BadPixelCounts bad_pixels;
  bool is_current = true;    ///< false: the scene cannot be drawn, this is the last one that could
  uint32_t samples = 0;      ///< so far, of each pixel
  uint32_t all_samples = 0;  ///< that there will be; 0 where none are taken
};

/// Whether the scene can be drawn.
struct SceneState {
  int64_t preview = 0;
  int64_t version = 0;
  std::string problem;  ///< one line for a person; empty where it can be drawn
};

using Event = std::variant<SceneState, Frame>;

}  // namespace texbrdf::preview
