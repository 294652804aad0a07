#include "render/scene_text.h"

#include <fmt/format.h>

#include "render/bad_pixels.h"

namespace texbrdf::render {

namespace {

// Drivers write the code of a function anew at each place that calls it, and that of a scene is long. So each loop
// below has one call of scene_distance, and begins at a uniform that is 0, which keeps loops from being unrolled.

constexpr std::string_view kUniforms = R"(
uniform vec3 trace_eye;
uniform vec3 trace_forward;
uniform vec3 trace_right;
uniform vec3 trace_up;
uniform vec2 trace_corner;
uniform vec2 trace_size;
uniform vec2 trace_jitter;
uniform int trace_zero;
uniform int trace_view;
uniform int trace_max_steps;
uniform float trace_max_distance;
uniform float trace_threshold;
uniform float trace_depth;
uniform vec3 trace_background;
uniform vec3 trace_ambient;
uniform vec2 trace_ambient_jitter;
uniform int trace_light_count;
uniform vec4 trace_light_places[16];
uniform vec3 trace_light_colours[16];
uniform float trace_light_width;
uniform float trace_occlusion_radius;
uniform vec2 trace_display;
out vec4 trace_value;
)";

// J. C. Hart, "Sphere tracing", The Visual Computer 12, 1996. A ray that runs out of steps has met nothing. Normals by
// four values at the corners of a tetrahedron: iquilezles.org/articles/normalsSDF.
constexpr std::string_view kMarch = R"(
struct trace_Hit {
  float t;
  float steps;
  float slope;
  float leaf;
  bool met;
};

const vec3 trace_corners[4] = vec3[4](vec3(1.0, -1.0, -1.0), vec3(-1.0, -1.0, 1.0), vec3(-1.0, 1.0, -1.0), vec3(1.0));

#ifdef TRACE_SLOPES
float trace_slope_around(vec3 place) {
  vec3 far = abs(place);
  float h = 0.001 * (1.0 + max(far.x, max(far.y, far.z)));
  float values[6];
  vec3 gradient = vec3(0.0);
  for (int i = trace_zero; i < 6; ++i) {
    vec3 offset;
    if (i < 4) {
      offset = trace_corners[i] * 0.57735027;
    } else {
      float size = length(gradient);
      offset = size > 0.0 ? gradient / size : vec3(0.0, 1.0, 0.0);
      if (i == 5) offset = -offset;
    }
    values[i] = scene_distance(place + h * offset).x;
    if (i < 4) gradient += trace_corners[i] * values[i];
  }
  float slope = abs(values[4] - values[5]) / 2.0;
  for (int i = 0; i < 3; ++i) {
    for (int j = i + 1; j < 4; ++j) slope = max(slope, abs(values[i] - values[j]) / 1.6329932);
  }
  return slope / h;
}
#endif

trace_Hit trace_march(vec3 direction) {
  trace_Hit hit = trace_Hit(0.0, 0.0, 0.0, 0.0, false);
  vec2 found = vec2(0.0);
  float walked = 0.0;
  for (int i = trace_zero; i < trace_max_steps; ++i) {
    vec3 place = trace_eye + hit.t * direction;
    float before = found.x;
    found = scene_distance(place);
    hit.steps += 1.0;
#ifdef TRACE_SLOPES
    if (walked > 0.001 * (1.0 + hit.t)) hit.slope = max(hit.slope, abs(found.x - before) / walked);
    hit.slope = max(hit.slope, trace_slope_around(place));
#endif
    if (isnan(found.x)) {
      hit.t = found.x;
      return hit;
    }
    if (found.x < trace_threshold) {
      hit.met = true;
      break;
    }
    walked = found.x;
    hit.t += walked;
    if (hit.t > trace_max_distance) return hit;
  }
  if (hit.met) hit.t += clamp(found.x, -trace_threshold, trace_threshold);
  hit.leaf = found.y;
  return hit;
}

vec3 trace_gradient(vec3 place, float h) {
  vec3 sum = vec3(0.0);
  for (int i = trace_zero; i < 4; ++i) sum += trace_corners[i] * scene_distance(place + h * trace_corners[i]).x;
  return sum / (4.0 * h);
}
)";

// Soft shadows: S. Aaltonen, "GPU-based clay simulation and ray-tracing tech in Claybook", GDC 2018, in the words of
// iquilezles.org/articles/rmshadows. Occlusion: A. Evans, "Fast approximations for global illumination on dynamic
// scenes", SIGGRAPH 2006 courses. The frame of ambient directions: J. R. Frisvad, "Building an orthonormal basis from a
// 3D unit vector without normalization", Journal of Graphics Tools 16, 2012.
constexpr std::string_view kLight = R"(
float trace_seen(vec3 place, vec3 direction, float reach) {
#ifdef TRACE_SHADOWS
  float seen = 1.0;
  float t = 0.0;
  float before = 1e20;
  float near = trace_threshold;
  for (int i = trace_zero; i < trace_max_steps; ++i) {
    float d = scene_distance(place + t * direction).x;
    if (i == trace_zero) near = min(near, 0.5 * d);
    if (!(d > near)) return 0.0;
#ifdef TRACE_SOFT
    float back = d * d / (2.0 * before);
    float beside = sqrt(max(d * d - back * back, 0.0));
    seen = min(seen, beside / (trace_light_width * max(t - back, 1e-6)));
    before = d;
#endif
    t += d;
    if (t > reach) break;
  }
  return seen * seen * (3.0 - 2.0 * seen);
#else
  return 1.0;
#endif
}

float trace_open(vec3 place, vec3 normal, float slope) {
#ifdef TRACE_OCCLUSION
  float open = 1.0;
  float weight = 0.5;
  for (int i = trace_zero; i < 5; ++i) {
    float height = trace_occlusion_radius * float(i + 1) / 5.0;
    float free = scene_distance(place + height * normal).x / slope;
    open -= weight / 0.96875 * clamp(1.0 - free / height, 0.0, 1.0);
    weight *= 0.5;
  }
  return clamp(open, 0.0, 1.0);
#else
  return 1.0;
#endif
}

bool trace_is_fine(vec3 value) {
  return all(greaterThanEqual(value, vec3(0.0))) && all(lessThan(value, vec3(3.4028234e38)));
}

const int trace_ambient_count = 8;

vec3 trace_ambient_direction(vec3 n, int i) {
  float part = (float(i) + trace_ambient_jitter.x) / float(trace_ambient_count);
  float turn = 2.3999632 * float(i) + 6.2831853 * trace_ambient_jitter.y;
  float a = 1.0 / max(1.0 + n.z, 1e-6);
  vec3 x = vec3(1.0 - a * n.x * n.x, -a * n.x * n.y, -n.x);
  return sqrt(part) * (cos(turn) * x + sin(turn) * cross(n, x)) + sqrt(1.0 - part) * n;
}

vec3 trace_lit(int material, vec3 place, vec3 normal, vec3 view, float slope) {
  vec3 n = normalize(normal + max(0.001 - dot(normal, view), 0.0) * view);
  vec3 x = vec3(n.z, 0.0, -n.x);
  x = dot(x, x) > 1e-12 ? normalize(x) : vec3(1.0, 0.0, 0.0);
  vec3 y = cross(n, x);
  vec3 start = place + 4.0 * trace_threshold * normal;
  vec3 sum = vec3(0.0);
  float open = trace_open(place, normal, slope);
  for (int i = trace_zero; i < trace_light_count + trace_ambient_count; ++i) {
    vec3 light;
    vec3 strength;
    float reach = trace_max_distance;
    if (i < trace_light_count) {
      vec4 at = trace_light_places[i];
      light = at.xyz - at.w * place;
      float away = length(light);
      light /= away;
      strength = trace_light_colours[i] / (at.w > 0.0 ? away * away : 1.0);
      if (at.w > 0.0) reach = away;
    } else {
      light = trace_ambient_direction(n, i - trace_light_count);
      strength = trace_ambient * (3.1415927 * open / float(trace_ambient_count));
    }
    float cosine = dot(n, light);
    if (!(cosine > 0.0) || strength == vec3(0.0)) continue;
    float seen = i < trace_light_count ? trace_seen(start, light, reach) : 1.0;
    if (seen == 0.0) continue;
    vec3 f = scene_brdf(material, light, view, n, x, y);
    if (!trace_is_fine(f)) return f;
    sum += f * strength * (i < trace_light_count ? cosine * seen : 1.0);
  }
  return sum;
}
)";

constexpr std::string_view kSurface = R"(
vec3 trace_surface(trace_Hit hit, vec3 direction) {
  if (!hit.met) return trace_view == 1 ? vec3(0.0) : trace_background;
  vec3 place = trace_eye + hit.t * direction;
  vec3 far = abs(place);
  vec3 gradient = trace_gradient(place, max(trace_threshold, 0.0001 * max(far.x, max(far.y, far.z))));
  float slope = length(gradient);
  vec3 normal = slope > 0.0 ? gradient / slope : -direction;
  if (trace_view == 1) return 0.5 + 0.5 * normal;
  int leaf = int(hit.leaf + 0.5);
  int material = scene_material(leaf);
  if (scene_is_lit(material)) return trace_lit(material, place, normal, -direction, slope > 0.01 ? slope : 1.0);
  return scene_shade(material, FragmentProperties(place, place - scene_origin(leaf), normal, direction, hit.t));
}
)";

constexpr std::string_view kSlopes = R"(
vec3 trace_steep(trace_Hit hit) {
  if (hit.slope <= 1.01) return vec3(hit.met ? 0.25 * (1.0 - hit.steps / float(trace_max_steps)) : 0.0);
  float stops = clamp(log2(hit.slope), 0.0, 2.0);
  return stops < 1.0 ? mix(vec3(1.0, 0.6, 0.0), vec3(1.0, 0.0, 0.0), stops)
                     : mix(vec3(1.0, 0.0, 0.0), vec3(1.0), stops - 1.0);
}
)";

constexpr std::string_view kMain = R"(
vec3 trace_ray(vec3 direction) {
  trace_Hit hit = trace_march(direction);
  if (isnan(hit.t)) return vec3(hit.t);
#ifdef TRACE_SLOPES
  return trace_steep(hit);
#else
  if (trace_view < 2) return trace_surface(hit, direction);
  if (trace_view == 3) return vec3(log2(1.0 + hit.steps) / log2(1.0 + float(trace_max_steps)));
  float part = hit.t / trace_depth;
  part *= part;
  return vec3(hit.met ? 1.0 / (1.0 + part * part) : 0.0);
#endif
}

vec3 trace_shown(vec3 value) {
  if (any(isnan(value))) return trace_bad_not_a_number;
  if (any(isinf(value))) return trace_bad_infinite;
  if (any(lessThan(value, vec3(0.0)))) return trace_bad_negative;
  return trace_view == 0 ? pow(clamp(value * trace_display.x, 0.0, 1.0), vec3(trace_display.y)) : value;
}

void main() {
  vec2 place = (trace_corner + gl_FragCoord.xy - 0.5 + trace_jitter) / trace_size * 2.0 - 1.0;
  vec3 value = trace_ray(normalize(trace_forward + place.x * trace_right + place.y * trace_up));
  trace_value = vec4(trace_display.x > 0.0 ? trace_shown(value) : value, 1.0);
}
)";

std::string_view bad_name(BadPixel kind) {
  switch (kind) {
    case BadPixel::NotANumber:
      return "trace_bad_not_a_number";
    case BadPixel::Infinite:
      return "trace_bad_infinite";
    case BadPixel::Negative:
      return "trace_bad_negative";
  }
  return {};
}

std::string bad_colours() {
  std::string text;
  for (const BadPixel kind : kBadPixelKinds) {
    const auto& [red, green, blue] = bad_pixel_entry(kind).colour;
    text += fmt::format("const vec3 {} = vec3({}.0, {}.0, {}.0) / 255.0;\n", bad_name(kind), red, green, blue);
  }
  return text;
}

std::string defines(const SceneEffects& effects) {
  if (effects.slopes) return "#define TRACE_SLOPES\n";
  std::string text;
  if (effects.shadows != Shadows::None) text += "#define TRACE_SHADOWS\n";
  if (effects.shadows == Shadows::Soft) text += "#define TRACE_SOFT\n";
  if (effects.occlusion) text += "#define TRACE_OCCLUSION\n";
  return text;
}

}  // namespace

std::string scene_fragment_text(std::string_view source, const SceneEffects& effects) {
  std::string text = "#version 330 core\n#line 1 0\n";
  text += source;
  text += "\n#line 1 0\n";
  text += defines(effects);
  text += kUniforms;
  text += bad_colours();
  text += kMarch;
  if (effects.slopes) {
    text += kSlopes;
  } else {
    text.append(kLight).append(kSurface);
  }
  return text.append(kMain);
}

}  // namespace texbrdf::render
