#include "emit/code_text.h"

#include <algorithm>

namespace texbrdf::emit {

void CodeText::append(std::string_view text) {
  code_.text += text;
  line_count_ += static_cast<uint32_t>(std::ranges::count(text, '\n'));
}

void CodeText::append(const CodeText& code) {
  for (const CodeLines& lines : code.code_.lines) {
    code_.lines.push_back({lines.name, line_count_ + lines.first, line_count_ + lines.last});
  }
  code_.text += code.code_.text;
  line_count_ += code.line_count_;
}

}  // namespace texbrdf::emit
