#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/client/cli/cli_fixture.h"

namespace remeshd::cli {
namespace {

using testing::HasSubstr;
using testing::MatchesRegex;

/// `young` is an edit of `old`, which is one of `oldest`; the face `rib.top` and the node 77 came
/// with `old`.
class CliBlame : public Cli {
 protected:
  void SetUp() override {
    service_.parents = {{"young", "old"}, {"old", "oldest"}, {"oldest", ""}};
    auto with = client::sample_mesh(1);
    with.facet_groups[0] = {"rib.top", "base.x_min"};
    with.node_ids[0] = 77;
    service_.meshes_by_name = {{"id-of-young", with}, {"id-of-old", with}, {"young", with}};
    for (const char* name : {"young", "old", "oldest"}) {
      service_.parents["id-of-" + std::string(name)] = service_.parents[name];
      if (const auto mesh = service_.meshes_by_name.find("id-of-" + std::string(name));
          mesh != service_.meshes_by_name.end())
        service_.meshes_by_name[name] = mesh->second;
      service_.meshes_by_name["id-of-oldest"] = client::sample_mesh(1);
    }
  }
};

TEST_F(CliBlame, TellsTheRevisionThatMadeAFace) {
  ASSERT_EQ(run({"blame", "young", "rib.top"}), kFine) << err_.str();
  EXPECT_THAT(out_.str(), HasSubstr("face      rib.top\nmade by   old@7\nrevision  id-of-old\n"));
  EXPECT_THAT(out_.str(), HasSubstr("change    same model"));
  ASSERT_EQ(run({"blame", "young", "base.x_min"}), kFine) << err_.str();
  EXPECT_THAT(out_.str(), HasSubstr("made by   oldest@7\n"));
  EXPECT_THAT(out_.str(), HasSubstr("change    first mesh"));
}

TEST_F(CliBlame, TellsTheRevisionThatMadeANodeAndFetchesNoMoreThanIds) {
  ASSERT_EQ(run({"blame", "young", "77"}), kFine) << err_.str();
  EXPECT_THAT(out_.str(), HasSubstr("node      77\nmade by   old@7\n"));
  for (const auto& request : service_.mesh_requests) {
    ASSERT_EQ(request.selection().arrays_size(), 1);
    EXPECT_EQ(request.selection().arrays(0), remesh::v1::MESH_ARRAY_NODE_IDS);
  }
}

TEST_F(CliBlame, WhatTheMeshHasNotIsToldWithTheNameThatMayBeMeant) {
  EXPECT_EQ(run({"blame", "young", "rip.top"}), kInvalid);
  EXPECT_THAT(err_.str(), HasSubstr("no face 'rip.top'; did you mean `rib.top`?"));
  EXPECT_EQ(run({"blame", "young", "987654321"}), kInvalid);
  EXPECT_THAT(err_.str(), HasSubstr("no node of the permanent id 987654321"));
}

}  // namespace
}  // namespace remeshd::cli
