#pragma once

#include "plots/drawing.h"
#include "render/image.h"

namespace texbrdf::plots {

/// The drawing in its own size, every pixel opaque.
render::ImageRgba8 rasterise(const Drawing& drawing);

}  // namespace texbrdf::plots
