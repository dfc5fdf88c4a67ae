#include "server/service/verify_call.h"

#include <utility>

namespace remeshd {

namespace v1 = remesh::v1;

namespace {
constexpr std::chrono::milliseconds kProgress(500);  // at least every second is promised
}

VerifyCall* VerifyCall::start(Tenants& tenants, grpc::CallbackServerContext* context,
                              const grpc::ByteBuffer& request, std::size_t message_limit,
                              std::shared_ptr<CallRecord> record) {
  auto call = std::make_shared<VerifyCall>(context, std::move(record));
  call->self_ = call;
  answering(*call, [&] {
    call->record_->admit(*context);
    Session& session = tenants.of(call->record_->tenant());
    session.later(Lane::Preparation,
                  {.run =
                       [call, &session, bytes = grpc::ByteBuffer(request), message_limit] {
                         answering(*call, [&] {
                           v1::VerifyCacheRequest message;
                           from_bytes(bytes, message_limit, message);
                           call->begin(session, message);
                         });
                       },
                   .refused = [call](const Error& why) { call->fail(why); }});
  });
  return call.get();
}

void VerifyCall::begin(Session& session, const v1::VerifyCacheRequest& request) {
  session_ = &session;
  repair_ = request.repair();
  verification_.emplace(session.cache());
  so_far_.set_bytes_total(verification_->bytes_total());
  go_on();
}

void VerifyCall::go_on() {
  while (!verification_->ended()) {
    Run{.stop = stop_.get_token(), .on_progress = {}, .dumps = {}}.poll();
    const std::optional<CacheFault> fault = verification_->next();
    so_far_.set_bytes_read(verification_->bytes_read());
    if (fault && repair_) {
      return session_->repair(*fault, stop_.get_token(),
                              [call = shared_from_this()](const CacheFault& told) {
                                answering(*call, [&] {
                                  call->tell(told);
                                  call->go_on_later();
                                });
                              });
    }
    if (fault) tell(*fault);
    tell_progress();
  }
  so_far_.set_done(true);
  send(so_far_);
  end(grpc::Status::OK);
}

void VerifyCall::go_on_later() {
  const auto call = shared_from_this();
  session_->later(Lane::Preparation, {.run = [call] { answering(*call, [&] { call->go_on(); }); },
                                      .refused = [call](const Error& why) { call->fail(why); }});
}

void VerifyCall::tell(const CacheFault& fault) {
  so_far_.set_findings(so_far_.findings() + 1);
  v1::VerifyCacheResponse message = so_far_;
  message.mutable_finding()->set_revision(fault.revision);
  message.mutable_finding()->set_what(fault.what);
  message.mutable_finding()->set_repaired(fault.repaired);
  send(message);
}

void VerifyCall::tell_progress() {
  const auto now = std::chrono::steady_clock::now();
  if (now - told_ < kProgress) return;
  told_ = now;
  send(so_far_);
}

void VerifyCall::send(const v1::VerifyCacheResponse& message) {
  const std::scoped_lock lock(mutex_);
  if (ended_) return;
  waiting_.push_back(to_bytes(message));
  if (waiting_.size() == 1) StartWrite(&waiting_.front());
}

void VerifyCall::OnWriteDone(bool ok) {
  const auto self = shared_from_this();  // `Finish` may end the call while the lock is held
  const std::scoped_lock lock(mutex_);
  waiting_.pop_front();
  if (!ok) waiting_.clear();
  if (!waiting_.empty()) {
    StartWrite(&waiting_.front());
  } else if (ended_ && !std::exchange(finished_, true)) {
    Finish(status_);
  }
}

void VerifyCall::fail(const Error& why) noexcept {
  add_pushback(why, *context_);
  end(to_status(why), why.info().reason);
}

void VerifyCall::end(const grpc::Status& status, const std::string& reason) noexcept {
  const auto self = weak_from_this().lock();  // as in OnWriteDone
  const std::scoped_lock lock(mutex_);
  if (std::exchange(ended_, true)) return;
  record_->set_status(status, reason);
  status_ = status;
  if (waiting_.empty() && !std::exchange(finished_, true)) Finish(status_);
}

void VerifyCall::OnDone() {
  record_->end();
  const auto self = std::move(self_);
}

}  // namespace remeshd
