#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "source/result.h"

namespace texbrdf::objects {

/// The lines of a .obj file that matter here, and nothing that its reader would take for zeros or leave out.
struct ObjLines {
  std::string text;                  ///< lines `v`, `vt`, `vn` and `f`, without comments
  std::vector<uint32_t> face_lines;  ///< of each face: its line in the file, from 1 on
};

/// Fails, with the line, for words that are no numbers, numbers that are not finite or beyond a float, places that do
/// not exist, more of anything than the limits of obj_file.h allow.
Result<ObjLines> check_obj_lines(std::string_view text);

}  // namespace texbrdf::objects
