#pragma once

#include <grpcpp/create_channel.h>
#include <grpcpp/security/credentials.h>
#include <grpcpp/server.h>
#include <grpcpp/server_builder.h>

#include <condition_variable>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <set>
#include <string>
#include <thread>
#include <variant>
#include <vector>

#include "remesh/v1/remesh.grpc.pb.h"
#include "remesh/v1/rpc_status.pb.h"
#include "tests/client/mesh_messages.h"
#include "tests/client/sample_mesh.h"

namespace remeshd::client {

/// A status that carries `error` in its details, as the daemon sends it.
inline grpc::Status status_of(const remesh::v1::Error& error) {
  remesh::v1::RpcStatus rich;
  rich.set_code(static_cast<int>(error.code()));
  rich.set_message(error.message());
  rich.add_details()->PackFrom(error);
  return {static_cast<grpc::StatusCode>(error.code()), error.message(), rich.SerializeAsString()};
}

inline remesh::v1::Error make_error(remesh::v1::Error::Code code, const std::string& reason) {
  remesh::v1::Error error;
  error.set_code(code);
  error.set_reason(reason);
  error.set_message("told by the test");
  return error;
}

/// A daemon that meshes nothing: what it gets is noted, what it answers is set by the test.
///
/// Revisions are numbered `rev-1`, `rev-2`, ... in the order of the requests of the stream.
class FakeService final : public remesh::v1::Remesh::Service {
 public:
  using Answer = std::variant<remesh::v1::RevisionReply, remesh::v1::Error>;

  /// The failure of every call that is not the stream.
  std::optional<remesh::v1::Error> failure;
  /// What the stream answers to the k-th request, from 0; where empty: a plain revision.
  std::map<int, remesh::v1::Error> stream_errors;
  /// Requests that are never answered unless they are cancelled, by place.
  std::set<int> hanging;
  /// Breaks the stream with this status before it answers anything.
  std::optional<remesh::v1::Error> stream_failure;
  std::function<void(std::vector<remesh::v1::MeshMessage>&)> damage;
  Mesh mesh = sample_mesh(1);
  remesh::v1::Comparison comparison;
  std::vector<remesh::v1::RevisionInfo> revisions;
  std::uint32_t page = 1000;
  bool head_moved = false;

  // What came.
  std::vector<remesh::v1::EditStreamRequest> requests;
  remesh::v1::CompareRequest compare_request;
  remesh::v1::ValidateModelRequest model_request;
  remesh::v1::ValidateEditRequest edit_request;
  std::vector<remesh::v1::DeleteRevisionRequest> deletions;

  grpc::Status EditStream(
      grpc::ServerContext* context,
      grpc::ServerReaderWriter<remesh::v1::EditStreamReply, remesh::v1::EditStreamRequest>* stream)
      override {
    if (stream_failure) return status_of(*stream_failure);
    std::mutex mutex;
    std::condition_variable changed;
    std::deque<remesh::v1::EditStreamRequest> waiting;
    std::set<std::string> cancelled;
    bool ended = false;
    std::thread reader([&] {
      remesh::v1::EditStreamRequest request;
      while (stream->Read(&request)) {
        const std::lock_guard lock(mutex);
        if (request.has_cancel())
          cancelled.insert(request.cancel().request_id());
        else
          waiting.push_back(request);
        changed.notify_all();
      }
      const std::lock_guard lock(mutex);
      ended = true;
      changed.notify_all();
    });
    for (int k = 0;; ++k) {
      std::unique_lock lock(mutex);
      changed.wait(lock, [&] { return ended || !waiting.empty(); });
      if (waiting.empty()) break;
      const auto request = waiting.front();
      waiting.pop_front();
      requests.push_back(request);
      const std::string id =
          request.has_edit() ? request.edit().request_id() : request.create().request_id();
      if (hanging.contains(k))
        changed.wait(lock,
                     [&] { return cancelled.contains(id) || context->IsCancelled() || ended; });
      const bool was_cancelled = cancelled.contains(id);
      lock.unlock();
      answer(*stream, k, id, request, was_cancelled);
    }
    reader.join();
    return grpc::Status::OK;
  }

  grpc::Status CreateRevision(grpc::ServerContext*,
                              const remesh::v1::CreateRevisionRequest* request,
                              remesh::v1::RevisionReply* reply) override {
    if (failure) return status_of(*failure);
    *reply = revision(1, request->model().name(), "");
    return grpc::Status::OK;
  }

  grpc::Status GetMesh(grpc::ServerContext*, const remesh::v1::GetMeshRequest*,
                       grpc::ServerWriter<remesh::v1::MeshMessage>* writer) override {
    if (failure) return status_of(*failure);
    auto messages = mesh_messages(mesh, 4096);
    if (damage) damage(messages);
    for (const auto& message : messages) writer->Write(message);
    return grpc::Status::OK;
  }

  grpc::Status Compare(grpc::ServerContext*, const remesh::v1::CompareRequest* request,
                       remesh::v1::Comparison* reply) override {
    compare_request = *request;
    if (failure) return status_of(*failure);
    *reply = comparison;
    return grpc::Status::OK;
  }

  grpc::Status ListRevisions(grpc::ServerContext*, const remesh::v1::ListRevisionsRequest* request,
                             remesh::v1::ListRevisionsReply* reply) override {
    if (failure) return status_of(*failure);
    std::size_t at = request->page_token().empty() ? 0 : std::stoul(request->page_token());
    for (; at < revisions.size() && reply->revisions_size() < static_cast<int>(page); ++at)
      if (request->design().empty() || request->design() == revisions[at].design())
        *reply->add_revisions() = revisions[at];
    if (at < revisions.size()) reply->set_next_page_token(std::to_string(at));
    return grpc::Status::OK;
  }

  grpc::Status DescribeRevision(grpc::ServerContext*,
                                const remesh::v1::DescribeRevisionRequest* request,
                                remesh::v1::RevisionDescription* reply) override {
    if (failure) return status_of(*failure);
    reply->mutable_revision()->set_id("id-of-" + request->revision());
    reply->mutable_model()->set_name("described");
    (*reply->mutable_model()->mutable_parameters())["top_x"].set_number_value(1);
    reply->mutable_model()->add_features()->set_id("hub");
    return grpc::Status::OK;
  }

  grpc::Status DeleteRevision(grpc::ServerContext*,
                              const remesh::v1::DeleteRevisionRequest* request,
                              remesh::v1::DeleteRevisionReply*) override {
    deletions.push_back(*request);
    return failure ? status_of(*failure) : grpc::Status::OK;
  }

  grpc::Status ValidateModel(grpc::ServerContext*, const remesh::v1::ValidateModelRequest* request,
                             remesh::v1::ValidateReply* reply) override {
    model_request = *request;
    if (failure) return status_of(*failure);
    reply->set_volume(258000);
    return grpc::Status::OK;
  }

  grpc::Status ValidateEdit(grpc::ServerContext*, const remesh::v1::ValidateEditRequest* request,
                            remesh::v1::ValidateReply* reply) override {
    edit_request = *request;
    if (failure) return status_of(*failure);
    reply->set_volume(258000);
    return grpc::Status::OK;
  }

  grpc::Status ListFeatureTypes(grpc::ServerContext*, const remesh::v1::ListFeatureTypesRequest*,
                                remesh::v1::ListFeatureTypesReply* reply) override {
    if (failure) return status_of(*failure);
    auto* type = reply->add_types();
    type->set_name("sphere");
    auto* radius = type->add_parameters();
    radius->set_name("radius");
    radius->set_unit("length");
    radius->set_required(true);
    type->add_faces("surface");
    return grpc::Status::OK;
  }

 private:
  [[nodiscard]] remesh::v1::RevisionReply revision(int k, const std::string& design,
                                                   const std::string& parent) const {
    remesh::v1::RevisionReply reply;
    reply.set_head_moved(head_moved);
    reply.set_head_number(9);
    reply.mutable_revision()->set_id("rev-" + std::to_string(k));
    reply.mutable_revision()->set_design(design.empty() ? "d" : design);
    reply.mutable_revision()->set_number(static_cast<std::uint32_t>(k));
    reply.mutable_revision()->set_parent(parent);
    auto* report = reply.mutable_report();
    report->set_revision(reply.revision().id());
    report->set_nodes(1500);
    report->set_tets(7000);
    report->set_nodes_kept(parent.empty() ? 0 : 1200);
    report->set_free_share(parent.empty() ? 1 : 0.25);
    report->set_volume(0.1);
    report->mutable_seconds()->set_total(0.5);
    report->mutable_quality()->set_dihedral_min(25);
    return reply;
  }

  void answer(
      grpc::ServerReaderWriter<remesh::v1::EditStreamReply, remesh::v1::EditStreamRequest>& stream,
      int k, const std::string& id, const remesh::v1::EditStreamRequest& request,
      bool was_cancelled) {
    remesh::v1::EditStreamReply reply;
    reply.set_request_id(id);
    reply.mutable_progress()->set_stage("optimise");
    reply.mutable_progress()->set_iteration(3);
    reply.mutable_progress()->set_fraction(0.5);
    stream.Write(reply);
    if (was_cancelled)
      *reply.mutable_error() = make_error(remesh::v1::Error::CANCELLED, "Cancelled");
    else if (const auto error = stream_errors.find(k); error != stream_errors.end())
      *reply.mutable_error() = error->second;
    else
      *reply.mutable_revision() = revision(k + 1, request.create().model().name(),
                                           request.has_edit() ? request.edit().base() : "");
    stream.Write(reply);
  }
};

/// A FakeService behind a port of this machine.
class FakeDaemon {
 public:
  FakeDaemon() {
    int port = 0;
    grpc::ServerBuilder builder;
    builder.AddListeningPort("127.0.0.1:0", grpc::InsecureServerCredentials(), &port);
    builder.RegisterService(&service);
    server_ = builder.BuildAndStart();
    address = "127.0.0.1:" + std::to_string(port);
  }
  ~FakeDaemon() {
    // Ends calls that hang.
    server_->Shutdown(std::chrono::system_clock::now() + std::chrono::milliseconds(200));
  }
  FakeDaemon(const FakeDaemon&) = delete;
  FakeDaemon& operator=(const FakeDaemon&) = delete;

  FakeService service;
  std::string address;

 private:
  std::unique_ptr<grpc::Server> server_;
};

}  // namespace remeshd::client
