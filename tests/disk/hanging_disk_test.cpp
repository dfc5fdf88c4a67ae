#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <future>
#include <mutex>
#include <thread>
#include <vector>

#include "server/limits.h"
#include "tests/disk/file_calls.h"
#include "tests/server/daemon_fixture.h"

namespace remeshd::test {
namespace {

using namespace std::chrono_literals;

/// A daemon on whose disk every sync takes until it is let go.
class HangingDisk : public DaemonTest {
 protected:
  void SetUp() override {
    use_store();
    std::filesystem::create_directory(options_.store);
    calls_ = std::make_unique<FileCalls>(options_.store);
    create(plate());
    edit("plate", set("at", 11));
    calls_->before_syncing([this](const std::string& /*path*/) {
      std::unique_lock lock(mutex_);
      ++hanging_;
      changed_.notify_all();
      changed_.wait(lock, [&] { return released_; });
    });
  }
  void TearDown() override {
    let_go();
    stop();
    calls_.reset();
  }
  void let_go() {
    const std::scoped_lock lock(mutex_);
    released_ = true;
    changed_.notify_all();
  }
  void wait_until_it_hangs() {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] { return hanging_ > 0; });
  }
  /// Has calls that wait for the disk made, more than there are threads for any lane.
  void have_calls_wait() {
    for (int n = 0; n < 4 * limits::kPreparationThreads; ++n)
      waiting_.push_back(std::async(std::launch::async, [this, n] {
        if (n % 2 == 0) return remove("plate@1", false);
        grpc::ClientContext context;
        v1::SetHeadRequest request;
        request.set_revision(n % 4 == 1 ? "plate@1" : "plate@2");
        v1::SetHeadResponse reply;
        return stub_->SetHead(&context, request, &reply);
      }));
    wait_until_it_hangs();
    std::this_thread::sleep_for(100ms);  // and the others for their turn
  }

  std::mutex mutex_;
  std::condition_variable changed_;
  int hanging_ = 0;
  bool released_ = false;
  std::unique_ptr<FileCalls> calls_;
  std::vector<std::future<grpc::Status>> waiting_;
};

TEST_F(HangingDisk, HoldsUpNeitherMetadataNorHealth) {
  have_calls_wait();
  auto others = std::async(std::launch::async, [&] {
    double longest = 0;
    for (int n = 0; n < 100; ++n) {
      const auto start = std::chrono::steady_clock::now();
      std::string reply;
      EXPECT_TRUE(call("/grpc.health.v1.Health/Check", "", &reply).ok());
      EXPECT_TRUE(info().load().persistent());
      EXPECT_GE(list("plate").revisions_size(), 1);
      const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - start;
      longest = std::max(longest, spent.count());
    }
    return longest;
  });
  const bool answered = others.wait_for(30s) == std::future_status::ready;
  let_go();
  EXPECT_TRUE(answered);
  RecordProperty("longest_ms", std::to_string(1000 * others.get()));
  for (auto& each : waiting_) each.get();
}

}  // namespace
}  // namespace remeshd::test
