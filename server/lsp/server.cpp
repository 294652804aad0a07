#include "lsp/server.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>
#include <optional>
#include <string_view>
#include <utility>

#include "lsp/channel.h"
#include "lsp/client_process.h"
#include "lsp/dispatcher.h"
#include "lsp/fd_channel.h"
#include "lsp/framing.h"
#include "lsp/log_output.h"
#include "lsp/message_handler.h"
#include "lsp/message_queue.h"
#include "lsp/preview_site.h"
#include "lsp/session.h"

namespace texbrdf::lsp {
namespace {

/// How often it is checked that the client's process is still there.
constexpr int kProcessCheckMs = 1000;
/// A client that never pauses still gets its diagnostics after so many messages.
constexpr int kMaxMessagesBetweenPublications = 1000;
constexpr int kUnwritableLogStatus = 2;

/// Handles the messages of one client, one at a time, on the calling thread.
class Server {
 public:
  Server(Channel& channel, Log& log, const ServerOptions& options)
      : channel_(channel),
        log_(log),
        client_process_(options.process_alive ? options.process_alive : process_exists),
        queue_(channel, log),
        session_(log, client_process_, options.version, options.docs_url),
        handler_(session_, methods_, log, [&channel](std::string body) { channel.write(frame(std::move(body))); }) {
    session_.bind_methods(methods_);
    if (options.starts_threads) session_.connect_wake([&channel] { channel.wake(); });
    if (options.preview_port) serve_browsers(*options.preview_port);
  }

  int run();

 private:
  void serve_browsers(uint16_t port);
  int end_without_exit(std::string_view reason);

  Channel& channel_;
  Log& log_;
  ClientProcess client_process_;
  MessageQueue queue_;
  Session session_;
  Dispatcher methods_;
  MessageHandler handler_;
  std::optional<PreviewSite> site_;
  int messages_since_publication_ = 0;
};

/// Messages that are there already come before diagnostics, so that a burst of edits ends in few publications.
int Server::run() {
  while (session_.phase() != Session::Phase::Exited) {
    session_.send_frames();
    handler_.take_findings();
    const bool idle = queue_.empty() && !handler_.has_publications();
    if (idle) handler_.use_idle_time();
    const Channel::Status status = queue_.receive(idle ? kProcessCheckMs : 0);
    if (site_) site_->receive(queue_, session_);
    if (!handler_.has_publications()) messages_since_publication_ = 0;
    if (handler_.has_publications() &&
        (queue_.empty() || messages_since_publication_ >= kMaxMessagesBetweenPublications)) {
      handler_.publish_next();
    } else if (!queue_.empty()) {
      handler_.handle(queue_.pop());
      ++messages_since_publication_;
    } else if (status == Channel::Status::Closed) {
      return end_without_exit("the client closed the connection");
    } else if (status == Channel::Status::Idle && client_process_.is_gone()) {
      return end_without_exit("the client's process is gone");
    }
  }
  channel_.flush();
  log_.info(fmt::format("exit, status {}", session_.exit_status()));
  return session_.exit_status();
}

void Server::serve_browsers(uint16_t port) {
  auto site = PreviewSite::open(port, [this] { channel_.wake(); });
  if (!site) {
    log_.error(fmt::format("no preview for browsers: {}", site.error()));
    return session_.browsers().give_up(site.error());
  }
  site_.emplace(*std::move(site));
  site_->connect(session_, log_);
}

int Server::end_without_exit(std::string_view reason) {
  channel_.flush();
  if (queue_.inside_message()) log_.error("the input ends inside a message");
  log_.info(fmt::format("{}, status {}", reason, session_.exit_status()));
  return session_.exit_status();
}

}  // namespace

int run_server(Channel& channel, Log& log, const ServerOptions& options) {
  log.info(fmt::format("texbrdf {}, process {}", options.version, getpid()));
  return Server(channel, log, options).run();
}

int run_server(const ServerOptions& options) {
  std::optional<LogOutput> output = options.log_file.empty() ? LogOutput() : LogOutput::to_file(options.log_file);
  if (!output) {
    fmt::print(stderr, "{}: cannot be written\n", options.log_file);
    return kUnwritableLogStatus;
  }
  Log log(options.log_level, [&output](std::string_view line) { output->write(line); });
  FdChannel channel(options.input_fd, options.output_fd);
  return run_server(channel, log, options);
}

}  // namespace texbrdf::lsp
