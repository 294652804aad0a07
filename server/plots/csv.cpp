#include "plots/csv.h"

#include <fmt/format.h>

#include <cmath>
#include <iterator>

#include "plots/channels.h"

namespace texbrdf::plots {
namespace {

std::string quoted(std::string_view text) {
  if (text.find_first_of(",\"\r\n") == std::string_view::npos) return std::string(text);
  std::string cell = "\"";
  for (const char character : text) {
    if (character == '"') cell += '"';
    cell += character;
  }
  return cell + '"';
}

std::string_view angle_columns(View view) {
  switch (view) {
    case View::Polar:
    case View::ThetaO:
      return "theta_o";
    case View::ThetaH:
      return "theta_h";
    case View::ThetaD:
      return "theta_d";
    case View::Albedo:
      return "theta_i";
    case View::Lobe:
      return "theta_o,phi_o";
    case View::Slice:
      return "theta_d,theta_h";
  }
  return "";
}

class CsvWriter {
 public:
  explicit CsvWriter(const Plot& plot) : plot_(plot) {}

  std::string write() {
    // Series of reals and of colours may stand in one table: then the columns are those of colours.
    columns_ = &plot_.series.front();
    for (const Series& series : plot_.series) {
      if (series.is_colour) columns_ = &series;
    }
    add("series,{}", angle_columns(plot_.request.view));
    for (const Component& component : components_of(plot_, *columns_)) add(",{}", component.word());
    if (plot_.request.view == View::Albedo) {
      for (const Component& component : components_of(plot_, *columns_)) add(",{}_error", component.word());
    }
    add("\n");
    for (const Series& series : plot_.series) write_series(series);
    return fmt::to_string(out_);
  }

 private:
  template <typename... Parts>
  void add(fmt::format_string<const Parts&...> format, const Parts&... parts) {
    fmt::format_to(std::back_inserter(out_), format, parts...);
  }

  void write_series(const Series& series) {
    const std::string name = quoted(series.label);
    if (const auto* const curve = std::get_if<Curve>(&series.samples)) {
      for (std::size_t i = 0; i < curve->angles.size(); ++i) {
        add("{},{}", name, curve->angles[i]);
        add_numbers(curve->values[i]);
        if (!curve->errors.empty()) add_numbers(curve->errors[i]);
        add("\n");
      }
      return;
    }
    const Grid& grid = std::get<Grid>(series.samples);
    for (std::size_t i = 0; i < grid.values.size(); ++i) {
      add("{},{},{}", name, grid.rows[i / grid.columns.size()], grid.columns[i % grid.columns.size()]);
      add_numbers(grid.values[i]);
      add("\n");
    }
  }

  void add_numbers(const Sample& sample) {
    for (const Component& component : components_of(plot_, *columns_)) {
      add(",");
      const std::optional<double> number = number_of(component, sample);
      if (!number) continue;
      // A NaN's sign says nothing, and differs between machines.
      if (std::isnan(*number)) add("nan");
      if (!std::isnan(*number)) add("{}", *number);
    }
  }

  const Plot& plot_;
  const Series* columns_ = nullptr;
  fmt::memory_buffer out_;
};

}  // namespace

std::string write_csv(const Plot& plot) {
  return CsvWriter(plot).write();
}

}  // namespace texbrdf::plots
