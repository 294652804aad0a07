#include "lsp/client_process.h"

#include <signal.h>

#include <cerrno>

namespace texbrdf::lsp {

bool process_exists(int64_t process_id) {
  return kill(static_cast<pid_t>(process_id), 0) == 0 || errno != ESRCH;
}

}  // namespace texbrdf::lsp
