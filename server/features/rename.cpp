#include "features/rename.h"

#include <fmt/format.h>

#include <algorithm>
#include <span>
#include <utility>

#include "analysis/document.h"
#include "features/new_name.h"
#include "features/places.h"
#include "features/rename_macro.h"
#include "features/rename_spelling.h"

namespace texbrdf::features {
namespace {

std::string text_of(const Snapshot& snapshot, NameId name) {
  return shown_name(snapshot.names().text(name));
}

Occurrence occurrence_in(const RootDirective& directive, const Snapshot& snapshot, DefinitionId meant) {
  const Definition definition = snapshot.definition(meant);
  return {.span = directive.span,
          .node = snapshot.syntax(meant).name,
          .block = definition.block,
          .name = definition.name,
          .inside = meant,
          .referent = {Referent::Kind::Definition, definition.name.value},
          .target = meant,
          .is_definition = true};
}

/// The name at the offset, which may also be that of the root in an instruction.
std::optional<Occurrence> name_at(const Snapshot& snapshot, uint32_t offset) {
  if (const auto occurrence = snapshot.occurrence_at(offset)) return occurrence;
  for (const RootDirective& directive : snapshot.root_directives()) {
    if (offset < directive.span.begin || offset > directive.span.end) continue;
    const auto definition = snapshot.find(directive.name);
    if (!definition) return std::nullopt;
    return occurrence_in(directive, snapshot, *definition);
  }
  return std::nullopt;
}

/// `a_1` is found by `a_k`, and f by `f'`: neither would follow another name.
std::string refusal_of_family(const Snapshot& snapshot, NameId name) {
  for (const Definition& definition : snapshot.all_definitions()) {
    const auto stands_for_it = [&](const Referent& referent) {
      if (referent.kind == Referent::Kind::Derivative) return referent.index == name.value;
      if (referent.kind != Referent::Kind::Indexed) return false;
      return std::ranges::count(definition.checked->indexed[referent.index].names, name) > 0;
    };
    if (!std::ranges::any_of(definition.checked->referents, stands_for_it)) continue;
    return fmt::format("`{}` is found by its index or derivative in `{}` and keeps its name", text_of(snapshot, name),
                       text_of(snapshot, definition.name));
  }
  return {};
}

/// `\theta_m` and `m_x` would not follow another name of the vector m.
std::string refusal_of_vector(const Snapshot& snapshot, NameId name) {
  const Referent vector{Referent::Kind::Definition, name.value};
  for (const Definition& definition : snapshot.all_definitions()) {
    const auto is_named_after_it = [&](const DerivedNumber& number) { return number.vector.referent == vector; };
    if (!std::ranges::any_of(definition.checked->derived, is_named_after_it)) continue;
    return fmt::format("in `{}`, an angle or a component is named after `{}`", text_of(snapshot, definition.name),
                       text_of(snapshot, name));
  }
  return {};
}

bool takes_argument(const Definition& definition, const Referent& argument) {
  return std::ranges::any_of(definition.checked->implied_calls, [&](const ImpliedCall& call) {
    return std::ranges::count(call.arguments, argument, &TypedReferent::referent) > 0;
  });
}

bool calls_without_arguments(const Snapshot& snapshot, const Definition& definition, NameId function) {
  const uint32_t first = snapshot.parsed(definition.block).definitions[definition.index_in_block].first_node;
  const Referent meant{Referent::Kind::Definition, function.value};
  return std::ranges::any_of(definition.checked->implied_calls, [&](const ImpliedCall& call) {
    return definition.checked->referents[call.node.value - first] == meant;
  });
}

/// A function without arguments takes what its parameters are called, and so does the BRDF.
std::string refusal_of_argument(const Snapshot& snapshot, const Occurrence& occurrence) {
  const bool is_parameter = occurrence.referent.kind == Referent::Kind::Parameter;
  const NameId function = is_parameter ? snapshot.definition(occurrence.inside).name : NameId{};
  for (const Definition& definition : snapshot.all_definitions()) {
    const bool takes_it = is_parameter ? calls_without_arguments(snapshot, definition, function)
                                       : takes_argument(definition, occurrence.referent);
    if (!takes_it) continue;
    return fmt::format("a function stands without arguments in `{}` and takes `{}` by its name",
                       text_of(snapshot, definition.name), text_of(snapshot, occurrence.name));
  }
  const std::optional<DefinitionId> root = snapshot.find(snapshot.root_name());
  if (!root) return {};
  const Definition brdf = snapshot.definition(*root);
  const auto is_it = [&](const CheckedParameter& parameter) { return parameter.name == occurrence.name; };
  const bool is_given_by_name =
      !has_brdf_parameters(brdf.checked->signature) && (!is_parameter || brdf.name == function);
  if (!is_given_by_name || !std::ranges::any_of(brdf.checked->parameters, is_it)) return {};
  return fmt::format("`{}` is given what its parameters are called", text_of(snapshot, brdf.name));
}

/// Why the name keeps its name whatever the new one; empty where it need not.
std::string refusal(const Snapshot& snapshot, const Occurrence& occurrence) {
  const std::string name = text_of(snapshot, occurrence.name);
  switch (occurrence.referent.kind) {
    case Referent::Kind::Bound:
      return fmt::format("`{}` is the variable of a sum, integral or derivative and keeps its name", name);
    case Referent::Kind::Transposition:
      return fmt::format("`{}` is the sign of a transposition", name);
    case Referent::Kind::Indexed:
    case Referent::Kind::Derivative:
      return fmt::format("`{}` stands for other names and keeps its own", name);
    case Referent::Kind::BoundAngle:
    case Referent::Kind::Angle:
      return fmt::format("`{}` is named after a parameter and keeps its name", name);
    case Referent::Kind::Convention:
      return fmt::format("`{}` is a convention of the language and keeps its name", name);
    case Referent::Kind::Derived:
      return fmt::format("`{}` is named after a vector and keeps its name", name);
    case Referent::Kind::Builtin:
      return fmt::format("`{}` is a function of the language and keeps its name", name);
    case Referent::Kind::None:
      return fmt::format("nothing in this document defines `{}`", name);
    case Referent::Kind::Definition: {
      std::string reason = refusal_of_family(snapshot, occurrence.name);
      if (reason.empty()) reason = refusal_of_vector(snapshot, occurrence.name);
      return reason.empty() ? refusal_of_argument(snapshot, occurrence) : reason;
    }
    case Referent::Kind::Parameter:
      return refusal_of_argument(snapshot, occurrence);
  }
  return {};
}

/// What would become another thing under the new name.
class Conflicts {
 public:
  /// An invalid `new_id` is of a name that stands nowhere in the document.
  Conflicts(const Snapshot& snapshot, const Occurrence& renamed, const NewName& new_name, NameId new_id)
      : snapshot_(snapshot), renamed_(renamed), new_(new_name), new_id_(new_id) {}

  /// The first one, told to a person; empty where there is none.
  std::string of_definition(std::span<const Occurrence> places) const {
    if (!new_id_.valid()) return {};
    if (const auto other = snapshot_.find(new_id_)) {
      return fmt::format("`{}` is defined already, on {}", new_.canonical, line(name_span(snapshot_, *other)));
    }
    for (const Occurrence& place : places) {
      if (place.is_definition || !has_parameter(place.inside)) continue;
      return fmt::format("on {} the parameter `{}` of `{}` would hide it", line(place.span), new_.canonical,
                         function_name(place.inside));
    }
    Occurrence undefined;
    undefined.name = new_id_;
    const std::vector<Occurrence> uses = snapshot_.occurrences_of(undefined);
    return uses.empty() ? std::string() : meant_then(uses.front().span);
  }

  std::string of_root() const {
    const std::vector<RootDirective> directives = snapshot_.root_directives();
    const auto named = std::ranges::find(directives, new_.canonical, &RootDirective::name);
    return named == directives.end() ? std::string() : meant_then(named->span);
  }

  std::string of_parameter() const {
    const Definition& function = snapshot_.definition(renamed_.inside);
    const CheckedDefinition& checked = *function.checked;
    const CheckedParameter& parameter = checked.parameters[renamed_.referent.index];
    const std::string of = function_name(renamed_.inside);
    if (has_parameter(renamed_.inside)) return fmt::format("`{}` has another parameter `{}`", of, new_.canonical);
    if (new_id_.valid() && mentions(function, new_id_)) {
      return fmt::format("`{}` is used in `{}`, where the parameter would hide it", new_.canonical, of);
    }
    for (const Referent& referent : checked.referents) {
      const bool is_its_angle =
          referent.kind == Referent::Kind::Angle && angle_of_parameter(referent).position == renamed_.referent.index;
      if (is_its_angle) {
        return fmt::format("in `{}`, an angle is named after `{}`", of, text_of(snapshot_, renamed_.name));
      }
      if (referent.kind != Referent::Kind::Convention) continue;
      const auto convention = static_cast<Convention>(referent.index);
      if (!depends_on(convention, parameter.shadowed)) continue;
      return fmt::format("in `{}`, `{}` follows `{}` because of its name", of,
                         convention_entry(convention).spellings.front(), text_of(snapshot_, renamed_.name));
    }
    return of_type(parameter);
  }

 private:
  bool mentions(const Definition& definition, NameId name) const {
    const ParsedBlock& parsed = snapshot_.parsed(definition.block);
    const DefinitionSyntax& syntax = parsed.definitions[definition.index_in_block];
    return mentioned_names(parsed, syntax, snapshot_.names_of(definition.block)).find(name).has_value();
  }

  /// The spelling of a parameter says whether it is a vector, or that its uses say so.
  std::string of_type(const CheckedParameter& parameter) const {
    const bool was_spelled = snapshot_.names().traits(parameter.name).is_vector;
    if (was_spelled && !new_.traits.is_vector) {
      return fmt::format("`{}` is a vector because of how it is written, `{}` need not be one",
                         text_of(snapshot_, parameter.name), new_.canonical);
    }
    if (!was_spelled && new_.traits.is_vector && !is_triple(parameter.type)) {
      return fmt::format("`{}` is no vector, `{}` would be one", text_of(snapshot_, parameter.name), new_.canonical);
    }
    return {};
  }

  bool has_parameter(DefinitionId function) const {
    if (!new_id_.valid()) return false;
    const Definition& definition = snapshot_.definition(function);
    return std::ranges::find(definition.checked->parameters, new_id_, &CheckedParameter::name) !=
           definition.checked->parameters.end();
  }
  std::string meant_then(Span place) const {
    return fmt::format("`{}` stands on {}, and would then mean this", new_.canonical, line(place));
  }
  std::string function_name(DefinitionId id) const { return text_of(snapshot_, snapshot_.definition(id).name); }
  std::string line(Span span) const { return line_name(snapshot_, span.begin); }

  const Snapshot& snapshot_;
  const Occurrence& renamed_;
  const NewName& new_;
  NameId new_id_;
};

std::vector<TextEdit> edits_in_equations(const Snapshot& snapshot, std::span<const Occurrence> places,
                                         std::string_view name) {
  std::vector<TextEdit> result;
  result.reserve(places.size());
  for (const Occurrence& place : places) {
    const ParsedBlock& block = snapshot.parsed(place.block);
    if (block.node_text(place.node) == name) continue;
    std::string spelled = spelled_in_place(block, place.node, name);
    // A macro's argument without braces is one symbol.
    if (!block.is_replaceable(block.span(place.node))) spelled = fmt::format("{{{}}}", name);
    result.push_back({place.span, std::move(spelled)});
  }
  return result;
}

/// In document order.
void sort_by_place(const Snapshot& snapshot, std::vector<TextEdit>& edits) {
  std::ranges::sort(edits, {}, [&](const TextEdit& edit) {
    const FilePlace place = snapshot.place(edit.span);
    return std::pair(place.file, place.span.begin);
  });
}

std::vector<TextEdit> edits_of_definition(const Snapshot& snapshot, std::span<const Occurrence> places,
                                          std::string_view old_name, std::string_view name) {
  std::vector<TextEdit> result = edits_in_equations(snapshot, places, name);
  const std::size_t in_equations = result.size();
  for (const RootDirective& directive : snapshot.root_directives()) {
    const FilePlace place = snapshot.place(directive.span);
    if (directive.name != old_name || snapshot.text(place.file).slice(place.span) == name) continue;
    result.push_back({directive.span, std::string(name)});
  }
  if (result.size() > in_equations) sort_by_place(snapshot, result);
  return result;
}

/// Names of which one may be the BRDF's because of how it is spelled.
bool is_root_spelling(std::string_view canonical) {
  return canonical == "f" || canonical.starts_with("f_");
}

std::string applied(const SourceText& text, std::span<const TextEdit> edits) {
  std::string result;
  uint32_t end = 0;
  for (const TextEdit& edit : edits) {
    result += text.slice({end, edit.span.begin});
    result += edit.text;
    end = edit.span.end;
  }
  return result += text.slice({end, text.size()});
}

/// The project as it would be.
Document edited(const Snapshot& snapshot, std::span<const TextEdit> edits) {
  std::vector<std::vector<TextEdit>> by_file(snapshot.file_count());
  for (const TextEdit& edit : edits) {
    const FilePlace place = snapshot.place(edit.span);
    by_file[place.file.value].push_back({place.span, edit.text});
  }
  Document document(applied(snapshot.text(FileId{0}), by_file.front()), snapshot.language(FileId{0}));
  for (uint32_t file = 1; file < by_file.size(); ++file) {
    document.insert_file({file}, SourceText(applied(snapshot.text(FileId{file}), by_file[file])),
                         snapshot.language(FileId{file}));
  }
  return document;
}

/// Which definition is the BRDF depends on names and on what uses what. Told to a person where the new name would make
/// another one of it; only names that can matter cost a look at the document as it would be.
std::string root_conflict(const Snapshot& snapshot, std::string_view old_name, std::string_view new_name,
                          std::span<const TextEdit> edits) {
  const std::string root = snapshot.root_name();
  const bool is_root = old_name == root;
  if (!is_root && !is_root_spelling(old_name) && !is_root_spelling(new_name)) return {};
  Document renamed = edited(snapshot, edits);
  if (renamed.snapshot().root_name() == (is_root ? new_name : root)) return {};
  if (is_root) return fmt::format("`{}` is the BRDF because of its name, `{}` would not be", old_name, new_name);
  return fmt::format("`{}` would no longer be the BRDF", root);
}

}  // namespace

Result<std::optional<RenameTarget>> renamable_at(const Snapshot& snapshot, uint32_t offset) {
  const auto occurrence = name_at(snapshot, offset);
  if (!occurrence) return renamable_macro_at(snapshot, offset);
  if (std::string reason = refusal(snapshot, *occurrence); !reason.empty()) return Failure{std::move(reason)};
  return std::optional(RenameTarget{occurrence->span, snapshot.text().slice(occurrence->span)});
}

Result<std::vector<TextEdit>> rename(const Snapshot& snapshot, uint32_t offset, std::string_view new_name) {
  const auto occurrence = name_at(snapshot, offset);
  if (!occurrence) return rename_macro(snapshot, offset, new_name);
  if (std::string reason = refusal(snapshot, *occurrence); !reason.empty()) return Failure{std::move(reason)};
  const Result<NewName> read = read_new_name(new_name);
  if (!read) return Failure{read.error()};
  const NameId new_id = snapshot.names().find(read->canonical);
  const bool is_same_name = new_id == occurrence->name;
  const Conflicts conflicts(snapshot, *occurrence, *read, new_id);
  const std::vector<Occurrence> places = snapshot.occurrences_of(*occurrence);
  if (const auto made = std::ranges::find_if(places, &Occurrence::is_made); made != places.end()) {
    return Failure{fmt::format("a macro writes `{}` on {}", text_of(snapshot, occurrence->name),
                               line_name(snapshot, made->span.begin))};
  }
  if (occurrence->referent.kind == Referent::Kind::Parameter) {
    if (std::string conflict = is_same_name ? "" : conflicts.of_parameter(); !conflict.empty()) {
      return Failure{std::move(conflict)};
    }
    return edits_in_equations(snapshot, places, read->text);
  }
  const std::string_view old_name = snapshot.names().text(occurrence->name);
  std::vector<TextEdit> edits = edits_of_definition(snapshot, places, old_name, read->text);
  if (is_same_name) return edits;
  std::string conflict = conflicts.of_definition(places);
  if (conflict.empty()) conflict = conflicts.of_root();
  if (conflict.empty()) conflict = root_conflict(snapshot, old_name, read->canonical, edits);
  if (!conflict.empty()) return Failure{std::move(conflict)};
  return edits;
}

}  // namespace texbrdf::features
