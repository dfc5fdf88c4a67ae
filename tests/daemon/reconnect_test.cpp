#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <future>
#include <iterator>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "remeshd/client.h"
#include "tests/daemon/process.h"

namespace remeshd::test {
namespace {

namespace fs = std::filesystem;
using client::Client;
using client::EditStream;
using client::MeshWanted;

/// A daemon that is killed and started anew at the same address, with the same store.
class Reconnect : public testing::Test {
 protected:
  Reconnect() { start(); }
  ~Reconnect() override {
    process_.reset();
    fs::remove_all(folder_);
  }
  void start() {
    process_ = std::make_unique<Process>(std::vector<std::string>{
        "--listen", address(), "--store", (folder_ / "store").string(), "--threads", "1"});
    EXPECT_NE(process_->address(), "");
  }
  void kill() {
    process_->signal(SIGKILL);
    process_->wait();
  }
  [[nodiscard]] std::string address() const { return "unix:" + (folder_ / "socket").string(); }

  static v1::CreateRevisionRequest simple() {
    v1::CreateRevisionRequest request;
    std::ifstream in(std::string(REMESHD_CASES_DIR) + "/simple-a.json");
    request.set_document(std::string(std::istreambuf_iterator<char>(in), {}));
    request.set_design("simple");
    request.mutable_options()->set_nodes(300);
    return request;
  }
  static v1::EditRevisionRequest moved(int step) {
    v1::EditRevisionRequest request;
    request.set_document("{\"edits\": [{\"setParameter\": {\"name\": \"top_x\", \"value\": " +
                         std::to_string(5 + 0.25 * step) + "}}]}");
    return request;
  }

  const fs::path folder_ = [] {
    const fs::path folder =
        fs::temp_directory_path() / ("remeshd-reconnect-" + std::to_string(::getpid()));
    fs::remove_all(folder);
    fs::create_directory(folder);
    return folder;
  }();
  std::unique_ptr<Process> process_;
};

TEST_F(Reconnect, AStreamGoesOnAndNothingIsDoneTwice) {
  constexpr int kEdits = 24;
  const Client client = Client::connect(address());
  EditStream stream = client.stream();
  std::vector<EditStream::Answers> answers;
  answers.push_back(stream.create(simple(), MeshWanted{.delta = true}));
  for (int k = 0; k < kEdits; ++k)
    answers.push_back(stream.edit(moved(k), MeshWanted{.delta = true}));
  for (const std::size_t answered : {1U, 9U}) {
    answers[answered].result.wait();
    kill();
    start();
  }
  answers.back().result.wait();  // once it came, the client's other calls find the daemon too
  std::string parent;
  for (std::size_t k = 0; k < answers.size(); ++k) {
    const auto result = answers[k].result.get();
    EXPECT_EQ(result.revision().parent(), parent) << k;
    EXPECT_EQ(result.revision().number(), k + 1);
    EXPECT_FALSE(result.head_conflict()) << k;
    parent = result.revision().id();
    const auto mesh = answers[k].mesh.get();
    EXPECT_EQ(mesh->revision, parent);
    EXPECT_TRUE(*mesh == client.get_mesh(parent)) << k;
  }
  stream.finish();
  EXPECT_EQ(client.log("simple").size(), answers.size());
}

TEST_F(Reconnect, AStreamThatWasIdleGoesOnFromItsLastResult) {
  const Client client = Client::connect(address());
  EditStream stream = client.stream();
  const std::string first = stream.create(simple()).get().revision().id();
  kill();
  start();
  EXPECT_EQ(stream.edit(moved(1)).get().revision().parent(), first);
  stream.finish();
}

TEST_F(Reconnect, WhatIsReadWhileTheDaemonIsAwayComesOnceItIsBack) {
  const Client client = Client::connect(address());
  const std::string first = client.create_revision(simple()).revision().id();
  kill();
  auto revision = std::async(std::launch::async, [&] { return client.get_revision(first); });
  auto mesh = std::async(std::launch::async, [&] { return client.get_mesh(first); });
  std::this_thread::sleep_for(std::chrono::milliseconds(300));
  start();
  EXPECT_EQ(revision.get().revision().id(), first);
  EXPECT_EQ(mesh.get().revision, first);
}

TEST_F(Reconnect, ADaemonThatNeverAnsweredIsNotWaitedFor) {
  kill();
  const Client client = Client::connect(address());
  client::CallOptions options;
  options.reconnect = 3600;
  EXPECT_THROW((void)client.info(options), client::CallError);
}

TEST_F(Reconnect, AStreamWhoseDaemonStaysAwayEndsWithItsError) {
  const Client client = Client::connect(address());
  client::CallOptions options;
  options.reconnect = 0.5;
  EditStream stream = client.stream({}, options);
  (void)stream.create(simple()).get();
  kill();
  EXPECT_THROW(stream.edit(moved(1)).get(), client::CallError);
}

}  // namespace
}  // namespace remeshd::test
