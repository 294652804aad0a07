#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "lighting/environment.h"
#include "preview/evaluate_table.h"
#include "preview/object_surface.h"
#include "render/tone_map.h"

namespace texbrdf::preview {

/// An object in a light.
struct ObjectScene {
  render::SphereView view;  ///< size, zoom, gamma, exposure, directional light
  SeenObject object;
  std::shared_ptr<const lighting::Environment> environment;  ///< nothing: the directional light of the view
};

/// A picture of an object as it becomes better with more samples. Light comes to each point unhindered: the object
/// casts no shadows and does not mirror itself.
class ObjectPicture {
 public:
  explicit ObjectPicture(ObjectScene scene);

  /// Samples in each pixel so far. In a directional light all of it is drawn by the first.
  uint32_t samples() const { return samples_; }
  bool is_exact() const { return !scene_.environment; }
  /// `count` more samples in each pixel, at least 1; asks the evaluator as often as is needed. Nothing, or why it
  /// failed. Where `is_wanted`, which is asked now and then, says no, the picture is of no use any more.
  std::optional<render::RenderFault> add(uint32_t count, const TableEvaluator& evaluate,
                                         const std::function<bool()>& is_wanted);
  render::Picture picture() const;
  /// The linear radiance of each pixel, before exposure; black where nothing is seen.
  std::vector<glm::dvec3> radiance() const;

 private:
  struct Batch;
  void add_directional(Batch& batch);
  void add_environment(Batch& batch, uint32_t index);

  ObjectScene scene_;
  ObjectSurface surface_;
  std::vector<glm::dvec3> sums_;                      // of each pixel
  std::vector<std::optional<render::BadPixel>> bad_;  // of each pixel: the worst of its values
  uint32_t samples_ = 0;
};

}  // namespace texbrdf::preview
