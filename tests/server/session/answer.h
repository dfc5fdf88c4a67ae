#pragma once

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <functional>
#include <memory>
#include <thread>

#include "server/session/commands.h"

namespace remeshd::test {

/// A value or an error, which another thread is to tell. Whoever tells it may outlive it.
template <typename Value>
class Awaited {
 public:
  [[nodiscard]] std::function<void(const Value&)> on_value() const {
    return [heard = heard_](const Value& value) {
      heard->value = value;
      ++heard->answers;
    };
  }
  [[nodiscard]] std::function<void(const Error&)> on_error() const {
    return [heard = heard_](const Error& why) {
      heard->error = why.info();
      ++heard->answers;
    };
  }
  /// Whether an answer came within 10 s.
  [[nodiscard]] bool came() const {
    for (int k = 0; k < 10000 && answers() == 0; ++k)
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    return answers() > 0;
  }
  /// Waits for it; fails the test where it is an error.
  [[nodiscard]] Value value() const {
    EXPECT_EQ(error().reason, "");
    return heard_->value;
  }
  /// Waits for it; without a reason where it is a value.
  [[nodiscard]] ErrorInfo error() const {
    EXPECT_TRUE(came());
    return heard_->error;
  }
  [[nodiscard]] int answers() const { return heard_->answers; }

 private:
  struct Heard {
    Value value{};
    ErrorInfo error;
    std::atomic<int> answers = 0;
  };
  std::shared_ptr<Heard> heard_ = std::make_shared<Heard>();
};

/// What a listener has heard.
class Answer : public Awaited<Made> {
 public:
  [[nodiscard]] Listener listener() const {
    Listener listener;
    listener.made = on_value();
    listener.failed = on_error();
    return listener;
  }
  [[nodiscard]] Made made() const { return value(); }
};

}  // namespace remeshd::test
