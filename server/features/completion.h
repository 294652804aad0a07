#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/snapshot.h"
#include "features/describe.h"
#include "features/name_index.h"

namespace texbrdf::features {

/// What is proposed; in this order where nothing else decides.
enum class CompletionKind : uint8_t { Parameter, Definition, Macro, Convention, Builtin, Command, Letter };

/// How well the type of a proposal suits its place.
enum class Fit : uint8_t { Good, Unknown, Bad };

struct CompletionItem {
  CompletionKind kind = CompletionKind::Definition;
  Fit fit = Fit::Good;
  bool is_function = false;
  bool is_snippet = false;
  std::string label;
  std::string detail;    ///< its type, of a macro what it stands for; empty where it has none
  std::string new_text;  ///< in place of Completions::replaced
  std::string filter;    ///< what has to match what is typed; empty: the label
};

struct Completions {
  bool in_math = false;               ///< false: the place is none of ours
  bool complete = true;               ///< false: more would be found if more were typed
  Span replaced;                      ///< absolute, on one line
  std::string function;               ///< in which the parameters stand; empty where there are none
  std::vector<CompletionItem> items;  ///< the best first
};

struct CompletionOptions {
  bool snippets = false;
};

/// No more definitions are proposed at once.
inline constexpr std::size_t kMostCompletions = 100;

/// The names in scope and the commands that somebody may go on to type at the offset.
Completions complete(const Snapshot& snapshot, uint32_t offset, NameIndex& index, const CompletionOptions& options);

/// The documentation of a proposal; empty where nothing is known of it any more.
std::string describe_completion(const Snapshot& snapshot, CompletionKind kind, std::string_view label,
                                std::string_view function, Markup markup);

}  // namespace texbrdf::features
