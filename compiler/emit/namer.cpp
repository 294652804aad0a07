#include "emit/namer.h"

#include <array>
#include <charconv>
#include <utility>

#include "source/characters.h"

namespace texbrdf::emit {
namespace {

constexpr auto kSpokenCharacters = std::to_array<std::pair<char, std::string_view>>({
    {'+', "plus"},
    {'-', "minus"},
    {'*', "times"},
    {'/', "over"},
    {'\'', "prime"},
    {'=', "equals"},
    {'<', "less"},
    {'>', "greater"},
    {'.', "point"},
    {'^', "to"},
    {'|', "bar"},
    {'&', "and"},
    {'!', "not"},
});

/// Commands that only say how a name looks.
constexpr auto kSilentCommands = std::to_array<std::string_view>({"text", "mathrm", "vec", "left", "right"});

/// Collects words and joins them with single underscores.
class Words {
 public:
  void letter(char c) { word_ += c; }
  void close() {
    if (word_.empty()) return;
    if (!joined_.empty()) joined_ += '_';
    joined_ += std::exchange(word_, {});
  }
  void whole(std::string_view word) {
    close();
    word_ = word;
    close();
  }
  std::string take() {
    close();
    return std::move(joined_);
  }

 private:
  std::string joined_;
  std::string word_;
};

/// A code point outside ASCII, and its length in bytes. A byte that is not part of UTF-8 stands for itself.
std::pair<uint32_t, std::size_t> code_point(std::string_view text) {
  auto byte = [&](std::size_t i) { return static_cast<uint32_t>(static_cast<unsigned char>(text[i])); };
  uint32_t first = byte(0);
  std::size_t length = first >= 0xF0 ? 4 : first >= 0xE0 ? 3 : first >= 0xC0 ? 2 : 1;
  if (length == 1 || text.size() < length) return {first, 1};
  uint32_t value = first & (0xFFu >> (length + 1));
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte(i) & 0xC0u) != 0x80u) return {first, 1};
    value = value << 6 | (byte(i) & 0x3Fu);
  }
  return {value, length};
}

std::string hexadecimal(uint32_t number) {
  std::array<char, 9> buffer;
  auto [end, error] = std::to_chars(buffer.data(), buffer.data() + buffer.size(), number, 16);
  return std::string(buffer.data(), end);
}

void spell_character(std::string_view& rest, Words& words) {
  char c = rest.front();
  if (static_cast<unsigned char>(c) >= 0x80) {
    auto [value, length] = code_point(rest);
    words.whole("u" + hexadecimal(value));
    rest.remove_prefix(length);
    return;
  }
  rest.remove_prefix(1);
  if (is_letter(c) || is_digit(c)) return words.letter(c);
  if (c == '{' || c == '}') return;
  words.close();
  for (auto [character, spoken] : kSpokenCharacters)
    if (character == c) words.whole(spoken);
}

/// Words of LaTeX source: commands by their name, letters and digits as they are, operators spoken.
void spell(std::string_view latex, Words& words) {
  while (!latex.empty()) {
    if (latex.front() != '\\') {
      spell_character(latex, words);
      continue;
    }
    latex.remove_prefix(1);
    std::size_t length = 0;
    while (length < latex.size() && is_letter(latex[length])) ++length;
    std::string_view command = latex.substr(0, length);
    latex.remove_prefix(length);
    words.close();
    bool silent = false;
    for (std::string_view known : kSilentCommands) silent = silent || command == known;
    if (!silent && !command.empty()) words.whole(command);
  }
  words.close();
}

std::string_view decoration_word(const Name& name) {
  if (name.is_vector()) return "vec";
  return name.is_text ? "text" : "";
}

}  // namespace

std::string identifier(const Name& name) {
  Words words;
  spell(name.base, words);
  for (const std::string& decoration : name.decorations) {
    if (decoration != "vec") words.whole(decoration);
  }
  for (const std::string& subscript : name.subscripts) spell(subscript, words);
  for (uint32_t i = 0; i < name.primes && i < 3; ++i) words.whole("prime");
  if (!name.label.empty()) spell(name.label, words);
  if (name.is_in_angles) words.whole("mean");
  std::string text = words.take();
  if (text.empty() || is_digit(text.front())) text.insert(0, "v");
  if (text.starts_with("gl_")) text.insert(0, "v_");
  if (text.size() > kLongestIdentifier) text.resize(kLongestIdentifier);
  while (text.ends_with('_')) text.pop_back();
  return text;
}

bool Namer::free(std::string_view name) const {
  return !taken_.contains(name) && !is_forbidden(*dialect_, name);
}

std::string Namer::claim(const Name& wanted) {
  std::string first = identifier(wanted);
  std::string_view decoration = decoration_word(wanted);
  if (taken_.contains(first) && !decoration.empty()) {
    std::string decorated = first + "_" + std::string(decoration);
    if (free(decorated)) first = std::move(decorated);
  }
  return claim(first);
}

std::string Namer::claim(std::string_view wanted) {
  std::string name(wanted);
  if (is_forbidden(*dialect_, name) && !name.ends_with('_')) name += '_';
  if (is_forbidden(*dialect_, name)) name.insert(0, "v_");
  require(name.find("__") == std::string::npos, "an identifier with two underscores in a row");
  if (!free(name)) name = numbered(name);
  taken_.insert(name);
  return name;
}

std::string Namer::numbered(const std::string& stem) {
  std::string separator = stem.ends_with('_') ? "" : "_";
  uint32_t& number = last_number_.try_emplace(stem, 1).first->second;
  std::string candidate;
  do {
    candidate = stem + separator + std::to_string(++number);
  } while (!free(candidate));
  return candidate;
}

}  // namespace texbrdf::emit
