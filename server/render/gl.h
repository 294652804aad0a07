#pragma once

#include <GL/glcorearb.h>

namespace texbrdf::render {

/// OpenGL as the current context gives it: nothing is linked.
struct Gl {
#define GL_FUNCTION(name, type) type name = nullptr;
#include "render/gl_functions.def"
#undef GL_FUNCTION
};

}  // namespace texbrdf::render
