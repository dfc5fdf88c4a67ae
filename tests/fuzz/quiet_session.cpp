#include "tests/fuzz/quiet_session.h"

#include <future>

#include "proto/document.h"
#include "proto/json_writer.h"
#include "server/service/decode.h"
#include "tests/fuzz/documents.h"
#include "tests/server/fake_engine.h"
#include "tests/server/session/only_session.h"

namespace remeshd::fuzz {
namespace {

void make(Session& session, Command command) {
  std::promise<std::string> done;
  const auto request = session.make(
      std::move(command), {.progress = {},
                           .made = [&](const Made&) { done.set_value(""); },
                           .failed = [&](const Error& why) { done.set_value(why.what()); }});
  const std::string failure = done.get_future().get();
  expect(failure.empty(), "the session cannot be made: " + failure);
}

std::shared_ptr<Session> make_session() {
  const test::FakeEngine engine;
  auto session =
      test::only_session(engine.engine(), std::make_unique<Store>(), {.max_nodes = 10000});
  make(
      *session,
      CreateCommand{.source = source_of_every_type(), .options = {.nodes = 20}, .design = "plate"});
  const auto edit = parse_edit(R"({"edits": [{"setParameter": {"name": "r", "value": 2}}]})");
  make(*session,
       EditCommand{.base = "plate", .edit = decode(edit), .document = write_document(edit)});
  return session;
}

}  // namespace

Session& quiet_session() {
  static const std::shared_ptr<Session> session = make_session();
  return *session;
}

}  // namespace remeshd::fuzz
