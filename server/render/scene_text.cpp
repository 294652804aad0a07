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

// What has no need of the scene's distance.
// The frame of ambient directions: J. R. Frisvad, "Building an orthonormal basis from a 3D unit vector without
// normalization", Journal of Graphics Tools 16, 2012.
constexpr std::string_view kLights = R"(
struct trace_Surface {
  vec3 place;
  vec3 normal;
  float slope;
  float open;
  int leaf;
  int material;
  vec3 n;
  vec3 x;
  vec3 y;
};

struct trace_Light {
  vec3 direction;
  vec3 strength;
  float reach;
  int steps;
};

const int trace_ambient_count = 8;

vec3 trace_ambient_direction(vec3 n, int i) {
  float part = (float(i) + trace_ambient_jitter.x) / float(trace_ambient_count);
  float turn = 2.3999632 * float(i) + 6.2831853 * trace_ambient_jitter.y;
  float a = 1.0 / max(1.0 + n.z, 1e-6);
  vec3 x = vec3(1.0 - a * n.x * n.x, -a * n.x * n.y, -n.x);
  return sqrt(part) * (cos(turn) * x + sin(turn) * cross(n, x)) + sqrt(1.0 - part) * n;
}

trace_Light trace_light(int i, trace_Surface surface) {
  if (i >= trace_light_count) {
    vec3 strength = trace_ambient * (3.1415927 * surface.open / float(trace_ambient_count));
    return trace_Light(trace_ambient_direction(surface.n, i - trace_light_count), strength, 0.0, 0);
  }
  vec4 at = trace_light_places[i];
  vec3 towards = at.xyz - at.w * surface.place;
  float away = length(towards);
  towards /= away;
  vec3 strength = trace_light_colours[i] * max(dot(surface.n, towards), 0.0);
  if (at.w == 0.0) return trace_Light(towards, strength, trace_max_distance, TRACE_SHADOW_STEPS);
  return trace_Light(towards, strength / (away * away), away, TRACE_SHADOW_STEPS);
}

float trace_spread(vec3 place) {
  vec3 far = abs(place);
  return max(far.x, max(far.y, far.z));
}

bool trace_is_fine(vec3 value) {
  return all(greaterThanEqual(value, vec3(0.0))) && all(lessThan(value, vec3(3.4028234e38)));
}

void trace_set_frame(inout trace_Surface surface, vec3 view) {
  surface.n = normalize(surface.normal + max(0.001 - dot(surface.normal, view), 0.0) * view);
  vec3 x = vec3(surface.n.z, 0.0, -surface.n.x);
  surface.x = dot(x, x) > 1e-12 ? normalize(x) : vec3(1.0, 0.0, 0.0);
  surface.y = cross(surface.n, surface.x);
}

vec3 trace_corner_of_tetrahedron(int i) {
  return vec3(i == 0 || i == 3 ? 1.0 : -1.0, i < 2 ? -1.0 : 1.0, (i & 1) == 0 ? -1.0 : 1.0);
}
)";

// What asks how near things are, not only whether something is there, asks without guards, which say less than is true.
// Stage 0 follows the ray of the camera, 1 finds the normal, 2 how open the surroundings are, each further one follows
// the ray to a light, or is a direction of ambient light.
// Rays: J. C. Hart, "Sphere tracing", The Visual Computer 12, 1996; one that runs out of steps has met nothing.
// Normals: iquilezles.org/articles/normalsSDF. Soft shadows: S. Aaltonen, "GPU-based clay simulation and ray-tracing
// tech in Claybook", GDC 2018, in the words of iquilezles.org/articles/rmshadows. Occlusion: A. Evans, "Fast
// approximations for global illumination on dynamic scenes", SIGGRAPH 2006 courses.
constexpr std::string_view kStages = R"(
vec3 trace_ray(vec3 ray) {
  trace_Surface surface;
  surface.open = 1.0;
  trace_Light light;
  vec3 sum = vec3(0.0);
  int stages = 3 + trace_light_count + trace_ambient_count;
  for (int stage = trace_zero; stage < stages; ++stage) {
    scene_guarded = stage < 2 || (stage > 2 && TRACE_GUARDED_SHADOWS);
    vec3 from = trace_eye;
    vec3 along = ray;
    float reach = trace_max_distance;
    int most = trace_max_steps;
    float h = 0.0;
    if (stage == 1) {
      from = surface.place;
      most = 4;
      h = max(trace_threshold, 0.0001 * trace_spread(from));
    } else if (stage == 2) {
      from = surface.place;
      along = surface.normal;
#ifdef TRACE_OCCLUSION
      most = 5;
#else
      continue;
#endif
    } else if (stage > 2) {
      light = trace_light(stage - 3, surface);
      if (light.strength == vec3(0.0)) continue;
      from = surface.place + 4.0 * trace_threshold * surface.normal;
      along = light.direction;
      reach = light.reach;
      most = light.steps;
    }
    bool is_ray = stage != 1;
    float t = 0.0;
    float near = trace_threshold;
    float before = 1e20;
    float seen = 1.0;
    bool met = false;
    vec2 found = vec2(0.0);
    vec3 gradient = vec3(0.0);
#ifdef TRACE_OCCLUSION
    float weight = 0.5 / 0.96875;
    float height = trace_occlusion_radius / 5.0;
    if (stage == 2) t = height;
#endif
    int i = trace_zero;
    for (; i < most; ++i) {
      vec3 corner = trace_corner_of_tetrahedron(i);
      found = scene_distance(from + (is_ray ? t * along : h * corner));
      gradient += corner * found.x;
#ifdef TRACE_OCCLUSION
      if (stage == 2) {
        surface.open -= weight * clamp(1.0 - found.x / (surface.slope * t), 0.0, 1.0);
        weight *= 0.5;
        t += height;
        continue;
      }
#endif
      if (i == 0 && stage > 2) near = min(near, 0.5 * found.x);
      met = !(found.x > near);
#ifdef TRACE_SOFT
      float back = found.x * found.x / (2.0 * before);
      float beside = sqrt(max(found.x * found.x - back * back, 0.0));
      seen = min(seen, beside / (trace_light_width * max(t - back, 1e-6)));
      before = found.x;
#endif
      t += found.x;
      if (is_ray && (met || t > reach)) break;
    }
    if (stage == 0) {
      if (isnan(found.x)) return vec3(found.x);
      if (trace_view == 3) return vec3(log2(float(min(i + 2, most + 1))) / log2(float(most + 1)));
      if (!met) return trace_view == 0 ? trace_background : vec3(0.0);
      t += max(-trace_threshold - found.x, 0.0);
      if (trace_view == 2) return vec3(1.0 / (1.0 + pow(abs(t) / trace_depth, 4.0)));
      surface.place = trace_eye + t * ray;
      surface.leaf = int(found.y + 0.5);
    } else if (stage == 1) {
      float slope = length(gradient) / (4.0 * h);
      surface.normal = slope > 0.0 ? gradient / (4.0 * h * slope) : -ray;
      surface.slope = slope > 0.01 ? slope : 1.0;
      if (trace_view == 1) return 0.5 + 0.5 * surface.normal;
      surface.material = scene_material(surface.leaf);
      if (!scene_is_lit(surface.material)) {
        vec3 in_object = surface.place - scene_origin(surface.leaf);
        return scene_shade(surface.material, FragmentProperties(surface.place, in_object, surface.normal, ray,
                                                                distance(surface.place, trace_eye)));
      }
      trace_set_frame(surface, -ray);
    } else if (stage == 2) {
      surface.open = max(surface.open, 0.0);
    } else if (!met && seen > 0.0) {
      vec3 f = scene_brdf(surface.material, light.direction, -ray, surface.n, surface.x, surface.y);
      if (!trace_is_fine(f)) return f;
      sum += f * light.strength * (seen * seen * (3.0 - 2.0 * seen));
    }
  }
  return sum;
}
)";

constexpr std::string_view kSlopes = R"(
vec3 trace_steepness(float slope, bool met, int steps) {
  if (slope <= 1.01) return vec3(met ? 0.25 * (1.0 - float(steps) / float(trace_max_steps)) : 0.0);
  float stops = clamp(log2(slope), 0.0, 2.0);
  return stops < 1.0 ? mix(vec3(1.0, 0.6, 0.0), vec3(1.0, 0.0, 0.0), stops)
                     : mix(vec3(1.0, 0.0, 0.0), vec3(1.0), stops - 1.0);
}

float trace_slope_between(float values[7]) {
  float slope = abs(values[5] - values[6]) / 2.0;
  for (int i = 1; i < 4; ++i) {
    for (int j = i + 1; j < 5; ++j) slope = max(slope, abs(values[i] - values[j]) / 1.6329932);
  }
  return slope;
}

vec3 trace_ray(vec3 ray) {
  float t = 0.0;
  float walked = 0.0;
  float before = 0.0;
  float slope = 0.0;
  float values[7];
  bool met = false;
  int i = trace_zero;
  for (; i < trace_max_steps; ++i) {
    vec3 place = trace_eye + t * ray;
    float h = 0.001 * (1.0 + trace_spread(place));
    vec3 gradient = vec3(0.0);
    for (int k = trace_zero; k < 7; ++k) {
      vec3 corner = trace_corner_of_tetrahedron((k + 3) & 3);
      float size = length(gradient);
      vec3 offset = k == 0 ? vec3(0.0) : corner * 0.57735027;
      if (k > 4) offset = (k == 5 ? 1.0 : -1.0) * (size > 0.0 ? gradient / size : vec3(0.0, 1.0, 0.0));
      values[k] = scene_distance(place + h * offset).x;
      if (k > 0 && k < 5) gradient += corner * values[k];
    }
    if (isnan(values[0])) return vec3(values[0]);
    slope = max(slope, trace_slope_between(values) / h);
    if (walked > 0.001 * (1.0 + t)) slope = max(slope, abs(values[0] - before) / walked);
    met = values[0] < trace_threshold;
    if (met) break;
    walked = values[0];
    before = walked;
    t += walked;
    if (t > trace_max_distance) break;
  }
  return trace_steepness(slope, met, i + 1);
}
)";

constexpr std::string_view kMain = R"(
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
  const bool is_soft = effects.shadows == Shadows::Soft;
  return fmt::format("#define TRACE_SHADOW_STEPS {}\n#define TRACE_GUARDED_SHADOWS {}\n{}{}",
                     effects.shadows == Shadows::None ? "0" : "trace_max_steps", !is_soft,
                     is_soft ? "#define TRACE_SOFT\n" : "", effects.occlusion ? "#define TRACE_OCCLUSION\n" : "");
}

}  // namespace

std::string scene_fragment_text(std::string_view source, const SceneEffects& effects) {
  std::string text = "#version 330 core\n#line 1 0\n";
  text += source;
  text += "\n#line 1 0\n";
  text += defines(effects.slopes ? SceneEffects() : effects);
  text += kUniforms;
  text += bad_colours();
  text += kLights;
  text += effects.slopes ? kSlopes : kStages;
  text += kMain;
  return text;
}

}  // namespace texbrdf::render
