#pragma once

namespace texbrdf::render {

/// The render worker's main loop: answers requests (render/protocol.h) from `in_fd` on `out_fd` until the other side is
/// gone. Returns the exit code of the process. Ends the process at once when the parent ends.
/// Standard output is lent to the protocol, so whatever a driver prints goes to standard error.
int run_render_worker(int in_fd, int out_fd);

}  // namespace texbrdf::render
