#include "tests/service/requests.h"

#include <cmath>
#include <fstream>
#include <iterator>
#include <stdexcept>

#include "remesh/v1/rpc_status.pb.h"

namespace remeshd::test {

std::string case_text(const std::string& file) {
  std::ifstream in(std::string(REMESHD_CASES_DIR) + "/" + file);
  if (!in) throw std::runtime_error("cannot read " + file);
  return {std::istreambuf_iterator<char>(in), {}};
}

v1::CreateRevisionRequest create_tool1(std::uint32_t nodes) {
  v1::CreateRevisionRequest request;
  request.set_document(case_text("tool1-a.json"));
  request.mutable_options()->set_nodes(nodes);
  return request;
}

v1::CreateRevisionRequest create_block(std::uint32_t nodes, double size) {
  v1::CreateRevisionRequest request;
  request.set_document(R"({"name": "block", "parameters": {"size": )" + std::to_string(size) +
                       R"(}, "features": [{"id": "a", "nature": "ADDITIVE", "type": "block",
       "parameters": {"dx": "size", "dy": "size", "dz": "size"},
       "placement": {"origin": [0, 0, 0]}}]})");
  request.mutable_options()->set_nodes(nodes);
  return request;
}

v1::EditRevisionRequest set_parameter(const std::string& base, const std::string& name,
                                      double value) {
  v1::EditRevisionRequest request;
  request.set_base(base);
  auto& change = *request.mutable_edit()->add_edits()->mutable_set_parameter();
  change.set_name(name);
  change.mutable_value()->set_number_value(value);
  request.mutable_head()->set_advance(false);
  return request;
}

double pin_radius(int number) {
  constexpr double kGolden = 0.6180339887498949;
  return 3.5 + std::fmod(kGolden * number, 1.0);
}

std::string made_by(v1::RemeshService::Stub& stub, const v1::CreateRevisionRequest& request) {
  grpc::ClientContext context;
  v1::CreateRevisionResponse reply;
  const grpc::Status status = stub.CreateRevision(&context, request, &reply);
  if (!status.ok()) throw std::runtime_error("CreateRevision: " + status.error_message());
  return reply.result().revision().id();
}

std::string reason_of(const grpc::Status& status, bool* retry) {
  if (retry != nullptr) *retry = false;
  v1::RpcStatus details;
  if (!details.ParseFromString(status.error_details())) return "";
  std::string reason;
  for (const auto& any : details.details()) {
    v1::Error error;
    v1::RpcRetryInfo info;
    if (any.type_url() == "type.googleapis.com/remesh.v1.Error" &&
        error.ParseFromString(any.value()))
      reason = v1::Error::Reason_Name(error.reason());
    if (retry != nullptr && any.type_url() == "type.googleapis.com/google.rpc.RetryInfo" &&
        info.ParseFromString(any.value()))
      *retry = info.retry_delay().seconds() > 0 || info.retry_delay().nanos() > 0;
  }
  return reason;
}

}  // namespace remeshd::test
