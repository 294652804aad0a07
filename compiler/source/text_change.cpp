#include "source/text_change.h"

#include <algorithm>

namespace texbrdf {

TextChange smallest_change(std::string_view before, std::string_view after) {
  const auto front = std::ranges::mismatch(before, after);
  const auto begin = static_cast<uint32_t>(front.in1 - before.begin());
  const auto back = std::mismatch(before.rbegin(), before.rend() - begin, after.rbegin(), after.rend() - begin);
  const auto same_behind = static_cast<uint32_t>(back.first - before.rbegin());
  return {{begin, static_cast<uint32_t>(before.size()) - same_behind},
          after.substr(begin, after.size() - same_behind - begin)};
}

}  // namespace texbrdf
