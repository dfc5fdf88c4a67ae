#pragma once

#include <grpcpp/server_context.h>
#include <grpcpp/support/sync_stream.h>

#include <condition_variable>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <set>
#include <string>
#include <thread>
#include <utility>
#include <variant>
#include <vector>

#include "remesh/v1/remesh.grpc.pb.h"
#include "tests/client/mesh_messages.h"
#include "tests/client/sample_mesh.h"
#include "tests/client/told_errors.h"

namespace remeshd::client {

/// A daemon that meshes nothing: what it gets is noted, what it answers is set by the test.
///
/// Revisions are numbered `rev-1`, `rev-2`, ... in the order of the requests of the stream; an edit
/// without a base is of the one before it.
class FakeService final : public remesh::v1::RemeshService::Service {
 public:
  /// The failure of every call that is not the stream.
  std::optional<remesh::v1::Error> failure;
  /// What every call ends with before it answers anything, the stream at its first request: what a
  /// daemon that is gone looks like.
  std::optional<grpc::Status> gone;
  /// What the stream answers to every request.
  std::optional<remesh::v1::Error> stream_error;
  /// What the stream answers to the k-th request, from 0; where empty: a plain revision.
  std::map<int, remesh::v1::Error> stream_errors;
  /// What it answers after the result, in place of the mesh that was asked for.
  std::map<int, remesh::v1::Error> mesh_errors;
  /// Requests that are never answered unless they are cancelled, by place.
  std::set<int> hanging;
  /// Breaks the stream with this status before it answers anything.
  std::optional<remesh::v1::Error> stream_failure;
  /// Breaks a stream off at the request after so many answers; the next ones stay.
  std::optional<int> stream_break;
  int broken_off = 1;  ///< requests that such a break leaves unanswered
  std::function<void(std::vector<remesh::v1::MeshMessage>&)> damage;
  /// Breaks every GetMesh off after so many messages, and the next GetMeshFile.
  std::optional<int> mesh_break;
  bool breaks_after_mesh = false;  ///< breaks every GetMesh off after the end of the mesh
  std::optional<int> file_break;  ///< breaks every GetMeshFile off after so many messages
  std::vector<remesh::v1::GetMeshFileResponse> file_messages;  ///< of every GetMeshFile
  Mesh mesh = sample_mesh(1);
  /// The meshes of `rev-1`, `rev-2`, ... of the stream; beyond the last: `mesh`.
  std::vector<Mesh> stream_meshes;
  remesh::v1::Comparison comparison;
  std::vector<remesh::v1::RevisionInfo> revisions;
  std::uint32_t page = 1000;
  std::optional<int> list_break;  ///< breaks every ListRevisions off after so many pages
  bool head_conflict = false;
  bool files_all = false;  ///< refuses HeadUpdate.file = false
  std::vector<remesh::v1::Warning> warnings;
  std::vector<remesh::v1::Report::Attempt> attempts;
  remesh::v1::Report stored_report;  ///< of every GetRevision
  std::string stored_parent;
  std::map<std::string, std::string> parents;  ///< by name of a revision; else: `stored_parent`
  std::map<std::string, Mesh> meshes_by_name;  ///< else: `mesh`
  std::map<std::string, remesh::v1::RevisionInfo> infos;  ///< by name of a revision

  // What came.
  std::vector<remesh::v1::EditStreamRequest> requests;
  remesh::v1::CompareRequest compare_request;
  remesh::v1::ValidateModelRequest model_request;
  remesh::v1::ValidateEditRequest edit_request;
  std::vector<remesh::v1::DeleteRevisionRequest> deletions;
  std::vector<remesh::v1::DeleteDesignRequest> design_deletions;
  std::vector<remesh::v1::SetHeadRequest> heads;
  std::vector<remesh::v1::RemakeRevisionRequest> remakes;
  std::vector<remesh::v1::GetMeshRequest> mesh_requests;
  std::vector<remesh::v1::GetMeshFileRequest> file_requests;
  std::vector<std::string> looked_up;  ///< by GetRevision
  std::vector<std::string> keys;       ///< `x-remesh-key` of each call

  grpc::Status EditStream(
      grpc::ServerContext* context,
      grpc::ServerReaderWriter<remesh::v1::EditStreamResponse, remesh::v1::EditStreamRequest>*
          stream) override {
    note(*context);
    if (stream_failure) return status_of(*stream_failure);
    if (gone) {
      remesh::v1::EditStreamRequest request;
      stream->Read(&request);
      return *gone;
    }
    if (const auto answers = std::exchange(stream_break, std::nullopt))
      return break_off(*stream, *answers);
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

  grpc::Status CreateRevision(grpc::ServerContext* context,
                              const remesh::v1::CreateRevisionRequest* request,
                              remesh::v1::CreateRevisionResponse* response) override {
    if (const auto wrong = begin(*context)) return *wrong;
    *response->mutable_result() = revision(1, request->model().name(), "");
    return grpc::Status::OK;
  }

  grpc::Status EditRevision(grpc::ServerContext* context,
                            const remesh::v1::EditRevisionRequest* request,
                            remesh::v1::EditRevisionResponse* response) override {
    requests.emplace_back();
    *requests.back().mutable_edit() = *request;
    if (const auto wrong = begin(*context)) return *wrong;
    *response->mutable_result() = revision(2, "", request->base());
    return grpc::Status::OK;
  }

  grpc::Status GetMesh(grpc::ServerContext* context, const remesh::v1::GetMeshRequest* request,
                       grpc::ServerWriter<remesh::v1::GetMeshResponse>* writer) override {
    mesh_requests.push_back(*request);
    if (const auto wrong = begin(*context)) return *wrong;
    const auto named = meshes_by_name.find(request->revision());
    auto messages = messages_of(named == meshes_by_name.end() ? mesh : named->second,
                                request->selection(), nullptr);
    if (request->has_resume_from()) drop_before(request->resume_from(), messages);
    int written = 0;
    for (const auto& message : messages) {
      if (mesh_break && written++ == *mesh_break)
        return {grpc::StatusCode::UNAVAILABLE, "told by the test"};
      remesh::v1::GetMeshResponse response;
      *response.mutable_mesh() = message;
      writer->Write(response);
    }
    if (breaks_after_mesh) return {grpc::StatusCode::UNAVAILABLE, "told by the test"};
    return grpc::Status::OK;
  }

  grpc::Status GetMeshFile(grpc::ServerContext* context,
                           const remesh::v1::GetMeshFileRequest* request,
                           grpc::ServerWriter<remesh::v1::GetMeshFileResponse>* writer) override {
    file_requests.push_back(*request);
    if (const auto wrong = begin(*context)) return *wrong;
    const auto stop = file_break ? file_break : std::exchange(mesh_break, std::nullopt);
    int written = 0;
    for (const auto& message : file_messages) {
      if (stop && written++ == *stop) return {grpc::StatusCode::UNAVAILABLE, "told by the test"};
      writer->Write(message);
    }
    return grpc::Status::OK;
  }

  grpc::Status Compare(grpc::ServerContext*, const remesh::v1::CompareRequest* request,
                       remesh::v1::CompareResponse* response) override {
    compare_request = *request;
    if (failure) return status_of(*failure);
    *response->mutable_comparison() = comparison;
    return grpc::Status::OK;
  }

  grpc::Status ListRevisions(grpc::ServerContext* context,
                             const remesh::v1::ListRevisionsRequest* request,
                             remesh::v1::ListRevisionsResponse* response) override {
    if (const auto wrong = begin(*context)) return *wrong;
    if (list_break && (*list_break)-- <= 0)
      return {grpc::StatusCode::UNAVAILABLE, "told by the test"};
    const std::string& design = request->filter().design();
    std::size_t at = request->page_token().empty() ? 0 : std::stoul(request->page_token());
    for (; at < revisions.size() && response->revisions_size() < static_cast<int>(page); ++at)
      if (design.empty() || design == revisions[at].design())
        *response->add_revisions() = revisions[at];
    if (at < revisions.size()) response->set_next_page_token(std::to_string(at));
    return grpc::Status::OK;
  }

  grpc::Status GetRevision(grpc::ServerContext* context,
                           const remesh::v1::GetRevisionRequest* request,
                           remesh::v1::GetRevisionResponse* response) override {
    looked_up.push_back(request->revision());
    if (const auto wrong = begin(*context)) return *wrong;
    auto* info = response->mutable_revision();
    if (const auto known = infos.find(request->revision()); known != infos.end()) {
      *info = known->second;
      return grpc::Status::OK;
    }
    info->set_id("id-of-" + request->revision());
    info->set_design(request->revision());
    info->set_number(7);
    const auto parent = parents.find(request->revision());
    info->set_parent(parent == parents.end() ? stored_parent : parent->second);
    *response->mutable_report() = stored_report;
    auto* model = response->mutable_model();
    model->set_name("described");
    for (const char* name : {"top_x", "a", "b"}) {
      auto* parameter = model->add_parameters();
      parameter->set_name(name);
      parameter->mutable_value()->set_number_value(1);
    }
    model->add_features()->set_id("hub");
    return grpc::Status::OK;
  }

  grpc::Status SetHead(grpc::ServerContext* context, const remesh::v1::SetHeadRequest* request,
                       remesh::v1::SetHeadResponse* response) override {
    heads.push_back(*request);
    if (const auto wrong = begin(*context)) return *wrong;
    response->mutable_design()->set_name("d");
    response->mutable_design()->set_head("id-of-" + request->revision());
    response->mutable_design()->set_head_number(2);
    return grpc::Status::OK;
  }

  grpc::Status RemakeRevision(grpc::ServerContext*,
                              const remesh::v1::RemakeRevisionRequest* request,
                              remesh::v1::RemakeRevisionResponse* response) override {
    remakes.push_back(*request);
    if (failure) return status_of(*failure);
    *response->mutable_result() = revision(1, "", "");
    response->add_remade("0123456789abcdef");
    return grpc::Status::OK;
  }

  grpc::Status DeleteRevision(grpc::ServerContext*,
                              const remesh::v1::DeleteRevisionRequest* request,
                              remesh::v1::DeleteRevisionResponse*) override {
    deletions.push_back(*request);
    return failure ? status_of(*failure) : grpc::Status::OK;
  }

  grpc::Status DeleteDesign(grpc::ServerContext*, const remesh::v1::DeleteDesignRequest* request,
                            remesh::v1::DeleteDesignResponse* response) override {
    design_deletions.push_back(*request);
    response->set_revisions(3);
    response->set_meshes_deleted(2);
    return failure ? status_of(*failure) : grpc::Status::OK;
  }

  grpc::Status ValidateModel(grpc::ServerContext*, const remesh::v1::ValidateModelRequest* request,
                             remesh::v1::ValidateModelResponse* response) override {
    model_request = *request;
    if (failure) return status_of(*failure);
    fill(*response->mutable_check());
    return grpc::Status::OK;
  }

  grpc::Status ValidateEdit(grpc::ServerContext*, const remesh::v1::ValidateEditRequest* request,
                            remesh::v1::ValidateEditResponse* response) override {
    edit_request = *request;
    if (failure) return status_of(*failure);
    fill(*response->mutable_check());
    return grpc::Status::OK;
  }

  grpc::Status ListFeatureTypes(grpc::ServerContext*, const remesh::v1::ListFeatureTypesRequest*,
                                remesh::v1::ListFeatureTypesResponse* response) override {
    if (failure) return status_of(*failure);
    auto* type = response->add_types();
    type->set_name("sphere");
    auto* radius = type->add_parameters();
    radius->set_name("radius");
    radius->set_unit("length");
    radius->set_required(true);
    type->add_faces("surface");
    return grpc::Status::OK;
  }

  grpc::Status GetServerInfo(grpc::ServerContext*, const remesh::v1::GetServerInfoRequest*,
                             remesh::v1::GetServerInfoResponse* response) override {
    if (failure) return status_of(*failure);
    response->mutable_server()->set_version("1.2.3");
    return grpc::Status::OK;
  }

 private:
  using Stream =
      grpc::ServerReaderWriter<remesh::v1::EditStreamResponse, remesh::v1::EditStreamRequest>;

  void note(const grpc::ServerContext& context) {
    const auto key = context.client_metadata().find("x-remesh-key");
    keys.push_back(key == context.client_metadata().end()
                       ? ""
                       : std::string(key->second.data(), key->second.size()));
  }
  /// How the call ends, where it does.
  std::optional<grpc::Status> begin(const grpc::ServerContext& context) {
    note(context);
    if (gone) return gone;
    if (failure) return status_of(*failure);
    return {};
  }

  void fill(remesh::v1::ModelCheck& check) const {
    check.set_volume(258000);
    auto& forecast = *check.mutable_forecast();
    forecast.set_nodes(15020);
    forecast.set_bytes(23'400'000);
    forecast.set_seconds(1.5);
    auto& detail = *forecast.add_details();
    detail.set_feature("hole");
    detail.set_face("hole.wall");
    detail.set_size(0.25);
    for (const auto& warning : warnings) *check.add_warnings() = warning;
  }

  [[nodiscard]] remesh::v1::RevisionResult revision(int k, const std::string& design,
                                                    const std::string& parent) const {
    remesh::v1::RevisionResult result;
    result.set_head_conflict(head_conflict);
    result.set_head_number(9);
    result.mutable_revision()->set_id("rev-" + std::to_string(k));
    result.mutable_revision()->set_design(design.empty() ? "d" : design);
    result.mutable_revision()->set_number(static_cast<std::uint32_t>(k));
    result.mutable_revision()->set_parent(parent);
    auto* report = result.mutable_report();
    report->set_revision(result.revision().id());
    report->set_way(parent.empty() ? remesh::v1::Report::WAY_LOCAL
                                   : remesh::v1::Report::WAY_MORPHED);
    report->set_nodes(1500);
    report->set_tets(7000);
    report->set_nodes_kept(parent.empty() ? 0 : 1200);
    report->set_free_share(parent.empty() ? 1 : 0.25);
    report->set_volume(0.1);
    report->mutable_seconds()->set_total(0.5);
    report->mutable_quality()->set_dihedral_min(25);
    for (const auto& warning : warnings) *report->add_warnings() = warning;
    for (const auto& attempt : attempts) *report->add_attempts() = attempt;
    return result;
  }

  [[nodiscard]] std::vector<remesh::v1::MeshMessage> messages_of(
      const Mesh& sent, const remesh::v1::MeshSelection& selection, const Mesh* base) const {
    Sending sending;
    for (const int array : selection.arrays())
      sending.arrays.push_back(static_cast<remesh::v1::MeshArray>(array));
    if (selection.delta()) sending.base = base;
    auto messages = mesh_messages(sent, sending);
    if (damage) damage(messages);
    return messages;
  }

  /// The k-th mesh of the stream, against the one before it.
  void send_mesh(Stream& stream, int k, const std::string& id,
                 const remesh::v1::MeshSelection& selection) const {
    const auto at = static_cast<std::size_t>(k);
    const Mesh* base = k > 0 && at < stream_meshes.size() ? &stream_meshes[at - 1] : nullptr;
    const Mesh& sent = at < stream_meshes.size() ? stream_meshes[at] : mesh;
    for (const auto& message : messages_of(sent, selection, base)) {
      remesh::v1::EditStreamResponse response;
      response.set_request_id(id);
      *response.mutable_mesh() = message;
      stream.Write(response);
    }
  }

  [[nodiscard]] std::optional<remesh::v1::Error> error_of_request(
      int k, const remesh::v1::EditStreamRequest& request) const {
    if (stream_error) return stream_error;
    if (const auto error = stream_errors.find(k); error != stream_errors.end())
      return error->second;
    const auto& head = request.has_edit() ? request.edit().head() : request.create().head();
    if (files_all && head.has_file() && !head.file())
      return make_error(remesh::v1::Error::CODE_UNIMPLEMENTED, remesh::v1::Error::UNSUPPORTED);
    return {};
  }

  grpc::Status break_off(Stream& stream, int answers) {
    remesh::v1::EditStreamRequest request;
    for (int k = 0; stream.Read(&request); ++k) {
      requests.push_back(request);
      if (k == answers + broken_off - 1) break;
      if (k >= answers) continue;
      answer(stream, k,
             request.has_edit() ? request.edit().request_id() : request.create().request_id(),
             request, false);
    }
    return {grpc::StatusCode::UNAVAILABLE, "told by the test"};
  }

  void answer(Stream& stream, int k, const std::string& id,
              const remesh::v1::EditStreamRequest& request, bool was_cancelled) {
    remesh::v1::EditStreamResponse response;
    response.set_request_id(id);
    response.mutable_progress()->set_stage("optimise");
    response.mutable_progress()->set_iteration(3);
    response.mutable_progress()->set_fraction(0.5);
    stream.Write(response);
    auto error = error_of_request(k, request);
    if (was_cancelled)
      error = make_error(remesh::v1::Error::CODE_CANCELLED, remesh::v1::Error::CANCELLED);
    if (error) {
      *response.mutable_error() = *error;
      stream.Write(response);
      return;
    }
    const std::string before =
        request.edit().base().empty() ? "rev-" + std::to_string(k) : request.edit().base();
    *response.mutable_result() =
        revision(k + 1, request.create().model().name(), request.has_edit() ? before : "");
    stream.Write(response);
    if (!request.has_mesh()) return;
    if (const auto mesh_error = mesh_errors.find(k); mesh_error != mesh_errors.end()) {
      *response.mutable_error() = mesh_error->second;
      stream.Write(response);
      return;
    }
    send_mesh(stream, k, id, request.mesh());
  }
};

}  // namespace remeshd::client
