#include "syntax/control_words.h"

#include <algorithm>
#include <array>
#include <utility>

namespace texbrdf {
namespace {

/// Of words that make a token by themselves.
constexpr TokenKind token_of(WordMeaning meaning) {
  if (meaning == WordMeaning::Vec) return TokenKind::Vec;
  return meaning == WordMeaning::Accent ? TokenKind::Accent : TokenKind::Unknown;
}

constexpr ControlWord kWords[] = {
#define COMMAND(name, spelling, category) \
  ControlWord{spelling, WordMeaning::Command, TokenKind::category, Command::name},
#include "syntax/commands.def"
#undef COMMAND
#define CONTROL_WORD(spelling, meaning) \
  ControlWord{spelling, WordMeaning::meaning, token_of(WordMeaning::meaning), Command::None},
#define CONTROL_TOKEN(spelling, kind) ControlWord{spelling, WordMeaning::Token, TokenKind::kind, Command::None},
#include "syntax/control_words.def"
#undef CONTROL_TOKEN
#undef CONTROL_WORD
};

constexpr ControlWord kName;

constexpr size_t kSlots = 512;
constexpr uint8_t kEmpty = 255;
static_assert(std::size(kWords) * 2 < kSlots && std::size(kWords) < kEmpty);

constexpr size_t slot_of(std::string_view word) {
  const auto first = static_cast<unsigned char>(word.front());
  const auto last = static_cast<unsigned char>(word.back());
  return (first * 5U + last * 19U + word.size() * 37U) % kSlots;
}

constexpr std::array<uint8_t, kSlots> make_slots() {
  std::array<uint8_t, kSlots> slots{};
  slots.fill(kEmpty);
  for (size_t i = 0; i < std::size(kWords); ++i) {
    size_t slot = slot_of(kWords[i].spelling);
    while (slots[slot] != kEmpty) slot = (slot + 1) % kSlots;
    slots[slot] = static_cast<uint8_t>(i);
  }
  return slots;
}

constexpr std::array<uint8_t, kSlots> kSlotsByHash = make_slots();

/// Words are a few letters long: calling memcmp would cost more.
bool equal(std::string_view a, std::string_view b) {
  if (a.size() != b.size()) return false;
  for (size_t i = 0; i < a.size(); ++i) {
    if (a[i] != b[i]) return false;
  }
  return true;
}

constexpr std::pair<Command, Command> kInverses[] = {
    {Command::Sin, Command::Arcsin}, {Command::Cos, Command::Arccos}, {Command::Tan, Command::Arctan},
    {Command::Arcsin, Command::Sin}, {Command::Arccos, Command::Cos}, {Command::Arctan, Command::Tan},
    {Command::Exp, Command::Ln},     {Command::Ln, Command::Exp},     {Command::Log, Command::Exp},
};

}  // namespace

const ControlWord& find_control_word(std::string_view letters) {
  if (letters.empty()) return kName;
  for (size_t slot = slot_of(letters); kSlotsByHash[slot] != kEmpty; slot = (slot + 1) % kSlots) {
    const ControlWord& word = kWords[kSlotsByHash[slot]];
    if (equal(word.spelling, letters)) return word;
  }
  return kName;
}

Command find_command(std::string_view letters) {
  return find_control_word(letters).command;
}

std::string_view command_spelling(Command command) {
  switch (command) {
    case Command::None:
      return {};
#define COMMAND(name, spelling, category) \
  case Command::name:                     \
    return spelling;
#include "syntax/commands.def"
#undef COMMAND
  }
  return {};
}

Command inverse_of(Command function) {
  const auto* const entry = std::ranges::find(kInverses, function, &std::pair<Command, Command>::first);
  return entry == std::end(kInverses) ? Command::None : entry->second;
}

bool is_trigonometric(Command function) {
  return function == Command::Sin || function == Command::Cos || function == Command::Tan;
}

}  // namespace texbrdf
