#include "remesh/v1/cache.grpc.pb.h"
#include "server/service/cache_list.h"
#include "server/service/encode_cache.h"
#include "server/service/query.h"
#include "server/service/raw_service.h"
#include "server/service/remesh_service.h"
#include "server/service/verify_call.h"
#include "server/session/session_error.h"

namespace remeshd {
namespace {

namespace v1 = remesh::v1;
using Cache = v1::CacheService;
using Context = grpc::CallbackServerContext;
using Bytes = grpc::ByteBuffer;
using Reply = grpc::ServerUnaryReactor;

using RawCacheMethods =
    RawMethods<Cache::Service, Cache::WithRawCallbackMethod_ListCacheEntries,
               Cache::WithRawCallbackMethod_GetCacheStats,
               Cache::WithRawCallbackMethod_CollectGarbage,
               Cache::WithRawCallbackMethod_VerifyCache, Cache::WithRawCallbackMethod_SetPin>::Type;

double checked_seconds(double seconds, const char* field) {
  constexpr double kMost = 1e9;  // 32 years
  if (!(seconds >= 0 && seconds <= kMost))
    throw error::option_invalid(field, "is not between 0 and 1e9");
  return seconds;
}

GarbageOptions garbage_options(const v1::CollectGarbageRequest& request) {
  GarbageOptions out{.dry_run = request.dry_run()};
  if (request.has_disk_bytes()) out.disk_bytes = request.disk_bytes();
  if (request.has_unused_seconds())
    out.unused_seconds = checked_seconds(request.unused_seconds(), "unused_seconds");
  if (request.has_recipes_unused_seconds()) {
    if (!request.tier())
      throw error::option_invalid("recipes_unused_seconds", "is for the shared tier alone");
    out.recipes_unused_seconds =
        checked_seconds(request.recipes_unused_seconds(), "recipes_unused_seconds");
  }
  return out;
}

class RawCacheService final : public RawCacheMethods {
 public:
  RawCacheService(Tenants& tenants, ServiceOptions options)
      : tenants_(tenants), options_(std::move(options)) {}

  Reply* ListCacheEntries(Context* context, const Bytes* in, Bytes* out) override {
    return query<v1::ListCacheEntriesRequest>(
        "ListCacheEntries", Lane::Metadata, context, in, out,
        [](Session& session, const auto& request) { return list_cache_entries(session, request); });
  }
  Reply* GetCacheStats(Context* context, const Bytes* in, Bytes* out) override {
    return query<v1::GetCacheStatsRequest>(
        "GetCacheStats", Lane::Preparation, context, in, out,
        [](Session& session, const auto&) { return encode(session.cache().cache_stats()); });
  }
  Reply* CollectGarbage(Context* context, const Bytes* in, Bytes* out) override {
    return query<v1::CollectGarbageRequest>(
        "CollectGarbage", Lane::Preparation, context, in, out,
        [](Session& session, const auto& request) {
          const GarbageOptions options = garbage_options(request);
          return encode(request.tier() ? session.cache().collect_tier_garbage(options)
                                       : session.cache().collect_garbage(options));
        });
  }
  grpc::ServerWriteReactor<Bytes>* VerifyCache(Context* context, const Bytes* in) override {
    return work_on_stream<v1::VerifyCacheRequest>(tenants_, options_, "VerifyCache", context, *in,
                                                  verify_cache);
  }
  Reply* SetPin(Context* context, const Bytes* in, Bytes* out) override {
    return query<v1::SetPinRequest>(
        "SetPin", Lane::Preparation, context, in, out, [](Session& session, const auto& request) {
          if (request.revision().empty()) throw error::reference_missing("revision");
          v1::SetPinResponse reply;
          *reply.mutable_entry() =
              encode(session.cache().set_pin(request.revision(), request.pinned()));
          return reply;
        });
  }

 private:
  template <typename Request, typename Answer>
  Reply* query(const char* method, Lane lane, Context* context, const Bytes* in, Bytes* out,
               Answer answer) {
    return answer_query<Request>(tenants_, options_, {method, lane}, context, *in, out,
                                 [answer](Session& session, const Request& request, const Run&) {
                                   return answer(session, request);
                                 });
  }

  Tenants& tenants_;
  const ServiceOptions options_;
};

}  // namespace

std::unique_ptr<grpc::Service> make_cache_service(Tenants& tenants, ServiceOptions options) {
  return std::make_unique<RawCacheService>(tenants, std::move(options));
}

}  // namespace remeshd
