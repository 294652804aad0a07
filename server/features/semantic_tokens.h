#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "analysis/snapshot.h"

namespace texbrdf::features {

/// From semantic_tokens.def; the values are indices into the legend.
enum class SemanticType : uint8_t {
#define SEMANTIC_TYPE(name, text) name,
#include "features/semantic_tokens.def"
#undef SEMANTIC_TYPE
};

enum class SemanticModifier : uint8_t {
#define SEMANTIC_MODIFIER(name, text) name,
#include "features/semantic_tokens.def"
#undef SEMANTIC_MODIFIER
};

std::span<const std::string_view> semantic_type_names();
std::span<const std::string_view> semantic_modifier_names();

struct SemanticToken {
  Span span;
  SemanticType type = SemanticType::Variable;
  uint32_t modifiers = 0;  ///< a bit for each SemanticModifier
  friend bool operator==(const SemanticToken&, const SemanticToken&) = default;
};

/// All that the tokens of a block depend on outside of it: which names of the convention the document defines.
/// So a block's tokens can be kept as long as its parse and this stay.
class HiddenConventions {
 public:
  explicit HiddenConventions(const Snapshot& snapshot);
  /// Of a name that is a convention, or usually means one.
  bool contains(NameId name) const { return std::ranges::binary_search(defined_, name); }
  friend bool operator==(const HiddenConventions&, const HiddenConventions&) = default;

 private:
  std::vector<NameId> defined_;  ///< in order
};

/// In the order of the text, spans relative to the block as it is written. Names, numbers, operators and commands
/// inside the block; a name is one token with its decoration and subscripts. Names keep their kinds while the block has
/// errors.
std::vector<SemanticToken> block_tokens(const Snapshot& snapshot, BlockId block, const HiddenConventions& hidden);

/// Tokens that the range holds or touches, with absolute spans.
std::vector<SemanticToken> semantic_tokens(const Snapshot& snapshot, Span range);

}  // namespace texbrdf::features
