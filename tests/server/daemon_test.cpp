#include "server/daemon.h"

#include <grpcpp/generic/generic_stub.h>
#include <spdlog/logger.h>
#include <spdlog/sinks/ostream_sink.h>

#include <future>
#include <sstream>
#include <thread>

#include "engine/base/error.h"
#include "tests/server/daemon_fixture.h"

namespace remeshd::test {
namespace {

using testing::HasSubstr;

class Daemons : public DaemonTest {};

TEST_F(Daemons, TakeAFreePortAndTellIt) {
  start();
  EXPECT_GT(daemon_->port(), 0);
  EXPECT_TRUE(serves());
}

TEST_F(Daemons, ServeInTheirOwnProcessWithoutAPort) {
  options_.listen.clear();
  Daemon daemon(options_, engine_.engine());
  EXPECT_EQ(daemon.port(), 0);
  const auto stub = v1::RemeshService::NewStub(daemon.in_process_channel());
  grpc::ClientContext context;
  v1::CreateRevisionResponse reply;
  EXPECT_TRUE(stub->CreateRevision(&context, create_request(plate()), &reply).ok());
  EXPECT_EQ(reply.result().revision().nodes(), 100U);
}

TEST_F(Daemons, GiveTheSameBytesInTheirOwnProcessAsOverThePort) {
  create(plate());
  const auto over_port = create(plate());
  options_.listen.clear();
  Daemon daemon(options_, engine_.engine());
  const auto stub = v1::RemeshService::NewStub(daemon.in_process_channel());
  grpc::ClientContext context;
  v1::CreateRevisionResponse reply;
  ASSERT_TRUE(stub->CreateRevision(&context, create_request(plate()), &reply).ok());
  EXPECT_EQ(reply.result().revision().id(), over_port.revision().id());
}

TEST_F(Daemons, DoNotShareAPort) {
  start();
  options_.listen = {"127.0.0.1:" + std::to_string(daemon_->port())};
  try {
    const Daemon second(options_, engine_.engine());
    FAIL() << "two daemons share a port";
  } catch (const Error& error) {
    EXPECT_EQ(error.info().reason, "LISTEN_FAILED");
  }
}

TEST_F(Daemons, RefuseAnAddressThatIsNone) {
  options_.listen = {"nonsense"};
  EXPECT_THROW(Daemon(options_, engine_.engine()), Error);
}

TEST_F(Daemons, AnswerTheHealthService) {
  start();
  std::string reply;
  // HealthCheckRequest.service is field 1; HealthCheckResponse.status is field 1, SERVING 1.
  const std::string name = "remesh.v1.RemeshService";
  std::string request = "\x0a";
  request += static_cast<char>(name.size());
  request += name;
  for (const std::string& service : {std::string(), request}) {
    ASSERT_TRUE(call("/grpc.health.v1.Health/Check", service, &reply).ok());
    EXPECT_EQ(reply, "\x08\x01");
  }
}

TEST_F(Daemons, ReflectNothingUnlessTold) {
  start();
  std::string reply;
  EXPECT_EQ(call("/grpc.reflection.v1alpha.ServerReflection/ServerReflectionInfo", "", &reply)
                .error_code(),
            grpc::StatusCode::UNIMPLEMENTED);
}

TEST_F(Daemons, ReflectTheirServiceWhereTold) {
  options_.reflection = true;
  start();
  grpc::GenericStub generic(channel_);
  grpc::ClientContext context;
  grpc::CompletionQueue queue;
  const auto wait = [&queue] {
    void* tag = nullptr;
    bool ok = false;
    queue.Next(&tag, &ok);
    return ok;
  };
  auto call = generic.PrepareCall(
      &context, "/grpc.reflection.v1alpha.ServerReflection/ServerReflectionInfo", &queue);
  call->StartCall(nullptr);
  ASSERT_TRUE(wait());
  const std::string list_services("\x3a\x00", 2);  // field 7, an empty text
  const grpc::Slice slice(list_services);
  call->Write(grpc::ByteBuffer(&slice, 1), nullptr);
  ASSERT_TRUE(wait());
  grpc::ByteBuffer answer;
  call->Read(&answer, nullptr);
  ASSERT_TRUE(wait());
  grpc::Slice all;
  ASSERT_TRUE(answer.DumpToSingleSlice(&all).ok());
  EXPECT_THAT(std::string(reinterpret_cast<const char*>(all.begin()), all.size()),
              HasSubstr("remesh.v1.RemeshService"));
  call->WritesDone(nullptr);
  wait();
  grpc::Status status;
  call->Finish(&status, nullptr);
  wait();
}

TEST_F(Daemons, AnswerUnknownMethodsWithUnimplemented) {
  start();
  std::string reply;
  EXPECT_EQ(call("/remesh.v1.RemeshService/Nothing", "", &reply).error_code(),
            grpc::StatusCode::UNIMPLEMENTED);
}

TEST_F(Daemons, SurviveBytesThatAreNoMessage) {
  start();
  std::string reply;
  for (const char* method : {"CreateRevision", "EditRevision", "Compare", "GetRevision"}) {
    const auto status =
        call(std::string("/remesh.v1.RemeshService/") + method, "\xFF\xFF\xFF", &reply);
    EXPECT_EQ(status.error_code(), grpc::StatusCode::INVALID_ARGUMENT) << method;
    EXPECT_EQ(detail(status).reason(), v1::Error::MESSAGE_UNREADABLE);
  }
  EXPECT_TRUE(serves());
}

TEST_F(Daemons, TellTheirLimitsAndLoad) {
  options_.memory = 123 << 20;
  create(plate());
  const auto about = info();
  EXPECT_EQ(about.protocol(), "remesh.v1");
  EXPECT_EQ(about.algorithm_version(), engine_.engine().algorithm_version);
  EXPECT_EQ(about.limits().workers(), 2U);
  EXPECT_EQ(about.limits().threads(), 3U);
  EXPECT_EQ(about.load().revisions(), 1U);
  EXPECT_EQ(about.load().designs(), 1U);
  EXPECT_EQ(about.load().cached_revisions(), 1U);
  EXPECT_GT(about.load().memory_bytes(), 100U * 24);
  EXPECT_EQ(about.limits().memory_bytes(), 123U << 20);
  EXPECT_EQ(about.limits().compute_seconds(), 600);
  EXPECT_EQ(about.limits().disk_bytes(), 0U);
  EXPECT_EQ(about.limits().connections(), 1024U);
  EXPECT_EQ(about.limits().streams(), 256U);
  EXPECT_EQ(about.limits().nodes(), 5000000U);
  EXPECT_TRUE(about.ready());
  EXPECT_EQ(about.load().disk_bytes(), 0U);
  EXPECT_FALSE(about.load().persistent());
  EXPECT_FALSE(about.version().empty());
}

TEST_F(Daemons, AreNotReadyWhileRevisionsThatCannotGoFillTheMemory) {
  options_.cache = 1;
  const auto first = create(plate());
  auto about = info();
  EXPECT_FALSE(about.ready());
  EXPECT_EQ(about.not_ready(), "memory: revisions fill it, and there is no store");
  EXPECT_TRUE(remove(first.revision().id(), true).ok());
  // The thread that made it may hold it for a moment longer.
  while (!info().ready()) std::this_thread::yield();
}

TEST_F(Daemons, AreReadyThoughMemoryIsFullOfWhatAStoreHasToo) {
  use_store();
  options_.cache = 1;
  create(plate());
  EXPECT_TRUE(info().ready());
}

TEST_F(Daemons, AreReadyThoughTheQueueIsFull) {
  options_.workers = 1;
  options_.queue = 1;
  start();
  engine_.close_gate();
  std::vector<std::future<grpc::Status>> calls;
  for (int n = 0; n < 2; ++n)
    calls.push_back(std::async(std::launch::async, [this, n] {
      v1::RevisionResult reply;
      return try_create(create_request(plate(5 + n)), &reply);
    }));
  // The first one is queued too, for a moment.
  const auto is_full = [](const v1::ServerLoad& load) {
    return load.running() == 1 && load.queued() == 1;
  };
  while (!is_full(info().load())) std::this_thread::yield();
  v1::RevisionResult reply;
  EXPECT_EQ(detail(try_create(create_request(plate(9)), &reply)).reason(), v1::Error::BUSY);
  EXPECT_TRUE(info().ready());
  engine_.open_gate();
  for (auto& call : calls) EXPECT_TRUE(call.get().ok());
}

TEST_F(Daemons, TellFeatureTypes) {
  grpc::ClientContext context;
  v1::ListFeatureTypesResponse reply;
  ASSERT_TRUE(stub().ListFeatureTypes(&context, {}, &reply).ok());
  ASSERT_EQ(reply.types_size(), 8);
  EXPECT_EQ(reply.types(0).name(), "block");
  EXPECT_EQ(reply.types(0).parameters(0).name(), "dx");
  EXPECT_EQ(reply.types(0).faces_size(), 6);
}

TEST_F(Daemons, ValidateModelsAndEditsWithoutMeshing) {
  {
    grpc::ClientContext context;
    v1::ValidateModelRequest request;
    *request.mutable_model() = plate();
    v1::ValidateModelResponse reply;
    ASSERT_TRUE(stub().ValidateModel(&context, request, &reply).ok());
    EXPECT_EQ(reply.check().volume(), 2000);
  }
  v1::ValidateEditResponse reply;
  v1::ValidateEditRequest request;
  *request.mutable_base_model() = plate();
  request.mutable_edit()->add_edits()->mutable_remove_feature()->set_feature("hole");
  {
    grpc::ClientContext context;
    ASSERT_TRUE(stub().ValidateEdit(&context, request, &reply).ok());
    EXPECT_EQ(reply.check().volume(), 1000);
    EXPECT_EQ(reply.check().model().features_size(), 1);
  }
  EXPECT_EQ(engine_.started(), 0);
  create(plate());
  request.set_base("plate");
  {
    grpc::ClientContext context;
    ASSERT_TRUE(stub().ValidateEdit(&context, request, &reply).ok());
    EXPECT_EQ(reply.check().volume(), 1000);
  }
  request.mutable_edit()->mutable_edits(0)->mutable_remove_feature()->set_feature("knob");
  grpc::ClientContext context;
  EXPECT_EQ(detail(stub().ValidateEdit(&context, request, &reply)).features(0), "knob");
  EXPECT_EQ(engine_.started(), 1);
}

class WarnedDaemons : public DaemonTest {
  [[nodiscard]] Engine make_engine() const override {
    Engine engine = DaemonTest::make_engine();
    engine.summarise = [](const Revision*, const FeatureModel&, const MeshOptions&,
                          const remeshd::Run&) {
      ModelSummary summary;
      summary.warnings = {{.code = WarningCode::FaceLost, .message = "hole.wall is gone"}};
      return summary;
    };
    return engine;
  }
};

TEST_F(WarnedDaemons, TellWhatIsCertainBeforeMeshing) {
  v1::ValidateModelRequest request;
  *request.mutable_model() = plate();
  v1::ValidateModelResponse reply;
  {
    grpc::ClientContext context;
    ASSERT_TRUE(stub().ValidateModel(&context, request, &reply).ok());
    ASSERT_EQ(reply.check().warnings_size(), 1);
    EXPECT_EQ(reply.check().warnings(0).message(), "hole.wall is gone");
  }
  request.mutable_options()->add_fail_on(v1::Warning::FACE_LOST);
  {
    grpc::ClientContext context;
    const auto status = stub().ValidateModel(&context, request, &reply);
    EXPECT_EQ(detail(status).reason(), v1::Error::WARNING_IS_ERROR);
  }
  create(plate());
  v1::ValidateEditRequest edit;
  edit.set_base("plate");
  *edit.mutable_edit() = set("at", 11);
  edit.mutable_options()->add_fail_on(v1::Warning::FACE_LOST);
  v1::ValidateEditResponse edited;
  grpc::ClientContext context;
  const auto status = stub().ValidateEdit(&context, edit, &edited);
  EXPECT_EQ(detail(status).reason(), v1::Error::WARNING_IS_ERROR);
}

TEST_F(Daemons, CompareRevisionsModelsAndEdits) {
  create(plate());
  v1::CompareResponse reply;
  v1::CompareRequest request;
  request.mutable_original()->set_revision("plate");
  request.mutable_modified()->mutable_edit()->add_edits()->mutable_remove_feature()->set_feature(
      "hole");
  {
    grpc::ClientContext context;
    ASSERT_TRUE(stub().Compare(&context, request, &reply).ok());
    ASSERT_EQ(reply.comparison().features_size(), 1);
    EXPECT_EQ(reply.comparison().features(0).id(), "plate");
    EXPECT_EQ(reply.comparison().features(0).cells().at(".+"), 2);
    EXPECT_EQ(reply.comparison().copycells(), 2);
    EXPECT_EQ(reply.comparison().method(), "membership");
  }
  *request.mutable_modified()->mutable_model() = plate(7);
  {
    grpc::ClientContext context;
    ASSERT_TRUE(stub().Compare(&context, request, &reply).ok());
    EXPECT_EQ(reply.comparison().features_size(), 2);
  }
  *request.mutable_original()->mutable_edit() = set("at", 3);
  {
    grpc::ClientContext context;
    EXPECT_EQ(detail(stub().Compare(&context, request, &reply)).reason(), v1::Error::SIDE_INVALID);
  }
  request.clear_original();
  grpc::ClientContext context;
  EXPECT_EQ(detail(stub().Compare(&context, request, &reply)).parameter(), "original");
}

TEST_F(Daemons, LogOneLineACallWithIdDurationAndStatus) {
  std::ostringstream text;
  options_.log = std::make_shared<spdlog::logger>(
      "test", std::make_shared<spdlog::sinks::ostream_sink_mt>(text));
  start();
  auto request = create_request(plate());
  request.set_request_id("try 7\nforged=line");
  create(request);
  v1::RevisionResult reply;
  EXPECT_FALSE(try_edit(edit_request("plank", set("at", 1)), &reply).ok());
  stop();
  const std::string log = text.str();
  EXPECT_EQ(std::count(log.begin(), log.end(), '\n'), 2) << log;
  EXPECT_THAT(log, testing::ContainsRegex("call=[0-9]+ method=CreateRevision peer=[^ ]+ "
                                          "ms=[0-9.]+ status=OK request=try_7_forged=line"));
  EXPECT_THAT(log, HasSubstr("method=EditRevision"));
  EXPECT_THAT(log, HasSubstr("status=NOT_FOUND reason=REVISION_NOT_FOUND"));
}

TEST_F(Daemons, EndTwiceAsOnce) {
  start();
  daemon_->shutdown();
  daemon_->shutdown();
}

}  // namespace
}  // namespace remeshd::test
