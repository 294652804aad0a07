#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "lsp/settings.h"
#include "source/source_text.h"

namespace texbrdf::lsp {

/// The parameters of the protocol's messages, as far as they are in use. Positions count columns in the encoding that
/// was negotiated.

struct Range {
  Position start;
  Position end;
};

struct NoParams {};

struct InitializeParams {
  std::optional<int64_t> process_id;
  std::string client_name;
  std::string client_version;
  std::vector<std::string> position_encodings;  ///< in the client's order of preference
  std::vector<std::string> hover_formats;       ///< "markdown", "plaintext", in order of preference
  bool markdown_parser = false;                 ///< it names one: what it shows is no bare text
  bool definition_links = false;
  bool hierarchical_symbols = false;
  bool related_information = false;
  bool diagnostic_tags = false;
  bool file_watchers = false;  ///< the client can be asked to watch files
  bool code_description = false;
  bool folds_lines_only = false;
  bool snippets = false;                        ///< completions may have places to fill in
  std::vector<std::string> completion_formats;  ///< of their documentation, in order of preference
  std::vector<std::string> signature_formats;   ///< of the documentation of signatures
  bool label_offsets = false;                   ///< a parameter may be a part of its signature's label
  bool code_action_literals = false;            ///< a code action may be more than a command
  bool preferred_actions = false;
  std::vector<std::string> commands;  ///< `experimental.texbrdf.commands`: those of lenses that it can carry out

  bool pull_diagnostics = false;    ///< it can ask for diagnostics
  bool prepare_rename = false;      ///< it asks before it renames
  bool versioned_edits = false;     ///< `documentChanges` of a WorkspaceEdit
  bool work_done_progress = false;  ///< the server may begin a progress of its own
  bool applies_edits = false;       ///< the server may ask it to change documents
  bool shows_documents = false;     ///< the server may ask it to show a place, or a page in a browser
  bool configuration = false;       ///< it can be asked for its settings
  bool configuration_registration = false;
  std::array<bool, kFeatureCount> registration{};  ///< by Feature: providers may be registered later
  std::array<bool, kFeatureCount> refresh{};       ///< by Feature: it can be told to ask again

  std::vector<std::string> folders;           ///< URIs
  Settings settings;                          ///< `initializationOptions`
  std::vector<std::string> setting_problems;  ///< what is not understood of them
};

struct WorkspaceFoldersParams {
  std::vector<std::string> added;  ///< URIs
  std::vector<std::string> removed;
};

struct DidOpenParams {
  std::string uri;
  std::string language_id;
  int64_t version = 0;
  std::string text;
};

struct ContentChange {
  std::optional<Range> range;  ///< nothing: the whole document
  std::string text;
};

struct DidChangeParams {
  std::string uri;
  std::optional<int64_t> version;
  std::vector<ContentChange> changes;
};

struct DocumentParams {
  std::string uri;
};

struct PositionParams {
  std::string uri;
  Position position;
};

struct RangeParams {
  std::string uri;
  Range range;
};

struct ReferenceParams {
  std::string uri;
  Position position;
  bool include_declaration = false;
};

struct PullParams {
  std::string uri;
  std::string previous_result;  ///< id of the result that the client has; empty where it has none
};

struct RenameParams {
  std::string uri;
  Position position;
  std::string new_name;
};

}  // namespace texbrdf::lsp
