#include "server/observe/log.h"

#include <spdlog/async.h>
#include <spdlog/async_logger.h>

#include <utility>
#include <vector>

#include "server/observe/log_sink.h"

namespace remeshd {

struct Log::Parts {
  std::shared_ptr<spdlog::details::thread_pool> thread;
  std::shared_ptr<LogSink> sink;
  std::shared_ptr<spdlog::async_logger> logger;
};

Log::Log(const LogOptions& options) : parts_(std::make_unique<Parts>()) {
  parts_->thread = std::make_shared<spdlog::details::thread_pool>(options.queue, 1);
  parts_->sink = std::make_shared<LogSink>(
      options.file, options.format == "json" ? make_json_format() : make_text_format(),
      [pool = parts_->thread.get()] { return pool->overrun_counter(); });
  parts_->logger = std::make_shared<spdlog::async_logger>(
      "remeshd", parts_->sink, parts_->thread, spdlog::async_overflow_policy::overrun_oldest);
  parts_->logger->set_level(spdlog::level::from_str(options.level));
}

Log::~Log() {
  // A thread that is blocked writing to a pipe cannot be joined: it is left running to the end of
  // the process, with its data. These stay reachable, so that no leak checker reports them.
  static std::vector<std::unique_ptr<Parts>>& left = *new std::vector<std::unique_ptr<Parts>>;
  if (!flush(std::chrono::seconds(1))) left.push_back(std::move(parts_));
}

std::shared_ptr<spdlog::logger> Log::logger() const { return parts_->logger; }

void Log::reopen() { parts_->sink->reopen(); }

bool Log::flush(std::chrono::milliseconds limit) {
  const std::uint64_t before = parts_->sink->flushes();
  parts_->logger->flush();
  return parts_->sink->wait_for_flush(before + 1, limit);
}

std::uint64_t Log::dropped() const { return parts_->sink->dropped(); }

}  // namespace remeshd
