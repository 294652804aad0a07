#include <fmt/format.h>

#include <cmath>
#include <span>

#include "features/places.h"
#include "lsp/session.h"
#include "plots/preview_plot.h"
#include "plots/samples.h"
#include "preview/surface_probe.h"

namespace texbrdf::lsp {
namespace {

/// Of the reference evaluator for one value: some 10 ms.
constexpr uint64_t kMaxProbeSteps = 500'000;

std::string_view protocol_type(Type type) {
  if (type == Type::Real) return "real";
  if (type == Type::Colour) return "colour";
  return is_triple(type) ? "vector" : "";
}

std::string_view kind_word(render::BadPixel kind) {
  switch (kind) {
    case render::BadPixel::NotANumber:
      return "nan";
    case render::BadPixel::Infinite:
      return "infinite";
    case render::BadPixel::Negative:
      return "negative";
  }
  return "";
}

void write_number(JsonWriter& out, double number) {
  if (std::isfinite(number)) {
    out.value(number);
  } else if (std::isnan(number)) {
    out.value("nan");
  } else {
    out.value(number > 0 ? "inf" : "-inf");
  }
}

void write_value(JsonWriter& out, Type type, const eval::Triple& value) {
  out.key("value");
  out.begin_array();
  for (const double component : std::span(value).first(type_components(type))) write_number(out, component);
  out.end_array();
}

/// To a millionth of a degree: more digits are only rounding.
double shown_angle(double degrees) {
  return std::round(degrees * 1e6) / 1e6 + 0.0;
}

void write_angles(JsonWriter& out, std::string_view key, const preview::Angles& angles) {
  out.key(key);
  out.begin_object();
  out.member("theta", shown_angle(angles.theta));
  out.member("phi", shown_angle(angles.phi));
  out.end_object();
}

/// As the document writes the name; where it has it no more, the name itself.
std::string label_of(const Snapshot& snapshot, const std::string& name) {
  const std::optional<DefinitionId> id = snapshot.find(name);
  if (!id) return name;
  return std::string(snapshot.parsed(snapshot.definition(*id).block).node_text(snapshot.syntax(*id).name));
}

void write_problem(JsonWriter& out, std::string_view problem) {
  if (!problem.empty()) out.member("problem", problem);
}

/// The values of a point, as far as they can be had.
class ProbeWriter {
 public:
  ProbeWriter(JsonWriter& out, const preview::ExactModel& model, const preview::SurfaceProbe& probe)
      : out_(out), model_(model), probe_(probe) {}

  void write(std::string_view definition) {
    if (probe_.is_lit) {
      write_value_of(model_.brdf());
    } else {
      write_no_value();
    }
    if (const preview::Quantity* quantity = model_.find(definition)) {
      out_.key("definition");
      out_.begin_object();
      out_.member("name", quantity->name);
      out_.member("type", protocol_type(quantity->type));
      write_value_of(*quantity);
      out_.end_object();
    }
    if (is_too_slow_) write_problem(out_, "a value takes too long to compute");
  }

 private:
  void write_value_of(const preview::Quantity& quantity) {
    eval::StepBudget budget{kMaxProbeSteps};
    const std::optional<eval::Triple> value = model_.value(quantity, probe_.geometry, budget);
    is_too_slow_ |= !value;
    if (value) write_value(out_, quantity.type, *value);
    if (!value) write_no_value();
  }

  void write_no_value() {
    out_.key("value");
    out_.null();
  }

  JsonWriter& out_;
  const preview::ExactModel& model_;
  const preview::SurfaceProbe& probe_;
  bool is_too_slow_ = false;
};

void write_probe(JsonWriter& out, const ExactValues& exact, const preview::SurfaceProbe& probe,
                 std::string_view definition) {
  out.begin_object();
  write_angles(out, "light", probe.light);
  write_angles(out, "view", probe.view);
  if (exact.source) {
    ProbeWriter(out, *exact.source, probe).write(definition);
  } else {
    out.key("value");
    out.null();
    write_problem(out, exact.problem);
  }
  out.end_object();
}

/// A list for each channel; null where a direction is below the surface.
void write_channels(JsonWriter& out, std::string_view key, std::span<const plots::Sample> values, uint32_t channels) {
  out.key(key);
  out.begin_array();
  for (uint32_t channel = 0; channel < channels && !values.empty(); ++channel) {
    out.begin_array();
    for (const plots::Sample& value : values) {
      if (value) write_number(out, (*value)[channel]);
      if (!value) out.null();
    }
    out.end_array();
  }
  out.end_array();
}

void write_degrees(JsonWriter& out, std::string_view key, std::span<const double> angles) {
  out.key(key);
  out.begin_array();
  for (const double angle : angles) out.value(angle);
  out.end_array();
}

void write_light(JsonWriter& out, const plots::Request& request) {
  out.key("light");
  out.begin_object();
  out.member("theta", shown_angle(request.incidence));
  if (request.view == plots::View::Lobe) out.member("phi", shown_angle(request.phi));
  out.end_object();
}

void write_curve(JsonWriter& out, const plots::Request& request, const plots::Curve& curve, uint32_t channels) {
  out.begin_object();
  write_light(out, request);
  write_degrees(out, "angles", curve.angles);
  write_channels(out, "values", curve.values, channels);
  if (!curve.errors.empty()) {
    const std::vector<plots::Sample> errors(curve.errors.begin(), curve.errors.end());
    write_channels(out, "errors", errors, channels);
  }
  out.member("cosine", request.times_cosine);
  write_problem(out, curve.problem);
  out.end_object();
}

void write_grid(JsonWriter& out, const plots::Request& request, const plots::Grid& grid, uint32_t channels) {
  out.begin_object();
  write_light(out, request);
  write_degrees(out, "rows", grid.rows);
  write_degrees(out, "columns", grid.columns);
  write_channels(out, "values", grid.values, channels);
  out.member("cosine", request.times_cosine);
  write_problem(out, grid.problem);
  out.end_object();
}

plots::Request request_of(const PlotParams& params, const render::SphereView& view) {
  plots::Request request = plots::request_beside(view, params.view);
  request.theta_h = params.theta_h.value_or(request.theta_h);
  request.theta_d = params.theta_d.value_or(request.theta_d);
  request.phi_d = params.phi_d.value_or(request.phi_d);
  return request;
}

bool has_nothing(const ExactValues& exact) {
  return !exact.source && exact.problem.empty();
}

}  // namespace

/// With its values compiled; nullptr where there is none.
const OpenPreview* Session::present_preview(int64_t id) {
  refresh_previews();
  OpenPreview* const preview = previews_.find(id);
  OpenDocument* const open = preview == nullptr ? nullptr : documents_.find(preview->uri);
  if (open == nullptr) return nullptr;
  update_exact(*preview, open->document.snapshot());
  return preview;
}

Session::Outcome Session::quantities(const ModelParams& params, JsonWriter& result) {
  OpenDocument* open = documents_.find(params.uri);
  if (open == nullptr) return not_open(params.uri);
  const Snapshot& snapshot = open->document.snapshot();
  const auto write = [&](const preview::Quantity& quantity) {
    result.begin_object();
    result.member("name", quantity.name);
    result.member("label", label_of(snapshot, quantity.name));
    result.member("type", protocol_type(quantity.type));
    result.end_object();
  };
  result.begin_array();
  if (const Result<ir::Program> program = snapshot.program(params.root)) {
    const std::vector<preview::Quantity> in_order_of_need = preview::quantities(*program);
    const std::span<const preview::Quantity> quantities(in_order_of_need);
    write(quantities.back());
    for (const preview::Quantity& quantity : quantities.first(quantities.size() - 1)) write(quantity);
  }
  result.end_array();
  return std::nullopt;
}

Session::Outcome Session::probe(const ProbeParams& params, JsonWriter& result) {
  const OpenPreview* const preview = present_preview(params.preview);
  if (preview == nullptr) return ResponseError{ErrorCode::InvalidParams, unknown_preview(params.preview)};
  const auto probe = preview::probe_surface(preview->view, params.place);
  if (probe && preview->object.is_plain() && !has_nothing(preview->exact)) {
    write_probe(result, preview->exact, *probe, params.definition);
  } else {
    result.null();
  }
  return std::nullopt;
}

Session::Outcome Session::bad_pixels(const PreviewParams& params, JsonWriter& result) {
  const OpenPreview* const preview = present_preview(params.preview);
  if (preview == nullptr) return ResponseError{ErrorCode::InvalidParams, unknown_preview(params.preview)};
  const ExactValues& exact = preview->exact;
  if (has_nothing(exact) || !preview->object.is_plain()) {
    result.null();
    return std::nullopt;
  }
  const preview::BadValues found =
      exact.source ? preview::find_bad_values(*exact.source, preview->view) : preview::no_bad_values(exact.problem);
  result.begin_object();
  result.member("size", found.size);
  for (const render::BadPixel kind : render::kBadPixelKinds) result.member(kind_word(kind), found.counts[kind]);
  result.key("first");
  if (found.first) write_bad_value(result, *preview, *found.first);
  if (!found.first) result.null();
  write_problem(result, found.problem);
  result.end_object();
  return std::nullopt;
}

void Session::write_bad_value(JsonWriter& out, const OpenPreview& preview, const preview::BadValue& bad) {
  OpenDocument& open = *documents_.find(preview.uri);
  const Snapshot& snapshot = open.document.snapshot();
  out.begin_object();
  out.member("x", bad.place.x);
  out.member("y", bad.place.y);
  out.member("kind", kind_word(bad.kind));
  out.member("definition", bad.origin);
  out.member("label", label_of(snapshot, bad.origin));
  out.key("location");
  if (const std::optional<DefinitionId> id = snapshot.find(bad.origin)) {
    Positions places = positions(open);
    write_location(out, places, preview.uri, features::name_span(snapshot, *id));
  } else {
    out.null();
  }
  out.end_object();
}

Session::Outcome Session::plot(const PlotParams& params, JsonWriter& result) {
  const OpenPreview* const preview = present_preview(params.preview);
  if (preview == nullptr) return ResponseError{ErrorCode::InvalidParams, unknown_preview(params.preview)};
  if (const auto fault = plots::find_fault(plots::Request{.theta_h = params.theta_h.value_or(0),
                                                          .theta_d = params.theta_d.value_or(0),
                                                          .phi_d = params.phi_d.value_or(0)})) {
    return ResponseError{ErrorCode::InvalidParams, *fault};
  }
  const ExactValues& exact = preview->exact;
  if (has_nothing(exact)) {
    result.null();
    return std::nullopt;
  }
  const plots::Request request = request_of(params, preview->view);
  std::string problem = exact.source ? plots::problem_of(request).value_or("") : exact.problem;
  const uint32_t channels = exact.source ? type_components(exact.source->brdf().type) : 0;
  const bool has_values = problem.empty();
  const plots::Effort effort = plots::quick_effort(params.view);
  if (plots::has_grid(params.view)) {
    plots::Grid none;
    none.problem = std::move(problem);
    write_grid(result, request, has_values ? plots::sample_grid(*exact.source, request, effort) : none, channels);
  } else {
    plots::Curve none;
    none.problem = std::move(problem);
    write_curve(result, request, has_values ? plots::sample_curve(*exact.source, request, effort) : none, channels);
  }
  return std::nullopt;
}

}  // namespace texbrdf::lsp
