#pragma once

#include <optional>
#include <vector>

#include "plots/canvas.h"
#include "plots/channels.h"
#include "plots/plot.h"

namespace texbrdf::plots {

/// A component of a series, and how it is told from the others.
struct Trace {
  const Series* series = nullptr;
  Component component;
  Stroke stroke;
  std::string name;  ///< empty where it is alone
};

/// In the order of the legend. They point into the plot.
std::vector<Trace> traces_of(const Plot& plot);

/// Room for head, legend and notes, and what is left of the canvas for the plot.
struct Layout {
  Rectangle plot;
  double notes_top = 0;
};

/// Draws title, what is fixed, the legend on the right and the notes at the bottom.
Layout draw_surroundings(Canvas& canvas, const Plot& plot, const std::vector<Trace>& traces);

/// What the values are, with their unit.
std::string value_label(const Plot& plot);

/// "45°".
std::string degrees_text(double degrees);

}  // namespace texbrdf::plots
