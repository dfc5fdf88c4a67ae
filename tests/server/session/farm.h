#pragma once

#include <gmock/gmock.h>

#include <chrono>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "tests/server/fake_engine.h"
#include "tests/server/session/answer.h"
#include "tests/server/session/only_session.h"
#include "tests/server/session/store_folder.h"
#include "tests/server/tier/shelf.h"
#include "tests/support/cases.h"
#include "tests/support/run.h"

namespace remeshd::test {

/// Revisions in a tier that daemons share, each with a store of its own.
class FarmTest : public testing::Test {
 protected:
  /// A daemon of the farm.
  struct Replica {
    FakeEngine engine;
    StoreFolder folder;
    std::shared_ptr<Session> session;

    Made make(Command command) const {
      Answer answer;
      session->make(std::move(command), answer.listener());
      return answer.made();
    }
    ErrorInfo fail(Command command) const {
      Answer answer;
      session->make(std::move(command), answer.listener());
      return answer.error();
    }
    /// Everything that is served of a revision: its recipe has the digests of every array.
    [[nodiscard]] std::string served(const std::string& id) const {
      const HeldRevisionPtr held = session->get(id, kRun);
      HeldRevision known;
      known.record = held->record;
      known.revision = held->revision;
      known.edit = held->edit;
      known.asked = session->recipe(id).options;
      return write_recipe(recipe_of(known));
    }
    /// Waits until the tier has all that it is to have.
    void settle() const {
      for (int i = 0; i < 1000 && session->cache().tier_waiting() > 0; ++i)
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
      EXPECT_EQ(session->cache().tier_waiting(), 0U);
    }
  };

  [[nodiscard]] Sharing sharing(bool acknowledge_in_tier = false) const {
    return {.objects = shelf_,
            .farm_key = kFarmKey,
            .acknowledge_in_tier = acknowledge_in_tier,
            .tell = {},
            .designs = table_};
  }
  void open(Replica& replica, const Sharing& sharing) const {
    replica.session.reset();  // which has the store
    replica.session = only_session(replica.engine.engine(), replica.folder.open(), {}, sharing);
  }
  void open(Replica& replica, bool acknowledge_in_tier = false) const {
    open(replica, sharing(acknowledge_in_tier));
  }
  static Command first_mesh() {
    return CreateCommand{.source = model_of({block("plate", 80, 40, 10)}),
                         .options = {.nodes = 100},
                         .design = "plate"};
  }
  static Command edit_of(const std::string& base, double dx) {
    return EditCommand{
        .base = base, .edit = {{SetFeatureParameter{"plate", "dx", Scalar(dx)}}}, .document = "{}"};
  }
  /// A first mesh and three edits of it, one of the other.
  std::vector<std::string> make_chain(const Replica& replica) {
    std::vector<std::string> ids{replica.make(first_mesh()).filed.record.id};
    for (int dx = 81; dx <= 83; ++dx)
      ids.push_back(replica.make(edit_of(ids.back(), dx)).filed.record.id);
    return ids;
  }

  inline static const std::string kFarmKey = "the key of this farm";
  std::shared_ptr<Shelf> shelf_ = std::make_shared<Shelf>();
  std::shared_ptr<DesignTable> table_;  ///< null: none
  Replica here_, there_;
};

}  // namespace remeshd::test
