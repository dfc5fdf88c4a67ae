#pragma once

#include <mutex>
#include <ostream>
#include <string>

#include "remesh/v1/remesh.pb.h"

namespace remeshd::cli {

enum class Verbosity { Quiet, Normal, Verbose };

/// The stream of messages: notes, warnings, errors and progress. On a terminal progress is a bar
/// that is redrawn in one line; elsewhere, and only with -v, it is a plain line for each stage and
/// tenth of the way. May be used from several threads.
class Console {
 public:
  Console(std::ostream& err, bool terminal) : err_(err), terminal_(terminal) {}

  void set_verbosity(Verbosity verbosity) { verbosity_ = verbosity; }
  [[nodiscard]] bool verbose() const { return verbosity_ == Verbosity::Verbose; }

  void error(const std::string& text);
  /// One line; nothing if quiet.
  void note(const std::string& text);
  /// Lines with their line ends; nothing if quiet.
  void text(const std::string& lines);
  /// One line, with -v only.
  void detail(const std::string& text);
  void progress(const remesh::v1::Progress& progress);
  /// Takes the bar away, so that what follows starts on a line of its own.
  void end_progress();

 private:
  void write(const std::string& text);
  void clear_bar();

  std::mutex mutex_;
  std::ostream& err_;
  bool terminal_;
  Verbosity verbosity_ = Verbosity::Normal;
  bool bar_shown_ = false;
  std::string last_stage_;
  int last_tenth_ = -1;
};

}  // namespace remeshd::cli
