#include <new>

#include "tests/server/daemon_fixture.h"

namespace remeshd::test {
namespace {

using grpc::StatusCode;

/// An engine that fails to mesh, to compare and to load by an exception of the test's choice.
class FailingEngine : public DaemonTest {
 protected:
  [[nodiscard]] Engine make_engine() const override {
    Engine engine = engine_.engine();
    if (!fail_) return engine;
    const auto fail = fail_;
    engine.make_revision = [fail](auto&&...) -> Revision { return fail(), Revision{}; };
    engine.compare = [fail](auto&&...) -> ModelComparison { return fail(), ModelComparison{}; };
    engine.revision_of = [fail](auto&&...) -> Revision { return fail(), Revision{}; };
    return engine;
  }
  /// Calls what the engine fails in, after a start in which one revision was made and stored.
  void call_all() {
    use_store();
    create(plate());
    fail_ = throwing_;
    start();
    v1::RevisionResult reply;
    statuses_.push_back(try_create(create_request(plate(6)), &reply));
    {
      grpc::ClientContext context;
      v1::CompareRequest request;
      *request.mutable_original()->mutable_model() = plate();
      *request.mutable_modified()->mutable_model() = plate(6);
      v1::CompareResponse comparison;
      statuses_.push_back(stub().Compare(&context, request, &comparison));
    }
    {
      grpc::ClientContext context;
      v1::GetMeshRequest request;
      request.set_revision("plate");
      const auto reader = stub().GetMesh(&context, request);
      v1::GetMeshResponse message;
      EXPECT_FALSE(reader->Read(&message));
      statuses_.push_back(reader->Finish());
    }
    grpc::ClientContext context;
    const auto stream = stub().EditStream(&context);
    v1::EditStreamRequest request;
    *request.mutable_create() = create_request(plate(7));
    EXPECT_TRUE(stream->Write(request));
    stream->WritesDone();
    for (v1::EditStreamResponse part; stream->Read(&part);)
      if (part.has_error()) in_band_ = part.error();
    EXPECT_TRUE(stream->Finish().ok());
    EXPECT_TRUE(serves());
  }

  std::function<void()> throwing_, fail_;
  std::vector<grpc::Status> statuses_;
  v1::Error in_band_;
};

TEST_F(FailingEngine, WithoutMemoryIsToldAsResourceExhausted) {
  throwing_ = [] { throw std::bad_alloc(); };
  call_all();
  for (const grpc::Status& status : statuses_) {
    EXPECT_EQ(status.error_code(), StatusCode::RESOURCE_EXHAUSTED) << status.error_message();
    EXPECT_EQ(detail(status).reason(), v1::Error::OUT_OF_MEMORY);
  }
  EXPECT_EQ(in_band_.code(), v1::Error::CODE_RESOURCE_EXHAUSTED);
  EXPECT_EQ(in_band_.reason(), v1::Error::OUT_OF_MEMORY);
}

TEST_F(FailingEngine, ByWhatIsNoExceptionClassIsToldAsInternal) {
  throwing_ = [] { throw 7; };
  call_all();
  for (const grpc::Status& status : statuses_)
    EXPECT_EQ(status.error_code(), StatusCode::INTERNAL) << status.error_message();
  EXPECT_EQ(in_band_.code(), v1::Error::CODE_INTERNAL);
}

}  // namespace
}  // namespace remeshd::test
