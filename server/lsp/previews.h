#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "lsp/browsers.h"
#include "lsp/preview_params.h"
#include "preview/exact_model.h"
#include "preview/preview_service.h"

namespace texbrdf::lsp {

/// What the numbers beside a picture come from. Where the document cannot be drawn it is what could be drawn last.
struct ExactValues {
  uint64_t model = 0;                                 ///< of the scene that this was last brought up to
  std::shared_ptr<const preview::ExactModel> source;  ///< nullptr: nothing was drawn so far, or see `problem`
  std::string problem;                                ///< why a BRDF that can be drawn has no values here
};

/// A preview that the editor or a browser has open.
struct OpenPreview {
  ViewerId viewer = kEditor;
  std::string uri;
  std::string root;  ///< canonical; empty: the document's own
  render::SphereView view;
  preview::ObjectLook object = {};
  std::map<std::string, std::vector<double>> values;  ///< set by sliders
  bool is_stale = true;                               ///< its document has changed since it was shown
  uint64_t model = 0;                                 ///< of the scene that was shown last
  ExactValues exact = {};
};

/// What answers who names a preview that there is not.
std::string unknown_preview(int64_t id);

/// Changes the view; why it cannot be, or nothing. A picture is as large as the smaller side of its pane.
std::optional<std::string> change_view(const ViewChange& change, OpenPreview& preview);

/// Compiles what the preview shows, unless that is done already. Precondition: it is not stale.
void update_exact(OpenPreview& preview, const Snapshot& snapshot);

/// The previews of the editor and of browsers. Threads that draw are started with the first.
class Previews {
 public:
  /// `wake` is called on any thread when there are events. Without it nothing is drawn.
  void connect(std::function<void()> wake) { wake_ = std::move(wake); }

  /// Until the next call all that names a preview means one of this viewer's, and no other.
  void serve(ViewerId viewer) { viewer_ = viewer; }
  /// So many that another is refused.
  bool are_many() const;
  int64_t open(OpenPreview preview);
  /// A number that no other preview has.
  int64_t take_id() { return ++last_id_; }
  /// nullptr where there is none.
  OpenPreview* find(int64_t id);
  /// nullptr where there is none, whosever it is.
  const OpenPreview* find_of_any(int64_t id) const;
  /// A document has another text: its previews are drawn anew, and those of all others, which may be of its project.
  void note_change();
  void close(int64_t id);
  void close_all(std::string_view uri);
  void close_all_of(ViewerId viewer);
  void clear();
  std::map<int64_t, OpenPreview>& all() { return previews_; }

  void show(int64_t id, const OpenPreview& preview, const Snapshot& snapshot, int64_t version);
  void acknowledge(int64_t id);
  std::vector<preview::Event> take_events();
  std::vector<std::string> take_faults();

 private:
  std::function<void()> wake_;
  std::map<int64_t, OpenPreview> previews_;
  ViewerId viewer_ = kEditor;
  int64_t last_id_ = 0;
  std::unique_ptr<preview::PreviewService> service_;
};

}  // namespace texbrdf::lsp
