#include "scene/tree_glsl.h"

#include <fmt/format.h>

#include "scene/glsl_text.h"
#include "scene/primitives.h"

namespace texbrdf::scene {
namespace {

// Each node that is not one expression is a function of a place of its parent and of `most`: where it is not nearer
// than that, it may say anything that is not nearer either.
constexpr std::string_view kJoins = R"(
vec2 nearer(vec2 a, vec2 b) { return b.x < a.x ? b : a; }
vec2 farther(vec2 a, vec2 b) { return b.x > a.x ? b : a; }
vec2 negated(vec2 a) { return vec2(-a.x, a.y); }
vec2 smoothly_nearer(vec2 a, vec2 b, float k) { return vec2(smooth_union(a.x, b.x, k), nearer(a, b).y); }
vec2 smoothly_farther(vec2 a, vec2 b, float k) { return vec2(smooth_intersection(a.x, b.x, k), farther(a, b).y); }
)";

/// No distance is more.
constexpr std::string_view kAll = "1e30";

constexpr std::string_view kMovedPlace = R"(
vec3 moved_place(int i, vec3 p) {
  vec4 q = vec4(p, 1.0);
  return vec3(dot(scene_frames[i], q), dot(scene_frames[i + 1], q), dot(scene_frames[i + 2], q));
}
)";

class TreeWriter {
 public:
  TreeWriter(const TreePlan& plan, const Scene& scene, std::span<const std::string> prefixes)
      : plan_(plan), scene_(scene), prefixes_(prefixes) {}

  std::string run() {
    for (uint32_t i = 0; i < plan_.nodes.size(); ++i) {
      if (!is_inline(plan_.nodes[i])) write(i);
    }
    text_ += fmt::format("vec2 scene_distance(vec3 place) {{ return {}; }}\n", value_of(plan_.root, "place", kAll));
    const std::string joins(kJoins);
    std::string head = "bool scene_guarded = true;\n";
    head += fmt::format("#define real float\n{}#undef real\n", functions_for(joins + text_));
    head += joins;
    if (text_.find("moved_place(") != std::string::npos) head += kMovedPlace;
    return head + text_;
  }

 private:
  static bool is_inline(const PlannedNode& node) {
    return is_primitive(node.kind) && node.children.empty() && !node.dynamic && !node.guard;
  }

  std::string place_in(const PlannedNode& node, std::string_view place) const {
    const Frame& frame = node.frame;
    if (node.dynamic) return fmt::format("moved_place({}, {})", *node.dynamic * kFramesStride, place);
    const std::string moved = frame.position == glm::dvec3(0)
                                  ? std::string(place)
                                  : fmt::format("({} - {})", place, vector_text(frame.position));
    if (frame.to_local == glm::dmat3(1)) return moved;
    return fmt::format("({} * {})", matrix_text(frame.to_local), moved);
  }

  std::string factor(const PlannedNode& node) const {
    if (node.dynamic) return fmt::format("scene_frames[{}].x", *node.dynamic * kFramesStride + 3);
    return node.frame.factor == 1 ? std::string() : float_text(node.frame.factor);
  }

  /// A vec2 of the node at a place of its parent.
  std::string value_of(uint32_t index, std::string_view place, std::string_view most) const {
    const PlannedNode& node = plan_.nodes[index];
    if (!is_inline(node)) return fmt::format("node_{}({}, {})", index, place, most);
    const std::string scale = factor(node);
    return fmt::format("vec2({}{}{}, {})", scale, scale.empty() ? "" : " * ", own_distance(node, place_in(node, place)),
                       float_text(node.leaf));
  }

  /// A float: the primitive alone, at a place in its own frame.
  std::string own_distance(const PlannedNode& node, const std::string& place) const {
    std::vector<std::string> numbers;
    if (node.kind == ObjectKind::UserPrimitive) {
      for (const double number : node.data) numbers.push_back(float_text(number));
      const UserPrimitive& primitive = scene_.user_primitives[node.user_primitive.value];
      const std::string value =
          fmt::format("{}{}({}, Primitive3D(float[8]({}))) / {}", prefixes_[node.user_primitive.value], primitive.name,
                      place, fmt::join(numbers, ", "), float_text(node.lipschitz));
      if (!node.bounds) return value;
      return fmt::format("max({}, {})", value, distance_to(glm::dvec3(0), to_vector(*node.bounds), place));
    }
    const PrimitiveFunction function = primitive_function(node.kind);
    for (std::size_t i = 0; i < function.number_count; ++i) numbers.push_back(float_text(node.data[i]));
    return fmt::format("{}({}, {})", function.name, place, fmt::join(numbers, ", "));
  }

  void line(std::string_view statement) { text_ += fmt::format("  {}\n", statement); }

  void write(uint32_t index) {
    const PlannedNode& node = plan_.nodes[index];
    text_ += fmt::format("vec2 node_{}(vec3 p, float most) {{\n", index);
    const std::string place = place_in(node, "p");
    if (place != "p") line(fmt::format("p = {};", place));
    const std::string scale = factor(node);
    if (!scale.empty()) line(fmt::format("most /= {};", scale));
    if (node.guard) write_guard(node, scale);
    write_inside(node);
    if (node.guard) {
      line(fmt::format("if (scene_guarded) d.x = guarded(d.x, outside, {}, {});", float_text(node.guard->level),
                       float_text(node.guard->margin)));
    }
    if (!scale.empty()) line(fmt::format("d.x *= {};", scale));
    line("return d;");
    text_ += "}\n";
  }

  static std::string distance_to(const glm::dvec3& centre, const glm::dvec3& half, std::string_view place) {
    const std::string moved =
        centre == glm::dvec3(0) ? std::string(place) : fmt::format("{} - {}", place, vector_text(centre));
    return fmt::format("box_distance({}, {})", moved, vector_text(half));
  }

  void write_guard(const PlannedNode& node, std::string_view scale) {
    const Guard& guard = *node.guard;
    const std::string level = float_text(guard.level);
    line(fmt::format("float outside = {};", distance_to(guard.box.centre(), guard.box.half(), "p")));
    line(
        fmt::format("if ((scene_guarded && outside > {}) || {} + outside >= most) return vec2(({} + outside){}{}, {});",
                    float_text(guard.margin), level, level, scale.empty() ? "" : " * ", scale, float_text(node.leaf)));
  }

  /// Declares `d`, of all children.
  void united(const PlannedNode& node, std::string_view place, std::string_view most = kAll) {
    line(fmt::format("vec2 d = {};", value_of(node.children.front(), place, most)));
    for (std::size_t i = 1; i < node.children.size(); ++i)
      line(fmt::format("d = nearer(d, {});", value_of(node.children[i], place, "d.x")));
  }

  void joined(const PlannedNode& node, std::string_view form) {
    line(fmt::format("vec2 d = {};", value_of(node.children.front(), "p", kAll)));
    for (std::size_t i = 1; i < node.children.size(); ++i) {
      const std::string other = value_of(node.children[i], "p", kAll);
      line(fmt::format("d = {};", fmt::format(fmt::runtime(form), other, float_text(node.data[0]))));
    }
  }

  /// The box of a copy is asked first: most of those that are near have nothing to say.
  void repeated(const PlannedNode& node) {
    const Repetition& plan = *node.repetition;
    const std::string spacing = vector_text(plan.spacing);
    const std::string inverse = vector_text(inverse_spacing(plan));
    const std::string last = vector_text(plan.last);
    const std::string window = vector_text(plan.window);
    line(fmt::format("vec3 x = p - {};", vector_text(plan.centre)));
    line(fmt::format("vec3 first = first_copy(x, {}, {}, {});", inverse, last, window));
    line(fmt::format("vec2 d = vec2({} + distance_beside(x, first, {}, {}, {}, {}, {}), {});", float_text(plan.level),
                     spacing, inverse, last, window, vector_text(plan.half), float_text(node.leaf)));
    const glm::ivec3 count(plan.window);
    line(fmt::format("for (int i = 0; i < {}; ++i) {{", count.x * count.y * count.z));
    line(fmt::format("  vec3 q = p - {} * (first + vec3(i % {}, i / {} % {}, i / {}));", spacing, count.x, count.x,
                     count.y, count.x * count.y));
    line(fmt::format("  float least = {} + {};", float_text(plan.level), distance_to(plan.centre, plan.half, "q")));
    line("  if (least >= d.x) continue;");
    for (const uint32_t child : node.children) {
      line(fmt::format("  vec2 e_{} = {};", child, value_of(child, "q", "d.x")));
      line(fmt::format("  d = nearer(d, vec2(max(e_{}.x, least), e_{}.y));", child, child));
    }
    line("}");
  }

  /// What a twist or bend of `d` says.
  void deformed(const PlannedNode& node, std::string_view function, std::string_view radius) {
    line(fmt::format("d.x = {}(d.x, {}, {});", function, float_text(std::abs(node.data[0])), radius));
    if (node.cut) line(fmt::format("d.x = max(d.x, {});", distance_to(node.cut->centre(), node.cut->half(), "p")));
  }

  void write_inside(const PlannedNode& node) {
    const auto& d = node.data;
    const auto number = [&](std::size_t i) { return float_text(d[i]); };
    switch (node.kind) {
      case ObjectKind::InfiniteRepetition:
      case ObjectKind::LimitedRepetition:
        return repeated(node);
      case ObjectKind::Displacement:
        united(node, "p");
        return line(fmt::format("d.x = max((d.x + displacement(p, {}, {})) / {}, d.x - {});", number(0), number(1),
                                float_text(node.lipschitz), float_text(std::abs(d[0]))));
      case ObjectKind::Twist:
        line(fmt::format("vec2 q = turned(p.zx, {} * p.y);", float_text(-d[0])));
        united(node, "vec3(q.y, p.y, q.x)");
        return deformed(node, "twisted_distance", "length(p.xz)");
      case ObjectKind::Bend:
        line(fmt::format("vec2 q = turned(p.xy, {} * p.x);", float_text(-d[0])));
        united(node, "vec3(q, p.z)");
        return deformed(node, "bent_distance", "length(p.xy)");
      case ObjectKind::Symmetry:
        return united(node, fmt::format("vec3({}p.x), {}p.y), {}p.z))", d[0] == 0 ? "(" : "abs(",
                                        d[1] == 0 ? "(" : "abs(", d[2] == 0 ? "(" : "abs("));
      case ObjectKind::Rounding:
        united(node, "p");
        return line(fmt::format("d.x -= {};", number(0)));
      case ObjectKind::Shell:
        united(node, "p");
        return line(fmt::format("d.x = abs(d.x) - {};", number(0)));
      case ObjectKind::Elongation: {
        const std::string half = vector_text({d[0], d[1], d[2]});
        return united(node, fmt::format("(p - clamp(p, -{}, {}))", half, half));
      }
      case ObjectKind::Extrusion:
        united(node, "vec3(p.xy, 0.0)");
        return line(fmt::format("d.x = length_above(vec2(d.x, abs(p.z) - {}));", number(0)));
      case ObjectKind::Revolution:
        return united(node, fmt::format("vec3(length(p.xz) - {}, p.y, 0.0)", number(0)));
      case ObjectKind::Union:
        return united(node, "p", "most");
      case ObjectKind::Subtraction:
        return joined(node, "farther(d, negated({}))");
      case ObjectKind::Intersection:
        return joined(node, "farther(d, {})");
      case ObjectKind::SmoothUnion:
        return joined(node, "smoothly_nearer(d, {}, {})");
      case ObjectKind::SmoothSubtraction:
        return joined(node, "smoothly_farther(d, negated({}), {})");
      case ObjectKind::SmoothIntersection:
        return joined(node, "smoothly_farther(d, {}, {})");
      case ObjectKind::UserPrimitive:
#define HELPER(name, ...)
#define DISTANCE_FUNCTION(kind, name, ...) case ObjectKind::kind:
#include "scene/distance_functions.def"
#undef DISTANCE_FUNCTION
#undef HELPER
        line(fmt::format("vec2 d = vec2({}, {});", own_distance(node, "p"), float_text(node.leaf)));
        for (const uint32_t child : node.children) line(fmt::format("d = nearer(d, {});", value_of(child, "p", "d.x")));
        return;
    }
  }

  const TreePlan& plan_;
  const Scene& scene_;
  std::span<const std::string> prefixes_;
  std::string text_;
};

}  // namespace

std::string tree_glsl(const TreePlan& plan, const Scene& scene, std::span<const std::string> primitive_prefixes) {
  return TreeWriter(plan, scene, primitive_prefixes).run();
}

}  // namespace texbrdf::scene
