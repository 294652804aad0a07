#pragma once

#include <sys/types.h>

#include <string>
#include <vector>

#include "source/result.h"

namespace texbrdf::render {

/// A program running at the other end of a socket, which is its standard input and output. Killed and reaped when the
/// object goes; nothing here blocks longer than half a second.
class ChildProcess {
 public:
  /// `environment` ("NAME=value") comes beside this process's own and before it.
  static Result<ChildProcess> start(const std::string& executable, const std::vector<std::string>& arguments,
                                    const std::vector<std::string>& environment);
  ChildProcess(ChildProcess&& other) noexcept;
  ChildProcess& operator=(ChildProcess&& other) noexcept;
  ~ChildProcess();

  /// Does not block: reads and writes are to be polled for.
  int socket() const { return socket_; }
  pid_t process_id() const { return process_; }
  bool has_ended();
  /// Kills it where it still runs, and says how it ended: "was killed by signal 9 (Killed)", "ended with code 3".
  std::string finish();

 private:
  ChildProcess(pid_t process, int socket) : process_(process), socket_(socket) {}
  bool wait_briefly();
  void close_socket();

  pid_t process_ = -1;
  int socket_ = -1;
  bool reaped_ = false;
  int status_ = 0;
};

}  // namespace texbrdf::render
