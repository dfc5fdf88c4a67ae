#include <fstream>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "engine/base/error.h"
#include "remesh/v1/cache.grpc.pb.h"
#include "remesh/v1/remesh.grpc.pb.h"
#include "server/guard/doorman.h"
#include "tests/server/daemon_fixture.h"
#include "tests/server/transport/sockets.h"

namespace remeshd::test {
namespace {

using grpc::StatusCode;

/// A daemon that knows the tenants `anna` and `ben` by their tokens.
class TenantCalls : public DaemonTest {
 protected:
  TenantCalls() {
    write_tokens({"anna", "ben"});
    options_.doorman = std::make_shared<Doorman>(file());
    use_store();
  }
  [[nodiscard]] std::string file() const { return folder_of_file_.file("tokens"); }
  static std::string token_of(const std::string& tenant) { return "the-secret-token-of-" + tenant; }
  void write_tokens(const std::vector<std::string>& tenants) const {
    {
      std::ofstream out(file());
      for (const std::string& tenant : tenants) out << tenant << " " << token_of(tenant) << "\n";
    }
    std::filesystem::permissions(file(), std::filesystem::perms(0600));
  }

  /// A call of a tenant's, by a method of one of the stubs.
  template <typename Stub, typename Request, typename Reply>
  grpc::Status call_as(const std::string& tenant, Stub& stub,
                       grpc::Status (Stub::*method)(grpc::ClientContext*, const Request&, Reply*),
                       const Request& request, Reply* reply) {
    grpc::ClientContext context;
    context.AddMetadata("authorization", "Bearer " + token_of(tenant));
    return (stub.*method)(&context, request, reply);
  }
  template <typename Stub, typename Request, typename Reply>
  grpc::Status call_as(const std::string& tenant, Stub& stub,
                       grpc::Status (Stub::*method)(grpc::ClientContext*, const Request&, Reply*),
                       const Request& request) {
    Reply reply;
    return call_as(tenant, stub, method, request, &reply);
  }
  v1::CacheService::Stub& cache() {
    stub();
    cache_ = v1::CacheService::NewStub(channel_);
    return *cache_;
  }

  v1::RevisionResult create_as(const std::string& tenant, const v1::FeatureModel& model,
                               const std::string& request_id = "") {
    v1::CreateRevisionRequest request = create_request(model);
    request.set_request_id(request_id);
    v1::CreateRevisionResponse reply;
    const auto status =
        call_as(tenant, stub(), &v1::RemeshService::Stub::CreateRevision, request, &reply);
    EXPECT_TRUE(status.ok()) << status.error_message();
    return reply.result();
  }
  v1::RevisionResult edit_as(const std::string& tenant, const std::string& base, double at) {
    v1::EditRevisionResponse reply;
    const auto status = call_as(tenant, stub(), &v1::RemeshService::Stub::EditRevision,
                                edit_request(base, set("at", at)), &reply);
    EXPECT_TRUE(status.ok()) << status.error_message();
    return reply.result();
  }
  v1::ListRevisionsResponse list_as(const std::string& tenant,
                                    const v1::ListRevisionsRequest& request = {}) {
    v1::ListRevisionsResponse reply;
    const auto status =
        call_as(tenant, stub(), &v1::RemeshService::Stub::ListRevisions, request, &reply);
    EXPECT_TRUE(status.ok()) << status.error_message();
    return reply;
  }
  v1::ServerLoad load_of(const std::string& tenant) {
    v1::GetServerInfoResponse reply;
    EXPECT_TRUE(call_as(tenant, stub(), &v1::RemeshService::Stub::GetServerInfo, {}, &reply).ok());
    return reply.server().load();
  }

  Folder folder_of_file_;
  std::unique_ptr<v1::CacheService::Stub> cache_;
};

/// What an error tells a client: code, message, details.
struct Told {
  StatusCode code;
  std::string message, details;
  friend bool operator==(const Told&, const Told&) = default;
  friend std::ostream& operator<<(std::ostream& out, const Told& told) {
    return out << told.code << " " << told.message;
  }
};

/// The same of another name of the same length.
Told renamed(Told told, const std::string& from, const std::string& to) {
  EXPECT_EQ(from.size(), to.size());
  for (std::string* text : {&told.message, &told.details})
    for (auto at = text->find(from); at != std::string::npos; at = text->find(from, at + to.size()))
      text->replace(at, from.size(), to);
  return told;
}

/// Every way in which a call can name a revision or a design.
class NamesOfAnother : public TenantCalls {
 protected:
  using Remesh = v1::RemeshService::Stub;
  using Cache = v1::CacheService::Stub;

  static Told told(const grpc::Status& status) {
    return {status.error_code(), status.error_message(), status.error_details()};
  }
  /// A call of ben's by a method that answers at once.
  template <typename Stub, typename Request, typename Reply>
  Told ask(Stub& stub, grpc::Status (Stub::*method)(grpc::ClientContext*, const Request&, Reply*),
           const Request& request) {
    return told(call_as("ben", stub, method, request));
  }
  Told ask_mesh(const v1::GetMeshRequest& request) {
    grpc::ClientContext context;
    context.AddMetadata("authorization", "Bearer " + token_of("ben"));
    const auto reader = stub().GetMesh(&context, request);
    for (v1::GetMeshResponse part; reader->Read(&part);) ADD_FAILURE() << "a mesh is sent";
    return told(reader->Finish());
  }
  Told ask_mesh_file(const v1::GetMeshFileRequest& request) {
    grpc::ClientContext context;
    context.AddMetadata("authorization", "Bearer " + token_of("ben"));
    const auto reader = stub().GetMeshFile(&context, request);
    for (v1::GetMeshFileResponse part; reader->Read(&part);) ADD_FAILURE() << "a file is sent";
    return told(reader->Finish());
  }
  Told ask_velocities(const v1::GetDesignVelocitiesRequest& request) {
    grpc::ClientContext context;
    context.AddMetadata("authorization", "Bearer " + token_of("ben"));
    const auto reader = stub().GetDesignVelocities(&context, request);
    for (v1::GetDesignVelocitiesResponse part; reader->Read(&part);)
      ADD_FAILURE() << "velocities are sent";
    return told(reader->Finish());
  }
  Told ask_stream(const v1::EditStreamRequest& request) {
    grpc::ClientContext context;
    context.AddMetadata("authorization", "Bearer " + token_of("ben"));
    const auto stream = stub().EditStream(&context);
    stream->Write(request);
    stream->WritesDone();
    v1::Error error;
    for (v1::EditStreamResponse reply; stream->Read(&reply);) {
      EXPECT_TRUE(reply.has_error());
      error = reply.error();
    }
    EXPECT_TRUE(stream->Finish().ok());
    return {static_cast<StatusCode>(error.code()), error.message(), error.SerializeAsString()};
  }

  /// What ben hears of a name, call by call.
  std::map<std::string, Told> asked(const std::string& name, const std::string& design) {
    std::map<std::string, Told> heard;
    const auto revision = [&](auto request) {
      request.set_revision(name);
      return request;
    };
    const auto base = [&](auto request) {
      request.set_base(name);
      *request.mutable_edit() = set("at", 12);
      return request;
    };
    heard["GetRevision"] = ask(stub(), &Remesh::GetRevision, revision(v1::GetRevisionRequest()));
    heard["GetRecipe"] = ask(stub(), &Remesh::GetRecipe, revision(v1::GetRecipeRequest()));
    heard["RemakeRevision"] =
        ask(stub(), &Remesh::RemakeRevision, revision(v1::RemakeRevisionRequest()));
    heard["EditRevision"] = ask(stub(), &Remesh::EditRevision, base(v1::EditRevisionRequest()));
    heard["ValidateEdit"] = ask(stub(), &Remesh::ValidateEdit, base(v1::ValidateEditRequest()));
    heard["SetPin"] = ask(cache(), &Cache::SetPin, revision(v1::SetPinRequest()));
    v1::SetHeadRequest head = revision(v1::SetHeadRequest());
    head.set_design("bens-plate");
    heard["SetHead"] = ask(stub(), &Remesh::SetHead, head);
    v1::CompareRequest original, modified;
    original.mutable_original()->set_revision(name);
    *original.mutable_modified()->mutable_model() = plate();
    *modified.mutable_original()->mutable_model() = plate();
    modified.mutable_modified()->set_revision(name);
    heard["Compare, original"] = ask(stub(), &Remesh::Compare, original);
    heard["Compare, modified"] = ask(stub(), &Remesh::Compare, modified);

    v1::GetMeshRequest mesh = revision(v1::GetMeshRequest());
    heard["GetMesh"] = ask_mesh(mesh);
    mesh.mutable_selection()->set_delta(true);
    heard["GetMesh, a delta"] = ask_mesh(mesh);
    mesh = revision(v1::GetMeshRequest());
    mesh.mutable_resume_from()->set_array(v1::MESH_ARRAY_TETS);
    heard["GetMesh, resumed"] = ask_mesh(mesh);
    v1::GetMeshFileRequest file = revision(v1::GetMeshFileRequest());
    file.set_format("inp");
    heard["GetMeshFile"] = ask_mesh_file(file);
    heard["GetDesignVelocities"] = ask_velocities(revision(v1::GetDesignVelocitiesRequest()));
    heard["GetDesignGradient"] =
        ask(stub(), &Remesh::GetDesignGradient, revision(v1::GetDesignGradientRequest()));
    heard["GetConnectivityHorizon"] =
        ask(stub(), &Remesh::GetConnectivityHorizon, revision(v1::GetConnectivityHorizonRequest()));
    v1::EditStreamRequest request;
    *request.mutable_edit() = base(v1::EditRevisionRequest());
    heard["EditStream"] = ask_stream(request);

    v1::ListRevisionsRequest list;
    list.mutable_filter()->set_design(design);
    heard["ListRevisions"] = ask(stub(), &Remesh::ListRevisions, list);
    v1::ListCacheEntriesRequest entries;
    entries.mutable_filter()->set_design(design);
    heard["ListCacheEntries"] = ask(cache(), &Cache::ListCacheEntries, entries);
    v1::EditStreamRequest of_design = request;
    of_design.mutable_edit()->set_base("");
    of_design.mutable_edit()->set_design(design);
    heard["EditStream, of a design"] = ask_stream(of_design);

    // Last, or a fault would hide those of the other calls.
    v1::DeleteRevisionRequest removed = revision(v1::DeleteRevisionRequest());
    removed.set_allow_head(true);
    heard["DeleteRevision"] = ask(stub(), &Remesh::DeleteRevision, removed);
    v1::DeleteDesignRequest no_design;
    no_design.set_design(design);
    heard["DeleteDesign"] = ask(stub(), &Remesh::DeleteDesign, no_design);
    return heard;
  }
};

TEST_F(NamesOfAnother, AnswerAsNamesThatNeverWere) {
  create_as("ben", plate(5, 10, "bens-plate"));
  create_as("anna", plate(5, 10, "annas-plate"));
  const std::string id = edit_as("anna", "annas-plate", 11).revision().id();
  std::string unknown_id = id;
  for (char& digit : unknown_id) digit = digit == '0' ? '1' : '0';
  const std::string design = "annas-plate", unknown_design = "other-plate";
  struct Name {
    std::string of_anna, of_nobody;
  };
  for (const auto& [of_anna, of_nobody] :
       {Name{id, unknown_id}, Name{id.substr(0, 8), unknown_id.substr(0, 8)},
        Name{design, unknown_design}, Name{design + "@2", unknown_design + "@2"}}) {
    const auto heard = asked(of_anna, design), expected = asked(of_nobody, unknown_design);
    EXPECT_GT(heard.size(), 20U);
    for (const auto& [call, told] : heard) {
      SCOPED_TRACE(call + " of " + of_anna);
      EXPECT_EQ(told.code, StatusCode::NOT_FOUND);
      EXPECT_EQ(told,
                renamed(renamed(expected.at(call), of_nobody, of_anna), unknown_design, design));
    }
  }
  EXPECT_EQ(list_as("anna").revisions_size(), 2);
  EXPECT_EQ(list_as("ben").revisions_size(), 1);
}

TEST_F(TenantCalls, ListsHaveTheTenantsOwnAlone) {
  const std::string first = create_as("anna", plate()).revision().id();
  edit_as("anna", "plate", 11);
  create_as("ben", plate(6));
  v1::ListRevisionsRequest of_parent, of_root, page;
  of_parent.mutable_filter()->set_parent(first);
  of_root.mutable_filter()->set_root(first);
  for (const auto& request : {of_parent, of_root}) {
    EXPECT_GT(list_as("anna", request).revisions_size(), 0);
    EXPECT_EQ(list_as("ben", request).revisions_size(), 0);
  }
  page.set_page_size(1);
  page.set_page_token(list_as("anna", page).next_page_token());
  EXPECT_NE(page.page_token(), "");
  EXPECT_EQ(list_as("anna", page).revisions(0).parent(), first);
  EXPECT_EQ(list_as("ben", page).revisions_size(), 0) << "after number 1 of the design";

  v1::ListDesignsResponse designs;
  EXPECT_TRUE(call_as("ben", stub(), &v1::RemeshService::Stub::ListDesigns, {}, &designs).ok());
  ASSERT_EQ(designs.designs_size(), 1);
  EXPECT_EQ(designs.designs(0).revisions(), 1U);
  v1::ListCacheEntriesResponse entries;
  EXPECT_TRUE(
      call_as("ben", cache(), &v1::CacheService::Stub::ListCacheEntries, {}, &entries).ok());
  EXPECT_EQ(entries.entries_size(), 1);
}

TEST_F(TenantCalls, FiguresAreTheTenantsOwn) {
  create_as("anna", plate());
  edit_as("anna", "plate", 11);
  create_as("ben", plate(6));
  EXPECT_EQ(load_of("anna").revisions(), 2U);
  EXPECT_EQ(load_of("ben").revisions(), 1U);
  EXPECT_EQ(load_of("ben").designs(), 1U);
  EXPECT_EQ(load_of("ben").cached_revisions(), 1U);
  EXPECT_LT(load_of("ben").disk_bytes(), load_of("anna").disk_bytes());
  v1::GetCacheStatsResponse stats;
  EXPECT_TRUE(call_as("ben", cache(), &v1::CacheService::Stub::GetCacheStats, {}, &stats).ok());
  EXPECT_EQ(stats.stored(), 1U);
  v1::CollectGarbageRequest all;
  all.set_disk_bytes(0);
  v1::CollectGarbageResponse collected;
  EXPECT_TRUE(
      call_as("ben", cache(), &v1::CacheService::Stub::CollectGarbage, all, &collected).ok());
  EXPECT_EQ(collected.meshes(), 1U);
  EXPECT_GT(load_of("anna").disk_bytes(), 0U);
}

TEST_F(TenantCalls, TwoMayUseTheSameDesignAndTheSameRequestId) {
  const auto of_anna = create_as("anna", plate(), "r-1");
  const auto of_ben = create_as("ben", plate(), "r-1");
  EXPECT_EQ(of_ben.revision().id(), of_anna.revision().id());
  EXPECT_EQ(of_ben.revision().number(), 1U);
  EXPECT_FALSE(of_ben.report().cached()) << "that another has made it is not to be told";
  EXPECT_EQ(engine_.made(), 2);
}

TEST_F(TenantCalls, RevisionsAreTheSameTenantsAfterARestart) {
  create_as("anna", plate());
  create_as("ben", plate(6));
  const std::string of_anna = list_as("anna").SerializeAsString();
  const std::string of_ben = list_as("ben").SerializeAsString();
  start();
  EXPECT_EQ(list_as("anna").SerializeAsString(), of_anna);
  EXPECT_EQ(list_as("ben").SerializeAsString(), of_ben);
  EXPECT_TRUE(std::filesystem::exists(folder_ / "tenants" / "anna" / "FORMAT"));
}

TEST_F(TenantCalls, WhatWasMadeWithoutTokensIsNoTenantsUntilItIsHandedToOne) {
  const auto doorman = std::exchange(options_.doorman, nullptr);
  create(plate());
  options_.doorman = doorman;
  start();
  EXPECT_EQ(list_as("anna").revisions_size(), 0);
  stop();
  // As deploy/CI-FARM.md tells.
  const std::filesystem::path of_carl = folder_ / "tenants" / "carl";
  std::filesystem::create_directories(of_carl);
  for (const char* name : {"FORMAT", "packs", "journal.a", "journal.b"})
    std::filesystem::rename(folder_ / name, of_carl / name);
  write_tokens({"anna", "carl"});
  doorman->reload();
  start();
  EXPECT_EQ(list_as("carl").revisions_size(), 1);
  EXPECT_EQ(list_as("anna").revisions_size(), 0);
}

TEST_F(TenantCalls, ATenantThatIsAddedIsServedOnceTheFileIsReadAnew) {
  create_as("anna", plate());
  write_tokens({"anna", "carl"});
  options_.doorman->reload();
  EXPECT_EQ(list_as("carl").revisions_size(), 0);
  create_as("carl", plate());
  EXPECT_EQ(list_as("anna").revisions_size(), 1);
  v1::ListRevisionsResponse none;
  EXPECT_EQ(call_as("ben", stub(), &v1::RemeshService::Stub::ListRevisions, {}, &none).error_code(),
            StatusCode::UNAUTHENTICATED);
}

TEST_F(TenantCalls, ATenantWhoseStoreCannotBeOpenedLeavesTheTokensAsTheyAre) {
  create_as("anna", plate());
  std::filesystem::create_directories(folder_ / "tenants" / "carl");
  std::ofstream(folder_ / "tenants" / "carl" / "thesis.tex") << "x";
  write_tokens({"carl"});
  try {
    options_.doorman->reload();
    ADD_FAILURE() << "a folder that is no store is taken";
  } catch (const Error& failure) {
    EXPECT_EQ(failure.info().reason, "STORE_FOREIGN");
  }
  EXPECT_EQ(list_as("anna").revisions_size(), 1);
}

TEST_F(TenantCalls, WithoutAStoreTenantsAreApartToo) {
  options_.store.clear();
  create_as("anna", plate());
  EXPECT_EQ(list_as("anna").revisions_size(), 1);
  EXPECT_EQ(list_as("ben").revisions_size(), 0);
}

}  // namespace
}  // namespace remeshd::test
