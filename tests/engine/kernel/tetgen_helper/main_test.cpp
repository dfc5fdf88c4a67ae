#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <limits>

#include "engine/kernel/tetgen.h"
#include "engine/kernel/tetgen_protocol.h"
#include "tests/support/child_process.h"

namespace remeshd {
namespace {

using namespace kernel::tetgen_protocol;

/// Exit code of the helper that reads `request` from a file and writes its answer to `answer`.
int exit_code(const std::string& request, const std::string& answer) {
  const std::filesystem::path file =
      std::filesystem::temp_directory_path() / ("tetgen-request-" + std::to_string(::getpid()));
  std::ofstream(file, std::ios::binary) << request;
  const std::string command =
      kernel::find_tetgen_helper().string() + " 1000000000 5 < " + file.string() + " > " + answer;
  const auto end = test::run_child("/bin/sh", {"sh", "-c", command}, 60);
  std::filesystem::remove(file);
  EXPECT_EQ(end.signal, 0);
  return end.exit_code;
}

/// A request for the mesh of one point that is nowhere: it is answered, with its refusal.
std::string request_of_a_bad_number() {
  const RequestHeader header{.points = 1};
  const std::vector<double> point(3, std::numeric_limits<double>::quiet_NaN());
  return std::string(reinterpret_cast<const char*>(&header), sizeof header) +
         std::string(reinterpret_cast<const char*>(point.data()), 3 * sizeof(double));
}

constexpr int kBrokenStream = 3;

TEST(TetGenHelper, AnswersAWholeRequestAndSaysWhereOneIsCut) {
  const std::string whole = request_of_a_bad_number();
  EXPECT_EQ(exit_code(whole, "/dev/null"), 0);
  for (std::size_t size = 0; size < whole.size(); size += sizeof(double))
    EXPECT_EQ(exit_code(whole.substr(0, size), "/dev/null"), kBrokenStream) << size;
}

TEST(TetGenHelper, SaysWhereItsAnswerCannotBeWritten) {
  EXPECT_EQ(exit_code(request_of_a_bad_number(), "/dev/full"), kBrokenStream);
}

}  // namespace
}  // namespace remeshd
