#include <gmock/gmock.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "engine/verify/verify.h"
#include "server/daemon.h"
#include "server/session/archive.h"
#include "server/store/store.h"
#include "tests/support/cases.h"
#include "tests/support/run.h"

// Stores that earlier versions of the program wrote, each with simple-a at 60 nodes and its edit
// simple-ab: `first_layout_store` is of before stores had a FORMAT, with revisions of format 8;
// `second_layout_store` of store version 1, with revisions of format 9.
namespace remeshd::test {
namespace {

namespace fs = std::filesystem;

class OlderStores : public testing::TestWithParam<const char*> {
 protected:
  OlderStores() {
    fs::remove_all(folder_);
    fs::copy(fs::path(REMESHD_CASES_DIR) / GetParam(), folder_, fs::copy_options::recursive);
  }
  ~OlderStores() override { fs::remove_all(folder_); }

  const fs::path folder_ =
      fs::temp_directory_path() / ("remeshd-older-store-" + std::to_string(::getpid()));
  const Engine engine_ = production_engine();
};

TEST_P(OlderStores, AreTakenOverWithAllThatTheyHold) {
  for (const char* opening : {"first", "second"}) {
    SCOPED_TRACE(opening);
    Store store(folder_);
    MemoryBudget memory(1 << 30);
    Archive archive(engine_, store, memory);
    const auto designs = store.read([](Catalogue& c) { return c.designs({}, {}); });
    ASSERT_EQ(designs.size(), 1U);
    EXPECT_EQ(designs[0].name, "simple-a");
    EXPECT_EQ(designs[0].head_number, 2U);

    const HeldRevisionPtr first = archive.get(archive.resolve("simple-a@1").id, kRun);
    EXPECT_EQ(first->revision.source, case_model("simple-a"));
    EXPECT_EQ(first->revision.output.mesh.nodes.size(), 68U);
    EXPECT_THAT(first->revision.report.warnings.size(), testing::Le(1U));
    EXPECT_GT(first->revision.report.seconds.total, 0);
    const HeldRevisionPtr second = archive.get(archive.resolve("simple-a").id, kRun);
    EXPECT_EQ(second->revision.source, apply(case_model("simple-a"), case_edit("simple-ab")));
    EXPECT_EQ(second->record.parent, first->record.id);
    EXPECT_EQ(second->edit.empty(), GetParam() == std::string("first_layout_store"));
    for (const HeldRevisionPtr& held : {first, second}) {
      const Revision& r = held->revision;
      EXPECT_TRUE(
          verify(r.output.mesh, r.supports(), r.cells.boundary, r.cells.volume, kRun).valid);
      EXPECT_EQ(r.report.revision, held->record.id);
      EXPECT_EQ(held->record.nodes, r.output.mesh.nodes.size());
      EXPECT_EQ(r.report.figures.size(), r.output.groups.facet_groups.size());
    }
  }
}

TEST_P(OlderStores, AreWorkedOnAsIfTheyWereOfToday) {
  std::string id(64, 'a');
  {
    Store store(folder_);
    MemoryBudget memory(1 << 30);
    Archive archive(engine_, store, memory);
    const HeldRevisionPtr base = archive.get(archive.resolve("simple-a").id, kRun);
    ModelSource source = base->revision.source;
    parameter(source, "top_x") = 5.0;
    auto made = std::make_shared<HeldRevision>();
    made->revision = make_revision(base->revision, source, base->revision.options, kRun);
    made->record = {.id = id, .parent = base->record.id};
    EXPECT_EQ(archive.file(made, "simple-a", {}).place.number, 3U);
  }
  Store store(folder_);
  MemoryBudget memory(1 << 30);
  Archive archive(engine_, store, memory);
  EXPECT_EQ(archive.resolve("simple-a@3").id, id);
  EXPECT_GT(archive.get(id, kRun)->revision.output.mesh.nodes.size(), 0U);
}

TEST_P(OlderStores, AreRefusedByTheProgramsThatWroteThem) {
  { const Store store(folder_); }
  // They refuse what has a higher version than theirs.
  std::ifstream in(folder_ / "FORMAT");
  const std::string text{std::istreambuf_iterator<char>(in), {}};
  EXPECT_THAT(text, testing::HasSubstr("\"version\":2"));
}

INSTANTIATE_TEST_SUITE_P(, OlderStores,
                         testing::Values("first_layout_store", "second_layout_store"),
                         [](const auto& test) { return std::string(test.param); });

}  // namespace
}  // namespace remeshd::test
