#include "lsp/markup.h"

namespace texbrdf::lsp {

features::Markup preferred_markup(const std::vector<std::string>& formats, features::Markup if_silent) {
  for (const std::string& format : formats) {
    if (format == "markdown") return features::Markup::Markdown;
    if (format == "plaintext") return features::Markup::PlainText;
  }
  return if_silent;
}

void write_markup(JsonWriter& out, std::string_view key, std::string_view text, features::Markup markup) {
  out.key(key);
  out.begin_object();
  out.member("kind", markup == features::Markup::Markdown ? "markdown" : "plaintext");
  out.member("value", text);
  out.end_object();
}

}  // namespace texbrdf::lsp
