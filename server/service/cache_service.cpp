#include "remesh/v1/cache.grpc.pb.h"
#include "server/service/call.h"
#include "server/service/raw_service.h"
#include "server/service/refused_call.h"
#include "server/service/remesh_service.h"

namespace remeshd {
namespace {

namespace v1 = remesh::v1;
using Cache = v1::CacheService;
using Context = grpc::CallbackServerContext;
using Bytes = grpc::ByteBuffer;
using Reply = grpc::ServerUnaryReactor;

using RawService =
    RawMethods<Cache::Service, Cache::WithRawCallbackMethod_ListCacheEntries,
               Cache::WithRawCallbackMethod_GetCacheStats,
               Cache::WithRawCallbackMethod_CollectGarbage,
               Cache::WithRawCallbackMethod_VerifyCache, Cache::WithRawCallbackMethod_SetPin>::Type;

class CacheServiceWithoutCalls final : public RawService {
 public:
  explicit CacheServiceWithoutCalls(FrontDeskPtr desk) : desk_(std::move(desk)) {}

  Reply* ListCacheEntries(Context* context, const Bytes* /*in*/, Bytes* out) override {
    return refuse("ListCacheEntries", context, out);
  }
  Reply* GetCacheStats(Context* context, const Bytes* /*in*/, Bytes* out) override {
    return refuse("GetCacheStats", context, out);
  }
  Reply* CollectGarbage(Context* context, const Bytes* /*in*/, Bytes* out) override {
    return refuse("CollectGarbage", context, out);
  }
  grpc::ServerWriteReactor<Bytes>* VerifyCache(Context* context, const Bytes* /*in*/) override {
    auto call = record("VerifyCache", context);
    Error why = error::unsupported("VerifyCache");
    try {
      call->admit(*context);
    } catch (const Error& refusal) {
      why = refusal;
    }
    return new RefusedCall<grpc::ServerWriteReactor<Bytes>>(context, why, std::move(call));
  }
  Reply* SetPin(Context* context, const Bytes* /*in*/, Bytes* out) override {
    return refuse("SetPin", context, out);
  }

 private:
  std::shared_ptr<CallRecord> record(const char* method, Context* context) const {
    return std::make_shared<CallRecord>(desk_, method, *context);
  }

  Reply* refuse(const char* method, Context* context, Bytes* out) {
    const auto call = UnaryCall::start(context, out, record(method, context));
    answering(*call, [&] {
      call->record().admit(*context);
      throw error::unsupported(method);
    });
    return call.get();
  }

  const FrontDeskPtr desk_;
};

}  // namespace

std::unique_ptr<grpc::Service> make_cache_service(FrontDeskPtr desk) {
  return std::make_unique<CacheServiceWithoutCalls>(std::move(desk));
}

}  // namespace remeshd
