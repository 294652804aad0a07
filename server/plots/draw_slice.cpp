#include "plots/draw_slice.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "plots/canvas.h"
#include "plots/legend.h"

namespace texbrdf::plots {
namespace {

constexpr double kDisplayGamma = 2.2;
constexpr Colour kBelowHorizon{0xe8, 0xe8, 0xe8};
constexpr Colour kNoNumber{0xff, 0x00, 0xff};
constexpr double kLeftRoom = 46;
constexpr double kBottomRoom = 42;
constexpr double kWhiteRoom = 20;  ///< for what white means
/// Of the values, on the linear scale: a few near the horizon are often far above all others.
constexpr double kShownPart = 0.98;
constexpr double kBarRoom = 92;
constexpr double kBarWidth = 14;
constexpr double kPanelGap = 24;

/// From black over blue, red and yellow to white, lighter all the way.
Colour heat(double fraction) {
  struct Stop {
    double at;
    std::array<double, 3> colour;
  };
  constexpr std::array<Stop, 6> kStops = {{{0.0, {0, 0, 4}},
                                           {0.2, {60, 15, 112}},
                                           {0.45, {160, 40, 110}},
                                           {0.7, {238, 95, 60}},
                                           {0.88, {252, 180, 60}},
                                           {1.0, {255, 255, 215}}}};
  const auto after = std::ranges::find_if(kStops, [&](const Stop& stop) { return stop.at >= fraction && stop.at > 0; });
  const Stop& high = after == kStops.end() ? kStops.back() : *after;
  const Stop& low = *(&high - 1);
  const double part = (fraction - low.at) / (high.at - low.at);
  const auto channel = [&](std::size_t c) {
    return static_cast<uint8_t>(std::lround(std::lerp(low.colour[c], high.colour[c], part)));
  };
  return {channel(0), channel(1), channel(2)};
}

class SliceDrawing {
 public:
  explicit SliceDrawing(const Plot& plot)
      : plot_(plot),
        canvas_(plot.look.width, plot.look.height, plot.title),
        scale_(scale_for(plot.look.scale, shown_numbers(plot), maximum_of(plot))),
        components_(components_of_all(plot)) {
    if (scale_.kind == ScaleKind::Linear) scale_.low = 0;
  }

  Drawing draw() {
    const Layout layout = draw_surroundings(canvas_, plot_, {});
    const double bar_room = components_.size() == 1 ? kBarRoom : 0;
    const double count = static_cast<double>(plot_.series.size());
    const double width = (layout.plot.width() - bar_room) / count - kLeftRoom - kPanelGap / 2;
    const double top = layout.plot.top + kLineHeight + 4;
    const double below = components_.size() == 1 ? kBottomRoom : kBottomRoom + kWhiteRoom;
    const double side = std::floor(std::max(20.0, std::min(width, layout.plot.bottom - below - top)));
    double left = std::round(layout.plot.left + kLeftRoom);
    for (const Series& series : plot_.series) {
      const Rectangle frame{left, std::round(top), left + side, std::round(top) + side};
      draw_panel(series, frame);
      left += std::round(side + kLeftRoom + kPanelGap / 2);
    }
    if (components_.size() == 1) draw_bar({left - kLeftRoom + 12, std::round(top), 0, std::round(top) + side});
    if (components_.size() > 1) tell_white(layout);
    return canvas_.take();
  }

 private:
  static std::optional<double> maximum_of(const Plot& plot) {
    if (plot.look.maximum || plot.look.scale == ScaleKind::Log) return plot.look.maximum;
    std::vector<double> numbers = shown_numbers(plot);
    std::erase_if(numbers, [](double number) { return !std::isfinite(number); });
    if (numbers.empty()) return std::nullopt;
    const auto place = static_cast<std::ptrdiff_t>(kShownPart * static_cast<double>(numbers.size() - 1));
    std::ranges::nth_element(numbers, numbers.begin() + place);
    return numbers[static_cast<std::size_t>(place)];
  }

  /// Those of a colour where there is one.
  static std::vector<Component> components_of_all(const Plot& plot) {
    std::vector<Component> most;
    for (const Series& series : plot.series) {
      std::vector<Component> components = components_of(plot, series);
      if (components.size() > most.size()) most = std::move(components);
    }
    return most;
  }

  void draw_panel(const Series& series, const Rectangle& frame) {
    canvas_.text({frame.left, frame.top - 6}, Anchor::Start, plain(series.label));
    canvas_.add(Picture{.place = frame, .cells = cells_of(std::get<Grid>(series.samples))});
    canvas_.add(Path{.lines = {{{frame.left, frame.top},
                                {frame.right, frame.top},
                                {frame.right, frame.bottom},
                                {frame.left, frame.bottom}}},
                     .is_closed = true,
                     .stroke = Stroke{.colour = kInk}});
    for (const double angle : {0.0, 30.0, 60.0, 90.0}) {
      const double x = frame.left + angle / 90 * frame.width();
      const double y = frame.bottom - angle / 90 * frame.height();
      canvas_.line({x, frame.bottom}, {x, frame.bottom + 4}, {.colour = kInk});
      canvas_.line({frame.left - 4, y}, {frame.left, y}, {.colour = kInk});
      canvas_.text({x, frame.bottom + 17}, Anchor::Middle, plain(degrees_text(angle)), kSmallText);
      canvas_.text({frame.left - 7, y + 4}, Anchor::End, plain(degrees_text(angle)), kSmallText);
    }
    canvas_.text({(frame.left + frame.right) / 2, frame.bottom + 34}, Anchor::Middle, rich("θ_h [degrees]"));
    canvas_.add(Label{.at = {frame.left - 34, (frame.top + frame.bottom) / 2},
                      .anchor = Anchor::Middle,
                      .runs = rich("θ_d [degrees]"),
                      .size = kTextSize,
                      .colour = kInk,
                      .is_upright = true});
  }

  /// The rows of a grid go up, those of a picture down.
  render::ImageRgba8 cells_of(const Grid& grid) const {
    const auto width = static_cast<uint32_t>(grid.columns.size());
    const auto height = static_cast<uint32_t>(grid.rows.size());
    render::ImageRgba8 image{.width = width, .height = height, .pixels = {}};
    for (uint32_t y = height; y-- > 0;) {
      for (uint32_t x = 0; x < width; ++x) {
        const Colour colour = colour_of(grid.values[std::size_t{y} * width + x]);
        image.pixels.insert(image.pixels.end(), {colour.red, colour.green, colour.blue, 255});
      }
    }
    return image;
  }

  Colour colour_of(const Sample& sample) const {
    if (!sample) return kBelowHorizon;
    std::array<uint8_t, 3> channels{};
    for (std::size_t c = 0; c < components_.size(); ++c) {
      const double number = components_[c].of(*sample);
      if (!std::isfinite(number)) return kNoNumber;
      const double fraction = std::clamp(scale_.fraction_of(number).value_or(0), 0.0, 1.0);
      if (components_.size() == 1) return heat(fraction);
      channels[c] = shade_of(fraction);
    }
    return {channels[0], channels[1], channels[2]};
  }

  uint8_t shade_of(double fraction) const {
    const double shown = scale_.kind == ScaleKind::Log ? fraction : std::pow(fraction, 1 / kDisplayGamma);
    return static_cast<uint8_t>(std::lround(shown * 255));
  }

  void draw_bar(Rectangle bar) {
    constexpr uint32_t kSteps = 256;
    bar.right = bar.left + kBarWidth;
    render::ImageRgba8 colours{.width = 1, .height = kSteps, .pixels = {}};
    for (uint32_t i = kSteps; i-- > 0;) {
      const Colour colour = heat(i / (kSteps - 1.0));
      colours.pixels.insert(colours.pixels.end(), {colour.red, colour.green, colour.blue, 255});
    }
    canvas_.add(Picture{.place = bar, .cells = std::move(colours)});
    for (const double tick : scale_.ticks) {
      const double fraction = scale_.fraction_of(tick).value_or(-1);
      if (fraction < 0) continue;
      const double y = bar.bottom - fraction * bar.height();
      canvas_.line({bar.right, y}, {bar.right + 4, y}, {.colour = kInk});
      canvas_.text({bar.right + 7, y + 4}, Anchor::Start, tick_text(scale_, tick), kSmallText);
    }
    canvas_.add(Label{.at = {bar.right + 62, (bar.top + bar.bottom) / 2},
                      .anchor = Anchor::Middle,
                      .runs = rich(value_label(plot_)),
                      .size = kTextSize,
                      .colour = kInk,
                      .is_upright = true});
  }

  /// What the lightest shade means.
  void tell_white(const Layout& layout) {
    Runs runs = rich(value_label(plot_) + ": white is ");
    const bool is_log = scale_.kind == ScaleKind::Log;
    const Runs white = tick_text(scale_, is_log ? std::pow(10, scale_.high) : scale_.high);
    runs.insert(runs.end(), white.begin(), white.end());
    if (!is_log) runs.push_back({.text = " or more"});
    if (is_log) {
      const Runs black = tick_text(scale_, std::pow(10, scale_.low));
      runs.push_back({.text = ", black "});
      runs.insert(runs.end(), black.begin(), black.end());
    }
    canvas_.text({layout.plot.left + kLeftRoom, layout.plot.bottom}, Anchor::Start, std::move(runs), kTextSize, kFaint);
  }

  const Plot& plot_;
  Canvas canvas_;
  Scale scale_;
  std::vector<Component> components_;
};

}  // namespace

Drawing draw_slice(const Plot& plot) {
  return SliceDrawing(plot).draw();
}

}  // namespace texbrdf::plots
