#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <filesystem>
#include <memory>
#include <mutex>
#include <string>

#include "server/session/engine.h"

namespace remeshd::test {

/// An engine that makes something mesh-like in no time: as many nodes as asked for, at places that
/// follow from model, options and original alone. A gate holds computations up, so that tests
/// decide when they end.
class FakeEngine {
 public:
  FakeEngine();
  Engine engine() const;

  /// From now on computations wait at the gate, polling for their stop as the real ones do.
  void close_gate();
  void open_gate();
  /// From now on it makes other meshes than it should, and than other engines do.
  void go_wrong();
  /// Waits until this many computations stand at the gate; false after 10 s.
  bool wait_at_gate(int computations) const;
  /// Waits until a computation has ended by being stopped.
  bool wait_stopped(int computations) const;

  [[nodiscard]] int made() const;
  [[nodiscard]] int started() const;
  [[nodiscard]] int stopped() const;
  [[nodiscard]] int loaded() const;
  /// The threads that the last computation was given.
  [[nodiscard]] int threads() const;
  /// The folder for dumps that the last computation was given.
  [[nodiscard]] std::filesystem::path dumps() const;

 private:
  struct State;
  std::shared_ptr<State> state_;
};

}  // namespace remeshd::test
