#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "source/characters.h"
#include "source/utf8.h"
#include "syntax/control_words.h"
#include "syntax/macro_expansion.h"
#include "syntax/parsed_block.h"

namespace texbrdf {

namespace {

/// What macros may make of a block: so much, and so many times more as the block is long.
constexpr size_t kBytesMade = 1024;
constexpr size_t kBytesMadePerByte = 24;
constexpr uint32_t kMaxDepth = 64;
/// Stands for a macro that cannot be expanded; nobody writes it into an equation.
constexpr char kProblem = '\x1a';
/// How far back a fraction is looked for whose second argument a macro may be.
constexpr size_t kLongestNumerator = 128;
constexpr size_t kLongestWord = 64;
constexpr size_t kFarthest = kLongestNumerator + 2 * kLongestWord;

bool uses_macros(std::string_view text, const MacroTable& macros) {
  bool found = false;
  visit_control_words(text, [&](std::string_view word) {
    found = macros.find(word) != nullptr || defines_macros(word);
    return !found;
  });
  return found;
}

/// The control word that the text ends with; empty where it ends with something else.
std::string_view word_at_end(std::string_view text) {
  size_t begin = text.size();
  const size_t limit = begin - std::min(begin, kLongestWord);
  while (begin > limit && is_letter(text[begin - 1])) --begin;
  if (begin == text.size() || begin == limit) return {};
  size_t backslashes = 0;
  while (backslashes < begin && text[begin - backslashes - 1] == '\\') ++backslashes;
  return backslashes % 2 == 1 ? text.substr(begin) : std::string_view();
}

/// As characters of one word or number, or of a command and what follows it, would.
bool would_join(std::string_view before, char next) {
  if (before.empty()) return false;
  const bool is_alphanumeric = is_letter(before.back()) || is_digit(before.back());
  return is_alphanumeric && (is_letter(next) || is_digit(next));
}

/// What takes the next token, whatever that stands for, as its argument.
bool takes_argument(std::string_view word) {
  const ControlWord& known = find_control_word(word);
  if (known.meaning == WordMeaning::Vec || known.meaning == WordMeaning::Accent) return true;
  return known.kind == TokenKind::Frac || known.kind == TokenKind::Sqrt;
}

bool is_fraction(std::string_view word) {
  return find_control_word(word).kind == TokenKind::Frac;
}

std::string_view without_spaces_behind(std::string_view text) {
  while (!text.empty() && is_space(text.back())) text.remove_suffix(1);
  return text;
}

/// Without the group or the character at its end.
std::string_view without_last_argument(std::string_view text) {
  if (text.empty()) return text;
  if (text.back() != '}') {
    const std::string_view word = word_at_end(text);
    return text.substr(0, text.size() - (word.empty() ? 1 : word.size() + 1));
  }
  uint32_t depth = 0;
  const size_t limit = text.size() - std::min(text.size(), kLongestNumerator);
  for (size_t i = text.size(); i > limit; --i) {
    if (text[i - 1] == '}') ++depth;
    if (text[i - 1] == '{' && --depth == 0) return text.substr(0, i - 1);
  }
  return {};
}

/// What follows the text is an argument without braces.
bool awaits_argument(std::string_view text) {
  const std::string_view before = without_spaces_behind(text.substr(text.size() - std::min(text.size(), kFarthest)));
  if (before.empty()) return false;
  if (before.back() == '^' || before.back() == '_') return !before.ends_with("\\_");
  if (takes_argument(word_at_end(before))) return true;
  return is_fraction(word_at_end(without_spaces_behind(without_last_argument(before))));
}

}  // namespace

/// Reads a stack of texts: the block's, and above it what the macros stand for that are being read.
class MacroExpander {
 public:
  MacroExpander(std::string_view source, const BlockExtent& extent, const MacroTable& macros)
      : macros_(macros), budget_(kBytesMade + kBytesMadePerByte * source.size()) {
    result_.source_ = source;
    result_.source_extent_ = extent;
    contexts_.push_back({});
  }

  MacroExpansion run() {
    const BlockExtent& extent = result_.source_extent_;
    const auto size = static_cast<uint32_t>(result_.source_.size());
    copy_source({0, extent.content.begin});
    frames_.push_back(frame_of_source(extent.content));
    while (!frames_.empty()) step();
    const auto content_end = static_cast<uint32_t>(result_.text_.size());
    copy_source({extent.content.end, size});
    if (result_.runs_.empty()) result_.runs_.push_back({.begin = 0, .source = {0, 0}, .is_written = true});
    result_.extent_ = extent;
    result_.extent_.content.end = content_end;
    result_.extent_.end = {content_end, content_end + extent.end.size()};
    result_.extent_.whole.end = extent.whole.begin + static_cast<uint32_t>(result_.text_.size());
    std::ranges::sort(result_.uses_, {}, [](const MacroUse& use) { return std::pair(use.whole, use.command); });
    const auto repeated = std::ranges::unique(result_.uses_);
    result_.uses_.erase(repeated.begin(), repeated.end());
    return std::move(result_);
  }

 private:
  static constexpr uint32_t kNoUse = MacroExpansion::kNoUse;

  /// A stretch of a frame that comes from one place.
  struct Region {
    uint32_t begin = 0;
    Span source;
    bool is_written = false;
    bool is_bare = false;
    uint32_t top = kNoUse;
    uint32_t context = 0;  // the macros in whose bodies it stands
  };
  /// Text, and where it comes from.
  struct Sourced {
    std::string text;
    std::vector<Region> regions;
  };
  struct Frame {
    Sourced content;
    size_t at = 0;
    size_t region = 0;  // the one that `at` is in
    bool is_grouped = false;
  };
  /// A macro that is being expanded, and those in whose bodies that stands.
  struct Context {
    const Macro* macro = nullptr;
    uint32_t parent = 0;
    uint32_t depth = 0;
  };

  Frame frame_of_source(Span content) const {
    Frame frame;
    frame.content.text = result_.source_.substr(content.begin, content.size());
    frame.content.regions.push_back({.begin = 0, .source = content, .is_written = true});
    return frame;
  }

  void copy_source(Span span) {
    if (span.empty()) return;
    add_run(span, /*is_written=*/true, /*is_bare=*/false, kNoUse);
    result_.text_.append(result_.source_, span.begin, span.size());
  }

  void step() {
    Frame& frame = frames_.back();
    const std::string& text = frame.content.text;
    if (frame.at == text.size()) return leave();
    if (text[frame.at] == '%') return emit(std::min(text.find_first_of("\r\n", frame.at), text.size()));
    if (text[frame.at] != '\\') return emit(std::min(text.find_first_of("\\%", frame.at), text.size()));
    size_t end = frame.at + 1;
    while (end < text.size() && is_letter(text[end])) ++end;
    if (end == frame.at + 1) return emit(std::min(end + 1, text.size()));
    read_word(end);
  }

  void leave() {
    const bool is_grouped = frames_.back().is_grouped;
    const Region last = frames_.back().content.regions.back();
    frames_.pop_back();
    if (is_grouped) make("}", last);
    joint_ = result_.text_.size();
  }

  void read_word(size_t end) {
    Frame& frame = frames_.back();
    const std::string_view word = std::string_view(frame.content.text).substr(frame.at + 1, end - frame.at - 1);
    if (defines_macros(word) && skip_definition(end)) return;
    const Region& region = region_at_front();
    if (region.context != 0 && word == "xspace") {
      frame.at = end;
      return;
    }
    if (region.context != 0 && word == "ensuremath") return expand("ensuremath", kEnsureMath, end);
    const Macro* const macro = macros_.find(word);
    if (macro == nullptr) return emit(end);
    expand(std::string(word), *macro, end);
  }

  /// What cannot be read is no definition.
  bool skip_definition(size_t behind_word) {
    Frame& frame = frames_.back();
    const MacroReading reading =
        read_macro_definition(frame.content.text, static_cast<uint32_t>(frame.at), static_cast<uint32_t>(behind_word));
    if (!reading.definition) return false;
    result_.has_definitions_ = true;
    frame.at = reading.definition->span.end;
    return true;
  }

  /// The region of the byte that is read next.
  const Region& region_at_front() {
    Frame& frame = frames_.back();
    const std::vector<Region>& regions = frame.content.regions;
    while (frame.region + 1 < regions.size() && regions[frame.region + 1].begin <= frame.at) ++frame.region;
    return regions[frame.region];
  }

  static uint32_t end_of(const Sourced& content, size_t region) {
    return region + 1 < content.regions.size() ? content.regions[region + 1].begin
                                               : static_cast<uint32_t>(content.text.size());
  }

  /// Copies what stands up to `end`.
  void emit(size_t end) {
    separate(frames_.back().content.text[frames_.back().at]);
    while (frames_.back().at < end) {
      const Region region = region_at_front();
      Frame& frame = frames_.back();
      const size_t part_end = std::min<size_t>(end, end_of(frame.content, frame.region));
      const auto into = static_cast<uint32_t>(frame.at - region.begin);
      const auto size = static_cast<uint32_t>(part_end - frame.at);
      const Span source =
          region.is_written ? Span{region.source.begin + into, region.source.begin + into + size} : region.source;
      add_run(source, region.is_written, region.is_bare, region.top);
      result_.text_.append(frame.content.text, frame.at, size);
      frame.at = part_end;
    }
  }

  /// What a macro made does not become one word with what stands beside it.
  void separate(char next) {
    if (joint_ != result_.text_.size() || !would_join(result_.text_, next)) return;
    make(" ", region_at_front());
  }

  /// Text that stands nowhere.
  void make(std::string_view text, const Region& beside) {
    const Span place = beside.is_written ? Span{beside.source.begin, beside.source.begin} : beside.source;
    add_run(place, /*is_written=*/false, /*is_bare=*/false, beside.top);
    result_.text_ += text;
  }

  void add_run(Span source, bool is_written, bool is_bare, uint32_t top) {
    const auto begin = static_cast<uint32_t>(result_.text_.size());
    std::vector<MacroExpansion::Run>& runs = result_.runs_;
    if (!runs.empty()) {
      MacroExpansion::Run& last = runs.back();
      const bool is_alike = last.is_written == is_written && last.is_bare == is_bare && last.top == top;
      if (is_alike && !is_written && last.source == source) return;
      if (is_alike && is_written && last.source.end == source.begin) {
        last.source.end = source.end;
        return;
      }
    }
    runs.push_back({begin, source, is_written, is_bare, top});
  }

  /// The macro's word stands at the front, up to `behind_word`.
  void expand(const std::string& name, const Macro& macro, size_t behind_word) {
    const Region place = region_at_front();
    const Span command = take_source(behind_word);
    whole_ = command;
    if (macro.is_original) {
      made_at(place, command, name);
      separate(macro.body.front());
      make(macro.body, made_region(place, command));
      joint_ = result_.text_.size();
      return;
    }
    const uint32_t depth = contexts_[place.context].depth + 1;
    if (is_open(place.context, macro)) return fail(Code::MacroRecursion, place, command, {name});
    std::vector<Sourced> arguments;
    if (!read_arguments(macro, arguments)) {
      return fail(Code::MacroArguments, place, command, {name, std::to_string(macro.parameters)});
    }
    if (depth > kMaxDepth) return fail(Code::MacroTooLong, place, command, {name});
    const uint32_t top = made_at(place, command, name);
    contexts_.push_back({&macro, place.context, depth});
    Region made = made_region(place, whole_);
    made.top = top;
    made.context = static_cast<uint32_t>(contexts_.size()) - 1;
    std::optional<Sourced> text = substitute(macro.body, arguments, made);
    if (!text) return fail(Code::MacroTooLong, place, command, {name});
    enter(std::move(*text), made);
  }

  void enter(Sourced text, const Region& made) {
    if (text.text.empty()) {
      joint_ = result_.text_.size();
      return;
    }
    const bool is_grouped = awaits_argument(result_.text_);
    frames_.push_back({.content = std::move(text), .is_grouped = is_grouped});
    if (is_grouped) {
      make("{", made);
    } else {
      joint_ = result_.text_.size();
    }
  }

  static Region made_region(const Region& place, Span source) {
    Region made = place;
    made.begin = 0;
    made.is_bare = false;
    if (place.is_written) made.source = source;
    made.is_written = false;
    return made;
  }

  /// Notes a use that stands in the source. Its outermost use.
  uint32_t made_at(const Region& place, Span command, const std::string& name) {
    if (place.is_written) result_.uses_.push_back({name, command, join_hull(command, whole_)});
    if (place.top == kNoUse) {
      result_.tops_.push_back(join_hull(command, whole_));
      return static_cast<uint32_t>(result_.tops_.size()) - 1;
    }
    // Its last arguments may stand behind the use whose body it ends.
    Span& top = result_.tops_[place.top];
    top = join_hull(top, whole_);
    return place.top;
  }

  static Span join_hull(Span a, Span b) {
    if (b.empty()) return a;
    return {std::min(a.begin, b.begin), std::max(a.end, b.end)};
  }

  void fail(Code code, const Region& place, Span command, std::vector<std::string> arguments) {
    arguments.front().insert(0, "\\");
    result_.problems_.push_back({code, static_cast<uint32_t>(result_.text_.size()), std::move(arguments)});
    make({&kProblem, 1}, made_region(place, command));
    joint_ = 0;
  }

  bool is_open(uint32_t context, const Macro& macro) const {
    for (; context != 0; context = contexts_[context].parent) {
      if (contexts_[context].macro == &macro) return true;
    }
    return false;
  }

  /// Passes over what stands up to `end`. Where it stands in the source.
  Span take_source(size_t end) {
    const Region& region = region_at_front();
    Frame& frame = frames_.back();
    const auto begin = static_cast<uint32_t>(frame.at) - region.begin;
    const auto size = static_cast<uint32_t>(end - frame.at);
    frame.at = end;
    if (!region.is_written) return region.source;
    return {region.source.begin + begin, region.source.begin + begin + size};
  }

  bool read_arguments(const Macro& macro, std::vector<Sourced>& arguments) {
    if (macro.takes_size) skip_size();
    if (macro.fallback) arguments.push_back(read_optional(*macro.fallback));
    while (arguments.size() < macro.parameters) {
      std::optional<Sourced> argument = read_argument();
      if (!argument) return false;
      arguments.push_back(std::move(*argument));
    }
    return true;
  }

  /// To what follows, which may stand behind the end of a macro's body. False where nothing does.
  bool find_argument() {
    for (;;) {
      Frame& frame = frames_.back();
      const std::string& text = frame.content.text;
      while (frame.at < text.size() && (is_space(text[frame.at]) || text[frame.at] == '%')) {
        frame.at = text[frame.at] == '%' ? std::min(text.find_first_of("\r\n", frame.at), text.size()) : frame.at + 1;
      }
      if (frame.at < text.size()) return true;
      if (frames_.size() == 1 || frame.is_grouped) return false;
      frames_.pop_back();
    }
  }

  std::optional<Sourced> read_argument() {
    if (!find_argument()) return std::nullopt;
    const std::string& text = frames_.back().content.text;
    const size_t begin = frames_.back().at;
    switch (text[begin]) {
      case '{': {
        const std::optional<size_t> close = closer_of(begin);
        if (!close) return std::nullopt;
        return take({begin + 1, *close}, *close + 1, /*is_bare=*/false);
      }
      case '}':
      case '&':
        return std::nullopt;
      case '\\': {
        size_t end = begin + 1;
        while (end < text.size() && is_letter(text[end])) ++end;
        if (end == begin + 1) end = std::min(end + 1, text.size());
        const std::string_view command = std::string_view(text).substr(begin, end - begin);
        if (command == "\\\\" || command == "\\end") return std::nullopt;
        return take({begin, end}, end, /*is_bare=*/true);
      }
      default: {
        const size_t end = begin + code_point_at_front(std::string_view(text).substr(begin)).size;
        return take({begin, end}, end, /*is_bare=*/true);
      }
    }
  }

  /// `[…]`, or the fallback.
  Sourced read_optional(const std::string& fallback) {
    if (find_argument()) {
      const size_t begin = frames_.back().at;
      const std::optional<size_t> close = frames_.back().content.text[begin] == '[' ? closer_of(begin) : std::nullopt;
      if (close) return take({begin + 1, *close}, *close + 1, /*is_bare=*/false);
    }
    return {.text = fallback, .regions = {}};
  }

  /// `*`, `[\big]`
  void skip_size() {
    if (!find_argument()) return;
    if (frames_.back().content.text[frames_.back().at] == '*') ++frames_.back().at;
    read_optional({});
  }

  /// Of the bracket at `open`, in the frame on top.
  std::optional<size_t> closer_of(size_t open) {
    const std::string& text = frames_.back().content.text;
    const bool is_square = text[open] == '[';
    uint32_t depth = 0;
    for (size_t i = open; i < text.size(); ++i) {
      spend(1);
      if (budget_ == 0) return std::nullopt;
      switch (text[i]) {
        case '\\':
          ++i;
          break;
        case '%':
          i = std::min(text.find_first_of("\r\n", i), text.size()) - 1;
          break;
        case '{':
          ++depth;
          break;
        case '}':
          if (depth == 0) return std::nullopt;
          if (--depth == 0 && !is_square) return i;
          break;
        case ']':
          if (is_square && depth == 0) return i;
          break;
        default:
          break;
      }
    }
    return std::nullopt;
  }

  struct Stretch {
    size_t begin;
    size_t end;
  };

  /// An argument of the frame on top, and goes behind it.
  Sourced take(Stretch stretch, size_t behind, bool is_bare) {
    Frame& frame = frames_.back();
    Sourced taken{.text = frame.content.text.substr(stretch.begin, stretch.end - stretch.begin), .regions = {}};
    spend(taken.text.size());
    const std::vector<Region>& regions = frame.content.regions;
    size_t region = frame.region;
    while (region + 1 < regions.size() && regions[region + 1].begin <= stretch.begin) ++region;
    for (; region < regions.size() && regions[region].begin < stretch.end; ++region) {
      Region part = regions[region];
      const auto skipped = static_cast<uint32_t>(std::max<size_t>(stretch.begin, part.begin)) - part.begin;
      part.begin = part.begin + skipped - static_cast<uint32_t>(stretch.begin);
      if (part.is_written) part.source.begin += skipped;
      part.is_bare = part.is_bare || is_bare;
      taken.regions.push_back(part);
    }
    note_argument(behind);
    frame.at = behind;
    return taken;
  }

  /// The use goes up to `behind`.
  void note_argument(size_t behind) {
    Frame& frame = frames_.back();
    frame.at = behind - 1;
    const Region& region = region_at_front();
    if (!region.is_written) return;
    const uint32_t end = region.source.begin + static_cast<uint32_t>(behind - region.begin);
    whole_ = join_hull(whole_, {end - 1, end});
  }

  void spend(size_t bytes) { budget_ -= std::min(budget_, bytes); }

  /// The body with the arguments; nothing where it is too much.
  std::optional<Sourced> substitute(std::string_view body, const std::vector<Sourced>& arguments, const Region& made) {
    Sourced result;
    spend(1);
    for (size_t at = 0; at < body.size();) {
      const bool is_parameter = body[at] == '#' && at + 1 < body.size() && is_digit(body[at + 1]);
      if (is_parameter) {
        const auto index = static_cast<size_t>(body[at + 1] - '1');
        if (index < arguments.size() && !append(result, arguments[index], made)) return std::nullopt;
        at += 2;
        continue;
      }
      const size_t end = std::min(body.find('#', at + 1), body.size());
      if (!append(result, {.text = std::string(body.substr(at, end - at)), .regions = {}}, made)) return std::nullopt;
      at = end;
    }
    return result;
  }

  /// What has no regions of its own is made.
  bool append(Sourced& result, const Sourced& part, const Region& made) {
    spend(part.text.size() + part.regions.size());
    if (budget_ == 0) return false;
    if (part.text.empty()) return true;
    if (is_letter(part.text.front()) && !word_at_end(result.text).empty()) {
      add_region(result, made);
      result.text += ' ';
    }
    const auto begin = static_cast<uint32_t>(result.text.size());
    if (part.regions.empty()) add_region(result, made);
    for (Region region : part.regions) {
      region.begin += begin;
      region.top = made.top;
      result.regions.push_back(region);
    }
    result.text += part.text;
    return true;
  }

  static void add_region(Sourced& result, Region made) {
    made.begin = static_cast<uint32_t>(result.text.size());
    result.regions.push_back(made);
  }

  inline static const Macro kEnsureMath{.parameters = 1, .fallback = {}, .body = "#1"};

  const MacroTable& macros_;
  MacroExpansion result_;
  std::vector<Frame> frames_;
  std::vector<Context> contexts_;
  size_t budget_;
  size_t joint_ = 0;  // where what a macro made begins or ends
  Span whole_;        // of the use that is read, with its arguments
};

std::shared_ptr<const MacroExpansion> expand_macros(std::string_view text, const BlockExtent& extent,
                                                    const MacroTable& macros) {
  if (macros.empty() || text.size() > kMaxBlockBytes) return nullptr;
  const std::string_view content = text.substr(extent.content.begin, extent.content.size());
  if (!uses_macros(content, macros)) return nullptr;
  return std::make_shared<const MacroExpansion>(MacroExpander(text, extent, macros).run());
}

}  // namespace texbrdf
