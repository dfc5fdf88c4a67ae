#include "remesh/v1/cache.grpc.pb.h"
#include "server/service/call.h"
#include "server/service/raw_service.h"
#include "server/service/remesh_service.h"
#include "server/service/status.h"

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

/// A stream that ends before it has begun.
class RefusedStream final : public grpc::ServerWriteReactor<Bytes> {
 public:
  RefusedStream(const Error& why, std::shared_ptr<CallRecord> record) : record_(std::move(record)) {
    const grpc::Status status = to_status(why);
    record_->set_status(status, why.info().reason);
    Finish(status);
  }
  void OnDone() override {
    record_->end();
    delete this;
  }

 private:
  const std::shared_ptr<CallRecord> record_;
};

class CacheServiceWithoutCalls final : public RawService {
 public:
  explicit CacheServiceWithoutCalls(std::shared_ptr<spdlog::logger> log) : log_(std::move(log)) {}

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
    return new RefusedStream(error::unsupported("VerifyCache"), record("VerifyCache", context));
  }
  Reply* SetPin(Context* context, const Bytes* /*in*/, Bytes* out) override {
    return refuse("SetPin", context, out);
  }

 private:
  std::shared_ptr<CallRecord> record(const char* method, Context* context) const {
    return std::make_shared<CallRecord>(log_, method, context->peer());
  }

  Reply* refuse(const char* method, Context* context, Bytes* out) {
    const auto call = UnaryCall::start(context, out, record(method, context));
    call->fail(error::unsupported(method));
    return call.get();
  }

  const std::shared_ptr<spdlog::logger> log_;
};

}  // namespace

std::unique_ptr<grpc::Service> make_cache_service(std::shared_ptr<spdlog::logger> log) {
  return std::make_unique<CacheServiceWithoutCalls>(std::move(log));
}

}  // namespace remeshd
