#include "render/gl.h"

#include <string_view>

namespace texbrdf::render {

namespace {

/// Part of OpenGL 4.1, and an extension of 3.3 wherever there is one: it spares the vertex shader's compilation.
bool has_separate_shaders(const Gl& gl) {
  GLint count = 0;
  gl.glGetIntegerv(GL_NUM_EXTENSIONS, &count);
  for (GLint i = 0; i < count; ++i) {
    const GLubyte* name = gl.glGetStringi(GL_EXTENSIONS, static_cast<GLuint>(i));
    if (name != nullptr && std::string_view(reinterpret_cast<const char*>(name)) == "GL_ARB_separate_shader_objects") {
      return true;
    }
  }
  return false;
}

}  // namespace

Result<Gl> load_gl(const GlAddress& address) {
  Gl gl;
#define GL_FUNCTION(name, type)                     \
  gl.name = reinterpret_cast<type>(address(#name)); \
  if (gl.name == nullptr) return Failure{"this OpenGL has no function " #name};
#include "render/gl_functions.def"
#undef GL_FUNCTION
  if (!has_separate_shaders(gl)) return Failure{"this OpenGL has no separate shader objects"};
  return gl;
}

}  // namespace texbrdf::render
