#include "cli/picture_size.h"

#include <charconv>

namespace texbrdf::cli {

std::optional<PictureSize> read_picture_size(std::string_view typed) {
  const auto read = [](std::string_view text, uint32_t& number) {
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    return error == std::errc{} && end == text.data() + text.size();
  };
  const std::string_view width = typed.substr(0, typed.find('x'));
  const std::string_view height = width.size() == typed.size() ? width : typed.substr(width.size() + 1);
  PictureSize size;
  if (!read(width, size.width) || !read(height, size.height)) return std::nullopt;
  return size;
}

}  // namespace texbrdf::cli
