#pragma once

#include <optional>
#include <string>

namespace texbrdf::render {

/// glslang, the reference compiler: what every shader passes before a driver sees it. Making one takes 0.1 s, for the
/// tables of built-in functions. One thread at a time.
class GlslChecker {
 public:
  GlslChecker();
  ~GlslChecker();
  GlslChecker(const GlslChecker&) = delete;
  GlslChecker& operator=(const GlslChecker&) = delete;

  /// The first complaint about a fragment shader, in one line, or nothing.
  std::optional<std::string> find_fault(const std::string& fragment_shader) const;
};

}  // namespace texbrdf::render
