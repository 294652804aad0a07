#include "web/mailbox.h"

namespace texbrdf::web {

bool Mailbox::is_full() const {
  const std::lock_guard lock(mutex_);
  return waiting_.size() >= limits_.happenings || bytes_ >= limits_.bytes;
}

void Mailbox::add(Happening happening) {
  {
    const std::lock_guard lock(mutex_);
    if (const auto* message = std::get_if<Message>(&happening)) bytes_ += message->body.size();
    waiting_.push_back(std::move(happening));
  }
  wake_();
}

std::vector<Happening> Mailbox::take() {
  const std::lock_guard lock(mutex_);
  bytes_ = 0;
  return std::exchange(waiting_, {});
}

}  // namespace texbrdf::web
