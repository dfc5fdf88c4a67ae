#include "remesh/v1/cache.grpc.pb.h"
#include "tests/server/daemon_fixture.h"

namespace remeshd::test {
namespace {

using grpc::StatusCode;

/// What the protocol has and this daemon does not do is refused by name.
class Unsupported : public DaemonTest {
 protected:
  void SetUp() override { create(plate()); }

  static void expect_refused(const grpc::Status& status, const std::string& what) {
    EXPECT_EQ(status.error_code(), StatusCode::UNIMPLEMENTED) << what;
    EXPECT_EQ(detail(status).reason(), v1::Error::UNSUPPORTED) << what;
    EXPECT_EQ(detail(status).parameter(), what);
  }
  template <typename Change>
  void expect_no_first_mesh(const std::string& what, Change change) {
    auto request = create_request(plate(6));
    change(request);
    v1::RevisionResult result;
    expect_refused(try_create(request, &result), what);
  }
  template <typename Change>
  void expect_no_edit(const std::string& what, Change change) {
    v1::ModelEdit edit = set("at", 11);
    change(*edit.add_edits());
    v1::RevisionResult result;
    const auto status = try_edit(edit_request("plate", edit), &result);
    expect_refused(status, what);
    EXPECT_EQ(detail(status).edit_index(), 1U);
  }
  template <typename Change>
  void expect_no_mesh(const std::string& what, Change change) {
    v1::GetMeshRequest request;
    request.set_revision("plate");
    change(request);
    grpc::ClientContext context;
    const auto reader = stub().GetMesh(&context, request);
    v1::GetMeshResponse response;
    EXPECT_FALSE(reader->Read(&response));
    expect_refused(reader->Finish(), what);
  }
};

TEST_F(Unsupported, FieldsOfAFirstMeshAreNamed) {
  expect_no_first_mesh("groups", [](auto& r) { r.mutable_model()->add_groups(); });
  auto request = create_request(plate(6));
  request.mutable_options()->set_order(1);
  request.mutable_head()->set_file(true);
  create(request);
}

TEST_F(Unsupported, EditsOfGroupsAreNamed) {
  expect_no_edit("set_group", [](v1::Edit& e) { e.mutable_set_group(); });
  expect_no_edit("remove_group", [](v1::Edit& e) { e.mutable_remove_group(); });
}

TEST_F(Unsupported, FieldsOfAMeshAreNamed) {
  for (const auto name :
       {v1::MESH_ARRAY_GROUP_NAMES, v1::MESH_ARRAY_GROUP_FACETS, v1::MESH_ARRAY_GROUP_TETS}) {
    expect_no_mesh(v1::MeshArray_Name(name),
                   [&](auto& r) { r.mutable_selection()->add_arrays(name); });
  }
}

TEST_F(Unsupported, AnArrayOfAMeshInAStreamIsNamedAndTheStreamLivesOn) {
  grpc::ClientContext context;
  const auto stream = stub().EditStream(&context);
  v1::EditStreamRequest request;
  *request.mutable_edit() = edit_request("plate", set("at", 11));
  request.mutable_mesh()->add_arrays(v1::MESH_ARRAY_GROUP_NAMES);
  ASSERT_TRUE(stream->Write(request));
  request.clear_mesh();
  ASSERT_TRUE(stream->Write(request));
  v1::EditStreamResponse reply;
  ASSERT_TRUE(stream->Read(&reply));
  EXPECT_EQ(reply.error().code(), v1::Error::CODE_UNIMPLEMENTED);
  EXPECT_EQ(reply.error().parameter(), "MESH_ARRAY_GROUP_NAMES");
  do ASSERT_TRUE(stream->Read(&reply));
  while (reply.has_progress());
  EXPECT_TRUE(reply.has_result());
  stream->WritesDone();
  EXPECT_TRUE(stream->Finish().ok());
}

TEST_F(Unsupported, AndNotAmongTheCapabilities) {
  const v1::ServerCapabilities can = info().capabilities();
  EXPECT_THAT(can.capabilities(),
              testing::ElementsAre(v1::ServerCapabilities::CAPABILITY_SIZING,
                                   v1::ServerCapabilities::CAPABILITY_SIZES,
                                   v1::ServerCapabilities::CAPABILITY_FORECAST,
                                   v1::ServerCapabilities::CAPABILITY_MESH_DELTA,
                                   v1::ServerCapabilities::CAPABILITY_REMAKE,
                                   v1::ServerCapabilities::CAPABILITY_CACHE));
  EXPECT_THAT(can.orders(), testing::ElementsAre(1, 2));
  EXPECT_EQ(can.arrays_size(), 25);
  EXPECT_THAT(can.formats(), testing::ElementsAre("vtu", "msh", "inp"));
}

}  // namespace
}  // namespace remeshd::test
