#pragma once

#include <cstddef>
#include <cstring>
#include <string_view>

namespace texbrdf {

/// The next place of one character. No stretch of the text is searched twice, however far the wanted one is.
class NextCharacter {
 public:
  NextCharacter(std::string_view text, char wanted) : text_(text), wanted_(wanted), known_(find(0, text.size())) {}

  size_t from(size_t at) {
    if (known_ < at) known_ = find(at, text_.size());
    if (at < searched_from_) {
      const size_t earlier = find(at, searched_from_);
      if (earlier != searched_from_) known_ = earlier;
    }
    searched_from_ = at;
    return known_;
  }

 private:
  size_t find(size_t begin, size_t end) const {
    if (begin >= end) return end;
    const void* found = std::memchr(text_.data() + begin, wanted_, end - begin);
    return found == nullptr ? end : static_cast<size_t>(static_cast<const char*>(found) - text_.data());
  }

  std::string_view text_;
  char wanted_;
  size_t known_;
  size_t searched_from_ = 0;
};

}  // namespace texbrdf
