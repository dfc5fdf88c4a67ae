#pragma once

#include "remesh/v1/report.pb.h"

namespace remeshd::test {

/// A report without what a clock has a part in, and whether it came from the cache.
inline remesh::v1::Report timeless(remesh::v1::Report report) {
  report.clear_seconds();
  report.clear_cached();
  for (auto& attempt : *report.mutable_attempts()) attempt.clear_seconds();
  auto& diagnostics = *report.mutable_diagnostics();
  diagnostics.clear_table3();
  diagnostics.clear_geometry_seconds();
  diagnostics.mutable_taken()->clear_seconds();
  for (auto& attempt : *diagnostics.mutable_geometry_attempts()) attempt.clear_seconds();
  return report;
}

}  // namespace remeshd::test
