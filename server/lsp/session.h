#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "features/code_actions.h"
#include "features/hover.h"
#include "lsp/browser_params.h"
#include "lsp/browsers.h"
#include "lsp/client_process.h"
#include "lsp/code_actions.h"
#include "lsp/code_lenses.h"
#include "lsp/completion.h"
#include "lsp/configuration.h"
#include "lsp/dispatcher.h"
#include "lsp/documents.h"
#include "lsp/json_rpc.h"
#include "lsp/json_writer.h"
#include "lsp/late_findings.h"
#include "lsp/log.h"
#include "lsp/outbox.h"
#include "lsp/positions.h"
#include "lsp/previews.h"
#include "lsp/protocol.h"
#include "lsp/providers.h"
#include "lsp/scene_documents.h"
#include "lsp/scene_previews.h"
#include "lsp/semantic_tokens.h"
#include "lsp/settings.h"
#include "lsp/workspace_folders.h"
#include "lsp/write_edits.h"
#include "lsp/write_results.h"
#include "preview/bad_values.h"
#include "preview/expression_look.h"

namespace texbrdf::lsp {

/// Messages counted for `texbrdf/stats`.
struct Traffic {
  uint64_t requests = 0;
  uint64_t notifications = 0;
  uint64_t cancelled = 0;
  uint64_t errors = 0;  ///< error replies
  uint64_t published = 0;
};

/// Everything between one client's `initialize` and `exit`: what it can do, its open documents, and a handler for each
/// method. Knows neither bytes nor the order in which messages are handled.
class Session {
 public:
  enum class Phase : uint8_t { Created, Running, ShutDown, Exited };

  /// All have to outlive the session.
  Session(Log& log, ClientProcess& client_process, std::string_view version, std::string_view docs_url)
      : log_(log),
        client_process_(client_process),
        program_version_(version),
        docs_url_(docs_url),
        first_log_level_(log.level()),
        outbox_(log) {}
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;

  /// The dispatch table: one line a method (methods.cpp).
  void bind_methods(Dispatcher& bind);

  Phase phase() const { return phase_; }
  /// 0 where `shutdown` came before the end.
  int exit_status() const { return shut_down_ ? 0 : 1; }
  Traffic& traffic() { return traffic_; }
  Outbox& outbox() { return outbox_; }
  Browsers& browsers() { return browsers_; }
  /// The method belongs to a feature that the client has switched off: it is answered with null.
  bool is_switched_off(std::string_view method) const;
  /// Answers what is asked of a scene as of any document: there is nothing.
  bool answer_about_scene(std::string_view method, const nlohmann::json& params, JsonWriter& result);

  /// The parameters of the next `publishDiagnostics` to send. Precondition: has_publications().
  void write_next_publication(JsonWriter& out);
  /// After a fault, which may have left anything broken behind but the texts.
  void start_anew() {
    documents_.start_anew();
    scenes_.start_anew();
    previews_.note_change();
  }
  void publish_anew() { publish_anew(pushes_diagnostics()); }
  /// While there is nothing else to do.
  void prepare_for_edits() {
    for (auto& [uri, open] : documents_.all()) open.document.prepare_for_edits();
  }
  /// `wake` may be called by any thread: `send_frames` and `take_findings` then have something to take. Without it
  /// nothing is drawn, and diagnostics wait for all that is computed for them.
  void connect_wake(std::function<void()> wake) {
    late_findings_.connect(wake);
    scene_previews_.connect(wake);
    previews_.connect(std::move(wake));
  }
  /// Has what the previews show drawn anew where their documents have changed.
  void refresh_previews();
  void send_frames();
  /// Documents whose diagnostics had to do without what has now been computed are published once more.
  void take_findings();

  /// Whose message is handled next.
  void serve(ViewerId viewer);
  ViewerId speaker() const { return speaker_; }
  bool listens_to(ViewerId viewer) const;
  void browser_came(ViewerId browser);
  void browser_went(ViewerId browser);
  /// Tells browsers which document was opened or edited last.
  void lead_browsers();

  bool has_publications() {
    notice_projects();
    return !closed_.empty() || !elsewhere_.empty() || (shows_scene_problems() && scenes_.has_problems_to_tell(unit_)) ||
           (pushes_diagnostics() && documents_.next_unpublished() != nullptr);
  }

 private:
  using Outcome = std::optional<ResponseError>;

  // lifecycle.cpp
  Outcome initialize(const InitializeParams& params, JsonWriter& result);
  Outcome shutdown(const NoParams& params, JsonWriter& result);
  std::string initialized(const NoParams& params);
  std::string exit(const NoParams& params);
  void greet_client();
  void write_capabilities(JsonWriter& out) const;

  // text_sync.cpp
  std::string did_open(const DidOpenParams& params);
  std::string did_change(const DidChangeParams& params);
  std::string did_save(const DocumentParams& params);
  std::string did_close(const DocumentParams& params);
  void apply(const ContentChange& change, OpenDocument& open) const;
  void analyse_visibly(OpenDocument& open);

  // scenes.cpp
  std::string open_scene_document(const DidOpenParams& params);
  std::string change_scene_document(const DidChangeParams& params);
  std::string close_scene_document(const DocumentParams& params);
  /// Whatever a client can do: it does not ask about files that are not open.
  bool shows_scene_problems() const { return settings_.shows(Feature::Diagnostics); }
  static void write_scene_problems(JsonWriter& out, const SceneProblems& problems);
  Outcome open_scene(const OpenSceneParams& params, JsonWriter& result);
  std::string update_scene(const UpdateSceneParams& params);
  std::string scene_input(const SceneInputParams& params);
  void refresh_scene_previews();
  void send_scene_frames();
  void tell_scene_state(int64_t id, const ScenePreview& preview);

  // configuration.cpp
  std::string did_change_configuration(const DidChangeConfigurationParams& params);
  void watch_configuration();
  void ask_for_configuration();
  void configure(const nlohmann::json& section);
  void adopt(const Settings& wanted);
  void announce_anew(const Provider& provider);
  bool is_kept(Feature feature) const;
  LogLevel chosen_log_level() const;

  // workspace.cpp
  std::string did_change_workspace_folders(const WorkspaceFoldersParams& params);
  std::string did_change_watched_files(const NoParams& params);
  std::vector<std::string> folder_paths() const;
  void watch_files();

  // project_files.cpp
  Positions positions(OpenDocument& open);
  std::string uri_of(const OpenDocument& open, FileId file);
  std::vector<FileEdits> by_file(OpenDocument& open, std::span<const features::TextEdit> edits);
  void notice_projects();
  void show_elsewhere(OpenDocument& open, std::span<const std::vector<features::ShownDiagnostic>> by_file);
  void forget_elsewhere();

  // shown_diagnostics.cpp
  Outcome diagnostic(const PullParams& params, JsonWriter& result);
  bool is_pulled() const;
  LateFindings::Findings findings_for_pull(OpenDocument& open, const Snapshot& snapshot);
  bool pushes_diagnostics() const { return settings_.shows(Feature::Diagnostics) && !is_pulled(); }
  void publish_anew(bool pushed_before);
  std::vector<std::vector<features::ShownDiagnostic>> shown_by_file(const Snapshot& snapshot,
                                                                    const features::NumericFindings* findings) const;
  std::vector<features::ShownDiagnostic> as_set(std::vector<features::ShownDiagnostic> shown) const;
  DiagnosticStyle diagnostic_style() const;

  // rename.cpp
  Outcome prepare_rename(const PositionParams& params, JsonWriter& result);
  Outcome rename(const RenameParams& params, JsonWriter& result);

  // semantic_tokens.cpp
  Outcome semantic_tokens_full(const DocumentParams& params, JsonWriter& result);
  Outcome semantic_tokens_delta(const SemanticTokensDeltaParams& params, JsonWriter& result);
  Outcome semantic_tokens_range(const RangeParams& params, JsonWriter& result);

  // document_symbols.cpp, document_highlights.cpp, folding_ranges.cpp, inlay_hints.cpp
  Outcome document_symbol(const DocumentParams& params, JsonWriter& result);
  Outcome document_highlight(const PositionParams& params, JsonWriter& result);
  Outcome folding_range(const DocumentParams& params, JsonWriter& result);
  Outcome inlay_hint(const RangeParams& params, JsonWriter& result);

  // code_lenses.cpp
  Outcome code_lens(const DocumentParams& params, JsonWriter& result);
  Outcome resolve_code_lens(const CodeLensParams& params, JsonWriter& result);

  // completion.cpp, signature_help.cpp
  Outcome completion(const PositionParams& params, JsonWriter& result);
  Outcome resolve_completion(const CompletionItemParams& params, JsonWriter& result);
  Outcome signature_help(const PositionParams& params, JsonWriter& result);

  // code_actions.cpp
  Outcome code_action(const CodeActionParams& params, JsonWriter& result);
  void write_code_action(JsonWriter& out, Positions& positions, const OpenDocument& open,
                         features::CodeAction& action) const;

  // hover.cpp
  Outcome hover(const PositionParams& params, JsonWriter& result);
  bool shows_looks() const;
  std::string look_of(const Snapshot& snapshot, const features::Expression& expression);

  // queries.cpp
  Outcome definition(const PositionParams& params, JsonWriter& result);
  Outcome references(const ReferenceParams& params, JsonWriter& result);
  Outcome stats(const NoParams& params, JsonWriter& result);

  // preview.cpp
  Outcome open_preview(const OpenPreviewParams& params, JsonWriter& result);
  std::string update_preview(const UpdatePreviewParams& params);
  /// Why it cannot be, or nothing.
  std::optional<std::string> change(const ViewChange& change, OpenPreview& preview);
  std::string close_preview(const PreviewParams& params);
  std::string frame_shown(const PreviewParams& params);
  std::string set_parameter(const SetParameterParams& params);
  Outcome parameters(const ModelParams& params, JsonWriter& result);
  Outcome parameter_edit(const ParameterEditParams& params, JsonWriter& result);
  Outcome roots(const ModelParams& params, JsonWriter& result);
  Outcome emit(const EmitParams& params, JsonWriter& result);
  void show(int64_t id, const OpenPreview& preview);
  void tell_viewer(ViewerId viewer, std::string_view method, const Outbox::WriteParams& write_params);

  // browser_requests.cpp
  Outcome apply_edit(const ApplyEditParams& params, JsonWriter& result);
  Outcome reveal(const RevealParams& params, JsonWriter& result);
  Outcome execute_command(const ExecuteCommandParams& params, JsonWriter& result);
  void write_commands(JsonWriter& out) const;
  void tell_url();
  bool is_known_file(std::string_view uri);
  std::optional<std::string> fault_of(const WantedChange& change);

  // preview_values.cpp
  Outcome quantities(const ModelParams& params, JsonWriter& result);
  Outcome probe(const ProbeParams& params, JsonWriter& result);
  Outcome bad_pixels(const PreviewParams& params, JsonWriter& result);
  Outcome plot(const PlotParams& params, JsonWriter& result);
  const OpenPreview* present_preview(int64_t id);
  void write_bad_value(JsonWriter& out, const OpenPreview& preview, const preview::BadValue& bad);

  static ResponseError not_open(std::string_view uri);

  Log& log_;
  ClientProcess& client_process_;
  std::string_view program_version_;
  std::string_view docs_url_;
  Phase phase_ = Phase::Created;
  bool shut_down_ = false;
  InitializeParams client_;
  ColumnUnit unit_ = ColumnUnit::Utf16;
  features::Markup hover_markup_ = features::Markup::Markdown;
  Documents documents_;
  SceneDocuments scenes_{documents_.projects()};
  ScenePreviews scene_previews_;
  std::vector<std::string> closed_;  ///< URIs whose diagnostics are to be taken away
  Traffic traffic_;
  LogLevel first_log_level_;
  Settings settings_;
  std::array<bool, kFeatureCount> registered_{};  ///< by Feature: announced later than in the answer to `initialize`
  WorkspaceFolders folders_;
  uint64_t seen_state_ = 0;                             ///< of the projects
  std::map<std::string, std::string> shown_elsewhere_;  ///< diagnostics of files that are not open, by path
  std::vector<std::string> elsewhere_;                  ///< paths of those that are to be published
  uint64_t last_result_ = 0;                            ///< id of the last pulled result
  uint64_t last_progress_ = 0;                          ///< token of the last progress that the server began
  uint64_t last_token_result_ = 0;                      ///< id of the last semantic tokens
  uint64_t last_touch_ = 0;                             ///< grows with each document that is opened or edited
  int64_t last_edit_ = 0;                               ///< that a browser asked for
  ViewerId speaker_ = kEditor;                          ///< whose message is being handled
  Browsers browsers_;
  Previews previews_;
  LateFindings late_findings_;
  std::optional<preview::ExpressionSampler> sampler_;  ///< from the first hover that needs it
  Outbox outbox_;
};

}  // namespace texbrdf::lsp
