#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace texbrdf::plots {

enum class View : uint8_t {
#define VIEW(name, word, description) name,
#include "plots/views.def"
#undef VIEW
};

std::string_view word_of(View view);
std::optional<View> view_of(std::string_view word);
/// With commas between.
std::string view_words();

enum class Channels : uint8_t { Red, Green, Blue, All, Luminance };

/// What is plotted of a BRDF, angles in degrees. Each view uses a part of it.
struct Request {
  View view = View::Polar;
  double incidence = 45;  ///< of the light from the normal, 0 to below 90
  double phi = 0;         ///< of the light around the normal, from X towards Y
  double theta_h = 0;     ///< where the difference angle varies, 0 to 90
  double theta_d = 0;     ///< where the half vector's angle varies, 0 to 90
  double phi_d = 90;      ///< of the light around the half vector, from the plane of half vector and normal
  bool times_cosine = false;
};

/// Why the angles cannot be used, in words, or nothing.
std::optional<std::string> find_fault(const Request& request);

}  // namespace texbrdf::plots
