#include "server/service/status.h"

#include <gmock/gmock.h>
#include <grpcpp/test/server_context_test_spouse.h>

#include "remesh/v1/rpc_status.pb.h"
#include "server/service/encode_report.h"

namespace remeshd {
namespace {

namespace v1 = remesh::v1;
using testing::ElementsAre;

Error full_error() {
  return Error({.kind = ErrorKind::ResourceExhausted,
                .reason = "BUSY",
                .message = "the daemon is busy",
                .stage = "request",
                .features = {"hole1", "plate"},
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
      {ErrorKind::Internal, grpc::INTERNAL},
      {ErrorKind::DataLoss, grpc::DATA_LOSS},
      {ErrorKind::Unimplemented, grpc::UNIMPLEMENTED},
      {ErrorKind::PermissionDenied, grpc::PERMISSION_DENIED},
      {ErrorKind::Unauthenticated, grpc::UNAUTHENTICATED}};
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
  EXPECT_EQ(error.code(), v1::Error::CODE_RESOURCE_EXHAUSTED);
  EXPECT_THAT(error.features(), ElementsAre("hole1", "plate"));
  EXPECT_EQ(error.reason(), v1::Error::BUSY);
  EXPECT_EQ(error.parameter(), "radius");
  EXPECT_TRUE(error.has_edit_index());
  EXPECT_EQ(error.retry_after(), 2.5);

  v1::RpcErrorInfo info;
  EXPECT_EQ(details.details(1).type_url(), "type.googleapis.com/google.rpc.ErrorInfo");
  ASSERT_TRUE(info.ParseFromString(details.details(1).value()));
  EXPECT_EQ(info.reason(), "BUSY");

  v1::RpcRetryInfo retry;
  EXPECT_EQ(details.details(2).type_url(), "type.googleapis.com/google.rpc.RetryInfo");
  ASSERT_TRUE(retry.ParseFromString(details.details(2).value()));
  EXPECT_EQ(retry.retry_delay().seconds(), 2);
  EXPECT_EQ(retry.retry_delay().nanos(), 500000000);
}

TEST(Status, EveryWarningHasItsCode) {
  for (std::size_t i = 0; i < kWarningNames.size(); ++i) {
    Warning warning;
    warning.code = static_cast<WarningCode>(i);
    EXPECT_EQ(v1::Warning::Code_Name(encode(warning).code()), kWarningNames[i]);
  }
  EXPECT_EQ(v1::Warning::Code_ARRAYSIZE, static_cast<int>(kWarningNames.size()) + 1);
}

TEST(Status, TellsPlaceLineColumnAndTheWarningThatIsAnError) {
  Error error = full_error();
  error.info().place = Vec3{1, 2.5, -3};
  error.info().line = 7;
  error.info().column = 21;
  error.info().attempts = {"full: an inverted tet"};
  error.info().warning = Warning{.code = WarningCode::FaceLost,
                                 .message = "a face is lost",
                                 .features = {"hole1"},
                                 .groups = {"hole1.wall"},
                                 .point = Vec3{4, 5, 6}};
  const v1::Error message = to_message(error);
  EXPECT_THAT(message.point(), ElementsAre(1, 2.5, -3));
  EXPECT_EQ(message.line(), 7U);
  EXPECT_EQ(message.column(), 21U);
  EXPECT_THAT(message.attempts(), ElementsAre("full: an inverted tet"));
  EXPECT_EQ(message.warning().code(), v1::Warning::FACE_LOST);
  EXPECT_THAT(message.warning().features(), ElementsAre("hole1"));
  EXPECT_THAT(message.warning().groups(), ElementsAre("hole1.wall"));
  EXPECT_THAT(message.warning().point(), ElementsAre(4, 5, 6));
  const v1::Error bare = to_message(Error({.reason = "INTERNAL"}));
  EXPECT_TRUE(bare.point().empty());
  EXPECT_FALSE(bare.has_line());
  EXPECT_FALSE(bare.has_warning());
}

TEST(Status, TellsGrpcsOwnRetriesHowLongToWait) {
  const auto pushback = [](const Error& error) {
    grpc::ServerContext context;
    add_pushback(error, context);
    return grpc::testing::ServerContextTestSpouse(&context).GetTrailingMetadata();
  };
  EXPECT_THAT(pushback(full_error()), ElementsAre(testing::Pair("grpc-retry-pushback-ms", "2500")));
  Error error = full_error();
  error.info().retry_after.reset();
  EXPECT_TRUE(pushback(error).empty());
}

TEST(Status, StaysBelowFourKilobytesAndValidUtf8) {
  Error error = full_error();
  const auto swell = [](std::string& text) {
    text = "\xFF\xC3";  // no UTF-8
    while (text.size() < 5000) text += "\xE2\x82\xAC";
  };
  std::string name;
  swell(name);
  error.info().features.assign(100, name);
  error.info().attempts.assign(100, name);
  error.info().warning = Warning{.code = WarningCode::FaceLost,
                                 .message = name,
                                 .features = {100, name},
                                 .groups = {100, name},
                                 .point = Vec3{4, 5, 6}};
  for (std::string* text : {&error.info().message, &error.info().hint, &error.info().parameter,
                            &error.info().reason, &error.info().stage})
    swell(*text);
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
