#pragma once

#include <memory>
#include <string>
#include <utility>

#include "server/service/call.h"
#include "server/session/session.h"

namespace remeshd {

/// Fetches a revision for a call and has `work(revision)` done in the lane of computations; what
/// that throws, and what goes wrong before, ends the call. For the lane of preparations. Throws
/// Error: what is wrong with the reference.
template <typename Call, typename Work>
void work_on_revision(const std::shared_ptr<Call>& call, Session& session,
                      const std::string& reference, Work work) {
  const auto failed = [call](const Error& why) { call->fail(why); };
  const auto got = [call, &session, failed, work](const HeldRevisionPtr& revision) {
    answering(*call, [&] {
      call->record().set_note("revision=" + revision->record.id.substr(0, 12));
      session.later(Lane::Computation,
                    {.run = [call, work, revision] { answering(*call, [&] { work(revision); }); },
                     .refused = failed,
                     .overdue =
                         [call](const Error& why) {
                           call->fail(why);
                           call->stop();
                         }});
    });
  };
  session.fetch(session.resolve(reference).id, call->stop_token(), {.got = got, .failed = failed});
}

}  // namespace remeshd
