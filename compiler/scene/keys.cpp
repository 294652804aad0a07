#include "scene/keys.h"

#include <algorithm>
#include <array>

namespace texbrdf::scene {
namespace {

using std::operator""sv;

constexpr std::array kNames{
#define SCENE_KEY(name) #name##sv,
#include "scene/keys.def"
#undef SCENE_KEY
};

}  // namespace

std::span<const std::string_view> key_names() {
  return kNames;
}

bool is_key_name(std::string_view name) {
  return std::ranges::find(kNames, name) != kNames.end();
}

}  // namespace texbrdf::scene
