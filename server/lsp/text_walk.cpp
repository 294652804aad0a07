#include "lsp/text_walk.h"

#include "source/utf8.h"

namespace texbrdf::lsp {
namespace {

/// One column wide, whatever the unit, and no end of a line.
bool is_plain(char c) {
  const auto byte = static_cast<unsigned char>(c);
  return (byte >= 0x20 && byte < 0x80) || byte == '\t';
}

}  // namespace

Position TextWalk::at(uint32_t offset) {
  if (offset < at_) restart();
  while (at_ < offset) {
    const uint32_t begin = at_;
    while (at_ < offset && is_plain(text_[at_])) ++at_;
    position_.column += at_ - begin;
    if (at_ < offset) step();
  }
  return position_;
}

void TextWalk::restart() {
  at_ = 0;
  position_ = begin_;
}

void TextWalk::step() {
  const char c = text_[at_];
  if (c == '\n' || (c == '\r' && !text_.substr(at_ + 1).starts_with('\n'))) {
    ++at_;
    position_ = {position_.line + 1, 0};
  } else {
    const uint32_t size = code_point_at_front(text_.substr(at_)).size;
    at_ += size;
    position_.column += columns_of(size, unit_);
  }
}

}  // namespace texbrdf::lsp
