#include "render/child_process.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <string_view>
#include <thread>
#include <utility>

namespace texbrdf::render {

namespace {

using namespace std::chrono_literals;

constexpr auto kPatience = 3s;  ///< with a process that is dead already: giving back gigabytes takes a while
constexpr auto kLook = 1ms;

std::string_view name_of(std::string_view assignment) {
  return assignment.substr(0, assignment.find('='));
}

/// `first`, then what of this process's own environment it does not name.
std::vector<std::string> merged_environment(const std::vector<std::string>& first) {
  std::vector<std::string> merged = first;
  for (char** entry = environ; entry != nullptr && *entry != nullptr; ++entry) {
    const bool named = std::any_of(first.begin(), first.end(), [entry](const std::string& assignment) {
      return name_of(assignment) == name_of(*entry);
    });
    if (!named) merged.emplace_back(*entry);
  }
  return merged;
}

std::vector<char*> pointers(std::vector<std::string>& texts) {
  std::vector<char*> result;
  for (std::string& text : texts) result.push_back(text.data());
  result.push_back(nullptr);
  return result;
}

/// posix_spawn's helper objects, freed in every case.
class SpawnPlan {
 public:
  explicit SpawnPlan(int child_socket) {
    posix_spawn_file_actions_init(&actions_);
    posix_spawn_file_actions_adddup2(&actions_, child_socket, STDIN_FILENO);
    posix_spawn_file_actions_adddup2(&actions_, child_socket, STDOUT_FILENO);
    posix_spawnattr_init(&attributes_);
    // The child begins as if nobody had blocked or ignored a signal.
    sigset_t none;
    sigset_t changed;
    sigemptyset(&none);
    sigemptyset(&changed);
    sigaddset(&changed, SIGPIPE);
    posix_spawnattr_setsigmask(&attributes_, &none);
    posix_spawnattr_setsigdefault(&attributes_, &changed);
    posix_spawnattr_setflags(&attributes_, POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF);
  }
  ~SpawnPlan() {
    posix_spawnattr_destroy(&attributes_);
    posix_spawn_file_actions_destroy(&actions_);
  }
  SpawnPlan(const SpawnPlan&) = delete;
  SpawnPlan& operator=(const SpawnPlan&) = delete;

  int spawn(pid_t& process, const std::string& executable, char** arguments, char** environment) {
    return posix_spawn(&process, executable.c_str(), &actions_, &attributes_, arguments, environment);
  }

 private:
  posix_spawn_file_actions_t actions_;
  posix_spawnattr_t attributes_;
};

}  // namespace

Result<ChildProcess> ChildProcess::start(const std::string& executable, const std::vector<std::string>& arguments,
                                         const std::vector<std::string>& environment) {
  std::array<int, 2> sockets{};
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, sockets.data()) != 0) {
    return Failure{fmt::format("no socket for the render worker: {}", std::strerror(errno))};
  }
  const auto [ours, theirs] = sockets;
  std::vector<std::string> words{executable};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<std::string> variables = merged_environment(environment);
  pid_t process = -1;
  const int error = SpawnPlan(theirs).spawn(process, executable, pointers(words).data(), pointers(variables).data());
  close(theirs);
  if (error != 0) {
    close(ours);
    return Failure{fmt::format("cannot start the render worker {}: {}", executable, std::strerror(error))};
  }
  fcntl(ours, F_SETFL, fcntl(ours, F_GETFL) | O_NONBLOCK);
  return ChildProcess(process, ours);
}

ChildProcess::ChildProcess(ChildProcess&& other) noexcept
    : process_(std::exchange(other.process_, -1)),
      socket_(std::exchange(other.socket_, -1)),
      reaped_(std::exchange(other.reaped_, true)),
      status_(other.status_) {}

ChildProcess& ChildProcess::operator=(ChildProcess&& other) noexcept {
  std::swap(process_, other.process_);
  std::swap(socket_, other.socket_);
  std::swap(reaped_, other.reaped_);
  std::swap(status_, other.status_);
  return *this;
}

ChildProcess::~ChildProcess() {
  if (process_ > 0) finish();
}

bool ChildProcess::has_ended() {
  if (reaped_) return true;
  const pid_t result = waitpid(process_, &status_, WNOHANG);
  reaped_ = result == process_ || (result < 0 && errno == ECHILD);
  return reaped_;
}

bool ChildProcess::wait_briefly() {
  const auto until = std::chrono::steady_clock::now() + kPatience;
  while (!has_ended()) {
    if (std::chrono::steady_clock::now() > until) return false;
    std::this_thread::sleep_for(kLook);
  }
  return true;
}

void ChildProcess::close_socket() {
  if (socket_ >= 0) close(std::exchange(socket_, -1));
}

std::string ChildProcess::finish() {
  // In this order: a worker whose socket is closed ends by itself, and what it says of its end would be chance.
  if (!has_ended()) kill(process_, SIGKILL);
  close_socket();
  if (!wait_briefly()) return "was killed, but does not end";
  if (WIFSIGNALED(status_)) {
    const int signal = WTERMSIG(status_);
    return fmt::format("was killed by signal {} ({})", signal, strsignal(signal));
  }
  return fmt::format("ended with code {}", WEXITSTATUS(status_));
}

}  // namespace texbrdf::render
