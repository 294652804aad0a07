#pragma once

#include <cstdint>
#include <string_view>

#include "source/source_text.h"

namespace texbrdf::lsp {

/// Positions within a text that are asked for from front to back: the text is gone through once.
class TextWalk {
 public:
  /// `begin`: where the text begins in its document.
  TextWalk(std::string_view text, ColumnUnit unit, Position begin = {}) : text_(text), unit_(unit), begin_(begin) {
    restart();
  }

  /// Of an offset at a code point of the text, or its end. Going back costs a walk from the front.
  Position at(uint32_t offset);

 private:
  void restart();
  void step();

  std::string_view text_;
  ColumnUnit unit_;
  Position begin_;
  uint32_t at_ = 0;
  Position position_;
};

}  // namespace texbrdf::lsp
