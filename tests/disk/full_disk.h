#pragma once

#include <gmock/gmock.h>

#include <algorithm>
#include <cerrno>
#include <optional>
#include <thread>

#include "server/session/archive.h"
#include "tests/disk/file_calls.h"
#include "tests/server/fake_engine.h"
#include "tests/server/store/store_folder.h"
#include "tests/support/cases.h"
#include "tests/support/run.h"

namespace remeshd::test {

/// An archive over a store whose disk takes nothing more from a moment on.
class FullDisk : public StoreFolderTest {
 protected:
  FullDisk() { open(); }

  void open() {
    archive_.reset();
    store_.reset();
    store_.emplace(folder_);
    archive_.emplace(engine_, *store_, memory_);
  }
  HeldRevisionPtr made(int n, const std::string& parent = "") {
    auto held = std::make_shared<HeldRevision>();
    held->asked = MeshOptions{.nodes = 100};
    held->revision = engine_.make_revision(nullptr, model_of({block("plate", 80 + n, 40, 10)}),
                                           *held->asked, kRun);
    held->record = {.id = id(n),
                    .parent = parent,
                    .algorithm_version = engine_.algorithm_version,
                    .created_ns = n};
    return held;
  }
  Filed file(int n) { return archive_->file(made(n), "plate", {}); }
  void fill_disk() {
    calls_.decide([](const FileCall& call, std::size_t) {
      const bool grows = call.kind == FileCall::Kind::Write || call.kind == FileCall::Kind::Create;
      return grows ? ENOSPC : 0;
    });
  }
  /// As well, until a pack is deleted.
  void fill_disk_until_a_pack_goes() {
    calls_.decide([room = false](const FileCall& call, std::size_t) mutable {
      room |= call.kind == FileCall::Kind::Unlink && call.path.starts_with("packs/");
      const bool grows = call.kind == FileCall::Kind::Write || call.kind == FileCall::Kind::Create;
      return grows && !room ? ENOSPC : 0;
    });
  }
  /// The disk has room again; waits until all is saved.
  void make_room() {
    calls_.decide({});
    eventually([&] { return store_->healthy() && archive_->is_durable(id(2)); });
  }
  template <typename Holds>
  static bool eventually(Holds&& holds) {
    for (int k = 0; k < 10000 && !holds(); ++k)
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    return holds();
  }

  FileCalls calls_{folder_};
  FakeEngine fake_;
  const Engine engine_ = fake_.engine();
  std::optional<Store> store_;
  MemoryBudget memory_{1 << 30};
  std::optional<Archive> archive_;
};

}  // namespace remeshd::test
