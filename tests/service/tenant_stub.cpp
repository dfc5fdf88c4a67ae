#include "tests/service/tenant_stub.h"

#include <grpcpp/support/client_interceptor.h>

#include <utility>
#include <vector>

namespace remeshd::test {
namespace {

/// gRPC's own credentials of calls want TLS.
class AddToken final : public grpc::experimental::Interceptor {
 public:
  explicit AddToken(std::string header) : header_(std::move(header)) {}
  void Intercept(grpc::experimental::InterceptorBatchMethods* methods) override {
    using Point = grpc::experimental::InterceptionHookPoints;
    if (methods->QueryInterceptionHookPoint(Point::PRE_SEND_INITIAL_METADATA))
      methods->GetSendInitialMetadata()->emplace("authorization", header_);
    methods->Proceed();
  }

 private:
  const std::string header_;
};

class AddTokens final : public grpc::experimental::ClientInterceptorFactoryInterface {
 public:
  explicit AddTokens(const std::string& token) : header_("Bearer " + token) {}
  grpc::experimental::Interceptor* CreateClientInterceptor(
      grpc::experimental::ClientRpcInfo* /*call*/) override {
    return new AddToken(header_);  // gRPC's, from here on
  }

 private:
  const std::string header_;
};

}  // namespace

std::unique_ptr<v1::RemeshService::Stub> stub_with(const std::string& token,
                                                   const ServedDaemon& daemon) {
  grpc::ChannelArguments arguments;
  arguments.SetInt(GRPC_ARG_USE_LOCAL_SUBCHANNEL_POOL, 1);
  std::vector<std::unique_ptr<grpc::experimental::ClientInterceptorFactoryInterface>> interceptors;
  interceptors.push_back(std::make_unique<AddTokens>(token));
  return v1::RemeshService::NewStub(grpc::experimental::CreateCustomChannelWithInterceptors(
      daemon.address(), grpc::InsecureChannelCredentials(), arguments, std::move(interceptors)));
}

}  // namespace remeshd::test
