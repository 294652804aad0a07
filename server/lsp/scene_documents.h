#pragma once

#include <chrono>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "files/file_source.h"
#include "lsp/protocol.h"
#include "scene_json/load_scene.h"
#include "viewing/file_watch.h"

namespace texbrdf::lsp {

/// *.scene.json, *.model.json, *.material.json, *.shader.json, *.primitive.json
bool is_scene_uri(std::string_view uri);

/// A scene, or a part of one, that the client has open.
struct OpenScene {
  std::string uri;
  std::string path;  ///< real; the URI where it is no file
  SourceText text;
  std::optional<int64_t> version;
  uint64_t touched = 0;                                 ///< the larger, the later it was opened or edited
  bool is_published = false;                            ///< the client has the problems of this version
  bool is_stale = true;                                 ///< what it depends on has changed since it was read
  uint64_t state = 0;                                   ///< another one each time that it was read
  std::shared_ptr<const scene_json::LoadedScene> read;  ///< nullptr before
  viewing::FileWatch watch;
};

/// What the client is to know of a file of scenes.
struct SceneProblems {
  std::string uri;
  std::optional<int64_t> version;
  std::string items;  ///< Diagnostic[]
};

/// The open scenes, read with all that they name whenever something of it changes. What is open is never read from the
/// disk; beside it the folders of the workspace may be read, and those of the open scenes.
class SceneDocuments final : public files::FileSource {
 public:
  /// The other open documents and the disk; it outlives the object.
  explicit SceneDocuments(files::FileSource& others) : others_(others) {}

  OpenScene& open(std::string uri, std::string_view text, int64_t version);
  bool close(std::string_view uri);
  void clear();
  /// nullptr where it is not open.
  OpenScene* find(std::string_view uri);
  std::map<std::string, OpenScene, std::less<>>& all() { return scenes_; }
  void apply(const ContentChange& change, ColumnUnit unit, OpenScene& open);
  /// An open document of another kind has another text, came or went.
  void note_change(std::string_view path);
  /// Files may have come, gone or changed.
  void disk_changed() { looked_ = {}; }
  /// Forgets what was read.
  void start_anew();
  /// Reads what is stale.
  void settle();

  /// What the client has not been told: after `settle`, one file at a time; nothing where it knows all.
  std::optional<SceneProblems> next_problems(ColumnUnit unit);
  bool has_problems_to_tell(ColumnUnit unit);
  /// Everything is to be told again; URIs of that of which something was told.
  std::vector<std::string> forget_told();

  bool may_read(std::string_view path) const override;
  bool exists(const std::string& path) const override;
  std::optional<SourceText> text(const std::string& path) override;
  TextLanguage language(const std::string& path) const override { return others_.language(path); }

 private:
  const OpenScene* find_path(std::string_view path) const;
  void look_at_disk();
  void collect(ColumnUnit unit);

  files::FileSource& others_;
  std::map<std::string, OpenScene, std::less<>> scenes_;  // by URI
  std::map<std::string, std::string> told_;               // Diagnostic[] by path, of what is not empty
  std::map<std::string, std::string> wanted_;
  bool is_collected_ = true;
  uint64_t last_state_ = 0;
  std::chrono::steady_clock::time_point looked_{};
};

}  // namespace texbrdf::lsp
