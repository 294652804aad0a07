#pragma once

#include <cstdint>

namespace texbrdf::cli {

/// A line on a terminal that counts the samples of a picture; nothing where standard error is no terminal.
class SampleProgress {
 public:
  /// 0: nothing is shown.
  explicit SampleProgress(uint32_t total);
  ~SampleProgress();  ///< clears the line
  SampleProgress(const SampleProgress&) = delete;
  SampleProgress& operator=(const SampleProgress&) = delete;

  void show(uint32_t samples);
  /// As a bar, for pictures of which parts of samples are done: 0 to 1.
  void show_part(double part);

 private:
  uint32_t total_;
  bool is_shown_ = false;
  int percent_ = -1;
};

}  // namespace texbrdf::cli
