#include <gtest/gtest.h>

#include <cstring>
#include <string>

#include "engine/remesh/remesh.h"
#include "tests/support/cases.h"
#include "tests/support/expect_error.h"
#include "tests/support/run.h"

namespace remeshd {
namespace {

using test::kRun;

/// Leaves numbers on the stack that are no addresses, where what comes next has its variables.
[[gnu::noinline]] void spoil_stack() {
  volatile char spoilt[1 << 16];
  for (volatile char& byte : spoilt) byte = 0x5A;
}

/// A run that is stopped from within one of its reports of progress.
class StoppedRun {
 public:
  /// `at`: the number of the report, from 1; 0: none.
  remeshd::Run stopped_at(int at) {
    stop_ = std::stop_source();
    reports_ = 0;
    return {.stop = stop_.get_token(), .on_progress = [this, at](const Progress&) {
              if (++reports_ == at) stop_.request_stop();
            }};
  }
  [[nodiscard]] int reports() const { return reports_; }

 private:
  std::stop_source stop_;
  int reports_ = 0;
};

/// Stops a run at every one of its reports in turn.
void stop_everywhere(const Revision& original, const ModelSource& source,
                     const MeshOptions& options) {
  StoppedRun stopped;
  make_revision(original, source, options, stopped.stopped_at(0));
  const int all = stopped.reports();
  ASSERT_GT(all, 5);
  int cancelled = 0;
  for (int at = 1; at < all; ++at) {
    const remeshd::Run run = stopped.stopped_at(at);
    spoil_stack();
    try {
      make_revision(original, source, options, run);
    } catch (const Error& error) {
      EXPECT_EQ(error.info().kind, ErrorKind::Cancelled) << at;
      ++cancelled;
    }
  }
  EXPECT_GT(cancelled, all / 2);  // after the last reports it may come to its end all the same
}

TEST(Cancelled, AtAnyReportAFirstMeshEndsAsIfItHadNotBeen) {
  stop_everywhere(Revision::none(), test::case_model("tool1-a"), {.nodes = 500});
}

TEST(Cancelled, AtAnyReportAnEditEndsAsIfItHadNotBeen) {
  const Revision base =
      make_revision(Revision::none(), test::case_model("tool1-a"), {.nodes = 500}, kRun);
  ModelSource longer = base.source;
  test::parameter(longer, "pin_radius") = 4.5;
  stop_everywhere(base, longer, {});
}

}  // namespace
}  // namespace remeshd
