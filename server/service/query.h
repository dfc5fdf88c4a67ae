#pragma once

#include <memory>
#include <utility>

#include "server/service/call.h"
#include "server/service/message_stream.h"
#include "server/service/remesh_service.h"
#include "server/session/session_error.h"
#include "server/session/tenants.h"

namespace remeshd {

struct QueryKind {
  const char* method;
  Lane lane;
};

/// A call to which `work(call, session, request)` replies, at once or later; `session` is that of
/// the call's tenant. The request is read, and `work` called, in the lane of `kind`. The call is
/// withdrawn when its client goes away before its turn.
template <typename Request, typename Work>
grpc::ServerUnaryReactor* work_on_query(Tenants& tenants, const ServiceOptions& options,
                                        QueryKind kind, grpc::CallbackServerContext* context,
                                        const grpc::ByteBuffer& in, grpc::ByteBuffer* out,
                                        Work work) {
  const auto call = UnaryCall::start(
      context, out, std::make_shared<CallRecord>(options.desk, kind.method, *context));
  answering(*call, [&] {
    call->record().admit(*context);
    Session& session = tenants.of(call->record().tenant());
    const WorkId id = session.later(
        kind.lane,
        // A copy of the buffer, not of its bytes: the call may be over before they are read.
        {.run =
             [call, &session, work, bytes = in, limit = options.limits.message_bytes] {
               answering(*call, [&] {
                 Request request;
                 from_bytes(bytes, limit, request);
                 work(call, session, request);
               });
             },
         .refused = [call](const Error& why) { call->fail(why); },
         .overdue =
             [call](const Error& why) {
               call->fail(why);
               call->stop();
             }});
    call->on_cancel([call, &session, lane = kind.lane, id] {
      if (session.withdraw(lane, id)) call->fail(error::cancelled());
    });
  });
  return call.get();
}

/// The same for a call whose reply `answer(session, request, run)` returns.
template <typename Request, typename Answer>
grpc::ServerUnaryReactor* answer_query(Tenants& tenants, const ServiceOptions& options,
                                       QueryKind kind, grpc::CallbackServerContext* context,
                                       const grpc::ByteBuffer& in, grpc::ByteBuffer* out,
                                       Answer answer) {
  return work_on_query<Request>(
      tenants, options, kind, context, in, out,
      [answer](const std::shared_ptr<UnaryCall>& call, Session& session, const Request& request) {
        const Run run{.stop = call->stop_token(), .on_progress = {}, .dumps = {}};
        call->reply(answer(session, request, run));
      });
}

/// A call to which `work(stream, session, request)` replies with a stream of messages; it is called
/// in the lane of preparations.
template <typename Request, typename Work>
grpc::ServerWriteReactor<grpc::ByteBuffer>* work_on_stream(Tenants& tenants,
                                                           const ServiceOptions& options,
                                                           const char* method,
                                                           grpc::CallbackServerContext* context,
                                                           const grpc::ByteBuffer& in, Work work) {
  const auto stream =
      MessageStream::start(context, std::make_shared<CallRecord>(options.desk, method, *context));
  answering(*stream, [&] {
    stream->record().admit(*context);
    stream->record().count_as_stream();
    Session& session = tenants.of(stream->record().tenant());
    session.later(Lane::Preparation,
                  {.run =
                       [stream, &session, work, bytes = in, limit = options.limits.message_bytes] {
                         answering(*stream, [&] {
                           Request request;
                           from_bytes(bytes, limit, request);
                           work(stream, session, request);
                         });
                       },
                   .refused = [stream](const Error& why) { stream->fail(why); }});
  });
  return stream.get();
}

}  // namespace remeshd
