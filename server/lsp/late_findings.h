#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "features/numeric_findings.h"

namespace texbrdf::lsp {

/// What takes long to find out about documents (features/numeric_findings.h), computed on a thread of its own: of each
/// document only what was asked for last. What was found lately is kept, and is had at once as long as nothing changes
/// that it depends on.
class LateFindings {
 public:
  using Findings = std::shared_ptr<const features::NumericFindings>;

  LateFindings();
  ~LateFindings();
  LateFindings(const LateFindings&) = delete;
  LateFindings& operator=(const LateFindings&) = delete;

  /// `wake` may be called by any thread: `take_found` then has something to give. Without it no thread is started, and
  /// whoever asks waits.
  void connect(std::function<void()> wake);

  /// Those that hold for the snapshot; nullptr where they are being computed.
  Findings of(const std::string& document, const Snapshot& snapshot);
  /// The same, but waits for them.
  Findings wait_for(const Snapshot& snapshot);
  /// What is computed for the document is wanted no more.
  void forget(const std::string& document);

  /// The documents that have got what `of` did not have.
  std::vector<std::string> take_found();
  /// Faults of ours, for the log.
  std::vector<std::string> take_faults();

 private:
  class Worker;
  class Memory;
  std::unique_ptr<Memory> memory_;
  std::function<void()> wake_;
  std::unique_ptr<Worker> worker_;  ///< from the first document that needs it
};

}  // namespace texbrdf::lsp
