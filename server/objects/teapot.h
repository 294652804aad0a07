#pragma once

#include "objects/mesh.h"

namespace texbrdf::objects {

/// The Utah teapot with its bottom, in Newell's units, +y up and the spout towards +x. Normals and tangents are those
/// of the patches themselves: X goes around the axis of body and lid (counter-clockwise seen from above), and around
/// the cross-sections of handle and spout. `steps`, at least 1: how many squares each of the 32 patches has along a
/// side.
Mesh make_teapot(uint32_t steps = 20);

}  // namespace texbrdf::objects
