#pragma once

#include <atomic>
#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "tests/service/requests.h"

namespace remeshd::test {

/// Sends edits of one revision, each another one, and counts how they end.
class EditLoad {
 public:
  struct Counts {
    std::size_t sent = 0, done = 0, refused = 0;
    double done_per_second = 0;             ///< until the last was answered
    std::size_t without_delay = 0;          ///< refusals that lack RetryInfo or the push-back
    std::size_t lost = 0;                   ///< neither done nor refused at the door
    std::vector<double> refusal_ms;         ///< from sending to hearing of it
    std::map<std::string, int> other_ends;  ///< of those lost
  };

  /// The stub must outlive it.
  EditLoad(v1::RemeshService::Stub& stub, std::string base) : stub_(stub), base_(std::move(base)) {}

  /// So many clients that each wait for an answer before they ask again.
  /// Throws std::runtime_error where one fails.
  Counts closed_loop(int clients, double seconds);
  /// Requests at a fixed rate, whatever becomes of them. Returns when all are answered.
  Counts open_loop(double per_second, double seconds);

 private:
  v1::EditRevisionRequest next() {
    return set_parameter(base_, "pin_radius", pin_radius(++number_));
  }

  v1::RemeshService::Stub& stub_;
  const std::string base_;
  std::atomic<int> number_ = 0;
};

}  // namespace remeshd::test
