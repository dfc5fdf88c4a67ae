#include <thread>

#include "tests/server/daemon_fixture.h"

namespace remeshd::test {
namespace {

using testing::ElementsAre;

class EditStreams : public DaemonTest {
 protected:
  using Stream = grpc::ClientReaderWriterInterface<v1::EditStreamRequest, v1::EditStreamResponse>;

  void open() {
    context_ = std::make_unique<grpc::ClientContext>();
    stream_ = stub().EditStream(context_.get());
  }
  void send_create(const std::string& id, const v1::FeatureModel& model) {
    v1::EditStreamRequest request;
    *request.mutable_create() = create_request(model);
    request.mutable_create()->set_request_id(id);
    ASSERT_TRUE(stream_->Write(request));
  }
  void send_edit(const std::string& id, double at, const std::string& base = "",
                 bool advance = true) {
    v1::EditStreamRequest request;
    *request.mutable_edit() = edit_request(base, set("at", at));
    request.mutable_edit()->set_request_id(id);
    request.mutable_edit()->mutable_head()->set_advance(advance);
    ASSERT_TRUE(stream_->Write(request));
  }
  void send_cancel(const std::string& id) {
    v1::EditStreamRequest request;
    request.mutable_cancel()->set_request_id(id);
    ASSERT_TRUE(stream_->Write(request));
  }
  /// The next reply that ends a request; progress on the way is gathered.
  v1::EditStreamResponse answer() {
    v1::EditStreamResponse reply;
    while (stream_->Read(&reply)) {
      if (!reply.has_progress()) return reply;
      progress_.push_back(reply);
    }
    ADD_FAILURE() << "the stream ended";
    return reply;
  }
  grpc::Status close() {
    stream_->WritesDone();
    v1::EditStreamResponse reply;
    while (stream_->Read(&reply)) EXPECT_TRUE(reply.has_progress());
    return stream_->Finish();
  }

  std::unique_ptr<grpc::ClientContext> context_;
  std::unique_ptr<Stream> stream_;
  std::vector<v1::EditStreamResponse> progress_;
};

TEST_F(EditStreams, AnswersPipelinedEditsInOrderEachOnTheHeadThatTheLastLeft) {
  open();
  send_create("base", plate());
  for (int i = 0; i < 20; ++i) send_edit("edit" + std::to_string(i), 11 + i);
  std::string head = answer().result().revision().id();
  for (int i = 0; i < 20; ++i) {
    const auto reply = answer();
    EXPECT_EQ(reply.request_id(), "edit" + std::to_string(i));
    EXPECT_EQ(reply.result().request_id(), reply.request_id());
    EXPECT_EQ(reply.result().revision().parent(), head);
    EXPECT_EQ(reply.result().revision().number(), static_cast<std::uint32_t>(i + 2));
    EXPECT_FALSE(reply.result().head_conflict());
    head = reply.result().revision().id();
  }
  EXPECT_TRUE(close().ok());
}

TEST_F(EditStreams, EditsThatNameNoBaseFollowTheLastWhereThatIsInNoDesign) {
  open();
  send_create("base", plate());
  std::string last = answer().result().revision().id();
  for (int i = 0; i < 3; ++i) {
    v1::EditStreamRequest request;
    *request.mutable_edit() = edit_request("", set("at", 11 + i));
    request.mutable_edit()->mutable_head()->set_file(false);
    ASSERT_TRUE(stream_->Write(request));
    const auto revision = answer().result().revision();
    EXPECT_EQ(revision.design(), "");
    EXPECT_EQ(revision.number(), 0U);
    EXPECT_EQ(revision.parent(), last);
    last = revision.id();
  }
  EXPECT_TRUE(close().ok());
  EXPECT_EQ(describe("plate").revision().number(), 1U);
  EXPECT_EQ(describe(last).places_size(), 0);
}

TEST_F(EditStreams, TakeTheDesignOfTheirLastResultForAnIdThatStandsInSeveral) {
  const std::string id = create(plate()).revision().id();
  v1::EditStreamRequest request;
  *request.mutable_create() = create_request(plate());
  request.mutable_create()->set_design("other");
  open();
  ASSERT_TRUE(stream_->Write(request));
  EXPECT_EQ(answer().result().revision().id(), id);
  send_edit("edit", 11, id);
  EXPECT_EQ(answer().result().revision().design(), "other");
  EXPECT_TRUE(close().ok());
  open();
  send_edit("edit", 12, id);
  const auto error = answer().error();
  EXPECT_EQ(error.reason(), v1::Error::MISSING_FIELD);
  EXPECT_EQ(error.parameter(), "design");
  EXPECT_TRUE(close().ok());
  EXPECT_EQ(describe("plate").revision().number(), 1U);
}

TEST_F(EditStreams, SendProgressWithItsRequestIdFractionsNeverFalling) {
  open();
  send_create("base", plate());
  answer();
  ASSERT_FALSE(progress_.empty());
  double last = 0;
  for (const auto& reply : progress_) {
    EXPECT_EQ(reply.request_id(), "base");
    EXPECT_GE(reply.progress().fraction(), last);
    last = reply.progress().fraction();
  }
}

TEST_F(EditStreams, ErrorsComeInBandAndTheStreamLivesOn) {
  open();
  send_create("base", plate());
  v1::EditStreamRequest wrong;
  wrong.mutable_edit()->set_base("plate");
  wrong.mutable_edit()->set_request_id("wrong");
  wrong.mutable_edit()->mutable_edit()->add_edits()->mutable_remove_feature()->set_feature("knob");
  ASSERT_TRUE(stream_->Write(wrong));
  ASSERT_TRUE(stream_->Write({}));  // neither edit nor create nor cancel
  send_edit("lost", 12, "plank");
  send_edit("right", 12);
  EXPECT_TRUE(answer().has_result());
  const auto error = answer();
  EXPECT_EQ(error.request_id(), "wrong");
  EXPECT_EQ(error.error().features(0), "knob");
  EXPECT_EQ(error.error().edit_index(), 0U);
  EXPECT_EQ(answer().error().code(), v1::Error::CODE_INVALID_ARGUMENT);
  EXPECT_EQ(answer().error().code(), v1::Error::CODE_NOT_FOUND);
  const auto right = answer();
  EXPECT_EQ(right.request_id(), "right");
  EXPECT_EQ(right.result().revision().number(), 2U);
  EXPECT_TRUE(close().ok());
}

TEST_F(EditStreams, ARequestAtWorkIsCancelledByItsIdAndTheNextGoesOn) {
  start();
  create(plate());
  engine_.close_gate();
  open();
  send_edit("slow", 11, "plate");
  send_edit("next", 12, "plate");
  ASSERT_TRUE(engine_.wait_at_gate(1));
  send_cancel("slow");
  ASSERT_TRUE(engine_.wait_stopped(1));
  engine_.open_gate();
  const auto cancelled = answer();
  EXPECT_EQ(cancelled.request_id(), "slow");
  EXPECT_EQ(cancelled.error().code(), v1::Error::CODE_CANCELLED);
  const auto next = answer();
  EXPECT_EQ(next.request_id(), "next");
  EXPECT_EQ(next.result().revision().number(), 2U);
  EXPECT_TRUE(close().ok());
}

TEST_F(EditStreams, AWaitingRequestIsCancelledByItsIdAndAnsweredInItsTurn) {
  start();
  create(plate());
  engine_.close_gate();
  open();
  send_edit("first", 11, "plate", false);
  send_edit("second", 12, "plate", false);
  send_edit("third", 13, "plate", false);
  ASSERT_TRUE(engine_.wait_at_gate(1));
  send_cancel("second");
  send_cancel("nobody");
  // Cancellations are read in their order: once this one stopped "first", "second" is marked.
  send_cancel("first");
  ASSERT_TRUE(engine_.wait_stopped(1));
  engine_.open_gate();
  std::vector<std::string> order;
  for (int i = 0; i < 3; ++i) {
    const auto reply = answer();
    order.push_back(reply.request_id() + (reply.has_error() ? " cancelled" : ""));
  }
  EXPECT_THAT(order, ElementsAre("first cancelled", "second cancelled", "third"));
  EXPECT_EQ(engine_.started(), 3);  // the base, first and third
}

TEST_F(EditStreams, ALostCompareAndSetIsMarked) {
  create(plate());
  open();
  send_edit("one", 11, "plate@1");
  send_edit("two", 12, "plate@1");
  const auto one = answer();
  const auto two = answer();
  EXPECT_FALSE(one.result().head_conflict());
  EXPECT_TRUE(two.result().head_conflict());
  EXPECT_EQ(two.result().head(), one.result().revision().id());
}

TEST_F(EditStreams, TheFirstEditMustNameItsBase) {
  create(plate());
  open();
  send_edit("homeless", 11);
  EXPECT_EQ(answer().error().reason(), v1::Error::REVISION_MISSING);
}

TEST_F(EditStreams, ClosingTheSendingSideLetsWhatWasSentFinish) {
  open();
  send_create("base", plate());
  for (int i = 0; i < 5; ++i) send_edit(std::to_string(i), 11 + i);
  stream_->WritesDone();
  for (int i = 0; i < 6; ++i) EXPECT_TRUE(answer().has_result());
  v1::EditStreamResponse reply;
  EXPECT_FALSE(stream_->Read(&reply));
  EXPECT_TRUE(stream_->Finish().ok());
}

TEST_F(EditStreams, CancellingTheCallStopsWhatIsAtWorkAndDropsWhatWaits) {
  start();
  create(plate());
  engine_.close_gate();
  open();
  send_edit("one", 11, "plate");
  send_edit("two", 12, "plate");
  ASSERT_TRUE(engine_.wait_at_gate(1));
  context_->TryCancel();
  EXPECT_TRUE(engine_.wait_stopped(1));
  EXPECT_EQ(stream_->Finish().error_code(), grpc::StatusCode::CANCELLED);
  engine_.open_gate();
  EXPECT_TRUE(serves());
  EXPECT_EQ(engine_.started(), 2);
}

TEST_F(EditStreams, ManyBadRequestsSentAheadAreAllAnswered) {
  open();
  constexpr int kRequests = 10000;
  std::thread writer([&] {
    v1::EditStreamRequest bad;
    bad.mutable_edit()->set_base("plate");
    for (int i = 0; i < kRequests; ++i) {
      bad.mutable_edit()->set_request_id(std::to_string(i));
      if (!stream_->Write(bad)) break;
    }
  });
  for (int i = 0; i < kRequests; ++i) {
    const auto reply = answer();
    ASSERT_EQ(reply.request_id(), std::to_string(i));
    ASSERT_TRUE(reply.has_error());
  }
  writer.join();
  EXPECT_TRUE(close().ok());
}

TEST_F(EditStreams, SeveralAtATimeDoNotMixTheirAnswers) {
  start();
  std::vector<std::thread> clients;
  for (int c = 0; c < 6; ++c)
    clients.emplace_back([&, c] {
      const std::string design = "design" + std::to_string(c);
      grpc::ClientContext context;
      auto stream = stub_->EditStream(&context);
      v1::EditStreamRequest request;
      *request.mutable_create() = create_request(plate(1 + c, 10, design));
      stream->Write(request);
      for (int i = 0; i < 10; ++i) {
        v1::EditStreamRequest next;
        *next.mutable_edit() = edit_request("", set("at", 11 + i));
        next.mutable_edit()->set_request_id(std::to_string(i));
        stream->Write(next);
      }
      stream->WritesDone();
      std::uint32_t number = 0;
      for (v1::EditStreamResponse reply; stream->Read(&reply);) {
        if (reply.has_progress()) continue;
        EXPECT_EQ(reply.result().revision().design(), design);
        EXPECT_EQ(reply.result().revision().number(), ++number);
      }
      EXPECT_EQ(number, 11U);
      EXPECT_TRUE(stream->Finish().ok());
    });
  for (auto& client : clients) client.join();
}

}  // namespace
}  // namespace remeshd::test
