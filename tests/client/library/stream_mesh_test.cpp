#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <memory>
#include <thread>

#include "remeshd/client.h"
#include "tests/client/fake_daemon.h"

namespace remeshd::client {
namespace {

using remesh::v1::Error;
using testing::SizeIs;

/// The sample mesh and two edits of it, each of which moves a node.
std::vector<Mesh> chain() {
  std::vector<Mesh> meshes(3, sample_mesh(2));
  for (std::size_t k = 0; k < meshes.size(); ++k) {
    meshes[k].revision = "rev-" + std::to_string(k + 1);
    if (k > 0) meshes[k].parent = meshes[k - 1].revision;
    for (std::size_t moved = 0; moved < k; ++moved) meshes[k].nodes[moved][0] += 0.125;
  }
  return meshes;
}

remesh::v1::EditRevisionRequest edit_of(const std::string& base) {
  remesh::v1::EditRevisionRequest request;
  request.set_base(base);
  return request;
}

template <class Future>
Error error_of(Future& future) {
  try {
    (void)future.get();
  } catch (const CallError& e) {
    return e.detail();
  }
  return {};
}

TEST(StreamMesh, ComesBehindItsResult) {
  FakeDaemon daemon;
  daemon.service.stream_meshes = chain();
  EditStream stream = Client::connect(daemon.address).stream();
  auto first = stream.create({}, MeshWanted{});
  auto second = stream.edit(edit_of(""), MeshWanted{});
  auto third = stream.edit(edit_of(""));
  EXPECT_EQ(first.result.get().revision().id(), "rev-1");
  EXPECT_EQ(*first.mesh.get(), daemon.service.stream_meshes[0]);
  EXPECT_EQ(*second.mesh.get(), daemon.service.stream_meshes[1]);
  EXPECT_EQ(third.get().revision().id(), "rev-3");
  stream.finish();
  ASSERT_THAT(daemon.service.requests, SizeIs(3));
  EXPECT_TRUE(daemon.service.requests[1].has_mesh());
  EXPECT_FALSE(daemon.service.requests[2].has_mesh()) << "none was asked for";
}

TEST(StreamMesh, IsRebuiltFromItsDifferenceFromTheOneBefore) {
  FakeDaemon daemon;
  daemon.service.stream_meshes = chain();
  std::size_t sent = 0;
  daemon.service.damage = [&](auto& messages) {  // only looks
    sent = 0;
    for (const auto& message : messages) sent += message.ByteSizeLong();
  };
  EditStream stream = Client::connect(daemon.address).stream();
  std::vector<EditStream::Answers> answers;
  answers.push_back(stream.create({}, {.delta = true}));
  for (int k = 0; k < 2; ++k) answers.push_back(stream.edit(edit_of(""), {.delta = true}));
  for (std::size_t k = 0; k < 3; ++k)
    EXPECT_EQ(*answers[k].mesh.get(), daemon.service.stream_meshes[k]) << k;
  stream.finish();
  std::size_t whole = 0;
  for (const auto& message : mesh_messages(daemon.service.stream_meshes[2]))
    whole += message.ByteSizeLong();
  EXPECT_LT(sent, whole / 3);
}

TEST(StreamMesh, IsRebuiltFromAMeshOfTheCaller) {
  FakeDaemon daemon;
  daemon.service.stream_meshes = chain();
  EditStream stream = Client::connect(daemon.address).stream();
  stream.create({}).get();
  const auto base = std::make_shared<const Mesh>(daemon.service.stream_meshes[0]);
  auto answers = stream.edit(edit_of("rev-1"), {.delta = true, .base = base});
  EXPECT_EQ(*answers.mesh.get(), daemon.service.stream_meshes[1]);
}

TEST(StreamMesh, ThatIsDamagedLeavesTheResultAndTheStream) {
  FakeDaemon daemon;
  daemon.service.damage = [](auto& messages) { messages[1].mutable_part()->set_crc32c(1); };
  EditStream stream = Client::connect(daemon.address).stream();
  auto answers = stream.edit(edit_of("a"), MeshWanted{});
  auto next = stream.edit(edit_of("b"));
  EXPECT_EQ(answers.result.get().revision().id(), "rev-1");
  EXPECT_EQ(error_of(answers.mesh).reason(), Error::MESH_DAMAGED);
  EXPECT_EQ(next.get().revision().id(), "rev-2");
}

TEST(StreamMesh, ThatCannotBeSentLeavesTheResult) {
  FakeDaemon daemon;
  daemon.service.mesh_errors[0] = make_error(Error::CODE_RESOURCE_EXHAUSTED, Error::OUT_OF_MEMORY);
  EditStream stream = Client::connect(daemon.address).stream();
  auto answers = stream.edit(edit_of("a"), MeshWanted{});
  EXPECT_EQ(answers.result.get().revision().id(), "rev-1");
  EXPECT_EQ(error_of(answers.mesh).reason(), Error::OUT_OF_MEMORY);
}

TEST(StreamMesh, HasTheErrorOfItsRequest) {
  FakeDaemon daemon;
  daemon.service.stream_errors[0] = make_error(Error::CODE_UNIMPLEMENTED, Error::UNSUPPORTED);
  EditStream stream = Client::connect(daemon.address).stream();
  auto answers = stream.edit(edit_of("a"), MeshWanted{});
  EXPECT_EQ(error_of(answers.result).reason(), Error::UNSUPPORTED);
  EXPECT_EQ(error_of(answers.mesh).reason(), Error::UNSUPPORTED);
}

TEST(StreamMesh, HasTheErrorThatBrokeTheStream) {
  FakeDaemon daemon;
  daemon.service.hanging = {0};
  EditStream stream = Client::connect(daemon.address).stream();
  auto answers = stream.edit(edit_of("a"), MeshWanted{});
  stream.cancel_all();
  EXPECT_EQ(error_of(answers.result).code(), Error::CODE_CANCELLED);
  EXPECT_EQ(error_of(answers.mesh).code(), Error::CODE_CANCELLED);
}

TEST(EditStream, ThatIsCancelledWhileItWaitsForADaemonCancelsItsRequests) {
  auto daemon = std::make_unique<FakeDaemon>();
  EditStream stream = Client::connect(daemon->address).stream();
  EXPECT_NO_THROW(stream.edit(edit_of("a")).get());
  daemon.reset();
  auto waiting = stream.edit(edit_of("a@1"));
  std::this_thread::sleep_for(std::chrono::milliseconds(200));
  stream.cancel_all();
  EXPECT_EQ(error_of(waiting).code(), Error::CODE_CANCELLED);
}

TEST(EditStream, TakesAnIdAgainOnceItsRequestIsAnswered) {
  FakeDaemon daemon;
  EditStream stream = Client::connect(daemon.address).stream();
  for (int k = 0; k < 200; ++k) {
    auto request = edit_of("a");
    request.set_request_id("same");
    EXPECT_NO_THROW(stream.edit(std::move(request)).get());
  }
}

}  // namespace
}  // namespace remeshd::client
