#include <array>

#include "emit/dialect.h"
#include "emit/disney.h"
#include "emit/emit.h"
#include "emit/glsl.h"
#include "emit/glsl_code.h"

namespace texbrdf::emit {
namespace {

constexpr std::array kTargets{
    Target{"glsl", ".glsl", "functions of GLSL 330 and ESSL 300, to be pasted into a shader", emit_glsl},
    Target{"disney", ".brdf", "a file that Disney BRDF Explorer loads", emit_disney},
};

}  // namespace

std::span<const Target> targets() {
  return kTargets;
}

const Target* find_target(std::string_view name) {
  for (const Target& target : kTargets)
    if (target.name == name) return &target;
  return nullptr;
}

std::vector<std::string> parameter_identifiers(const ir::Program& program) {
  Namer names = entry_point_names(kGlslDialect);
  return claim_parameters(program, names);
}

}  // namespace texbrdf::emit
