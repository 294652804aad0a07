#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <set>
#include <string>
#include <string_view>

#include "lsp/json_writer.h"

namespace texbrdf::lsp {

/// Who a message is from and whom a picture is for: the editor, or one of the browsers.
using ViewerId = uint64_t;
inline constexpr ViewerId kEditor = 0;

/// A browser has no business with other methods.
bool is_for_browsers(std::string_view method);

/// The document that was opened or edited last.
struct FollowedDocument {
  std::string uri;
  int64_t version = 0;
  bool operator==(const FollowedDocument&) const = default;
};

/// The browsers that show previews: which are there, and what they are told.
class Browsers {
 public:
  using Send = std::function<void(ViewerId browser, std::string body)>;
  using WriteParams = std::function<void(JsonWriter& params)>;

  /// `url` is where browsers find the preview. Until then there are none.
  void connect(std::string url, Send send);
  /// There will be none: why, for the user.
  void give_up(std::string problem) { problem_ = std::move(problem); }
  const std::string& problem() const { return problem_; }
  bool are_served() const { return !url_.empty(); }
  const std::string& url() const { return url_; }

  void add(ViewerId browser);
  void remove(ViewerId browser) { present_.erase(browser); }
  bool is_present(ViewerId browser) const { return present_.contains(browser); }

  void send(ViewerId browser, std::string body) const { send_(browser, std::move(body)); }
  void notify(ViewerId browser, std::string_view method, const WriteParams& write_params) const;
  /// Tells all of them, where it is another document or another version.
  void follow(std::optional<FollowedDocument> document);

 private:
  void tell_document(ViewerId browser) const;

  std::string url_;
  std::string problem_;
  Send send_ = [](ViewerId, const std::string&) {};
  std::set<ViewerId> present_;
  std::optional<FollowedDocument> document_;
};

}  // namespace texbrdf::lsp
