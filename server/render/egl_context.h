#pragma once

#include <memory>
#include <string>

#include "render/gl.h"
#include "source/result.h"

namespace texbrdf::render {

/// An OpenGL 3.3 core context without window or surface, current on the thread that made it.
/// libEGL is opened when the program runs. The surfaceless platform of Mesa is tried first, then each device: drivers
/// beside Mesa may offer only those. The environment variable TEXBRDF_EGL=surfaceless|device|none restricts the choice.
class EglContext {
 public:
  static Result<EglContext> create();
  EglContext(EglContext&&) noexcept;
  EglContext& operator=(EglContext&&) noexcept;
  ~EglContext();

  const Gl& gl() const;
  /// "llvmpipe (LLVM 15.0.6, 256 bits), OpenGL 4.5 (Core Profile) Mesa 22.3.6, EGL surfaceless"
  const std::string& description() const;

 private:
  struct State;
  explicit EglContext(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace texbrdf::render
