#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "lsp/browsers.h"
#include "lsp/scene_documents.h"
#include "lsp/scene_params.h"
#include "preview/scene_painter.h"
#include "viewing/viewer.h"

namespace texbrdf::lsp {

/// A preview of a scene that the editor or a browser has open.
struct ScenePreview {
  ViewerId viewer = kEditor;
  std::string uri;
  uint32_t width = 512;
  uint32_t height = 512;
  render::SceneDisplay display;
  uint32_t view = 0;                    ///< of render::scene_view_entries
  std::optional<viewing::Viewer> seen;  ///< nothing before its files could be read without an error
  std::shared_ptr<const scene::SceneShader> shader;
  uint64_t state = 0;        ///< OpenScene::state when they were read
  std::string problem;       ///< why the files as they are now are not shown
  int64_t version = 0;       ///< of the document
  bool is_told = false;      ///< the client knows `problem`
  bool is_rejected = false;  ///< `shader` cannot be compiled
};

/// The previews of scenes. Their thread starts with the first.
class ScenePreviews {
 public:
  /// `wake` is called on any thread when there are events. Without it nothing is drawn.
  void connect(std::function<void()> wake) { wake_ = std::move(wake); }

  bool are_many() const;
  void open(int64_t id, ScenePreview preview);
  /// nullptr where there is none of this viewer.
  ScenePreview* find(int64_t id, ViewerId viewer);
  std::map<int64_t, ScenePreview>& all() { return previews_; }
  void close(int64_t id, ViewerId viewer);
  void close_all(std::string_view uri);
  void close_all_of(ViewerId viewer);
  void clear();

  /// Why it cannot be, or nothing.
  std::optional<std::string> change(const SceneChange& change, ScenePreview& preview);
  /// Takes what the files say now; whether there is something else to draw.
  static bool read(const OpenScene& scene, ScenePreview& preview);
  /// Has it drawn, where there is something to draw.
  void show(int64_t id, const ScenePreview& preview);
  void acknowledge(int64_t id, ViewerId viewer);
  std::vector<preview::SceneEvent> take_events();

 private:
  template <typename Condition>
  void close_where(const Condition& condition);

  std::function<void()> wake_;
  std::map<int64_t, ScenePreview> previews_;
  std::unique_ptr<preview::ScenePainter> painter_;
};

}  // namespace texbrdf::lsp
