#pragma once

#include <array>
#include <cmath>
#include <glm/vec3.hpp>
#include <optional>

#include "scene/check.h"
#include "scene/scene.h"
#include "support/random.h"

namespace texbrdf::test {

/// Trees of all built-in objects, a few units large, with transforms of all kinds.
class RandomScene {
 public:
  explicit RandomScene(uint64_t seed, bool has_dynamic = false) : random_(seed), has_dynamic_(has_dynamic) {}

  scene::Scene make(std::size_t nodes = 24) {
    for (;;) {
      scene_ = {};
      budget_ = nodes;
      const std::size_t roots = whole(1, 3);
      for (std::size_t i = 0; i < roots; ++i) scene_.roots.push_back(node(0, false));
      if (!find_fault(scene_)) return scene_;
    }
  }

  glm::dvec3 place(double reach = 3) { return {real(-reach, reach), real(-reach, reach), real(-reach, reach)}; }
  double real(double least, double greatest) { return random_.real(least, greatest); }

 private:
  bool chance(double probability) { return random_.chance(probability); }
  std::size_t whole(std::size_t least, std::size_t greatest) { return least + random_.below(greatest - least + 1); }

  const scene::ObjectEntry& entry(std::size_t depth, bool flat) {
    const auto entries = scene::object_entries();
    for (;;) {
      const scene::ObjectEntry& found = entries[whole(0, entries.size() - 1)];
      const bool is_flat = found.object_class == scene::ObjectClass::Primitive2d;
      const bool is_primitive = found.id != 0;
      if (is_primitive && is_flat != flat) continue;
      if (!is_primitive && (depth >= 5 || budget_ == 0)) continue;
      const bool is_repetition =
          found.kind == scene::ObjectKind::InfiniteRepetition || found.kind == scene::ObjectKind::LimitedRepetition;
      if (is_repetition && repetitions_ > 0) continue;
      if (flat && (found.kind == scene::ObjectKind::Extrusion || found.kind == scene::ObjectKind::Revolution)) continue;
      return found;
    }
  }

  double number(const scene::Datum& datum, scene::ObjectKind kind) {
    switch (datum.domain) {
      case scene::Domain::Any:
        return datum.name == "frequency" ? real(1, 20) : real(-1, 1);
      case scene::Domain::Positive:
        return kind == scene::ObjectKind::LimitedRepetition ? real(1, 3) : real(0.1, 0.9);
      case scene::Domain::NotNegative:
        if (kind == scene::ObjectKind::InfiniteRepetition) return chance(0.3) ? 0 : real(1, 4);
        return chance(0.2) ? 0 : real(0, 0.3);
      case scene::Domain::UpToQuarterTurn:
        return real(0.1, 1.4);
      case scene::Domain::UpToHalfTurn:
        return real(0.1, 3.1);
      case scene::Domain::Count:
        return static_cast<double>(whole(0, 3));
      case scene::Domain::Flag:
        return static_cast<double>(whole(0, 1));
    }
    return 0;
  }

  scene::Transform transform(bool flat) {
    scene::Transform result;
    if (chance(0.6)) result.position = {real(-1, 1), real(-1, 1), flat ? 0 : real(-1, 1)};
    if (chance(0.5)) result.rotation = {flat ? 0 : real(-3, 3), flat ? 0 : real(-3, 3), real(-3, 3)};
    if (chance(0.3)) result.scale = {real(0.5, 2), real(0.5, 2), real(-2, -0.5)};
    if (chance(0.2)) result.scale.fill(real(0.3, 3));
    return result;
  }

  scene::NodeId node(std::size_t depth, bool flat) {
    if (budget_ > 0) --budget_;
    const scene::ObjectEntry& what = entry(depth, flat);
    scene::Node node;
    node.kind = what.kind;
    for (std::size_t i = 0; i < what.data_count; ++i) node.data[i] = number(what.data[i], what.kind);
    node.transform = transform(flat);
    const bool opens_flat = what.kind == scene::ObjectKind::Extrusion || what.kind == scene::ObjectKind::Revolution;
    const bool is_primitive = what.id != 0;
    const std::size_t count = is_primitive ? (depth < 3 && budget_ > 0 && chance(0.15) ? 1 : 0)
                              : what.object_class == scene::ObjectClass::Binary ? whole(2, chance(0.1) ? 14 : 3)
                                                                                : whole(1, 2);
    const bool repeats =
        what.kind == scene::ObjectKind::InfiniteRepetition || what.kind == scene::ObjectKind::LimitedRepetition;
    repetitions_ += repeats ? 1 : 0;
    for (std::size_t i = 0; i < count; ++i) node.children.push_back(this->node(depth + 1, flat || opens_flat));
    repetitions_ -= repeats ? 1 : 0;
    const scene::NodeId id{static_cast<uint32_t>(scene_.nodes.size())};
    if (has_dynamic_ && chance(0.1)) node.dynamic = scene::Dynamic{"d" + std::to_string(id.value), {}};
    scene_.nodes.push_back(std::move(node));
    return id;
  }

  Random random_;
  bool has_dynamic_;
  scene::Scene scene_;
  std::size_t budget_ = 0;
  int repetitions_ = 0;  // around what is made; not more than one, for the time that a test takes
};

}  // namespace texbrdf::test
