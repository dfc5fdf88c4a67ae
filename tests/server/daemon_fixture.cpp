#include "tests/server/daemon_fixture.h"

#include <grpcpp/generic/generic_stub.h>
#include <unistd.h>

#include <atomic>

#include "remesh/v1/rpc_status.pb.h"

namespace remeshd::test {

google::protobuf::Value& parameter(v1::FeatureModel& model, const std::string& name) {
  for (v1::Parameter& each : *model.mutable_parameters())
    if (each.name() == name) return *each.mutable_value();
  model.add_parameters()->set_name(name);
  return *model.mutable_parameters()->rbegin()->mutable_value();
}

google::protobuf::Value& parameter(v1::Feature& feature, const std::string& name) {
  for (v1::FeatureParameter& each : *feature.mutable_parameters())
    if (each.name() == name) return *each.mutable_value();
  feature.add_parameters()->set_name(name);
  return *feature.mutable_parameters()->rbegin()->mutable_value();
}

v1::FeatureModel plate(double r, double at, const std::string& name) {
  v1::FeatureModel model = parse_model(R"({
    "name": "", "unit": "mm", "parameters": {"r": 0, "at": 0},
    "features": [
      {"id": "plate", "nature": "ADDITIVE", "type": "block",
       "parameters": {"dx": 80, "dy": 40, "dz": 10}, "placement": {"origin": [0, 0, 0]}},
      {"id": "hole", "nature": "SUBTRACTIVE", "type": "cylinder",
       "parameters": {"radius": "r", "height": 10}, "placement": {"origin": ["at", 0, 0]}}]})");
  model.set_name(name);
  parameter(model, "r").set_number_value(r);
  parameter(model, "at").set_number_value(at);
  return model;
}

v1::ModelEdit set(const std::string& parameter, double value) {
  v1::ModelEdit edit;
  auto& change = *edit.add_edits()->mutable_set_parameter();
  change.set_name(parameter);
  change.mutable_value()->set_number_value(value);
  return edit;
}

v1::Error detail(const grpc::Status& status) {
  v1::RpcStatus details;
  EXPECT_TRUE(details.ParseFromString(status.error_details()));
  EXPECT_EQ(details.code(), status.error_code());
  v1::Error error;
  for (const auto& any : details.details())
    if (any.type_url() == "type.googleapis.com/remesh.v1.Error") {
      EXPECT_TRUE(error.ParseFromString(any.value()));
      EXPECT_EQ(static_cast<int>(error.code()), status.error_code());
      return error;
    }
  ADD_FAILURE() << "no Error in the details of: " << status.error_message();
  return error;
}

DaemonTest::~DaemonTest() {
  engine_.open_gate();
  stop();
  if (!folder_.empty()) std::filesystem::remove_all(folder_);
}

void DaemonTest::start() {
  stop();
  daemon_ = std::make_unique<Daemon>(options_, make_engine());
  // A channel of its own: channels of one process to one address share their connection.
  grpc::ChannelArguments arguments;
  arguments.SetInt(GRPC_ARG_USE_LOCAL_SUBCHANNEL_POOL, 1);
  arguments.SetMaxSendMessageSize(-1);
  channel_ = grpc::CreateCustomChannel("127.0.0.1:" + std::to_string(daemon_->port()),
                                       grpc::InsecureChannelCredentials(), arguments);
  stub_ = v1::RemeshService::NewStub(channel_);
}

void DaemonTest::stop() {
  stub_.reset();
  channel_.reset();
  daemon_.reset();
}

void DaemonTest::use_store() {
  static std::atomic<int> counter{0};
  folder_ = std::filesystem::temp_directory_path() /
            ("remeshd-server-test-" + std::to_string(::getpid()) + "-" + std::to_string(counter++));
  std::filesystem::remove_all(folder_);
  options_.store = folder_;
}

v1::CreateRevisionRequest DaemonTest::create_request(const v1::FeatureModel& model,
                                                     std::uint32_t nodes) {
  v1::CreateRevisionRequest request;
  *request.mutable_model() = model;
  request.mutable_options()->set_nodes(nodes);
  return request;
}

v1::EditRevisionRequest DaemonTest::edit_request(const std::string& base,
                                                 const v1::ModelEdit& edit) {
  v1::EditRevisionRequest request;
  request.set_base(base);
  *request.mutable_edit() = edit;
  return request;
}

grpc::Status DaemonTest::try_create(const v1::CreateRevisionRequest& request,
                                    v1::RevisionResult* reply) {
  grpc::ClientContext context;
  v1::CreateRevisionResponse response;
  const grpc::Status status = stub().CreateRevision(&context, request, &response);
  *reply = response.result();
  return status;
}
grpc::Status DaemonTest::try_edit(const v1::EditRevisionRequest& request,
                                  v1::RevisionResult* reply) {
  grpc::ClientContext context;
  v1::EditRevisionResponse response;
  const grpc::Status status = stub().EditRevision(&context, request, &response);
  *reply = response.result();
  return status;
}

v1::RevisionResult DaemonTest::create(const v1::CreateRevisionRequest& request) {
  v1::RevisionResult reply;
  const grpc::Status status = try_create(request, &reply);
  EXPECT_TRUE(status.ok()) << status.error_message();
  return reply;
}
v1::RevisionResult DaemonTest::edit(const v1::EditRevisionRequest& request) {
  v1::RevisionResult reply;
  const grpc::Status status = try_edit(request, &reply);
  EXPECT_TRUE(status.ok()) << status.error_message();
  return reply;
}

v1::GetRevisionResponse DaemonTest::describe(const std::string& revision) {
  grpc::ClientContext context;
  v1::GetRevisionRequest request;
  request.set_revision(revision);
  v1::GetRevisionResponse reply;
  const grpc::Status status = stub().GetRevision(&context, request, &reply);
  EXPECT_TRUE(status.ok()) << status.error_message();
  return reply;
}

v1::ListRevisionsResponse DaemonTest::list(const std::string& design) {
  grpc::ClientContext context;
  v1::ListRevisionsRequest request;
  request.mutable_filter()->set_design(design);
  v1::ListRevisionsResponse reply;
  const grpc::Status status = stub().ListRevisions(&context, request, &reply);
  EXPECT_TRUE(status.ok()) << status.error_message();
  return reply;
}

grpc::Status DaemonTest::remove(const std::string& revision, bool allow_head,
                                v1::DeleteRevisionResponse* reply) {
  grpc::ClientContext context;
  v1::DeleteRevisionRequest request;
  request.set_revision(revision);
  request.set_allow_head(allow_head);
  v1::DeleteRevisionResponse unused;
  return stub().DeleteRevision(&context, request, reply != nullptr ? reply : &unused);
}

v1::ServerInfo DaemonTest::info() {
  grpc::ClientContext context;
  v1::GetServerInfoResponse reply;
  const grpc::Status status = stub().GetServerInfo(&context, {}, &reply);
  EXPECT_TRUE(status.ok()) << status.error_message();
  return reply.server();
}

bool DaemonTest::serves() {
  grpc::ClientContext context;
  v1::GetServerInfoResponse reply;
  return stub().GetServerInfo(&context, {}, &reply).ok();
}

grpc::Status DaemonTest::call(const std::string& method, const std::string& request,
                              std::string* reply) {
  grpc::GenericStub generic(channel_);
  grpc::ClientContext context;
  grpc::CompletionQueue queue;
  const grpc::Slice slice(request);
  auto call = generic.PrepareUnaryCall(&context, method, grpc::ByteBuffer(&slice, 1), &queue);
  call->StartCall();
  grpc::ByteBuffer answer;
  grpc::Status status;
  call->Finish(&answer, &status, nullptr);
  void* tag = nullptr;
  bool ok = false;
  queue.Next(&tag, &ok);
  grpc::Slice all;
  if (status.ok() && answer.DumpToSingleSlice(&all).ok())
    reply->assign(reinterpret_cast<const char*>(all.begin()), all.size());
  return status;
}

std::vector<v1::MeshMessage> DaemonTest::mesh(const v1::GetMeshRequest& request) {
  grpc::ClientContext context;
  const auto reader = stub().GetMesh(&context, request);
  std::vector<v1::MeshMessage> messages;
  for (v1::GetMeshResponse part; reader->Read(&part);) messages.push_back(part.mesh());
  const grpc::Status status = reader->Finish();
  EXPECT_TRUE(status.ok()) << status.error_message();
  return messages;
}

std::string DaemonTest::mesh_bytes(const std::string& revision) {
  v1::GetMeshRequest request;
  request.set_revision(revision);
  std::string bytes;
  for (const v1::MeshMessage& message : mesh(request)) bytes += message.part().data();
  return bytes;
}

}  // namespace remeshd::test
