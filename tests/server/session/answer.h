#pragma once

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <memory>
#include <thread>

#include "server/session/commands.h"

namespace remeshd::test {

/// What a listener has heard. The listener may outlive it.
class Answer {
 public:
  [[nodiscard]] Listener listener() const {
    return {.progress = {},
            .made =
                [heard = heard_](const Made& made) {
                  heard->made = made;
                  ++heard->answers;
                },
            .failed =
                [heard = heard_](const Error& why) {
                  heard->error = why.info();
                  ++heard->answers;
                }};
  }
  /// Whether an answer came within 10 s.
  [[nodiscard]] bool came() const {
    for (int k = 0; k < 10000 && answers() == 0; ++k)
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    return answers() > 0;
  }
  /// Waits for it; fails the test where it is no revision.
  [[nodiscard]] Made made() const {
    EXPECT_EQ(error().reason, "");
    return heard_->made;
  }
  /// Waits for it; without a reason where it is a revision.
  [[nodiscard]] ErrorInfo error() const {
    EXPECT_TRUE(came());
    return heard_->error;
  }
  [[nodiscard]] int answers() const { return heard_->answers; }

 private:
  struct Heard {
    Made made;
    ErrorInfo error;
    std::atomic<int> answers = 0;
  };
  std::shared_ptr<Heard> heard_ = std::make_shared<Heard>();
};

}  // namespace remeshd::test
