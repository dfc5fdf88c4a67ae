#pragma once

#include <CLI/CLI.hpp>
#include <csignal>
#include <cstdio>
#include <exception>
#include <functional>
#include <string>
#include <utility>

namespace remeshd::test {

/// The command line of a program that measures against goals, and its end.
class LoadProgram {
 public:
  /// `goals`: set by `--goals`.
  LoadProgram(std::string what, bool& goals) : app_(std::move(what)) {
    app_.add_flag("--goals", goals, "goals for times and rates count too");
  }

  /// For further options.
  CLI::App& options() { return app_; }

  /// Reads the command line, then does `work`. Where nobody reads the output any more, the program
  /// goes on all the same: else its daemon would be left behind. Returns the exit status: what
  /// `work` returns, 1 after an exception, which is told.
  int run(int argc, char** argv, const std::function<int()>& work) {
    CLI11_PARSE(app_, argc, argv);
    std::signal(SIGPIPE, SIG_IGN);
    try {
      return work();
    } catch (const std::exception& failure) {
      std::fprintf(stderr, "failed: %s\n", failure.what());
      return 1;
    }
  }

 private:
  CLI::App app_;
};

}  // namespace remeshd::test
