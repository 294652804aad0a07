#pragma once

#include <list>
#include <string>

#include "render/gl.h"
#include "render/glsl_check.h"
#include "render/shader_text.h"
#include "source/result.h"

namespace texbrdf::render {

/// Compiled fragment programs by their text; the ones used last stay. Parameters are uniforms, so a new value finds its
/// program here.
class ProgramCache {
 public:
  struct Program {
    ShaderText text;
    GLuint id = 0;
  };
  struct Found {
    const Program* program;  ///< until the next call
    bool compiled;
  };

  ProgramCache(const Gl& gl, const GlslChecker& checker) : gl_(gl), checker_(checker) {}
  ~ProgramCache();
  ProgramCache(const ProgramCache&) = delete;
  ProgramCache& operator=(const ProgramCache&) = delete;

  Result<Found> find_or_compile(const std::string& source, GeometrySource geometry);
  /// Fails with what is wrong with the text, in one line.
  Result<Found> find_or_compile(ShaderText text);

 private:
  const Gl& gl_;
  const GlslChecker& checker_;
  std::list<Program> programs_;  ///< the one used last first
};

/// The driver's program for one stage, or what it says against the text.
Result<GLuint> compile_program(const Gl& gl, GLenum stage, const char* text);

}  // namespace texbrdf::render
