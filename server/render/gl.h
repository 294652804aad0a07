#pragma once

#include <GL/glcorearb.h>

#include <functional>

#include "source/result.h"

namespace texbrdf::render {

/// OpenGL as the current context gives it: nothing is linked.
struct Gl {
#define GL_FUNCTION(name, type) type name = nullptr;
#include "render/gl_functions.def"
#undef GL_FUNCTION
};

/// eglGetProcAddress, glfwGetProcAddress, …
using GlAddress = std::function<void (*(const char* name))()>;

/// The functions of the context that is current, OpenGL 3.3 with separate shader objects, or what it lacks.
Result<Gl> load_gl(const GlAddress& address);

}  // namespace texbrdf::render
