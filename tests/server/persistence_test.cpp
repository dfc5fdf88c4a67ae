#include <google/protobuf/util/message_differencer.h>

#include <fstream>
#include <thread>

#include "engine/base/error.h"
#include "tests/server/daemon_fixture.h"

namespace remeshd::test {
namespace {

namespace fs = std::filesystem;
using google::protobuf::util::MessageDifferencer;

class Persistence : public DaemonTest {
 protected:
  void SetUp() override { use_store(); }

  /// The files that hold the bytes of revisions.
  std::vector<fs::path> packs() const {
    std::vector<fs::path> files;
    for (const auto& entry : fs::recursive_directory_iterator(folder_ / "packs"))
      if (entry.is_regular_file()) files.push_back(entry.path());
    return files;
  }
  static void flip_byte(const fs::path& file, std::int64_t at) {
    std::fstream f(file, std::ios::in | std::ios::out | std::ios::binary);
    f.seekg(at);
    const char byte = static_cast<char>(f.get() ^ 1);
    f.seekp(at);
    f.put(byte);
  }
  static std::string content(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
  }
  std::string journal() const { return content(folder_ / "journal.a"); }
  void set_journals(const std::string& text) const {
    for (const char* name : {"journal.a", "journal.b"})
      std::ofstream(folder_ / name, std::ios::binary) << text;
  }
};

/// An engine whose meshes have three nodes on edges.
class PersistenceOfSecondOrder : public Persistence {
 protected:
  [[nodiscard]] Engine make_engine() const override {
    Engine engine = engine_.engine();
    engine.make_revision = [make = engine.make_revision](const auto&... given) {
      Revision made = make(given...);
      MidNodes& mids = made.output.mids;
      mids.positions.resize(3, Vec3{1, 2, 3});
      mids.edges.resize(3);
      mids.of_tets.resize(made.output.mesh.tets.size());
      mids.ids.resize(3);
      mids.origin.resize(3);
      mids.original.resize(3, -1);
      mids.transform.resize(3, -1);
      return made;
    };
    return engine;
  }
};

TEST_F(PersistenceOfSecondOrder, NodesOnEdgesAreCountedBeforeARestartAndAfter) {
  EXPECT_EQ(create(plate()).revision().mid_nodes(), 3U);
  EXPECT_EQ(list().revisions(0).mid_nodes(), 3U);
  start();
  EXPECT_EQ(list().revisions(0).mid_nodes(), 3U);
}

TEST_F(Persistence, RevisionsDesignsAndMeshesAreThereAfterARestartToTheByte) {
  create(plate());
  const auto child = edit("plate", set("at", 11));
  const std::string described = describe("plate").SerializeAsString();
  const std::string listed = list().SerializeAsString();
  const std::string bytes = mesh_bytes("plate");
  start();
  EXPECT_EQ(engine_.loaded(), 0);
  EXPECT_EQ(list().SerializeAsString(), listed);
  EXPECT_TRUE(MessageDifferencer::Equals(describe("plate"), [&] {
    v1::GetRevisionResponse before;
    before.ParseFromString(described);
    return before;
  }()));
  EXPECT_TRUE(mesh_bytes("plate") == bytes);
  EXPECT_EQ(engine_.made(), 2);
  EXPECT_TRUE(info().load().persistent());
  EXPECT_GT(info().load().disk_bytes(), 2U * 100 * 24);
}

TEST_F(Persistence, AStoredAnswerIsTheCachedOneOfBefore) {
  create(plate());
  const auto cached = create(plate());
  start();
  EXPECT_EQ(create(plate()).SerializeAsString(), cached.SerializeAsString());
  EXPECT_EQ(engine_.made(), 1);
}

TEST_F(Persistence, AnEditInheritsTheSizingOfItsBaseAlsoAfterARestart) {
  auto request = create_request(plate());
  v1::Sizing& sizing = *request.mutable_options()->mutable_sizing();
  sizing.set_edges_per_circle(20);
  sizing.set_layers(3);
  sizing.set_min_size(0.25);
  create(request);
  auto finer = edit_request("plate", set("at", 12));
  finer.mutable_options()->mutable_sizing()->set_growth(1.5);
  edit(finer);
  auto even = edit_request("plate@2", set("at", 13));
  even.mutable_options()->mutable_sizing()->set_even(true);
  edit(even);
  for (int k = 0; k < 2; ++k) {
    const v1::Sizing first = describe("plate@1").options().sizing();
    EXPECT_FALSE(first.even());
    EXPECT_EQ(first.edges_per_circle(), 20U);
    EXPECT_EQ(first.layers(), 3U);
    EXPECT_EQ(first.min_size(), 0.25);
    EXPECT_EQ(first.growth(), 1.3);
    const v1::Sizing second = describe("plate@2").options().sizing();
    EXPECT_FALSE(second.even());
    EXPECT_EQ(second.edges_per_circle(), 20U);
    EXPECT_EQ(second.min_size(), 0.25);
    EXPECT_EQ(second.growth(), 1.5);
    const v1::Sizing third = describe("plate@3").options().sizing();
    EXPECT_TRUE(third.even());
    EXPECT_FALSE(third.has_growth()) << "no rule holds";
    start();
  }
}

TEST_F(Persistence, AnEditOfALoadedBaseIsTheEditOfTheOneInMemory) {
  create(plate());
  const auto in_memory = edit("plate@1", set("at", 11));
  const std::string bytes = mesh_bytes(in_memory.revision().id());
  ASSERT_TRUE(remove(in_memory.revision().id(), true).ok());
  start();
  const auto loaded = edit("plate@1", set("at", 11));
  EXPECT_EQ(loaded.revision().id(), in_memory.revision().id());
  EXPECT_FALSE(loaded.report().cached());
  EXPECT_EQ(mesh_bytes(loaded.revision().id()), bytes);
  EXPECT_EQ(loaded.revision().number(), 3U);  // 2 was given away
}

TEST_F(Persistence, RevisionsBeyondTheMemoryBudgetGoToTheStoreAndComeBack) {
  options_.cache = 50000;
  std::vector<std::string> ids;
  for (int i = 0; i < 5; ++i)
    ids.push_back(create(create_request(plate(1 + i), 1000)).revision().id());
  EXPECT_LT(info().load().cached_revisions(), 5U);
  // The thread that made the last one may hold what it needed for a moment longer.
  while (info().load().memory_bytes() > 200000U) std::this_thread::yield();
  for (const auto& id : ids) EXPECT_EQ(describe(id).revision().id(), id);
  EXPECT_GT(engine_.loaded(), 0);
  EXPECT_EQ(engine_.made(), 5);
}

TEST_F(Persistence, ADamagedFileIsNoticedAndItsMeshMadeAgainAndStored) {
  const auto before = create(plate());
  const std::string bytes = mesh_bytes("plate");
  ASSERT_EQ(packs().size(), 1U);
  const std::string whole = content(packs()[0]);
  int made = engine_.made();
  for (const std::size_t at : {std::size_t{0}, whole.size() / 2, whole.size() - 1}) {
    stop();
    flip_byte(packs()[0], static_cast<std::int64_t>(at));
    EXPECT_TRUE(mesh_bytes("plate") == bytes);
    EXPECT_EQ(engine_.made(), ++made);
    const auto again = create(plate());
    EXPECT_TRUE(again.report().cached());
    EXPECT_EQ(again.revision().number(), 1U);
    EXPECT_EQ(again.revision().created().seconds(), before.revision().created().seconds());
    EXPECT_EQ(again.report().seconds().total(), before.report().seconds().total());
    stop();
    EXPECT_TRUE(content(packs()[0]) == whole);
  }
}

TEST_F(Persistence, AMissingFileIsMadeAgain) {
  create(plate());
  const std::string bytes = mesh_bytes("plate");
  stop();
  fs::remove(packs()[0]);
  EXPECT_TRUE(mesh_bytes("plate") == bytes);
  EXPECT_EQ(packs().size(), 1U);
}

TEST_F(Persistence, ARevisionOfWhichTheJournalLostItsLineIsThereAllTheSame) {
  create(plate());
  const std::string before = journal();
  const auto child = edit("plate", set("at", 11));
  const std::string listed = list().SerializeAsString();
  const std::string bytes = mesh_bytes("plate");
  const std::string after = journal();
  for (const auto size : {after.size() - 1, after.size() - 5, before.size()}) {
    stop();
    set_journals(after.substr(0, size));
    EXPECT_EQ(list().SerializeAsString(), listed);
    EXPECT_TRUE(mesh_bytes("plate") == bytes);
  }
  EXPECT_EQ(edit("plate", set("at", 12)).revision().number(), 3U);
}

TEST_F(Persistence, WithoutItsJournalTheStoreIsMadeAgainFromTheRevisions) {
  create(plate());
  const auto child = edit("plate", set("at", 11));
  const std::string bytes = mesh_bytes("plate");
  stop();
  for (const char* name : {"journal.a", "journal.b"}) fs::remove(folder_ / name);
  EXPECT_EQ(list("plate").revisions_size(), 2);
  EXPECT_EQ(describe("plate").revision().id(), child.revision().id());
  EXPECT_TRUE(mesh_bytes("plate") == bytes);
}

TEST_F(Persistence, DeletedRevisionsLeaveNoFileOnceNoOtherStandsOnIt) {
  create(plate());
  edit("plate", set("at", 11));
  EXPECT_EQ(packs().size(), 2U);
  ASSERT_TRUE(remove("plate@1", false).ok());
  ASSERT_TRUE(remove("plate", true).ok());
  EXPECT_TRUE(packs().empty());
  start();
  EXPECT_EQ(create(plate()).revision().number(), 3U);
}

TEST_F(Persistence, OneProcessAtATimeHasAStore) {
  start();
  try {
    const Daemon second(options_, engine_.engine());
    FAIL() << "two daemons share a store";
  } catch (const Error& error) {
    EXPECT_EQ(error.info().reason, "STORE_LOCKED");
  }
}

TEST_F(Persistence, AStoreThatCannotBeMadeIsAnError) {
  options_.store = "/proc/remeshd-test";
  EXPECT_THROW(Daemon(options_, engine_.engine()), Error);
}

}  // namespace
}  // namespace remeshd::test
