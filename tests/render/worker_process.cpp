#include <unistd.h>

#include "render/worker.h"

/// The render worker by itself, so that these tests need no command line.
int main() {
  return texbrdf::render::run_render_worker(STDIN_FILENO, STDOUT_FILENO);
}
