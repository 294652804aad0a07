#include "lsp/read_params.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <utility>

namespace texbrdf::lsp {
namespace {

using nlohmann::json;

/// The protocol's integers are 32 bits wide; what is beyond is read as the largest.
constexpr int64_t kMaxInteger = INT32_MAX;

/// Reads members and remembers the first that is missing or of the wrong kind. Members of nothing read as defaults,
/// so that callers need no checks in between.
class Reader {
 public:
  const std::string& problem() const { return problem_; }

  json* object(json* parent, const char* name) {
    return required(parent, name, "an object", [](const json& v) { return v.is_object(); });
  }
  json* array(json* parent, const char* name) {
    return required(parent, name, "an array", [](const json& v) { return v.is_array(); });
  }
  std::string string(json* parent, const char* name) {
    json* value = required(parent, name, "a string", [](const json& v) { return v.is_string(); });
    return value == nullptr ? std::string{} : std::move(value->get_ref<std::string&>());
  }
  bool boolean(json* parent, const char* name) {
    const json* value = required(parent, name, "a boolean", [](const json& v) { return v.is_boolean(); });
    return value != nullptr && value->get<bool>();
  }
  int64_t integer(json* parent, const char* name) {
    const json* value = required(parent, name, "an integer", is_integral);
    return value == nullptr ? 0 : integer_of(*value);
  }
  uint32_t natural(json* parent, const char* name) {
    const json* value =
        required(parent, name, "a natural number", [](const json& v) { return is_integral(v) && integer_of(v) >= 0; });
    return value == nullptr ? 0 : static_cast<uint32_t>(integer_of(*value));
  }
  Position position(json* parent, const char* name) {
    json* value = object(parent, name);
    return {natural(value, "line"), natural(value, "character")};
  }
  Range range(json* value) { return {position(value, "start"), position(value, "end")}; }

  /// The member, or nullptr where it is absent or null.
  static json* optional(json* parent, const char* name) {
    if (parent == nullptr || !parent->is_object()) return nullptr;
    const auto found = parent->find(name);
    return found == parent->end() || found->is_null() ? nullptr : &*found;
  }

  void fail(std::string problem) {
    if (problem_.empty()) problem_ = std::move(problem);
  }

 private:
  template <typename Predicate>
  json* required(json* parent, const char* name, const char* kind, Predicate fits) {
    if (parent == nullptr) return nullptr;
    json* value = optional(parent, name);
    if (value != nullptr && fits(*value)) return value;
    fail(fmt::format("`{}` has to be {}", name, kind));
    return nullptr;
  }
  /// Also 3.0, which some JSON libraries make of 3.
  static bool is_integral(const json& value) {
    if (!value.is_number_float()) return value.is_number_integer();
    const double number = value.get<double>();
    return number >= INT32_MIN && number <= INT32_MAX && number == static_cast<double>(static_cast<int64_t>(number));
  }
  static int64_t integer_of(const json& value) {
    if (value.is_number_unsigned()) {
      return static_cast<int64_t>(std::min<uint64_t>(value.get<uint64_t>(), kMaxInteger));
    }
    return std::clamp<int64_t>(value.get<int64_t>(), -kMaxInteger, kMaxInteger);
  }

  std::string problem_;
};

json* object_of(Reader& reader, json& params) {
  if (params.is_object()) return &params;
  reader.fail("`params` has to be an object");
  return nullptr;
}

std::string document_uri(Reader& reader, json* params) {
  return reader.string(reader.object(params, "textDocument"), "uri");
}

std::vector<std::string> strings(json* array) {
  std::vector<std::string> result;
  if (array == nullptr || !array->is_array()) return result;
  for (const json& element : *array) {
    if (element.is_string()) result.push_back(element.get<std::string>());
  }
  return result;
}

bool flag(json* parent, const char* name) {
  const json* value = Reader::optional(parent, name);
  return value != nullptr && value->is_boolean() && value->get<bool>();
}

std::string text_or_empty(json* parent, const char* name) {
  const json* value = Reader::optional(parent, name);
  return value != nullptr && value->is_string() ? value->get<std::string>() : std::string{};
}

}  // namespace

std::string read_params(json&, NoParams&) {
  return {};
}

/// What a client says of itself is taken as far as it is understood: odd capabilities are no reason to refuse it.
std::string read_params(json& params, InitializeParams& out) {
  Reader reader;
  json* object = object_of(reader, params);
  if (Reader::optional(object, "processId") != nullptr) out.process_id = reader.integer(object, "processId");
  json* client = Reader::optional(object, "clientInfo");
  out.client_name = text_or_empty(client, "name");
  out.client_version = text_or_empty(client, "version");

  json* capabilities = Reader::optional(object, "capabilities");
  json* documents = Reader::optional(capabilities, "textDocument");
  json* published = Reader::optional(documents, "publishDiagnostics");
  out.position_encodings = strings(Reader::optional(Reader::optional(capabilities, "general"), "positionEncodings"));
  out.hover_formats = strings(Reader::optional(Reader::optional(documents, "hover"), "contentFormat"));
  out.definition_links = flag(Reader::optional(documents, "definition"), "linkSupport");
  out.hierarchical_symbols = flag(Reader::optional(documents, "documentSymbol"), "hierarchicalDocumentSymbolSupport");
  out.related_information = flag(published, "relatedInformation");
  out.code_description = flag(published, "codeDescriptionSupport");
  return reader.problem();
}

std::string read_params(json& params, DidOpenParams& out) {
  Reader reader;
  json* document = reader.object(object_of(reader, params), "textDocument");
  out.uri = reader.string(document, "uri");
  out.language_id = text_or_empty(document, "languageId");
  out.version = reader.integer(document, "version");
  out.text = reader.string(document, "text");
  return reader.problem();
}

std::string read_params(json& params, DidChangeParams& out) {
  Reader reader;
  json* object = object_of(reader, params);
  json* document = reader.object(object, "textDocument");
  out.uri = reader.string(document, "uri");
  if (Reader::optional(document, "version") != nullptr) out.version = reader.integer(document, "version");
  json* changes = reader.array(object, "contentChanges");
  if (changes == nullptr) return reader.problem();
  for (json& change : *changes) {
    if (!change.is_object()) {
      reader.fail("`contentChanges` has to be an array of objects");
      break;
    }
    ContentChange& added = out.changes.emplace_back();
    if (json* range = Reader::optional(&change, "range")) added.range = reader.range(range);
    added.text = reader.string(&change, "text");
  }
  return reader.problem();
}

std::string read_params(json& params, DocumentParams& out) {
  Reader reader;
  out.uri = document_uri(reader, object_of(reader, params));
  return reader.problem();
}

std::string read_params(json& params, PositionParams& out) {
  Reader reader;
  json* object = object_of(reader, params);
  out.uri = document_uri(reader, object);
  out.position = reader.position(object, "position");
  return reader.problem();
}

std::string read_params(json& params, ReferenceParams& out) {
  Reader reader;
  json* object = object_of(reader, params);
  out.uri = document_uri(reader, object);
  out.position = reader.position(object, "position");
  out.include_declaration = reader.boolean(reader.object(object, "context"), "includeDeclaration");
  return reader.problem();
}

}  // namespace texbrdf::lsp
