#include "lsp/framing.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <utility>

#include "source/trimmed.h"

namespace texbrdf::lsp {
namespace {

constexpr std::string_view kContentLength = "content-length:";
/// An empty buffer that is larger gives its memory back.
constexpr std::size_t kKeptCapacity = std::size_t{1} << 20;

char lower(char c) {
  return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

bool equal_ignoring_case(char a, char b) {
  return lower(a) == lower(b);
}

bool starts_with_content_length(std::string_view line) {
  return line.size() >= kContentLength.size() &&
         std::equal(kContentLength.begin(), kContentLength.end(), line.begin(), equal_ignoring_case);
}

bool is_field(std::string_view line) {
  const std::size_t colon = line.find(':');
  if (colon == 0 || colon == std::string_view::npos) return false;
  return std::all_of(line.begin(), line.begin() + static_cast<std::ptrdiff_t>(colon),
                     [](char c) { return (lower(c) >= 'a' && lower(c) <= 'z') || c == '-'; });
}

std::optional<uint64_t> natural_number(std::string_view text) {
  uint64_t number = 0;
  const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (fault != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return number;
}

}  // namespace

std::optional<std::variant<Frame, FramingProblem>> FrameDecoder::next() {
  consume(0);
  if (lost_ && !skip_to_header()) return std::nullopt;
  if (!content_length_) {
    std::string problem;
    switch (read_header(problem)) {
      case HeaderState::Complete:
        break;
      case HeaderState::Incomplete:
        return std::nullopt;
      case HeaderState::Broken:
        content_length_.reset();
        lost_ = true;
        return FramingProblem{std::move(problem)};
    }
  }
  if (buffer_.size() - start_ < *content_length_) return std::nullopt;
  const auto length = static_cast<std::size_t>(*content_length_);
  const Frame result{std::string_view(buffer_).substr(start_, length)};
  start_ += length;
  content_length_.reset();
  return result;
}

/// Reads one header block and consumes it; of a broken one, at most up to and with the line that broke it.
FrameDecoder::HeaderState FrameDecoder::read_header(std::string& problem) {
  const std::string_view input = std::string_view(buffer_).substr(start_);
  std::optional<uint64_t> length;
  std::size_t line_begin = 0;
  for (;;) {
    const std::size_t newline = input.find('\n', line_begin);
    if (newline > kMaxHeaderBytes) {  // npos too
      if (input.size() <= kMaxHeaderBytes) return HeaderState::Incomplete;
      problem = fmt::format("no end of the header within {} bytes", kMaxHeaderBytes);
      consume(1);
      return HeaderState::Broken;
    }
    std::string_view line = input.substr(line_begin, newline - line_begin);
    if (line.ends_with('\r')) line.remove_suffix(1);
    const std::size_t line_end = newline + 1;
    if (line.empty()) {
      if (!length) problem = "header without Content-Length";
      consume(line_end);
      content_length_ = length;
      return length ? HeaderState::Complete : HeaderState::Broken;
    }
    if (!is_field(line)) {
      problem = fmt::format("no header field: {}", line.substr(0, 80));
      consume(line_begin);  // a header may stand right behind what is no field
      return HeaderState::Broken;
    }
    if (starts_with_content_length(line)) {
      const std::string_view number = trimmed(line.substr(kContentLength.size()), " \t");
      length = natural_number(number);
      if (!length) problem = fmt::format("Content-Length is no natural number: {}", number.substr(0, 80));
      if (length && *length > max_message_bytes_) {
        problem = fmt::format("a message of {} bytes is longer than {}", *length, max_message_bytes_);
      }
    }
    if (!problem.empty()) {
      consume(line_end);
      return HeaderState::Broken;
    }
    line_begin = line_end;
  }
}

/// Consumes what comes before the next `Content-Length:`; false when there is none yet.
bool FrameDecoder::skip_to_header() {
  const std::string_view input = std::string_view(buffer_).substr(start_);
  const auto found =
      std::search(input.begin(), input.end(), kContentLength.begin(), kContentLength.end(), equal_ignoring_case);
  if (found == input.end()) {
    const std::size_t kept = std::min(input.size(), kContentLength.size() - 1);
    consume(input.size() - kept);
    return false;
  }
  consume(static_cast<std::size_t>(found - input.begin()));
  lost_ = false;
  return true;
}

void FrameDecoder::consume(std::size_t bytes) {
  start_ += bytes;
  if (start_ < buffer_.size() - start_) return;  // moving the rest has to be paid for by what was consumed
  buffer_.erase(0, start_);
  start_ = 0;
  if (buffer_.empty() && buffer_.capacity() > kKeptCapacity) buffer_ = {};
}

std::string frame(std::string body) {
  body.insert(0, fmt::format("Content-Length: {}\r\n\r\n", body.size()));
  return body;
}

}  // namespace texbrdf::lsp
