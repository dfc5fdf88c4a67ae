#include "server/service/verify_call.h"

#include <chrono>
#include <optional>
#include <utility>

#include "server/session/verification.h"

namespace remeshd {
namespace {

namespace v1 = remesh::v1;

constexpr std::chrono::milliseconds kProgress(500);  // at least every second is promised

/// One VerifyCache under way. One piece of its work follows the other.
class VerifyCall final : public std::enable_shared_from_this<VerifyCall> {
 public:
  VerifyCall(std::shared_ptr<MessageStream> stream, Session& session, bool repair)
      : stream_(std::move(stream)),
        session_(session),
        repair_(repair),
        verification_(session.cache()) {
    so_far_.set_bytes_total(verification_.bytes_total());
  }

  /// For the lane of preparations.
  void go_on() {
    const auto resume = [call = shared_from_this()] { call->go_on_later(); };
    while (!verification_.ended()) {
      if (stream_->wait_for_client(resume)) return;
      Run{.stop = stream_->stop_token(), .on_progress = {}, .dumps = {}}.poll();
      const std::optional<CacheFault> fault = verification_.next();
      so_far_.set_bytes_read(verification_.bytes_read());
      if (fault && repair_) return repair(*fault);
      if (fault) tell(*fault);
      tell_progress();
    }
    so_far_.set_done(true);
    stream_->send(so_far_);
    stream_->end();
  }

 private:
  void go_on_later() {
    const auto call = shared_from_this();
    session_.later(Lane::Preparation,
                   {.run = [call] { answering(*call->stream_, [&] { call->go_on(); }); },
                    .refused = [call](const Error& why) { call->stream_->fail(why); }});
  }

  void repair(const CacheFault& fault) {
    session_.repair(fault, stream_->stop_token(),
                    [call = shared_from_this()](const CacheFault& told) {
                      answering(*call->stream_, [&] {
                        call->tell(told);
                        call->go_on_later();
                      });
                    });
  }

  void tell(const CacheFault& fault) {
    so_far_.set_findings(so_far_.findings() + 1);
    v1::VerifyCacheResponse message = so_far_;
    message.mutable_finding()->set_revision(fault.revision);
    message.mutable_finding()->set_what(fault.what);
    message.mutable_finding()->set_repaired(fault.repaired);
    stream_->send(message);
  }

  void tell_progress() {
    const auto now = std::chrono::steady_clock::now();
    if (now - told_ < kProgress || !stream_->all_taken()) return;
    told_ = now;
    stream_->send(so_far_);
  }

  const std::shared_ptr<MessageStream> stream_;
  Session& session_;
  const bool repair_;
  CacheVerification verification_;
  v1::VerifyCacheResponse so_far_;
  std::chrono::steady_clock::time_point told_ = std::chrono::steady_clock::now();
};

}  // namespace

void verify_cache(const std::shared_ptr<MessageStream>& stream, Session& session,
                  const v1::VerifyCacheRequest& request) {
  stream->keep(session.take_reply_memory(0, stream->stop_token()));
  std::make_shared<VerifyCall>(stream, session, request.repair())->go_on();
}

}  // namespace remeshd
