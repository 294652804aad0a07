#include "render/tone_map.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "render/gamma_table.h"

namespace texbrdf::render {

namespace {

ImageRgba8 black_disc(const SphereGeometry& geometry) {
  ImageRgba8 image{geometry.size, geometry.size, std::vector<uint8_t>(geometry.alpha.size() * 4)};
  for (std::size_t i = 0; i < geometry.alpha.size(); ++i) image.pixels[i * 4 + 3] = geometry.alpha[i];
  return image;
}

}  // namespace

struct ToneMapper::State {
  const SphereGeometry& geometry;
  GammaTable encode;
  float exposure;
  bool times_cosine;
  Picture picture;
};

ToneMapper::ToneMapper(const SphereGeometry& geometry, const SphereView& view)
    : state_(new State{geometry,
                       GammaTable(view.gamma),
                       static_cast<float>(std::exp2(view.exposure)),
                       view.times_cosine,
                       {black_disc(geometry), {}}}) {}
ToneMapper::~ToneMapper() = default;

void ToneMapper::add(std::size_t first, std::size_t count, const ShadedValues& values) {
  const SphereGeometry& geometry = state_->geometry;
  Picture& picture = state_->picture;
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t at = i * values.stride;
    const std::array<float, 3> value{values.channels[0][at], values.channels[1][at], values.channels[2][at]};
    uint8_t* pixel = &picture.image.pixels[std::size_t{geometry.pixels[first + i]} * 4];
    if (const std::optional<BadPixel> bad = find_bad(value)) {
      ++picture.bad_pixels[*bad];
      std::copy_n(bad_pixel_entry(*bad).colour.begin(), 3, pixel);
      continue;
    }
    const float cosine = state_->times_cosine ? geometry.cosines[first + i] : 1;
    const float scale = cosine * state_->exposure;
    for (std::size_t c = 0; c < 3; ++c) pixel[c] = state_->encode(value[c] * scale);
  }
}

Picture ToneMapper::take() {
  return std::move(state_->picture);
}

Picture tone_map(const SphereGeometry& geometry, const SphereView& view, const ShadedValues& values) {
  ToneMapper mapper(geometry, view);
  mapper.add(0, geometry.point_count(), values);
  return mapper.take();
}

Picture map_directions(const SphereGeometry& geometry, const ShadedValues& values) {
  Picture picture{black_disc(geometry), {}};
  for (std::size_t i = 0; i < geometry.point_count(); ++i) {
    const std::size_t at = i * values.stride;
    const std::array<float, 3> value{values.channels[0][at], values.channels[1][at], values.channels[2][at]};
    uint8_t* pixel = &picture.image.pixels[std::size_t{geometry.pixels[i]} * 4];
    const std::optional<BadPixel> bad = find_bad(value);
    if (bad && *bad != BadPixel::Negative) {
      ++picture.bad_pixels[*bad];
      std::ranges::copy(bad_pixel_entry(*bad).colour, pixel);
      continue;
    }
    for (std::size_t c = 0; c < 3; ++c) {
      pixel[c] = static_cast<uint8_t>(std::lround(255 * std::clamp(0.5F + 0.5F * value[c], 0.0F, 1.0F)));
    }
  }
  return picture;
}

}  // namespace texbrdf::render
