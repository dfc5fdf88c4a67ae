#include <filesystem>
#include <nlohmann/json.hpp>

#include "remesh/v1/cache.grpc.pb.h"
#include "tests/server/daemon_fixture.h"

namespace remeshd::test {
namespace {

namespace fs = std::filesystem;
using grpc::StatusCode;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::SizeIs;

/// The operator's calls, of a daemon with a design of three revisions.
class Cache : public DaemonTest {
 protected:
  void SetUp() override {
    use_store();
    ids_ = {create(plate()).revision().id()};
    for (const double at : {11, 12}) ids_.push_back(edit("plate", set("at", at)).revision().id());
  }
  std::unique_ptr<v1::CacheService::Stub> cache() {
    stub();
    return v1::CacheService::NewStub(channel_);
  }
  std::vector<v1::CacheEntry> entries(v1::ListCacheEntriesRequest request = {}) {
    std::vector<v1::CacheEntry> all;
    do {
      grpc::ClientContext context;
      v1::ListCacheEntriesResponse page;
      const auto status = cache()->ListCacheEntries(&context, request, &page);
      EXPECT_TRUE(status.ok()) << status.error_message();
      all.insert(all.end(), page.entries().begin(), page.entries().end());
      request.set_page_token(page.next_page_token());
    } while (!request.page_token().empty());
    return all;
  }
  std::vector<std::string> listed(const v1::ListCacheEntriesRequest& request) {
    std::vector<std::string> ids;
    for (const auto& entry : entries(request)) ids.push_back(entry.revision());
    return ids;
  }
  v1::GetCacheStatsResponse stats() {
    grpc::ClientContext context;
    v1::GetCacheStatsResponse reply;
    EXPECT_TRUE(cache()->GetCacheStats(&context, {}, &reply).ok());
    return reply;
  }
  v1::CollectGarbageResponse collect(std::uint64_t disk_bytes) {
    grpc::ClientContext context;
    v1::CollectGarbageRequest request;
    request.set_disk_bytes(disk_bytes);
    v1::CollectGarbageResponse reply;
    EXPECT_TRUE(cache()->CollectGarbage(&context, request, &reply).ok());
    return reply;
  }
  v1::CacheEntry pin(const std::string& revision, bool pinned) {
    grpc::ClientContext context;
    v1::SetPinRequest request;
    request.set_revision(revision);
    request.set_pinned(pinned);
    v1::SetPinResponse reply;
    EXPECT_TRUE(cache()->SetPin(&context, request, &reply).ok());
    return reply.entry();
  }
  std::vector<v1::VerifyCacheResponse> verify(bool repair) {
    grpc::ClientContext context;
    v1::VerifyCacheRequest request;
    request.set_repair(repair);
    std::vector<v1::VerifyCacheResponse> messages;
    const auto reader = cache()->VerifyCache(&context, request);
    for (v1::VerifyCacheResponse message; reader->Read(&message);) messages.push_back(message);
    EXPECT_TRUE(reader->Finish().ok());
    EXPECT_TRUE(!messages.empty() && messages.back().done());
    return messages;
  }
  v1::GetRecipeResponse recipe(const std::string& revision) {
    grpc::ClientContext context;
    v1::GetRecipeRequest request;
    request.set_revision(revision);
    v1::GetRecipeResponse reply;
    const auto status = stub().GetRecipe(&context, request, &reply);
    EXPECT_TRUE(status.ok()) << status.error_message();
    return reply;
  }
  fs::path pack(int n) const {
    const std::string& id = ids_.at(static_cast<std::size_t>(n - 1));
    return folder_ / "packs" / id.substr(0, 2) / id.substr(2);
  }

  std::vector<std::string> ids_;
};

TEST_F(Cache, ListsWhatEveryRevisionTakes) {
  const auto all = entries();
  ASSERT_THAT(all, SizeIs(3));
  for (const auto& entry : all) {
    EXPECT_EQ(entry.state(), v1::CacheEntry::STATE_STORED);
    EXPECT_GT(entry.memory_bytes(), 0U);
    EXPECT_EQ(entry.places(), 1U);
    EXPECT_GE(entry.used().seconds(), entry.created().seconds());
  }
  std::uint64_t bytes = 0;
  for (int n = 1; n <= 3; ++n) bytes += fs::file_size(pack(n));
  EXPECT_EQ(stats().disk_bytes(), bytes);
  EXPECT_EQ(stats().stored(), 3U);
  EXPECT_EQ(stats().recipes(), 3U);
  EXPECT_GT(stats().disk_free_bytes(), 0U);
}

TEST_F(Cache, ListsInPagesByUseAgeOrBytes) {
  mesh_bytes("plate@1");  // the latest use
  v1::ListCacheEntriesRequest request;
  request.set_page_size(2);
  EXPECT_THAT(listed(request), ElementsAre(ids_[1], ids_[2], ids_[0]));
  request.set_descending(true);
  EXPECT_THAT(listed(request), ElementsAre(ids_[0], ids_[2], ids_[1]));
  request.set_order(v1::CACHE_ORDER_CREATED);
  EXPECT_THAT(listed(request), ElementsAre(ids_[2], ids_[1], ids_[0]));
  request.set_order(v1::CACHE_ORDER_BYTES);
  EXPECT_THAT(listed(request), SizeIs(3));
  request.mutable_filter()->set_design("plate");
  EXPECT_THAT(listed(request), SizeIs(3));
  request.mutable_filter()->add_states(v1::CacheEntry::STATE_RECIPE);
  EXPECT_THAT(listed(request), SizeIs(0));
}

TEST_F(Cache, HasPagesNoLargerThanAskedFor) {
  for (const std::uint32_t size : {1U, 2U}) {
    grpc::ClientContext context;
    v1::ListCacheEntriesRequest request;
    request.set_page_size(size);
    v1::ListCacheEntriesResponse page;
    ASSERT_TRUE(cache()->ListCacheEntries(&context, request, &page).ok());
    EXPECT_EQ(page.entries_size(), static_cast<int>(size));
    EXPECT_NE(page.next_page_token(), "");
  }
}

TEST_F(Cache, ListsPinnedRevisionsAloneWhereAsked) {
  pin("plate@2", true);
  v1::ListCacheEntriesRequest request;
  request.mutable_filter()->set_pinned(true);
  EXPECT_THAT(listed(request), ElementsAre(ids_[1]));
}

TEST_F(Cache, CollectsWhatWasNotUsedForUpToABillionSeconds) {
  for (const auto& [seconds, code] :
       {std::pair(0.0, StatusCode::OK), std::pair(1e9, StatusCode::OK),
        std::pair(1e9 + 1, StatusCode::INVALID_ARGUMENT),
        std::pair(-1.0, StatusCode::INVALID_ARGUMENT)}) {
    grpc::ClientContext context;
    v1::CollectGarbageRequest request;
    request.set_dry_run(true);
    request.set_unused_seconds(seconds);
    v1::CollectGarbageResponse reply;
    EXPECT_EQ(cache()->CollectGarbage(&context, request, &reply).error_code(), code) << seconds;
  }
}

TEST_F(Cache, MeshesThatWentComeBackToTheByteWhenTheyAreAskedFor) {
  std::vector<std::string> bytes;
  for (const std::string& id : ids_) bytes.push_back(mesh_bytes(id));
  pin("plate@2", true);
  EXPECT_EQ(collect(0).meshes(), 2U);
  start();
  EXPECT_FALSE(fs::exists(pack(1)));
  EXPECT_EQ(stats().stored(), 1U);
  EXPECT_EQ(stats().pinned(), 1U);
  for (std::size_t i = 0; i < ids_.size(); ++i) EXPECT_TRUE(mesh_bytes(ids_[i]) == bytes[i]);
  EXPECT_EQ(stats().remade(), 2U);
  EXPECT_EQ(stats().stored(), 3U);
  EXPECT_FALSE(pin("plate@2", false).pinned());
}

TEST_F(Cache, AMeshThatIsMadeAgainIsTheOneUsedLast) {
  collect(0);
  start();
  mesh_bytes("plate@1");
  EXPECT_THAT(listed({}), ElementsAre(ids_[1], ids_[2], ids_[0]));
}

TEST_F(Cache, ARequestForAMeshThatWentMakesItAgainInItsPlace) {
  collect(0);
  start();
  EXPECT_EQ(create(plate()).revision().number(), 1U);
  EXPECT_EQ(edit("plate@2", set("at", 13)).revision().number(), 4U);
}

TEST_F(Cache, DamageIsFoundAndRepaired) {
  EXPECT_THAT(verify(false), SizeIs(1));
  stop();
  fs::resize_file(pack(1), fs::file_size(pack(1)) - 1);
  const auto found = verify(false);
  ASSERT_GE(found.size(), 2U);
  EXPECT_EQ(found[0].finding().revision(), ids_[0]);
  EXPECT_THAT(found[0].finding().what(), HasSubstr("damaged"));
  EXPECT_FALSE(found[0].finding().repaired());
  for (const auto& message : verify(true))
    EXPECT_TRUE(message.finding().repaired() || !message.has_finding());
  EXPECT_THAT(verify(false), SizeIs(1));
}

TEST_F(Cache, ARecipeTellsAllThatAMeshIsMadeOf) {
  const auto reply = recipe("plate@2");
  EXPECT_EQ(reply.recipe().revision(), ids_[1]);
  EXPECT_EQ(reply.recipe().parent(), ids_[0]);
  EXPECT_EQ(reply.recipe().algorithm_version(), 13U);
  EXPECT_EQ(reply.recipe().edit().SerializeAsString(), set("at", 11).SerializeAsString());
  EXPECT_EQ(reply.recipe().digests_size(), 16);
  const auto document = nlohmann::json::parse(reply.document());
  EXPECT_EQ(document["edit"]["edits"].size(), 1U);
  EXPECT_EQ(document["model"]["features"].size(), 2U);
  EXPECT_EQ(document["digests"]["MESH_ARRAY_NODES"], reply.recipe().digests(0).digest());
  EXPECT_EQ(recipe("plate@2").document(), reply.document());
  EXPECT_FALSE(recipe("plate@1").recipe().has_edit());
}

TEST_F(Cache, OfMemoryAloneARecipeIsToldToo) {
  const std::string stored = recipe("plate@2").document();
  options_.store.clear();
  start();
  create(plate());
  edit("plate", set("at", 11));
  EXPECT_EQ(recipe("plate@2").document(), stored);
  EXPECT_EQ(entries()[0].state(), v1::CacheEntry::STATE_MEMORY);
  EXPECT_EQ(collect(0).meshes(), 0U);
}

TEST_F(Cache, ARevisionIsDescribedThoughItsMeshHasGone) {
  const auto before = describe("plate@2");
  collect(0);
  start();
  engine_.close_gate();  // to make it again would take for ever
  auto now = describe("plate@2");
  engine_.open_gate();
  EXPECT_FALSE(now.has_report());
  EXPECT_EQ(now.revision().SerializeAsString(), before.revision().SerializeAsString());
  EXPECT_EQ(now.model().SerializeAsString(), before.model().SerializeAsString());
  EXPECT_EQ(now.edit().SerializeAsString(), before.edit().SerializeAsString());
  EXPECT_EQ(now.options().iterations(), before.options().iterations());
  EXPECT_EQ(now.places_size(), 1);
  EXPECT_THAT(now.children(), ElementsAre(ids_[2]));
}

/// After an upgrade whose algorithm gives other meshes.
class CacheOfYesterday : public Cache {
 protected:
  [[nodiscard]] Engine make_engine() const override {
    Engine engine = engine_.engine();
    engine.algorithm_version = version_;
    return engine;
  }
  grpc::Status remake(const std::string& revision, v1::RemakeRevisionResponse* reply) {
    grpc::ClientContext context;
    v1::RemakeRevisionRequest request;
    request.set_revision(revision);
    request.set_request_id("r");
    request.set_threads(2);
    return stub().RemakeRevision(&context, request, reply);
  }
  std::uint32_t version_ = 13;
};

TEST_F(CacheOfYesterday, ALostMeshIsOutdatedAndRemadeAsANewRevision) {
  stop();
  for (int n = 1; n <= 3; ++n) fs::remove(pack(n));
  version_ = 14;
  const auto kept = describe("plate@3");
  EXPECT_EQ(kept.revision().id(), ids_[2]);
  EXPECT_FALSE(kept.has_report());
  grpc::ClientContext context;
  v1::GetMeshRequest request;
  request.set_revision("plate@3");
  const auto reader = stub().GetMesh(&context, request);
  v1::GetMeshResponse message;
  EXPECT_FALSE(reader->Read(&message));
  const auto status = reader->Finish();
  EXPECT_EQ(status.error_code(), StatusCode::FAILED_PRECONDITION);
  EXPECT_EQ(detail(status).reason(), v1::Error::REVISION_OUTDATED);
  EXPECT_THAT(detail(status).hint(), HasSubstr("remesh remake"));

  v1::RemakeRevisionResponse reply;
  ASSERT_TRUE(remake("plate@3", &reply).ok());
  EXPECT_EQ(reply.remade_size(), 2) << "both its ancestors";
  EXPECT_EQ(reply.result().revision().number(), 6U);
  EXPECT_EQ(reply.result().revision().parent(), reply.remade(1));
  EXPECT_EQ(reply.result().revision().algorithm_version(), 14U);
  EXPECT_EQ(reply.result().request_id(), "r");
  EXPECT_EQ(engine_.threads(), 2);
  EXPECT_EQ(describe(reply.result().revision().id()).model().SerializeAsString(),
            recipe("plate@3").recipe().model().SerializeAsString());
}

TEST_F(CacheOfYesterday, AnIntactMeshIsServedAndBuiltUpon) {
  const std::string bytes = mesh_bytes("plate@1");
  stop();
  fs::remove(pack(2));
  version_ = 14;
  EXPECT_TRUE(mesh_bytes("plate@1") == bytes);
  v1::RemakeRevisionResponse reply;
  ASSERT_TRUE(remake("plate@2", &reply).ok());
  EXPECT_EQ(reply.remade_size(), 0);
  EXPECT_EQ(reply.result().revision().parent(), ids_[0]);
}

TEST_F(CacheOfYesterday, OfTodayRemakingIsTheSameRevision) {
  v1::RemakeRevisionResponse reply;
  ASSERT_TRUE(remake("plate@2", &reply).ok());
  EXPECT_EQ(reply.result().revision().id(), ids_[1]);
  EXPECT_TRUE(reply.result().report().cached());
}

}  // namespace
}  // namespace remeshd::test
