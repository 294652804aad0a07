#pragma once

#include <libdeflate.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iterator>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "render/image.h"

namespace texbrdf::test {

/// Reads PNG files of eight bits, RGB or RGBA, not interlaced; nothing where the bytes are anything else. Written from
/// the specification, not from the writer that it checks.
class PngReader {
 public:
  explicit PngReader(std::span<const uint8_t> file) : rest_(file) {}

  std::optional<render::ImageRgba8> read() {
    constexpr std::array<uint8_t, 8> kSignature{137, 80, 78, 71, 13, 10, 26, 10};
    if (rest_.size() < 8 || !std::equal(kSignature.begin(), kSignature.end(), rest_.begin())) return std::nullopt;
    rest_ = rest_.subspan(8);
    while (!ended_) {
      if (!read_chunk()) return std::nullopt;
    }
    if (!rest_.empty() || width_ == 0 || height_ == 0) return std::nullopt;
    return unfilter();
  }

 private:
  static uint32_t big_endian(std::span<const uint8_t> bytes) {
    return uint32_t{bytes[0]} << 24 | uint32_t{bytes[1]} << 16 | uint32_t{bytes[2]} << 8 | uint32_t{bytes[3]};
  }

  bool read_chunk() {
    if (rest_.size() < 12) return false;
    const std::size_t size = big_endian(rest_);
    if (rest_.size() < 12 + size) return false;
    const auto checked = rest_.subspan(4, 4 + size);
    if (libdeflate_crc32(0, checked.data(), checked.size()) != big_endian(rest_.subspan(8 + size))) return false;
    const std::string type(checked.begin(), checked.begin() + 4);
    const auto data = checked.subspan(4);
    rest_ = rest_.subspan(12 + size);
    if (type == "IHDR") return read_header(data);
    if (type == "IDAT") compressed_.insert(compressed_.end(), data.begin(), data.end());
    if (type == "IEND") ended_ = true;
    return true;
  }

  bool read_header(std::span<const uint8_t> data) {
    if (data.size() != 13 || data[8] != 8 || (data[9] != 2 && data[9] != 6)) return false;
    if (data[10] != 0 || data[11] != 0 || data[12] != 0) return false;
    width_ = big_endian(data);
    height_ = big_endian(data.subspan(4));
    channels_ = data[9] == 2 ? 3 : 4;
    return width_ > 0 && width_ <= 65536 && height_ > 0 && height_ <= 65536;
  }

  std::optional<std::vector<uint8_t>> inflate() const {
    std::vector<uint8_t> rows((std::size_t{width_} * channels_ + 1) * height_);
    libdeflate_decompressor* decompressor = libdeflate_alloc_decompressor();
    std::size_t size = 0;
    const auto result = libdeflate_zlib_decompress(decompressor, compressed_.data(), compressed_.size(), rows.data(),
                                                   rows.size(), &size);
    libdeflate_free_decompressor(decompressor);
    if (result != LIBDEFLATE_SUCCESS || size != rows.size()) return std::nullopt;
    return rows;
  }

  static int predict(uint8_t filter, int left, int up, int corner) {
    const int p = left + up - corner;
    const int pa = std::abs(p - left);
    const int pb = std::abs(p - up);
    const int pc = std::abs(p - corner);
    switch (filter) {
      case 1:
        return left;
      case 2:
        return up;
      case 3:
        return (left + up) / 2;
      case 4:
        return pa <= pb && pa <= pc ? left : (pb <= pc ? up : corner);
      default:
        return 0;
    }
  }

  std::optional<render::ImageRgba8> unfilter() const {
    auto rows = inflate();
    if (!rows) return std::nullopt;
    const std::size_t row_bytes = std::size_t{width_} * channels_;
    render::ImageRgba8 image{width_, height_, {}};
    image.pixels.reserve(std::size_t{width_} * height_ * 4);
    std::vector<uint8_t> above(row_bytes);
    for (uint32_t y = 0; y < height_; ++y) {
      uint8_t* row = &(*rows)[y * (row_bytes + 1)];
      const uint8_t filter = *row++;
      if (filter > 4) return std::nullopt;
      for (std::size_t i = 0; i < row_bytes; ++i) {
        const int left = i >= channels_ ? row[i - channels_] : 0;
        const int corner = i >= channels_ ? above[i - channels_] : 0;
        row[i] = static_cast<uint8_t>(row[i] + predict(filter, left, above[i], corner));
      }
      for (std::size_t x = 0; x < width_; ++x) {
        const uint8_t* pixel = row + x * channels_;
        const uint8_t alpha = channels_ == 4 ? pixel[3] : uint8_t{255};
        image.pixels.insert(image.pixels.end(), {pixel[0], pixel[1], pixel[2], alpha});
      }
      std::copy_n(row, row_bytes, above.begin());
    }
    return image;
  }

  std::span<const uint8_t> rest_;
  uint32_t width_ = 0;
  uint32_t height_ = 0;
  uint32_t channels_ = 0;
  bool ended_ = false;
  std::vector<uint8_t> compressed_;
};

inline std::optional<render::ImageRgba8> read_png(std::span<const uint8_t> file) {
  return PngReader(file).read();
}

inline std::optional<render::ImageRgba8> read_png_file(const std::string& path) {
  std::ifstream stream(path, std::ios::binary);
  const std::vector<uint8_t> bytes{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
  return read_png(bytes);
}

}  // namespace texbrdf::test
