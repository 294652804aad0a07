#pragma once

#include <cstdint>
#include <vector>

#include "semantics/conventions.h"
#include "semantics/names.h"
#include "semantics/small_name_map.h"
#include "semantics/types.h"
#include "syntax/parsed_block.h"

namespace texbrdf {

/// All that a definition may know of the rest of the document: what a name is, or that it is absent.
/// Facts asked and their answers are the cache key of a checked definition.
struct NameFact {
  enum class Kind : uint8_t { Absent, Defined };
  Kind kind = Kind::Absent;
  Signature signature;  ///< of the first definition; Type::Error where an error leaves a type unknown
  friend bool operator==(const NameFact&, const NameFact&) = default;
};

class Facts {
 public:
  virtual ~Facts() = default;
  /// The definition of the document that is in force for the name. Conventions are not facts.
  virtual const NameFact& fact(NameId name) const = 0;
};

/// What a Name node refers to.
struct Referent {
  enum class Kind : uint8_t { None, Definition, Convention, Parameter, Angle };
  Kind kind = Kind::None;
  uint32_t index = 0;  ///< NameId::value, Convention, the parameter's position, or see `angle_of_parameter`
  friend bool operator==(const Referent&, const Referent&) = default;
};

/// The angle of a direction that is a parameter: `\theta_m` in `D(\vec{m})`.
struct ParameterAngle {
  Convention kind = Convention::ThetaI;  ///< ThetaI or PhiI, made of the parameter instead of \omega_i
  uint32_t position = 0;
};
constexpr Referent angle_referent(ParameterAngle angle) {
  return {Referent::Kind::Angle, angle.position * 2 + (angle.kind == Convention::PhiI ? 1 : 0)};
}
constexpr ParameterAngle angle_of_parameter(Referent referent) {
  return {referent.index % 2 == 1 ? Convention::PhiI : Convention::ThetaI, referent.index / 2};
}

/// One parameter of a function, in order.
struct CheckedParameter {
  NodeId node;  ///< its Name node on the left side
  NameId name;
  Type type = Type::Error;
  bool inferred = false;             ///< decided by the body, not by \vec or its name
  std::vector<Convention> shadowed;  ///< conventions whose spelling it has: these follow it inside the body
};

/// A definition with types. Everything by node is in side tables indexed by NodeId::value - syntax.first_node.
struct CheckedDefinition {
  NameId name;
  Signature signature;
  std::vector<CheckedParameter> parameters;
  std::vector<Type> types;
  std::vector<Referent> referents;
  std::vector<NodeId> spread_arguments;  ///< colours for real parameters (Signature::spreads), in order
  std::vector<Diagnostic> diagnostics;   ///< spans relative to the block, Location::block not set
  /// Nothing in the definition is in error, and all its types are known: it can be lowered. What it uses may be in
  /// error.
  bool sound = false;
};

/// The most reports of one definition; a document where everything is wrong must not fill the memory.
inline constexpr uint32_t kMaxReports = 1000;

/// Checks one definition against facts. Pure; never fails. Names that are absent and no convention are reported as
/// undefined (the nearest name is added when a Snapshot is read, because it depends on the whole document).
CheckedDefinition check_definition(const ParsedBlock& block, const DefinitionSyntax& definition,
                                   const BlockNames& names, const NameTable& table, const Facts& facts);

/// The names that the definition's body mentions and that its parameters do not hide, each once, in order.
/// Cheaper than checking: it gives the order in which to check.
SmallNameMap mentioned_names(const ParsedBlock& block, const DefinitionSyntax& definition, const BlockNames& names);

}  // namespace texbrdf
