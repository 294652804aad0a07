#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "plots/drawing.h"
#include "plots/request.h"
#include "plots/samples.h"
#include "plots/scale.h"
#include "preview/exact_model.h"
#include "source/result.h"

namespace texbrdf::plots {

/// One of the BRDFs that are held against each other.
struct Series {
  std::string label;  ///< what tells it from the others; empty where it is alone
  bool is_colour = false;
  bool is_grey = true;  ///< all channels of each value are the same
  std::variant<Curve, Grid> samples;
};

/// How a plot looks, whatever its values.
struct Look {
  ScaleKind scale = ScaleKind::Linear;
  std::optional<Channels> channels;  ///< nothing: what the view shows best
  std::optional<double> maximum;     ///< of the axis of values; nothing: all of them fit, of a slice nearly all
  uint32_t width = 720;              ///< pixels, kLeastSize to kMostSize
  uint32_t height = 480;
  double azimuth = 65;    ///< of the eye that sees a lobe, degrees from where a mirror sends the light
  double elevation = 25;  ///< of the eye above the surface, 0 to 90
};

inline constexpr uint32_t kLeastSize = 200;
inline constexpr uint32_t kMostSize = 8192;

/// Why it cannot be drawn so, in words, or nothing.
std::optional<std::string> find_fault(const Look& look);

struct Plot {
  Request request;
  Look look;
  std::string title;
  std::vector<Series> series;
};

/// The values that the view of the request needs. Fails where there are none, with the reason.
Result<Series> sample(const preview::ExactModel& model, std::string label, const Request& request,
                      const Effort& effort);

Drawing draw(const Plot& plot);

/// What of the values has no place in the picture, one line each.
std::vector<std::string> notes_of(const Plot& plot);

}  // namespace texbrdf::plots
