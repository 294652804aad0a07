#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "semantics/conventions.h"
#include "semantics/instance.h"
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
  Signature signature;             ///< of the first definition; Type::Error where an error leaves a type unknown
  std::vector<NameId> parameters;  ///< what a function calls its parameters; invalid where that is no name
  bool is_parameter = false;       ///< of an absent name: a function of the document calls a parameter so
  friend bool operator==(const NameFact&, const NameFact&) = default;
};

/// What a function's body makes of parameters of certain types.
struct InstanceFact {
  enum class Kind : uint8_t { Misfit, TooLarge, Fits };
  Kind kind = Kind::Misfit;
  Type result = Type::Error;
  uint32_t size = 1;  ///< how many bodies had to be checked: its own, and those of the instances that it calls
  friend bool operator==(const InstanceFact&, const InstanceFact&) = default;
};

class Facts {
 public:
  virtual ~Facts() = default;
  /// The definition of the document that is in force for the name. Conventions are not facts.
  virtual const NameFact& fact(NameId name) const = 0;
  /// Of a function in force: its body, checked as if it had been written for these types.
  virtual InstanceFact instance(const Instance& instance) const = 0;
};

/// What a Name node refers to; and, as Parameter, an expression that a left side has as a parameter.
struct Referent {
  /// Bound, BoundAngle: as Parameter and Angle, of a binder; Indexed: several definitions, by the value of an index;
  /// Derivative: of the function that the index names; Derived: a place in CheckedDefinition::derived; Transposition:
  /// nothing, it is a sign in an exponent.
  enum class Kind : uint8_t {
    None,
    Definition,
    Convention,
    Parameter,
    Angle,
    Builtin,
    Derived,
    Bound,
    BoundAngle,
    Indexed,
    Derivative,
    Transposition
  };
  Kind kind = Kind::None;
  uint32_t index = 0;  ///< NameId::value, Convention, Builtin, a position, or see `angle_of_parameter`
  friend bool operator==(const Referent&, const Referent&) = default;
};

/// The angle of a direction that is a parameter: `\theta_m` in `D(\vec{m})`.
struct ParameterAngle {
  Convention kind = Convention::ThetaI;  ///< ThetaI or PhiI, made of the parameter instead of \omega_i
  uint32_t position = 0;
};
constexpr Referent angle_referent(ParameterAngle angle, Referent::Kind kind = Referent::Kind::Angle) {
  return {kind, angle.position * 2 + (angle.kind == Convention::PhiI ? 1 : 0)};
}
constexpr ParameterAngle angle_of_parameter(Referent referent) {
  return {referent.index % 2 == 1 ? Convention::PhiI : Convention::ThetaI, referent.index / 2};
}

/// What a name refers to, with its type.
struct TypedReferent {
  Referent referent;
  Type type = Type::Error;
  bool is_function = false;
};

/// A number that a name says of a vector: the component `h_x`, or the angle `\theta_m` of a vector of the document; of
/// what has entries an entry, `m_y` or `M_{12}`; and `x_+`, what is positive of a number or colour.
struct DerivedNumber {
  enum class Kind : uint8_t { PolarAngle, Azimuth, Component, Entry, PositivePart };
  Kind kind = Kind::Component;
  uint32_t axis = 0;  ///< of a component: 0 tangent, 1 bitangent, 2 normal; of an entry: counted row by row
  TypedReferent vector;
};

/// A function without arguments: it takes what its parameters are called.
struct ImpliedCall {
  NodeId node;  ///< the Name
  std::vector<TypedReferent> arguments;
  Type result = Type::Error;  ///< of the function
  uint64_t spread = 0;        ///< by position, one bit each: colours for real parameters (Signature::spreads)
};

/// A call whose arguments the function does not take by itself.
struct InstanceCall {
  NodeId callee;  ///< the Name
  Instance instance;
  Type result = Type::Error;
};

/// One parameter of a function, in order.
struct CheckedParameter {
  NodeId node;                       ///< its Name node on the left side, or the expression that it is written as; of
                                     ///< an implied one the first Name that needs it
  NodeId given;                      ///< what the argument is: the Name node, `\cos\theta`, or the expression
  NameId name;                       ///< invalid where it is an expression that gives no name a value
  Command function = Command::None;  ///< of `\cos\theta`: the argument is that function's value
  Type type = Type::Error;
  bool inferred = false;             ///< decided by the body, not by \vec or its name
  std::vector<Convention> shadowed;  ///< conventions whose spelling it has: these follow it inside the body
};

/// What a binder of the definition binds.
struct BoundName {
  NodeId node;              ///< the binder
  NodeId variable;          ///< its Name node
  uint32_t first_node = 0;  ///< of the body that it is bound in
  Type type = Type::Real;
  bool is_written_out = false;       ///< term by term, for `indices`
  std::vector<int> indices;          ///< as in Binder, those for which the document has all names
  bool is_open = false;              ///< as in Binder
  std::vector<Convention> shadowed;  ///< conventions that follow it
};

/// What a Name with an index stands for.
struct IndexedName {
  std::vector<uint32_t> bound;  ///< positions in CheckedDefinition::bound, outermost first
  std::vector<size_t> counts;   ///< of each, how many indices there are names for
  std::vector<NameId> names;    ///< by index, that of the last fastest
  Signature signature;          ///< of all of them
};

/// A definition with types. Everything by node is in side tables indexed by NodeId::value - syntax.first_node.
struct CheckedDefinition {
  NameId name;
  Signature signature;
  std::vector<CheckedParameter> parameters;
  std::vector<Type> types;
  std::vector<Referent> referents;
  std::vector<DerivedNumber> derived;
  std::vector<ImpliedCall> implied_calls;    ///< in order of their nodes
  std::vector<InstanceCall> instance_calls;  ///< in order of their nodes
  std::vector<BoundName> bound;              ///< by binder, in order of nodes
  std::vector<IndexedName> indexed;
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

/// The same for a function with parameters of exactly these types, one for each: sound where its body fits them.
CheckedDefinition check_instance(const ParsedBlock& block, const DefinitionSyntax& definition, const BlockNames& names,
                                 const NameTable& table, const Facts& facts, std::span<const Type> parameters);

/// The names that the definition's body mentions and that its parameters do not hide, each once, in order.
/// Cheaper than checking: it gives the order in which to check.
SmallNameMap mentioned_names(const ParsedBlock& block, const DefinitionSyntax& definition, const BlockNames& names);

}  // namespace texbrdf
