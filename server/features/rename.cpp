#include "features/rename.h"

#include <fmt/format.h>

#include <algorithm>
#include <span>
#include <utility>

#include "analysis/document.h"
#include "features/new_name.h"
#include "features/places.h"
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

/// Why the name keeps its name whatever the new one; empty where it need not.
std::string refusal(const Snapshot& snapshot, const Occurrence& occurrence) {
  const std::string name = text_of(snapshot, occurrence.name);
  switch (occurrence.referent.kind) {
    case Referent::Kind::Angle:
      return fmt::format("`{}` is named after a parameter and keeps its name", name);
    case Referent::Kind::Convention:
      return fmt::format("`{}` is a convention of the language and keeps its name", name);
    case Referent::Kind::None:
      return fmt::format("nothing in this document defines `{}`", name);
    case Referent::Kind::Definition:
    case Referent::Kind::Parameter:
      break;
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
    result.push_back({place.span, spelled_in_place(block, place.node, name)});
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
  Document document(applied(snapshot.text(FileId{0}), by_file.front()));
  for (uint32_t file = 1; file < by_file.size(); ++file) {
    document.insert_file({file}, SourceText(applied(snapshot.text(FileId{file}), by_file[file])));
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
  if (!occurrence) return std::optional<RenameTarget>{};
  if (std::string reason = refusal(snapshot, *occurrence); !reason.empty()) return Failure{std::move(reason)};
  return std::optional(RenameTarget{occurrence->span, snapshot.text().slice(occurrence->span)});
}

Result<std::vector<TextEdit>> rename(const Snapshot& snapshot, uint32_t offset, std::string_view new_name) {
  const auto occurrence = name_at(snapshot, offset);
  if (!occurrence) return Failure{"no name stands here"};
  if (std::string reason = refusal(snapshot, *occurrence); !reason.empty()) return Failure{std::move(reason)};
  const Result<NewName> read = read_new_name(new_name);
  if (!read) return Failure{read.error()};
  const NameId new_id = snapshot.names().find(read->canonical);
  const bool is_same_name = new_id == occurrence->name;
  const Conflicts conflicts(snapshot, *occurrence, *read, new_id);
  const std::vector<Occurrence> places = snapshot.occurrences_of(*occurrence);
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
