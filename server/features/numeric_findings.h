#pragma once

#include <memory>
#include <optional>
#include <stop_token>
#include <string_view>
#include <vector>

#include "analysis/snapshot.h"

namespace texbrdf::features {

/// What there is to find out about a document by computing; in an order that depends on its names alone.
struct NumericQuestions {
  /// A further right side of a chain `a = b = c`: is it what the first one is?
  struct Chain {
    NameId name;
    NodeId body;
    friend bool operator==(const Chain&, const Chain&) = default;
  };
  std::vector<Chain> chains;
  std::vector<NameId> conventions;  ///< that the document defines: as what they are?
  NameId integrated;                ///< the BRDF, where integrals may make it inexact; else invalid

  bool empty() const { return chains.empty() && conventions.empty() && !integrated.valid(); }
  friend bool operator==(const NumericQuestions&, const NumericQuestions&) = default;
};

/// Nothing that `% texbrdf: allow` silences is asked. `root`: as for Snapshot::diagnostics.
NumericQuestions numeric_questions(const Snapshot& snapshot, std::string_view root = {});

/// The name whose definition the diagnostic says to hide a convention; invalid where it says something else.
NameId redefined_convention(const Snapshot& snapshot, const Diagnostic& diagnostic);

/// The answers, and all definitions that they depend on: they hold for a later snapshot that has the same.
struct NumericFindings {
  /// A diagnostic about a name, placed in the block of its definition whatever that block's number may be.
  struct Finding {
    NameId about;
    Diagnostic diagnostic;
  };
  struct Dependency {
    NameId name;
    std::shared_ptr<const CheckedDefinition> definition;  ///< nullptr where nothing defined it
  };
  NumericQuestions questions;
  std::vector<Dependency> dependencies;
  std::vector<Finding> findings;
  std::vector<NameId> usual;  ///< conventions that are defined as what they are

  /// Nothing is told that would not be told without them.
  bool is_silent() const { return findings.empty() && usual.size() == questions.conventions.size(); }
  bool hold_for(const Snapshot& snapshot, const NumericQuestions& asked) const;
};

/// Takes up to some 50 ms, and ends soon when it is stopped, with nothing. Deterministic. Of what would take longer
/// nothing is said.
std::optional<NumericFindings> find_numerically(const Snapshot& snapshot, NumericQuestions questions,
                                                const std::stop_token& stop = {});

}  // namespace texbrdf::features
