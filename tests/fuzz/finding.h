#pragma once

#include <stdexcept>
#include <string>

#include "engine/base/error.h"

namespace remeshd::fuzz {

/// Something that a target promises does not hold. No target catches it: libFuzzer keeps the input,
/// and the test of the corpus fails.
class Finding : public std::logic_error {
 public:
  using std::logic_error::logic_error;
};

/// Throws Finding unless `holds`.
inline void expect(bool holds, const std::string& what) {
  if (!holds) throw Finding(what);
}

/// What a stranger's input may end in: an error that is theirs, with a reason and a sentence.
inline void expect_in_words(const Error& error) {
  const ErrorInfo& info = error.info();
  expect(!info.reason.empty(), "an error without a reason: " + info.message);
  expect(!info.message.empty(), "an error without a message: " + info.reason);
  expect(info.kind != ErrorKind::Internal, "an internal error: " + info.message);
}

}  // namespace remeshd::fuzz
