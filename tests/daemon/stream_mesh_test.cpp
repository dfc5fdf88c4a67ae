#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <memory>
#include <string>
#include <vector>

#include "remeshd/client.h"
#include "tests/server/daemon_fixture.h"

namespace remeshd::test {
namespace {

using client::Client;
using client::EditStream;
using client::MeshWanted;

v1::CreateRevisionRequest tool() {
  v1::CreateRevisionRequest request;
  std::ifstream in(std::string(REMESHD_CASES_DIR) + "/tool1-a.json");
  request.set_document(std::string(std::istreambuf_iterator<char>(in), {}));
  request.mutable_options()->set_nodes(4000);
  return request;
}

v1::EditRevisionRequest pins(double radius) {
  v1::EditRevisionRequest request;
  request.set_document("{\"edits\": [{\"setParameter\": {\"name\": \"pin_radius\", \"value\": " +
                       std::to_string(radius) + "}}]}");
  return request;
}

/// Meshes in a stream, by the engine that meshes and the client library.
class StreamedMeshes : public testing::Test {
 protected:
  StreamedMeshes()
      : daemon_(options(), production_engine()), client_(daemon_.in_process_channel()) {}

  static DaemonOptions options() {
    DaemonOptions options;
    options.listen = {};
    options.workers = 2;
    return options;
  }
  /// Bytes of the data of a mesh, as sent.
  std::uint64_t sent(const std::string& revision, const MeshWanted& wanted) {
    std::uint64_t bytes = 0;
    const auto mesh = client_.get_mesh(
        revision, {}, [&](std::uint64_t /*done*/, std::uint64_t total) { bytes = total; }, wanted);
    return bytes;
  }

  Daemon daemon_;
  Client client_;
};

TEST_F(StreamedMeshes, ComeAsDifferencesAndAreTheSameToTheBit) {
  EditStream stream = client_.stream();
  std::vector<EditStream::Answers> answers;
  answers.push_back(stream.create(tool(), MeshWanted{.delta = true}));
  for (const double radius : {4.1, 4.2, 3.9})
    answers.push_back(stream.edit(pins(radius), MeshWanted{.delta = true}));
  for (auto& answer : answers) {
    const std::string id = answer.result.get().revision().id();
    EXPECT_TRUE(*answer.mesh.get() == client_.get_mesh(id)) << id;
  }
  stream.finish();
}

TEST_F(StreamedMeshes, OfSecondOrderComeAsDifferencesToo) {
  auto first = tool();
  first.mutable_options()->set_order(2);
  EditStream stream = client_.stream();
  std::vector<EditStream::Answers> answers;
  answers.push_back(stream.create(first, MeshWanted{.delta = true}));
  answers.push_back(stream.edit(pins(4.1), MeshWanted{.delta = true}));
  auto linear = pins(4.2);
  linear.mutable_options()->set_order(1);
  answers.push_back(stream.edit(linear, MeshWanted{.delta = true}));
  std::vector<std::size_t> mids;
  for (auto& answer : answers) {
    const v1::RevisionResult result = answer.result.get();
    const auto mesh = answer.mesh.get();
    EXPECT_TRUE(*mesh == client_.get_mesh(result.revision().id()));
    EXPECT_EQ(mesh->mid_nodes.size(), result.report().mid_nodes());
    EXPECT_EQ(mesh->tet_mids.size(), mesh->mid_nodes.empty() ? 0 : mesh->tets.size());
    mids.push_back(mesh->mid_nodes.size());
  }
  stream.finish();
  EXPECT_GT(mids[0], 20000U);
  EXPECT_GT(mids[1], 20000U) << "an edit inherits the order";
  EXPECT_EQ(mids[2], 0U);
}

TEST_F(StreamedMeshes, OfSecondOrderHaveTheSameCorners) {
  auto quadratic = tool();
  quadratic.mutable_options()->set_order(2);
  EditStream stream = client_.stream();
  const auto one = stream.create(tool(), MeshWanted{}).mesh.get();
  const auto two = stream.create(quadratic, MeshWanted{}).mesh.get();
  stream.finish();
  EXPECT_NE(one->revision, two->revision);
  EXPECT_EQ(one->nodes, two->nodes);
  EXPECT_EQ(one->tets, two->tets);
}

TEST_F(StreamedMeshes, AreShortWhereLittleChanged) {
  EditStream stream = client_.stream();
  auto first = stream.create(tool(), MeshWanted{});
  const std::string changed = stream.edit(pins(4.02)).get().revision().id();
  const auto base = first.mesh.get();
  const std::uint64_t whole = sent(changed, {});
  const std::uint64_t delta = sent(changed, {.delta = true, .base = base});
  RecordProperty("share", std::to_string(1.0 * delta / whole));
  EXPECT_LT(delta, whole / 2);
  EXPECT_GT(whole, 500000U);
}

TEST_F(StreamedMeshes, ComeWholeWhereTheParentIsGone) {
  EditStream stream = client_.stream();
  const std::string first = stream.create(tool()).get().revision().id();
  const std::string second = stream.edit(pins(4.1)).get().revision().id();
  client_.delete_revision(first);
  EXPECT_TRUE(client_.get_mesh(second, {}, {}, {.delta = true}) == client_.get_mesh(second));
}

}  // namespace
}  // namespace remeshd::test
