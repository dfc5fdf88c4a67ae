#pragma once

#include <gtest/gtest.h>

#include <string>
#include <utility>

#include "engine/base/error.h"

namespace remeshd::test {

/// What `work` throws; fails the test, and returns an empty ErrorInfo, where it throws nothing.
template <class Work>
ErrorInfo error_of(Work&& work) {
  try {
    std::forward<Work>(work)();
  } catch (const Error& e) {
    return e.info();
  }
  ADD_FAILURE() << "no Error was thrown";
  return {};
}

/// `a,b`, so that a test shows all features at once.
inline std::string joined(const FeatureIds& ids) {
  std::string text;
  for (const std::string& id : ids) text += (text.empty() ? "" : ",") + id;
  return text;
}

/// `reason features parameter`, so that a test shows all three at once; `-` where empty.
inline std::string place_of(const ErrorInfo& info) {
  const auto shown = [](const std::string& s) { return s.empty() ? std::string("-") : s; };
  return info.reason + " " + shown(joined(info.features)) + " " + shown(info.parameter);
}

}  // namespace remeshd::test
