#include "server/session/tenants.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <memory>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "tests/server/fake_engine.h"
#include "tests/server/session/answer.h"
#include "tests/server/session/store_folder.h"
#include "tests/support/cases.h"
#include "tests/support/expect_error.h"
#include "tests/support/run.h"

namespace remeshd::test {
namespace {

using namespace std::chrono_literals;

CreateCommand plate(double dx, const std::string& design = "plate") {
  return {.source = model_of({block("plate", dx, 40, 10)}),
          .options = {.nodes = 100},
          .design = design};
}

/// The tenants `anna` and `ben`, with stores.
class TenantsTest : public testing::Test {
 protected:
  ~TenantsTest() override { fake_.open_gate(); }

  void start(SessionLimits limits = {}, bool stored = true) {
    tenants_.reset();  // which has the stores
    tenants_ =
        std::make_unique<Tenants>(fake_.engine(), limits, [=, this](const std::string& name) {
          if (name == "damaged") throw std::runtime_error("no store");
          return stored ? std::make_unique<Store>(folder_.path() / "tenants" / name)
                        : std::make_unique<Store>();
        });
    for (const char* name : {"anna", "ben"}) tenants_->open(name);
  }
  Session& anna() { return tenants_->of("anna"); }
  Session& ben() { return tenants_->of("ben"); }
  static Made made(Session& session, const CreateCommand& command) {
    Answer answer;
    session.make(command, answer.listener());
    return answer.made();
  }
  template <typename Condition>
  static bool comes(Condition&& condition) {
    for (int k = 0; k < 10000 && !condition(); ++k) std::this_thread::sleep_for(1ms);
    return condition();
  }
  static std::vector<std::string> designs(Session& session) {
    std::vector<std::string> names;
    for (const DesignRecord& design : session.designs({}, {})) names.push_back(design.name);
    return names;
  }

  FakeEngine fake_;
  StoreFolder folder_;
  std::unique_ptr<Tenants> tenants_;
};

TEST_F(TenantsTest, OneDoesNotFindWhatTheOtherHas) {
  start();
  const std::string id = made(anna(), plate(80)).filed.record.id;
  for (const std::string& name : {id, id.substr(0, 12), std::string("plate"), id.substr(0, 8)})
    EXPECT_EQ(error_of([&] { ben().resolve(name); }).kind, ErrorKind::NotFound) << name;
  EXPECT_EQ(error_of([&] { ben().recipe_of_ancestor(id); }).reason, "REVISION_NOT_FOUND");
  EXPECT_EQ(error_of([&] { ben().get(id, kRun); }).reason, "REVISION_NOT_FOUND");
  EXPECT_TRUE(ben().list({}, {}).empty());
  EXPECT_TRUE(ben().cache().cache_entries().empty());
  EXPECT_EQ(ben().load().held, 0U);
  EXPECT_EQ(ben().load().disk_bytes, 0U);
  EXPECT_EQ(anna().get(id, kRun)->record.id, id);
}

TEST_F(TenantsTest, BothMayMakeTheSameModelUnderTheSameNamesAndEachPaysForIt) {
  start();
  const Made of_anna = made(anna(), plate(80)), of_ben = made(ben(), plate(80));
  EXPECT_EQ(of_ben.filed.record.id, of_anna.filed.record.id);
  EXPECT_FALSE(of_ben.cached);
  EXPECT_EQ(fake_.made(), 2);
  ben().remove("plate@1", true);
  EXPECT_EQ(anna().get("plate@1", kRun), of_anna.revision);
}

TEST_F(TenantsTest, RequestsOfTwoForTheSameModelAreTwoComputations) {
  start({.workers = 2});
  fake_.close_gate();
  Answer first, second;
  anna().make(plate(80), first.listener());
  ben().make(plate(80), second.listener());
  EXPECT_TRUE(fake_.wait_at_gate(2));
  EXPECT_EQ(anna().load().running, 2U) << "the lane is that of all";
  EXPECT_EQ(anna().load().waiting, 1U);
  fake_.open_gate();
  EXPECT_TRUE(first.made().revision);
  EXPECT_TRUE(second.made().revision);
}

TEST_F(TenantsTest, BothFindTheirOwnAfterARestart) {
  start();
  made(anna(), plate(80, "anna-s"));
  made(ben(), plate(81, "ben-s"));
  start();
  EXPECT_EQ(designs(anna()), std::vector<std::string>{"anna-s"});
  EXPECT_EQ(designs(ben()), std::vector<std::string>{"ben-s"});
  EXPECT_EQ(tenants_->load().revisions, 2U);
  EXPECT_EQ(anna().get("anna-s", kRun)->revision.output.mesh.nodes.size(), 100U);
}

TEST_F(TenantsTest, AStoreThatCannotBeOpenedIsNoSessionAndHurtsNobodyElse) {
  start();
  EXPECT_THROW(tenants_->open("damaged"), std::runtime_error);
  EXPECT_THROW(tenants_->of("damaged"), std::out_of_range);
  EXPECT_THROW(tenants_->of("a-stranger"), std::out_of_range);
  EXPECT_TRUE(made(anna(), plate(80)).revision);
}

TEST_F(TenantsTest, ASessionIsOpenedOnce) {
  start();
  Session* const before = &anna();
  tenants_->open("anna");
  EXPECT_EQ(&anna(), before);
}

TEST_F(TenantsTest, AreOpenedNoMoreOnceTheyAreStopped) {
  start();
  tenants_->stop();
  EXPECT_EQ(error_of([&] { tenants_->open("new"); }).reason, "SHUTTING_DOWN");
  Answer answer;
  anna().make(plate(80), answer.listener());
  EXPECT_EQ(answer.error().reason, "SHUTTING_DOWN");
}

TEST_F(TenantsTest, StoppingAnswersWhatIsUnderWayForEachOfThem) {
  start({.workers = 2});
  fake_.close_gate();
  Answer first, second;
  anna().make(plate(80), first.listener());
  ben().make(plate(80), second.listener());
  ASSERT_TRUE(fake_.wait_at_gate(2));
  tenants_->stop();
  EXPECT_EQ(first.error().reason, "SHUTTING_DOWN");
  EXPECT_EQ(second.error().reason, "SHUTTING_DOWN");
}

TEST_F(TenantsTest, RevisionsHeldOfTheOneThatHasMostGoFirst) {
  start();
  made(anna(), plate(80));
  const std::uint64_t one = anna().load().held_bytes;
  start({.held = 5 * one});
  for (int n = 0; n < 2; ++n) made(ben(), plate(90 + n));
  for (int n = 0; n < 12; ++n) made(anna(), plate(100 + n));
  EXPECT_EQ(ben().load().held, 2U) << "though they were used longest ago";
  EXPECT_LT(anna().load().held, 5U);
  EXPECT_LE(tenants_->load().held_bytes, 6 * one) << "those filed last may be in use";
  EXPECT_EQ(anna().load().revisions, 13U);
}

TEST_F(TenantsTest, MeshesStoredOfTheOneThatHasMostGoFirst) {
  start();
  made(anna(), plate(80));
  const std::uint64_t one = anna().load().disk_bytes;
  start({.disk = 5 * one});
  for (int n = 0; n < 2; ++n) made(ben(), plate(90 + n));
  for (int n = 0; n < 12; ++n) made(anna(), plate(100 + n));
  EXPECT_TRUE(comes([&] { return tenants_->load().disk_bytes <= 5 * one; }));
  EXPECT_EQ(ben().cache().cache_stats().stored, 2U);
  EXPECT_LT(anna().cache().cache_stats().stored, 5U);
  EXPECT_EQ(ben().cache().collect_garbage({}).meshes, 0U);
  EXPECT_EQ(anna().load().revisions, 13U);
}

TEST_F(TenantsTest, MayWorkAtTheSameTimeWhereMemoryAndDiskAreShort) {
  start();
  made(anna(), plate(80));
  const Load one = anna().load();
  start({.workers = 2, .held = 2 * one.held_bytes, .disk = 4 * one.disk_bytes});
  std::atomic<bool> done = false;
  std::vector<std::thread> others;
  others.emplace_back([&] {
    while (!done) ben().cache().collect_garbage({});
  });
  others.emplace_back([&] {
    while (!done)
      static_cast<void>(tenants_->load()), anna().cache().cache_stats(),
          ben().cache().cache_entries();
  });
  others.emplace_back([&] {
    for (int n = 0; !done; n = (n + 1) % 8) tenants_->open("new-" + std::to_string(n));
  });
  std::vector<std::thread> makers;
  for (Session* const session : {&anna(), &ben(), &anna(), &ben()})
    makers.emplace_back([=] {
      for (int n = 0; n < 8; ++n) EXPECT_TRUE(made(*session, plate(100 + n)).revision);
    });
  for (std::thread& maker : makers) maker.join();
  done = true;
  for (std::thread& other : others) other.join();
  EXPECT_EQ(anna().load().revisions, 9U);
  EXPECT_EQ(ben().load().revisions, 8U);
}

TEST_F(TenantsTest, WhatAllHoldInMemoryCountsWhereThereIsNoStore) {
  start({.held = 100000}, false);
  int n = 0;
  const auto refused = [&](Session& session) {
    Answer answer;
    session.make(plate(80 + ++n), answer.listener());
    return answer.error().reason;
  };
  while (n < 100 && refused(anna()).empty()) {
  }
  EXPECT_LT(n, 100);
  EXPECT_EQ(refused(ben()), "MEMORY_FULL");
}

TEST_F(TenantsTest, LeaveTheirDumpsInFoldersOfTheirOwn) {
  start({.dumps = "dumps"});
  const std::string id = made(anna(), plate(80)).filed.record.id;
  EXPECT_EQ(fake_.dumps(), std::filesystem::path("dumps/tenants/anna") / id);
  made(tenants_->of(""), plate(80));
  EXPECT_EQ(fake_.dumps(), std::filesystem::path("dumps") / id);
}

}  // namespace
}  // namespace remeshd::test
