// SPDX-License-Identifier: Apache-2.0
// What operators ask of the meshes that one daemon holds.
#include <utility>

#include "client/library/calls.h"
#include "client/library/client_impl.h"
#include "remeshd/client.h"

namespace remeshd::client {

using CacheStub = Replica::Cache::Stub;

std::vector<remesh::v1::CacheEntry> Client::list_cache(remesh::v1::ListCacheEntriesRequest request,
                                                       const CallOptions& call) const {
  return all_pages(impl_->search_cache(call), &CacheStub::ListCacheEntries, std::move(request),
                   &remesh::v1::ListCacheEntriesResponse::entries);
}

remesh::v1::GetCacheStatsResponse Client::cache_stats(const CallOptions& call) const {
  return call_again(impl_->search_cache(call), &CacheStub::GetCacheStats, {});
}

remesh::v1::CollectGarbageResponse Client::collect_garbage(
    const remesh::v1::CollectGarbageRequest& request, const CallOptions& call) const {
  return call_once(*impl_->farm, impl_->search_cache(call), &CacheStub::CollectGarbage, request);
}

remesh::v1::VerifyCacheResponse Client::verify_cache(
    bool repair, const std::function<void(const remesh::v1::VerifyCacheResponse&)>& on_message,
    const CallOptions& call) const {
  const Search search = impl_->search_cache(call);
  CallContext context(call, search.replica(), search.route());
  remesh::v1::VerifyCacheRequest request;
  request.set_repair(repair);
  const auto reader = search.replica().cache().VerifyCache(context.get(), request);
  remesh::v1::VerifyCacheResponse message;
  while (reader->Read(&message)) on_message(message);
  check(reader->Finish());
  return message;
}

remesh::v1::CacheEntry Client::set_pin(const std::string& revision, bool pinned,
                                       const CallOptions& call) const {
  remesh::v1::SetPinRequest request;
  request.set_revision(revision);
  request.set_pinned(pinned);
  return call_once(*impl_->farm, impl_->search_cache(call), &CacheStub::SetPin, request).entry();
}

}  // namespace remeshd::client
