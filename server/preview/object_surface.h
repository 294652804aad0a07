#pragma once

#include <memory>

#include "objects/rasterise.h"
#include "render/sphere.h"

namespace texbrdf::preview {

/// What is drawn and from where; its light is told elsewhere.
struct SeenObject {
  std::shared_ptr<const objects::Mesh> mesh;  ///< in the unit sphere; nothing: the sphere itself
  objects::Orbit orbit;
  friend bool operator==(const SeenObject&, const SeenObject&) = default;
};

/// All that is seen of an object in a picture, from which the frames of its points are formed.
class ObjectSurface {
 public:
  /// Size and zoom of the view; a unit sphere around the object would look as the sphere does.
  ObjectSurface(SeenObject object, const render::SphereView& view);

  const objects::Coverage& coverage() const { return coverage_; }
  /// `fragment` counts in the coverage. As the viewer sees it, V = (0, 0, 1).
  objects::SurfaceFrame frame(std::size_t fragment) const;
  /// From the object to the viewer.
  const glm::dmat3& rotation() const { return rotation_; }

 private:
  SeenObject object_;
  glm::dmat3 rotation_;
  objects::Coverage coverage_;  // of the sphere: x and y of the points as weights
};

}  // namespace texbrdf::preview
