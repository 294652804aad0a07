#include "lsp/late_findings.h"

#include <algorithm>
#include <condition_variable>
#include <deque>
#include <exception>
#include <mutex>
#include <optional>
#include <stop_token>
#include <thread>
#include <utility>

namespace texbrdf::lsp {
namespace {

using features::NumericFindings;
using features::NumericQuestions;

constexpr std::size_t kMostRemembered = 16;

/// What one document asks.
struct Question {
  std::string document;
  Snapshot snapshot;
  NumericQuestions asked;
};

const LateFindings::Findings& nothing() {
  static const LateFindings::Findings none = std::make_shared<const NumericFindings>();
  return none;
}

LateFindings::Findings shared(std::optional<NumericFindings> findings) {
  return findings ? std::make_shared<const NumericFindings>(*std::move(findings)) : nullptr;
}

}  // namespace

/// What was found lately, the last first. Safe from several threads.
class LateFindings::Memory {
 public:
  Findings find(const Snapshot& snapshot, const NumericQuestions& asked) {
    const std::lock_guard lock(mutex_);
    const auto holds = [&](const Findings& known) { return known->hold_for(snapshot, asked); };
    const auto found = std::ranges::find_if(recent_, holds);
    if (found == recent_.end()) return nullptr;
    std::rotate(recent_.begin(), found, std::next(found));
    return recent_.front();
  }

  void keep(Findings findings) {
    const std::lock_guard lock(mutex_);
    recent_.push_front(std::move(findings));
    if (recent_.size() > kMostRemembered) recent_.pop_back();
  }

 private:
  std::mutex mutex_;
  std::deque<Findings> recent_;
};

/// All that is shared stands behind the mutex; nothing is computed while it is held.
class LateFindings::Worker {
 public:
  Worker(Memory& memory, std::function<void()> wake)
      : memory_(memory), wake_(std::move(wake)), thread_([this] { run(); }) {}

  ~Worker() {
    {
      const std::lock_guard lock(mutex_);
      is_ending_ = true;
      running_.request_stop();
    }
    work_.notify_all();
    thread_.join();
  }
  Worker(const Worker&) = delete;
  Worker& operator=(const Worker&) = delete;

  void ask(Question question) {
    {
      const std::lock_guard lock(mutex_);
      drop(question.document);
      waiting_.push_back(std::move(question));
    }
    work_.notify_all();
  }

  void forget(const std::string& document) {
    const std::lock_guard lock(mutex_);
    drop(document);
  }

  std::vector<std::string> take_found() {
    const std::lock_guard lock(mutex_);
    return std::exchange(found_, {});
  }

  std::vector<std::string> take_faults() {
    const std::lock_guard lock(mutex_);
    return std::exchange(faults_, {});
  }

 private:
  void drop(const std::string& document) {
    std::erase_if(waiting_, [&](const Question& question) { return question.document == document; });
    if (running_for_ == document) running_.request_stop();
  }

  std::optional<Question> next() {
    std::unique_lock lock(mutex_);
    work_.wait(lock, [&] { return is_ending_ || !waiting_.empty(); });
    if (is_ending_) return std::nullopt;
    std::optional<Question> question(std::move(waiting_.front()));
    waiting_.pop_front();
    running_ = std::stop_source();
    running_for_ = question->document;
    return question;
  }

  void run() {
    while (std::optional<Question> question = next()) {
      const bool is_found = answer(*question, running_.get_token());
      {
        const std::lock_guard lock(mutex_);
        running_for_.clear();
        if (is_found) found_.push_back(question->document);
      }
      if (is_found) wake_();
    }
  }

  /// False where it was stopped.
  bool answer(const Question& question, const std::stop_token& stop) {
    if (memory_.find(question.snapshot, question.asked) != nullptr) return true;
    try {
      Findings findings = shared(features::find_numerically(question.snapshot, question.asked, stop));
      if (findings == nullptr) return false;
      memory_.keep(std::move(findings));
    } catch (const std::exception& fault) {
      give_up(question, fault);
    }
    return true;
  }

  /// After a fault of ours the same is not asked again.
  void give_up(const Question& question, const std::exception& fault) {
    NumericFindings unknown;
    unknown.questions = question.asked;
    memory_.keep(std::make_shared<const NumericFindings>(std::move(unknown)));
    const std::lock_guard lock(mutex_);
    faults_.push_back("computing for diagnostics was given up: " + std::string(fault.what()));
  }

  Memory& memory_;
  std::function<void()> wake_;
  std::mutex mutex_;
  std::condition_variable work_;
  std::deque<Question> waiting_;
  std::string running_for_;  ///< the document; empty: none
  std::stop_source running_;
  std::vector<std::string> found_;
  std::vector<std::string> faults_;
  bool is_ending_ = false;
  std::thread thread_;
};

LateFindings::LateFindings() : memory_(std::make_unique<Memory>()) {}
LateFindings::~LateFindings() = default;

void LateFindings::connect(std::function<void()> wake) {
  wake_ = std::move(wake);
}

LateFindings::Findings LateFindings::of(const std::string& document, const Snapshot& snapshot) {
  if (!wake_) return wait_for(snapshot);
  NumericQuestions asked = features::numeric_questions(snapshot);
  if (asked.empty()) {
    forget(document);
    return nothing();
  }
  if (Findings known = memory_->find(snapshot, asked)) {
    forget(document);
    return known;
  }
  if (!worker_) worker_ = std::make_unique<Worker>(*memory_, wake_);
  worker_->ask({document, snapshot, std::move(asked)});
  return nullptr;
}

LateFindings::Findings LateFindings::wait_for(const Snapshot& snapshot) {
  NumericQuestions asked = features::numeric_questions(snapshot);
  if (asked.empty()) return nothing();
  if (Findings known = memory_->find(snapshot, asked)) return known;
  Findings findings = shared(features::find_numerically(snapshot, std::move(asked)));
  memory_->keep(findings);
  return findings;
}

void LateFindings::forget(const std::string& document) {
  if (worker_) worker_->forget(document);
}

std::vector<std::string> LateFindings::take_found() {
  return worker_ ? worker_->take_found() : std::vector<std::string>();
}

std::vector<std::string> LateFindings::take_faults() {
  return worker_ ? worker_->take_faults() : std::vector<std::string>();
}

}  // namespace texbrdf::lsp
