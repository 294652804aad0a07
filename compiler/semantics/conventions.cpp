#include "semantics/conventions.h"

#include <algorithm>
#include <array>
#include <utility>

namespace texbrdf {
namespace {

// A row of conventions.def that can be formed at compile time.
struct Row {
  Convention id;
  Type type;
  std::string_view spellings;
  std::array<Convention, 3> operands;
  size_t operand_count;
  std::string_view symbol, formula, meaning;
};

struct Operands {
  std::array<Convention, 3> list{};
  size_t count = 0;
  template <typename... Ids>
  constexpr explicit Operands(Ids... ids) : list{ids...}, count(sizeof...(ids)) {}
};

constexpr Row make_row(Convention id, Type type, std::string_view spellings, Operands operands, std::string_view symbol,
                       std::string_view formula, std::string_view meaning) {
  return {id, type, spellings, operands.list, operands.count, symbol, formula, meaning};
}

constexpr auto make_rows() {
  using enum Convention;
  using enum Type;
  return std::to_array<Row>({
#define CONVENTION(name, type, spellings, operands, symbol, formula, meaning) \
  make_row(name, type, spellings, Operands operands, symbol, formula, meaning),
#include "semantics/conventions.def"
#undef CONVENTION
  });
}

constexpr auto kRows = make_rows();

std::vector<std::string_view> split_words(std::string_view text) {
  std::vector<std::string_view> words;
  while (!text.empty()) {
    const size_t length = std::min(text.find(' '), text.size());
    words.push_back(text.substr(0, length));
    text.remove_prefix(std::min(length + 1, text.size()));
  }
  return words;
}

std::vector<ConventionEntry> make_entries() {
  std::vector<ConventionEntry> entries;
  for (const Row& row : kRows) {
    entries.push_back({.id = row.id,
                       .type = row.type,
                       .spellings = split_words(row.spellings),
                       .operands = {row.operands.begin(), row.operands.begin() + row.operand_count},
                       .symbol = row.symbol,
                       .formula = row.formula,
                       .meaning = row.meaning});
  }
  return entries;
}

std::vector<UsualName> make_usual_names() {
  constexpr std::pair<Convention, std::string_view> kTable[] = {
#define USUAL_NAME(convention, spellings) {Convention::convention, spellings},
#include "semantics/usual_names.def"
#undef USUAL_NAME
  };
  std::vector<UsualName> names;
  for (const auto& [meaning, spellings] : kTable) {
    for (std::string_view spelling : split_words(spellings)) names.push_back({spelling, meaning});
  }
  std::ranges::sort(names, {}, &UsualName::spelling);
  return names;
}

}  // namespace

std::span<const UsualName> usual_names() {
  static const std::vector<UsualName> names = make_usual_names();
  return names;
}

std::optional<Convention> find_usual_name(std::string_view canonical) {
  const auto found = std::ranges::lower_bound(usual_names(), canonical, {}, &UsualName::spelling);
  if (found == usual_names().end() || found->spelling != canonical) return std::nullopt;
  return found->meaning;
}

std::span<const ConventionEntry> conventions() {
  static const std::vector<ConventionEntry> entries = make_entries();
  return entries;
}

const ConventionEntry& convention_entry(Convention id) {
  return conventions()[static_cast<size_t>(id)];
}

bool depends_on(Convention convention, std::span<const Convention> others) {
  if (std::ranges::find(others, convention) != others.end()) return true;
  const auto& operands = convention_entry(convention).operands;
  return std::ranges::any_of(operands, [&](Convention operand) { return depends_on(operand, others); });
}

std::optional<Convention> find_convention(std::string_view canonical) {
  if (!canonical.starts_with('\\')) return std::nullopt;
  for (const ConventionEntry& entry : conventions()) {
    for (std::string_view spelling : entry.spellings) {
      if (spelling == canonical) return entry.id;
    }
  }
  return std::nullopt;
}

std::optional<double> convention_constant(Convention id) {
  if (id == Convention::Pi) return kPi;
  if (id == Convention::Epsilon) return kEpsilon;
  if (id == Convention::Euler) return kEuler;
  return std::nullopt;
}

}  // namespace texbrdf
