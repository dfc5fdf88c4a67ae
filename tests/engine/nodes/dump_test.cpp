#include "engine/nodes/dump.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>

#include "engine/base/error.h"
#include "tests/support/temporary_folder.h"

namespace remeshd {
namespace {

using testing::HasSubstr;

Run dumping_to(const std::filesystem::path& folder) {
  Run run;
  run.dumps = folder;
  return run;
}

NodeSet one_copied_and_one_new_node() {
  NodeSet nodes;
  nodes.add_new({0.1, 0, 0});
  nodes.add_new({0, 1, 0});
  nodes.original[0] = 7;
  nodes.state[0] = NodeState::Fixed;
  return nodes;
}

TEST(Dump, WritesNodesWithWhatTheyAre) {
  const TemporaryFolder temporary;
  const std::filesystem::path folder = temporary / "run";
  dump_nodes(dumping_to(folder), "05-nodes", one_copied_and_one_new_node(), 2.5);

  std::ifstream in(folder / "05-nodes.vtu");
  const std::string text{std::istreambuf_iterator<char>(in), {}};
  EXPECT_THAT(text, HasSubstr("NumberOfPoints=\"2\" NumberOfCells=\"2\""));
  EXPECT_THAT(text, HasSubstr("Name=\"new\" NumberOfComponents=\"1\" format=\"ascii\">\n0\n1\n<"));
  EXPECT_THAT(text, HasSubstr("Name=\"free\" NumberOfComponents=\"1\" format=\"ascii\">\n0\n1\n<"));
  EXPECT_THAT(text,
              HasSubstr("Name=\"size\" NumberOfComponents=\"1\" format=\"ascii\">\n2.5\n2.5\n"));
  EXPECT_THAT(text, HasSubstr("0.10000000000000001 0 0\n0 1 0\n")) << "coordinates keep their bits";
}

TEST(Dump, DoesNothingWithoutAFolder) {
  EXPECT_NO_THROW(dump_nodes(dumping_to({}), "05-nodes", one_copied_and_one_new_node(), 2.5));
  EXPECT_FALSE(std::filesystem::exists("05-nodes.vtu"));
}

TEST(Dump, SaysWhereItCannotWrite) {
  const TemporaryFolder folder;
  EXPECT_THROW(dump_nodes(dumping_to(folder.path()), "no-such-folder/05-nodes",
                          one_copied_and_one_new_node(), 2.5),
               Error);
  std::ofstream(folder.path() / "file") << "no folder";
  EXPECT_THROW(dump_text(dumping_to(folder.path() / "file"), "04-plan", [] { return "plan"; }),
               Error);
}

}  // namespace
}  // namespace remeshd
