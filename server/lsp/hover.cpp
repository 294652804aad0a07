#include "features/hover.h"

#include <fmt/format.h>

#include "features/value_text.h"
#include "lsp/session.h"
#include "render/base64.h"

namespace texbrdf::lsp {
namespace {

/// What needs more is neither sampled nor drawn: somebody waits.
constexpr uint32_t kMostValues = 1000;
/// Single precision holds no more, and samples mean less.
constexpr int kDigits = 4;

std::string constant_text(const preview::ExpressionLook& look) {
  return look.has_nan ? "not a number" : "value " + features::value_text(look.least);
}

std::string range_text(const preview::ExpressionLook& look) {
  if (look.least.empty()) return "not a number in any direction that was sampled";
  return fmt::format("{} to {}, sampled over the hemisphere{}", features::value_text(look.least, kDigits),
                     features::value_text(look.most, kDigits), look.has_nan ? "; not a number in places" : "");
}

std::string picture(const preview::ExpressionLook& look) {
  return fmt::format("![over the sphere](data:image/png;base64,{})", render::base64(look.png));
}

}  // namespace

Session::Outcome Session::hover(const PositionParams& params, JsonWriter& result) {
  OpenDocument* open = documents_.find(params.uri);
  if (open == nullptr) return not_open(params.uri);
  const Snapshot& snapshot = open->document.snapshot();
  auto hover = features::hover(snapshot, snapshot.text().offset(params.position, unit_), hover_markup_);
  Positions positions(snapshot.text(), unit_);
  if (hover) {
    if (hover->expression && shows_looks()) hover->text += look_of(snapshot, *hover->expression);
    write_hover(result, positions, *hover, hover_markup_);
  } else {
    result.null();
  }
  return std::nullopt;
}

/// A client that names the parser of its Markdown shows pictures; others may show the bytes of one as text.
bool Session::shows_looks() const {
  switch (settings_.hover_picture) {
    case HoverPicture::Auto:
      return client_.markdown_parser && hover_markup_ == features::Markup::Markdown;
    case HoverPicture::On:
      return true;
    case HoverPicture::Off:
      return false;
  }
  return false;
}

/// Paragraphs. The value of a definition that is constant is said already.
std::string Session::look_of(const Snapshot& snapshot, const features::Expression& expression) {
  const std::optional<ir::Program> program = features::program_of(snapshot, expression, kMostValues);
  if (!program) return {};
  if (!sampler_) sampler_.emplace();
  const std::optional<preview::ExpressionLook> look = sampler_->look(*program);
  if (!look) return {};
  const bool is_constant = look->png.empty();
  const bool is_whole = expression.node == snapshot.syntax(expression.definition).body;
  if (is_constant) return is_whole ? std::string() : "\n\n" + constant_text(*look);
  std::string text = "\n\n" + range_text(*look);
  if (hover_markup_ == features::Markup::Markdown) text += "\n\n" + picture(*look);
  return text;
}

}  // namespace texbrdf::lsp
