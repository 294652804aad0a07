#include "cli/files.h"

#include <fcntl.h>
#include <fmt/core.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <climits>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <utility>

#include "source/source_text.h"

namespace texbrdf::cli {
namespace {

constexpr std::size_t kChunkBytes = std::size_t{1} << 18;

/// An open file descriptor that is closed at the end of its scope.
class Descriptor {
 public:
  explicit Descriptor(int value) : value_(value) {}
  ~Descriptor() { close_now(); }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;

  bool open() const { return value_ >= 0; }
  int get() const { return value_; }
  /// False where the system reports a write that failed late.
  bool close_now() {
    const int value = std::exchange(value_, -1);
    return value < 0 || ::close(value) == 0;
  }

 private:
  int value_;
};

std::string reason() {
  return std::strerror(errno);
}

Failure cannot_read(const std::string& path, std::string_view why) {
  return Failure{fmt::format("cannot read {}: {}", input_name(path), why)};
}

Failure cannot_write(const std::string& path, std::string_view why) {
  return Failure{fmt::format("cannot write {}: {}", path == "-" ? "standard output" : path, why)};
}

Result<std::string> read_all(int descriptor, const std::string& path) {
  std::string bytes;
  struct stat status{};
  if (::fstat(descriptor, &status) == 0 && S_ISREG(status.st_mode) && status.st_size > 0 &&
      status.st_size <= SourceText::kMaxBytes) {
    bytes.reserve(static_cast<std::size_t>(status.st_size) + kChunkBytes);
  }
  while (true) {
    const std::size_t old_size = bytes.size();
    bytes.resize(old_size + kChunkBytes);
    const ssize_t count = ::read(descriptor, bytes.data() + old_size, kChunkBytes);
    bytes.resize(old_size + static_cast<std::size_t>(std::max<ssize_t>(count, 0)));
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return cannot_read(path, reason());
    if (count == 0) return bytes;
    if (bytes.size() > SourceText::kMaxBytes) return cannot_read(path, "it is larger than 2 GiB");
  }
}

bool write_all(int descriptor, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t count = ::write(descriptor, bytes.data(), bytes.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return false;
    bytes.remove_prefix(static_cast<std::size_t>(count));
  }
  return true;
}

std::optional<Failure> write_standard_output(std::string_view bytes) {
  if (write_all(STDOUT_FILENO, bytes)) return std::nullopt;
  if (errno == EPIPE) {
    // `texbrdf print paper.tex | head` ends as every other program does.
    std::signal(SIGPIPE, SIG_DFL);
    std::raise(SIGPIPE);
  }
  return cannot_write("-", reason());
}

std::optional<Failure> write_in_place(const std::string& path, std::string_view bytes) {
  Descriptor file(::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666));
  if (!file.open() || !write_all(file.get(), bytes) || !file.close_now()) return cannot_write(path, reason());
  return std::nullopt;
}

/// The mode that open() would give a new file.
mode_t default_mode() {
  const mode_t mask = ::umask(0);
  ::umask(mask);
  return 0666 & ~mask;
}

std::string resolve_links(const std::string& path) {
  char* const resolved = ::realpath(path.c_str(), nullptr);
  std::string result = resolved ? resolved : path;
  std::free(resolved);
  return result;
}

}  // namespace

std::string input_name(const std::string& path) {
  return path == "-" ? "standard input" : path;
}

Result<std::string> read_input(const std::string& path) {
  if (path == "-") return read_all(STDIN_FILENO, path);
  const Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
  if (!file.open()) return cannot_read(path, reason());
  return read_all(file.get(), path);
}

std::optional<Failure> write_output(const std::string& path, std::string_view bytes) {
  if (path == "-") return write_standard_output(bytes);
  struct stat status{};
  const bool exists = ::stat(path.c_str(), &status) == 0;
  if (exists && !S_ISREG(status.st_mode)) return write_in_place(path, bytes);
  if (exists && ::access(path.c_str(), W_OK) != 0) return cannot_write(path, reason());

  const std::string target = resolve_links(path);
  std::string temporary = target + ".XXXXXX";
  Descriptor file(::mkostemp(temporary.data(), O_CLOEXEC));
  // A directory that takes no new files may still hold a writable one.
  if (!file.open()) return write_in_place(path, bytes);
  if (::fchmod(file.get(), exists ? status.st_mode & 07777 : default_mode()) == 0 && write_all(file.get(), bytes) &&
      file.close_now() && ::rename(temporary.c_str(), target.c_str()) == 0) {
    return std::nullopt;
  }
  Failure failure = cannot_write(path, reason());
  ::unlink(temporary.c_str());
  return failure;
}

}  // namespace texbrdf::cli
