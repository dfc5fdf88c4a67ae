#include "client/cli/console.h"

#include <algorithm>
#include <cmath>

namespace remeshd::cli {
namespace {

constexpr int kBarWidth = 30;

std::string label(const remesh::v1::Progress& progress) {
  std::string text = progress.stage();
  if (progress.iteration() > 0) text += " " + std::to_string(progress.iteration());
  return text;
}

int percent(const remesh::v1::Progress& progress) {
  return static_cast<int>(std::lround(100 * std::clamp(progress.fraction(), 0.0, 1.0)));
}

}  // namespace

void Console::error(const std::string& text) {
  const std::lock_guard lock(mutex_);
  write("remesh: " + text);
}

void Console::note(const std::string& text) {
  const std::lock_guard lock(mutex_);
  if (verbosity_ != Verbosity::Quiet) write(text);
}

void Console::text(const std::string& lines) {
  const std::lock_guard lock(mutex_);
  if (verbosity_ == Verbosity::Quiet) return;
  clear_bar();
  err_ << lines << std::flush;
}

void Console::detail(const std::string& text) {
  const std::lock_guard lock(mutex_);
  if (verbosity_ == Verbosity::Verbose) write(text);
}

void Console::progress(const remesh::v1::Progress& progress) {
  const std::lock_guard lock(mutex_);
  if (verbosity_ == Verbosity::Quiet) return;
  const int done = percent(progress);
  if (terminal_) {
    const int filled = done * kBarWidth / 100;
    err_ << "\r\033[K[" << std::string(static_cast<std::size_t>(filled), '#')
         << std::string(static_cast<std::size_t>(kBarWidth - filled), '.') << "] " << done << " % "
         << label(progress) << std::flush;
    bar_shown_ = true;
    return;
  }
  if (verbosity_ != Verbosity::Verbose) return;
  if (progress.stage() == last_stage_ && done / 10 == last_tenth_) return;
  last_stage_ = progress.stage();
  last_tenth_ = done / 10;
  write(std::to_string(done) + " % " + label(progress));
}

void Console::end_progress() {
  const std::lock_guard lock(mutex_);
  clear_bar();
  last_stage_.clear();
  last_tenth_ = -1;
}

void Console::write(const std::string& text) {
  clear_bar();
  err_ << text << '\n' << std::flush;
}

void Console::clear_bar() {
  if (bar_shown_) err_ << "\r\033[K" << std::flush;
  bar_shown_ = false;
}

}  // namespace remeshd::cli
