#include "server/service/status.h"

#include <gmock/gmock.h>

#include "remesh/v1/rpc_status.pb.h"

namespace remeshd {
namespace {

namespace v1 = remesh::v1;

Error full_error() {
  return Error({.kind = ErrorKind::ResourceExhausted,
                .reason = "Busy",
                .message = "the daemon is busy",
                .stage = "request",
                .feature = "hole1",
                .parameter = "radius",
                .hint = "try again later",
                .edit_index = 0,
                .retry_after = 2.5});
}

TEST(Status, EveryKindHasItsCode) {
  const std::vector<std::pair<ErrorKind, grpc::StatusCode>> table{
      {ErrorKind::InvalidArgument, grpc::INVALID_ARGUMENT},
      {ErrorKind::NotFound, grpc::NOT_FOUND},
      {ErrorKind::FailedPrecondition, grpc::FAILED_PRECONDITION},
      {ErrorKind::DeadlineExceeded, grpc::DEADLINE_EXCEEDED},
      {ErrorKind::ResourceExhausted, grpc::RESOURCE_EXHAUSTED},
      {ErrorKind::Aborted, grpc::ABORTED},
      {ErrorKind::Cancelled, grpc::CANCELLED},
      {ErrorKind::Unavailable, grpc::UNAVAILABLE},
      {ErrorKind::Internal, grpc::INTERNAL}};
  for (const auto& [kind, code] : table)
    EXPECT_EQ(to_status(Error({.kind = kind})).error_code(), code);
}

TEST(Status, CarriesTheErrorAndGooglesInfosUnderTheirPublishedNames) {
  const grpc::Status status = to_status(full_error());
  v1::RpcStatus details;
  ASSERT_TRUE(details.ParseFromString(status.error_details()));
  EXPECT_EQ(details.code(), 8);
  ASSERT_EQ(details.details_size(), 3);

  v1::Error error;
  EXPECT_EQ(details.details(0).type_url(), "type.googleapis.com/remesh.v1.Error");
  ASSERT_TRUE(error.ParseFromString(details.details(0).value()));
  EXPECT_EQ(error.code(), v1::Error::RESOURCE_EXHAUSTED);
  EXPECT_EQ(error.feature(), "hole1");
  EXPECT_EQ(error.parameter(), "radius");
  EXPECT_TRUE(error.has_edit_index());
  EXPECT_EQ(error.retry_after(), 2.5);

  v1::RpcErrorInfo info;
  EXPECT_EQ(details.details(1).type_url(), "type.googleapis.com/google.rpc.ErrorInfo");
  ASSERT_TRUE(info.ParseFromString(details.details(1).value()));
  EXPECT_EQ(info.reason(), "Busy");

  v1::RpcRetryInfo retry;
  EXPECT_EQ(details.details(2).type_url(), "type.googleapis.com/google.rpc.RetryInfo");
  ASSERT_TRUE(retry.ParseFromString(details.details(2).value()));
  EXPECT_EQ(retry.retry_delay().seconds(), 2);
  EXPECT_EQ(retry.retry_delay().nanos(), 500000000);
}

TEST(Status, StaysBelowFourKilobytesAndValidUtf8) {
  Error error = full_error();
  for (std::string* text : {&error.info().message, &error.info().hint, &error.info().feature,
                            &error.info().parameter, &error.info().reason, &error.info().stage}) {
    *text = "\xFF\xC3";  // no UTF-8
    while (text->size() < 5000) *text += "\xE2\x82\xAC";
  }
  const grpc::Status status = to_status(error);
  EXPECT_LT(status.error_details().size(), 4096U);
  v1::RpcStatus details;
  // The parser refuses texts that are not UTF-8.
  ASSERT_TRUE(details.ParseFromString(status.error_details()));
  v1::Error message;
  ASSERT_TRUE(message.ParseFromString(details.details(0).value()));
  EXPECT_THAT(message.message(), testing::StartsWith("??\xE2\x82\xAC"));
  EXPECT_THAT(message.message(), testing::EndsWith("\xE2\x82\xAC..."));
}

}  // namespace
}  // namespace remeshd
