#include "cli/sample_progress.h"

#include <fmt/core.h>
#include <unistd.h>

#include <cstdio>
#include <string>

namespace texbrdf::cli {

SampleProgress::SampleProgress(uint32_t total) : total_(isatty(STDERR_FILENO) == 1 ? total : 0) {}

SampleProgress::~SampleProgress() {
  if (is_shown_) fmt::print(stderr, "\r\x1b[K");
}

void SampleProgress::show(uint32_t samples) {
  if (total_ == 0) return;
  fmt::print(stderr, "\r{} of {} samples", samples, total_);
  std::fflush(stderr);
  is_shown_ = true;
}

void SampleProgress::show_part(double part) {
  constexpr int kWidth = 40;
  const int percent = static_cast<int>(part * 100);
  if (total_ == 0 || percent == percent_) return;
  percent_ = percent;
  fmt::print(stderr, "\r[{:<{}}] {:3} %", std::string(static_cast<std::size_t>(percent * kWidth / 100), '#'), kWidth,
             percent);
  std::fflush(stderr);
  is_shown_ = true;
}

}  // namespace texbrdf::cli
