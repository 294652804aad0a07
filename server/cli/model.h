#pragma once

#include <CLI/CLI.hpp>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "analysis/document.h"
#include "cli/exit_code.h"
#include "ir/program.h"
#include "source/result.h"

namespace texbrdf::cli {

/// A document as a command reads it, with the files that it includes.
struct NamedDocument {
  std::vector<std::string> file_names;  ///< by FileId, as they are shown
  std::vector<std::string> paths;       ///< by FileId, real
  Document document;
};

/// Reads FILE; says on standard error why it cannot be read.
std::variant<NamedDocument, ExitCode> read_document(const std::string& path);

/// Declares --root.
void add_root_option(CLI::App& arguments, std::string& root);
/// The canonical name of what --root was given, empty where it was not; says on standard error where it is no name.
std::optional<std::string> root_option(const std::string& typed);

/// Which model of a document a command is about: FILE, --root and --set.
struct ModelOptions {
  std::string file;
  std::string root;                   ///< as typed; empty: the document decides
  std::vector<std::string> settings;  ///< NAME=VALUE, as typed
};

/// Declares --root and --set.
void add_model_choice(CLI::App& arguments, ModelOptions& options);
/// Declares FILE, --root and --set.
void add_model_options(CLI::App& arguments, ModelOptions& options);

/// A program that the document gives, although other definitions of it may be in error.
struct Model {
  ir::Program program;
  bool document_has_errors = false;

  /// What a command that did its work exits with.
  ExitCode exit_code() const { return document_has_errors ? ExitCode::DocumentHasErrors : ExitCode::Fine; }
};

using ParameterValues = std::map<std::string, std::vector<double>>;  ///< by canonical name

/// "0.2" or "0.1,0.2,0.3".
std::optional<std::vector<double>> read_numbers(std::string_view text);

/// A document from which models can be had that differ in the values of parameters.
struct ModelSource {
  NamedDocument named;
  std::string root;        ///< canonical
  ParameterValues values;  ///< of --set
  bool document_has_errors = false;

  /// Fails where a value does not fit.
  Result<ir::Program> program(const ParameterValues& others = {});
};

/// As load_model, without a program yet.
std::variant<ModelSource, ExitCode> load_model_source(const ModelOptions& options);

/// Reads and compiles; writes errors and warnings to standard error. Where there is no model: the exit code.
std::variant<Model, ExitCode> load_model(const ModelOptions& options);

}  // namespace texbrdf::cli
