#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "analysis/document.h"
#include "cli/exit_code.h"
#include "ir/program.h"

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

/// Declares FILE, --root and --set.
void add_model_options(CLI::App& arguments, ModelOptions& options);

/// A program that the document gives, although other definitions of it may be in error.
struct Model {
  ir::Program program;
  bool document_has_errors = false;

  /// What a command that did its work exits with.
  ExitCode exit_code() const { return document_has_errors ? ExitCode::DocumentHasErrors : ExitCode::Fine; }
};

/// Reads and compiles; writes errors and warnings to standard error. Where there is no model: the exit code.
std::variant<Model, ExitCode> load_model(const ModelOptions& options);

}  // namespace texbrdf::cli
