#pragma once

#include <cstddef>
#include <functional>
#include <mutex>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "web/routes.h"

namespace texbrdf::web {

struct Connected {
  ClientId client;
};
struct Message {
  ClientId client;
  std::string body;
};
struct Gone {
  ClientId client;
};
using Happening = std::variant<Connected, Message, Gone>;

/// What has happened and nobody has looked at yet, in its order. Any thread may call it.
class Mailbox {
 public:
  struct Limits {
    std::size_t happenings = 1000;
    std::size_t bytes = std::size_t{4} << 20;  ///< of messages
  };

  /// `wake` is called for each happening, on the thread that adds it.
  Mailbox(std::function<void()> wake, Limits limits) : wake_(std::move(wake)), limits_(limits) {}

  bool is_full() const;
  void add(Happening happening);
  std::vector<Happening> take();

 private:
  const std::function<void()> wake_;
  const Limits limits_;
  mutable std::mutex mutex_;
  std::vector<Happening> waiting_;
  std::size_t bytes_ = 0;
};

}  // namespace texbrdf::web
