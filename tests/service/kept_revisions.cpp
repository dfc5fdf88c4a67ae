#include "tests/service/kept_revisions.h"

#include <cstdio>
#include <functional>
#include <stdexcept>
#include <vector>

namespace remeshd::test {
namespace {

std::set<std::string> listed(v1::RemeshService::Stub& stub) {
  std::set<std::string> ids;
  v1::ListRevisionsRequest request;
  do {
    grpc::ClientContext context;
    v1::ListRevisionsResponse reply;
    const grpc::Status status = stub.ListRevisions(&context, request, &reply);
    if (!status.ok()) throw std::runtime_error("ListRevisions: " + status.error_message());
    for (const v1::RevisionInfo& revision : reply.revisions()) ids.insert(revision.id());
    request.set_page_token(reply.next_page_token());
  } while (!request.page_token().empty());
  return ids;
}

}  // namespace

std::optional<std::size_t> mesh_hash(v1::RemeshService::Stub& stub, const std::string& id) {
  grpc::ClientContext context;
  v1::GetMeshRequest request;
  request.set_revision(id);
  const auto reader = stub.GetMesh(&context, request);
  v1::GetMeshResponse reply;
  std::string all;
  while (reader->Read(&reply)) {
    for (const auto& array : reply.mesh().header().arrays()) all += array.digest();
    all += reply.mesh().part().data();
  }
  if (!reader->Finish().ok()) return std::nullopt;
  return std::hash<std::string>()(all);
}

void KeptRevisions::made(const std::string& id) {
  const std::scoped_lock lock(mutex_);
  there_[id] = std::nullopt;
}

void KeptRevisions::read(const std::string& id, std::size_t bytes) {
  const std::scoped_lock lock(mutex_);
  const auto entry = there_.find(id);
  if (entry != there_.end()) entry->second = bytes;
}

std::optional<std::string> KeptRevisions::any(std::mt19937& random) const {
  const std::scoped_lock lock(mutex_);
  if (there_.empty()) return std::nullopt;
  return std::next(there_.begin(), static_cast<std::ptrdiff_t>(random() % there_.size()))->first;
}

void KeptRevisions::deleting(const std::string& id) {
  const std::scoped_lock lock(mutex_);
  there_.erase(id);
}

void KeptRevisions::deleted(const std::string& id) {
  const std::scoped_lock lock(mutex_);
  gone_.insert(id);
}

std::size_t KeptRevisions::count() const {
  const std::scoped_lock lock(mutex_);
  return there_.size();
}

KeptRevisions::Check KeptRevisions::compare(v1::RemeshService::Stub& stub, std::size_t meshes,
                                            std::mt19937& random) const {
  const std::scoped_lock lock(mutex_);
  const std::set<std::string> ids = listed(stub);
  Check check;
  for (const auto& [id, bytes] : there_) {
    if (ids.contains(id)) continue;
    ++check.lost;
    std::printf("lost: %s\n", id.c_str());
  }
  for (const std::string& id : gone_) check.risen += ids.contains(id);
  for (std::size_t i = 0; i < meshes && !there_.empty(); ++i) {
    const auto& [id, bytes] =
        *std::next(there_.begin(), static_cast<std::ptrdiff_t>(random() % there_.size()));
    const auto now = mesh_hash(stub, id);
    if (!now) ++check.lost;
    if (!now || !bytes) continue;
    ++check.read;
    check.wrong += *now != *bytes;
  }
  return check;
}

}  // namespace remeshd::test
