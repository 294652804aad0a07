#include "render/glsl_check.h"

#include <glslang/Public/ResourceLimits.h>
#include <glslang/Public/ShaderLang.h>

#include <string_view>

namespace texbrdf::render {

namespace {

constexpr int kDefaultVersion = 330;

std::string first_error(std::string_view log) {
  constexpr std::string_view kLabel = "ERROR: ";
  if (const std::size_t begin = log.find(kLabel); begin != std::string_view::npos) {
    log.remove_prefix(begin + kLabel.size());
  }
  log = log.substr(0, log.find('\n'));
  return std::string(log.substr(0, log.find_last_not_of(' ') + 1));
}

}  // namespace

GlslChecker::GlslChecker() {
  glslang::InitializeProcess();
  static_cast<void>(find_fault("#version 330 core\nvoid main() {}\n"));
}

GlslChecker::~GlslChecker() {
  glslang::FinalizeProcess();
}

std::optional<std::string> GlslChecker::find_fault(const std::string& fragment_shader) const {
  glslang::TShader shader(EShLangFragment);
  const char* text = fragment_shader.c_str();
  shader.setStrings(&text, 1);
  if (!shader.parse(GetDefaultResources(), kDefaultVersion, false, EShMsgDefault)) {
    return first_error(shader.getInfoLog());
  }
  glslang::TProgram program;
  program.addShader(&shader);
  if (!program.link(EShMsgDefault)) return first_error(program.getInfoLog());
  return std::nullopt;
}

}  // namespace texbrdf::render
