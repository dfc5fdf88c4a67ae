#pragma once

#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "client/cli/exit_code.h"
#include "client/cli/run.h"
#include "tests/client/fake_daemon.h"
#include "tests/support/temporary_folder.h"

namespace remeshd::cli {

inline const std::string kCases = REMESHD_CASES_DIR;

/// Runs commands in this process, against a daemon of the test's making.
class Cli : public testing::Test {
 protected:
  int run(const std::vector<std::string>& arguments) {
    out_.str("");
    return run(arguments, out_);
  }
  int run(const std::vector<std::string>& arguments, std::ostream& out) {
    err_.str("");
    return cli::run(arguments, {.in = in_,
                                .out = out,
                                .err = err_,
                                .terminal = false,
                                .stop = stop_.get_token(),
                                .connect = [this](const GlobalOptions& options) {
                                  seen_ = options;
                                  return client::Client::connect(daemon_.address);
                                }});
  }

  [[nodiscard]] nlohmann::json read_json(const std::string& name) const {
    return nlohmann::json::parse(std::ifstream(folder_ / name));
  }
  std::string file(const std::string& name) { return (folder_ / name).string(); }
  [[nodiscard]] std::vector<std::vector<std::string>> rows() const {
    std::vector<std::vector<std::string>> rows;
    std::istringstream text(out_.str());
    std::string line;
    while (std::getline(text, line)) {
      auto& row = rows.emplace_back();
      std::istringstream cells(line + "\t");
      std::string cell;
      while (std::getline(cells, cell, '\t')) row.push_back(cell);
    }
    return rows;
  }

  TemporaryFolder folder_;
  client::FakeDaemon daemon_;
  client::FakeService& service_ = daemon_.service;
  GlobalOptions seen_;
  std::stop_source stop_;
  std::istringstream in_;
  std::ostringstream out_, err_;
};

}  // namespace remeshd::cli
