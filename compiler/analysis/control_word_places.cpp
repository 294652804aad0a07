#include "analysis/control_word_places.h"

#include <algorithm>
#include <string>

#include "source/characters.h"
#include "syntax/markdown_code.h"
#include "syntax/verbatim.h"

namespace texbrdf {
namespace {

/// Goes over a text from one control word to the next.
class Walk {
 public:
  Walk(std::string_view text, TextLanguage language)
      : text_(text), is_markdown_(language == TextLanguage::Markdown), code_(text, /*starts_line=*/true) {}

  std::vector<Span> places_of(std::string_view word) {
    std::vector<Span> places;
    while (find_next()) {
      const size_t begin = at_++;
      while (at_ < text_.size() && is_letter(text_[at_])) ++at_;
      const std::string_view found = text_.substr(begin + 1, at_ - begin - 1);
      if (found.empty()) {
        at_ = std::min(at_ + 1, text_.size());
      } else if (found == word) {
        places.push_back({static_cast<uint32_t>(begin), static_cast<uint32_t>(at_)});
      } else if (!is_markdown_) {
        skip_verbatim(found);
      }
    }
    return places;
  }

 private:
  /// Stops at a backslash.
  bool find_next() {
    while (at_ < text_.size()) {
      const size_t stop = text_.find_first_of(is_markdown_ ? "\\" : "\\%", at_);
      const size_t code = is_markdown_ ? code_.next(at_) : text_.size();
      if (code < std::min(stop, text_.size())) {
        at_ = code_.read(code).end;
      } else if (stop == std::string_view::npos) {
        return false;
      } else if (text_[stop] == '\\') {
        at_ = stop;
        return true;
      } else {
        at_ = std::min(text_.find_first_of("\r\n", stop), text_.size());
      }
    }
    return false;
  }

  /// Behind `\verb` and `\begin`.
  void skip_verbatim(std::string_view word) {
    if (word == "verb") at_ = end_of_verb(text_, at_);
    if (word != "begin" || at_ >= text_.size() || text_[at_] != '{') return;
    const size_t close = text_.find('}', at_);
    if (close == std::string_view::npos) return;
    const std::string_view name = text_.substr(at_ + 1, close - at_ - 1);
    if (is_raw_environment(name)) at_ = std::min(text_.find("\\end{" + std::string(name) + "}", close), text_.size());
  }

  std::string_view text_;
  bool is_markdown_;
  MarkdownCode code_;
  size_t at_ = 0;
};

}  // namespace

std::vector<Span> control_word_places(std::string_view text, TextLanguage language, std::string_view word) {
  return Walk(text, language).places_of(word);
}

}  // namespace texbrdf
