#pragma once

#include <gmock/gmock.h>
#include <grpcpp/grpcpp.h>

#include <filesystem>
#include <memory>
#include <string>
#include <utility>

#include "proto/document.h"
#include "remesh/v1/remesh.grpc.pb.h"
#include "server/daemon.h"
#include "tests/server/fake_engine.h"

namespace remeshd::test {

namespace v1 = remesh::v1;

/// The value of a parameter, which is added if it is not there.
google::protobuf::Value& parameter(v1::FeatureModel& model, const std::string& name);
google::protobuf::Value& parameter(v1::Feature& feature, const std::string& name);

/// A plate with a hole of radius `r` at x = `at`.
v1::FeatureModel plate(double r = 5, double at = 10, const std::string& name = "plate");
/// The edit that sets a parameter of the model.
v1::ModelEdit set(const std::string& parameter, double value);

/// The Error in a status' details; fails the test where there is none.
v1::Error detail(const grpc::Status& status);

/// A daemon with a fake engine on a free port of loopback, and a stub.
class DaemonTest : public testing::Test {
 protected:
  DaemonTest() {
    options_.listen = {"127.0.0.1:0"};
    options_.workers = 2;
    options_.threads = 3;
  }
  ~DaemonTest() override;

  /// The engine to start with.
  [[nodiscard]] virtual Engine make_engine() const { return engine_.engine(); }
  /// Starts with `options_`, or starts anew.
  void start();
  void stop();
  /// Makes a fresh folder the store; gone after the test.
  void use_store();

  v1::RemeshService::Stub& stub() {
    if (!stub_) start();
    return *stub_;
  }

  static v1::CreateRevisionRequest create_request(const v1::FeatureModel& model,
                                                  std::uint32_t nodes = 100);
  v1::EditRevisionRequest edit_request(const std::string& base, const v1::ModelEdit& edit);

  grpc::Status try_create(const v1::CreateRevisionRequest& request, v1::RevisionResult* reply);
  grpc::Status try_edit(const v1::EditRevisionRequest& request, v1::RevisionResult* reply);
  /// These fail the test on an error.
  v1::RevisionResult create(const v1::CreateRevisionRequest& request);
  v1::RevisionResult create(const v1::FeatureModel& model) { return create(create_request(model)); }
  v1::RevisionResult edit(const v1::EditRevisionRequest& request);
  v1::RevisionResult edit(const std::string& base, const v1::ModelEdit& changes) {
    return edit(edit_request(base, changes));
  }
  v1::GetRevisionResponse describe(const std::string& revision);
  v1::ListRevisionsResponse list(const std::string& design = "");
  grpc::Status remove(const std::string& revision, bool allow_head,
                      v1::DeleteRevisionResponse* reply = nullptr);
  v1::ServerInfo info();
  /// All messages of a mesh.
  std::vector<v1::MeshMessage> mesh(const v1::GetMeshRequest& request);
  /// The data of all parts, one after the other.
  std::string mesh_bytes(const std::string& revision);
  bool serves();
  /// A call of bytes to bytes, past the stub; `reply` is left alone where the call fails.
  grpc::Status call(const std::string& method, const std::string& request, std::string* reply);

  DaemonOptions options_;
  FakeEngine engine_;
  std::unique_ptr<Daemon> daemon_;
  std::shared_ptr<grpc::Channel> channel_;
  std::unique_ptr<v1::RemeshService::Stub> stub_;
  std::filesystem::path folder_;
};

}  // namespace remeshd::test
