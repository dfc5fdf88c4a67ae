#include "engine/kernel/tetgen.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <limits>
#include <map>
#include <numbers>
#include <set>
#include <stop_token>
#include <thread>

#include "tests/support/expect_error.h"
#include "tests/support/run.h"

namespace remeshd::kernel {
namespace {

namespace fs = std::filesystem;

using test::kRun;

/// Adds the box from `lo` to `hi`.
void add_box(TetGenSurface& s, const Vec3& lo, const Vec3& hi) {
  const auto first = static_cast<std::int32_t>(s.points.size());
  for (int v = 0; v < 8; ++v)
    s.points.push_back(
        {(v & 1) != 0 ? hi.x : lo.x, (v & 2) != 0 ? hi.y : lo.y, (v & 4) != 0 ? hi.z : lo.z});
  for (const auto& [a, b, c, d] :
       {std::array{0, 2, 3, 1}, std::array{4, 5, 7, 6}, std::array{0, 1, 5, 4},
        std::array{2, 6, 7, 3}, std::array{0, 4, 6, 2}, std::array{1, 3, 7, 5}}) {
    s.triangles.push_back({first + a, first + b, first + c});
    s.triangles.push_back({first + a, first + c, first + d});
  }
}

TetGenSurface box(const Vec3& lo, const Vec3& hi) {
  TetGenSurface s;
  add_box(s, lo, hi);
  return s;
}

TetGenSurface cube() { return box({0, 0, 0}, {1, 1, 1}); }

/// A sphere of radius 1 with rings x around points.
TetGenSurface sphere(int rings, int around) {
  constexpr double kPi = std::numbers::pi;
  TetGenSurface s;
  s.points.push_back({0, 0, -1});
  for (int r = 1; r < rings; ++r)
    for (int i = 0; i < around; ++i) {
      const double latitude = kPi * r / rings, t = 2 * kPi * (i + 0.5 * (r % 2)) / around;
      s.points.push_back({std::sin(latitude) * std::cos(t), std::sin(latitude) * std::sin(t),
                          -std::cos(latitude)});
    }
  s.points.push_back({0, 0, 1});
  const auto last = static_cast<std::int32_t>(s.points.size()) - 1;
  const auto at = [&](int r, int i) {
    return r == 0 ? 0 : r == rings ? last : 1 + (r - 1) * around + (i + around) % around;
  };
  for (int r = 0; r < rings; ++r)
    for (int i = 0; i < around; ++i) {
      const int shift = r % 2;  // odd rings are turned by half a step
      if (r > 0) s.triangles.push_back({at(r, i), at(r, i + 1), at(r + 1, i + shift)});
      if (r < rings - 1)
        s.triangles.push_back({at(r + 1, i), at(r, i + 1 - shift), at(r + 1, i + 1)});
    }
  return s;
}

double volume(const TetMesh& mesh, const Tet& t) {
  const Vec3& a = mesh.nodes[t[0]];
  return dot(cross(mesh.nodes[t[1]] - a, mesh.nodes[t[2]] - a), mesh.nodes[t[3]] - a) / 6;
}

double volume(const TetMesh& mesh) {
  double sum = 0;
  for (const Tet& t : mesh.tets) sum += volume(mesh, t);
  return sum;
}

int open_files() {
  int n = 0;
  for ([[maybe_unused]] const auto& entry : fs::directory_iterator("/proc/self/fd")) ++n;
  return n;
}

/// After each test no process is left, running or dead, and no file descriptor.
class TetGen : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::temp_directory_path() / ("tetgen_test." + std::to_string(getpid()));
    fs::create_directories(folder_);
    open_before_ = open_files();
  }
  void TearDown() override {
    EXPECT_EQ(waitpid(-1, nullptr, WNOHANG), -1) << "a child is left";
    EXPECT_EQ(errno, ECHILD);
    EXPECT_EQ(open_files(), open_before_);
    fs::remove_all(folder_);
  }

  /// A stand-in for remeshd-tetgen: a shell script.
  fs::path script(const std::string& body) const {
    fs::path path = folder_ / "helper";
    std::ofstream(path) << "#!/bin/sh\n" << body << "\n";
    fs::permissions(path, fs::perms::owner_all);
    return path;
  }

  static ErrorInfo failure(const TetGenSurface& surface, const TetGenLimits& limits = {},
                           const remeshd::Run& run = kRun) {
    return test::error_of([&] { run_tetgen(surface, limits, run); });
  }

  fs::path folder_;
  int open_before_ = 0;
};

TEST_F(TetGen, FillsACubeWithPositiveTetsOfOneRegion) {
  const TetGenMesh out = run_tetgen(cube(), {}, kRun);
  ASSERT_EQ(out.regions.size(), out.mesh.tets.size());
  EXPECT_GE(out.mesh.tets.size(), 5U);
  EXPECT_NEAR(volume(out.mesh), 1, 1e-12);
  for (const Tet& t : out.mesh.tets) EXPECT_GT(volume(out.mesh, t), 0);
  EXPECT_EQ(std::set(out.regions.begin(), out.regions.end()).size(), 1U);
  for (const Vec3& p : cube().points)
    EXPECT_EQ(std::ranges::count(out.mesh.nodes, p), 1) << p.x << " " << p.y << " " << p.z;
}

/// The cube's sides 1 to 6, two triangles each, and its edges along x at y = z = 0, marked 7.
MarkedSurface marked_cube() {
  MarkedSurface marked;
  marked.surface = cube();
  for (std::int32_t t = 0; t < 12; ++t) marked.triangle_markers.push_back(1 + t / 2);
  marked.segments = {{0, 1}};
  marked.segment_markers = {7};
  return marked;
}

TEST_F(TetGen, AddsPointsInsideAndKeepsTheSurface) {
  MarkedSurface marked;
  marked.surface = sphere(16, 24);
  marked.triangle_markers.assign(marked.surface.triangles.size(), 1);
  const QualityMesh out =
      run_tetgen(marked, {.max_volume = 0.002, .split_surface = false}, {}, kRun);
  const TetMesh& mesh = out.filling.mesh;
  const std::size_t points = marked.surface.points.size();
  EXPECT_GT(mesh.nodes.size(), points + 100);
  EXPECT_TRUE(
      std::equal(marked.surface.points.begin(), marked.surface.points.end(), mesh.nodes.begin()));
  EXPECT_EQ(out.facets.size(), marked.surface.triangles.size());
  for (const Triangle& f : out.facets)
    for (const std::int32_t n : f) EXPECT_LT(n, static_cast<std::int32_t>(points));
  for (const Tet& t : mesh.tets) EXPECT_GT(volume(mesh, t), 0);
}

TEST_F(TetGen, MarksWhatItSplitsTheSurfaceInto) {
  const QualityMesh out = run_tetgen(marked_cube(), {.max_volume = 0.002}, {}, kRun);
  const std::vector<Vec3>& nodes = out.filling.mesh.nodes;
  EXPECT_GT(out.facets.size(), 12U);
  std::map<std::int32_t, double> area;
  for (std::size_t f = 0; f < out.facets.size(); ++f) {
    const auto& [a, b, c] = out.facets[f];
    area[out.facet_markers[f]] += 0.5 * norm(cross(nodes[b] - nodes[a], nodes[c] - nodes[a]));
  }
  EXPECT_EQ(area.size(), 6U);
  for (const auto& [marker, sum] : area) EXPECT_NEAR(sum, 1, 1e-9) << marker;
  double length = 0;
  for (std::size_t s = 0; s < out.segments.size(); ++s)
    if (out.segment_markers[s] == 7)
      length += distance(nodes[out.segments[s][0]], nodes[out.segments[s][1]]);
  EXPECT_NEAR(length, 1, 1e-9);
}

TEST_F(TetGen, NumbersTheRegionsOfAQualityMesh) {
  MarkedSurface marked;
  marked.surface = cube();
  add_box(marked.surface, {0.3, 0.3, 0.3}, {0.7, 0.7, 0.7});
  marked.triangle_markers.assign(24, 1);
  for (const bool split : {false, true}) {
    const QualityMesh out =
        run_tetgen(marked, {.max_volume = 0.05, .split_surface = split}, {}, kRun);
    std::map<std::int32_t, double> by_region;
    for (std::size_t t = 0; t < out.filling.mesh.tets.size(); ++t)
      by_region[out.filling.regions[t]] += volume(out.filling.mesh, out.filling.mesh.tets[t]);
    ASSERT_EQ(by_region.size(), 2U);
    EXPECT_NEAR(std::min(by_region.begin()->second, by_region.rbegin()->second), 0.064, 1e-9);
  }
}

TEST_F(TetGen, TellsAVoidFromWhatIsAroundIt) {
  TetGenSurface s = box({0, 0, 0}, {4, 4, 4});
  add_box(s, {1, 1, 1}, {2, 3, 3});
  const TetGenMesh out = run_tetgen(s, {}, kRun);
  std::map<std::int32_t, double> volumes;
  for (std::size_t t = 0; t < out.mesh.tets.size(); ++t)
    volumes[out.regions[t]] += volume(out.mesh, out.mesh.tets[t]);
  std::vector<double> sorted;
  for (const auto& [region, v] : volumes) sorted.push_back(v);
  std::ranges::sort(sorted);
  ASSERT_EQ(sorted.size(), 2U);
  EXPECT_NEAR(sorted[0], 4, 1e-9);
  EXPECT_NEAR(sorted[1], 60, 1e-9);
}

TEST_F(TetGen, TakesASurfaceThatNoSocketBufferHolds) {
  const TetGenSurface s = sphere(60, 120);  // about 0.5 MB there and more back
  const TetGenMesh out = run_tetgen(s, {}, kRun);
  EXPECT_NEAR(volume(out.mesh), 4 * std::numbers::pi / 3, 0.01);
}

TEST_F(TetGen, GivesTheSameMeshAgain) {
  const TetGenMesh a = run_tetgen(sphere(12, 20), {}, kRun);
  const TetGenMesh b = run_tetgen(sphere(12, 20), {}, kRun);
  EXPECT_EQ(a.mesh.nodes, b.mesh.nodes);
  EXPECT_EQ(a.mesh.tets, b.mesh.tets);
  EXPECT_EQ(a.regions, b.regions);
}

TEST_F(TetGen, IsFoundBesideTheRunningProgram) {
  EXPECT_EQ(find_tetgen_helper(),
            fs::read_symlink("/proc/self/exe").parent_path() / "remeshd-tetgen");
}

TEST_F(TetGen, IsTheOneThatTheEnvironmentNames) {
  setenv("REMESHD_TETGEN", (folder_ / "nothing").c_str(), 1);
  const ErrorInfo info = failure(cube());
  unsetenv("REMESHD_TETGEN");
  EXPECT_EQ(info.reason, "TETGEN_MISSING");
  EXPECT_NE(info.message.find((folder_ / "nothing").string()), std::string::npos) << info.message;
}

TEST_F(TetGen, IsMissingWhereTheFileMayNotBeRun) {
  const fs::path helper = script("exit 0");
  fs::permissions(helper, fs::perms::owner_read);
  EXPECT_EQ(failure(cube(), {.helper = helper}).reason, "TETGEN_MISSING");
}

TEST_F(TetGen, ThatIsKilledBeforeItReadsIsAnErrorWithTheSignal) {
  const std::uint64_t before = tetgen_crashes();
  const ErrorInfo info = failure(sphere(60, 120), {.helper = script("kill -SEGV $$")});
  EXPECT_EQ(info.reason, "TETGEN_CRASHED");
  EXPECT_EQ(tetgen_crashes(), before + 1);
  EXPECT_NE(info.message.find("signal 11"), std::string::npos) << info.message;
}

TEST_F(TetGen, ThatAbortsAfterReadingIsAnErrorWithTheSignal) {
  const ErrorInfo info = failure(cube(), {.helper = script("cat > /dev/null; kill -ABRT $$")});
  EXPECT_EQ(info.reason, "TETGEN_CRASHED");
  EXPECT_NE(info.message.find("signal 6"), std::string::npos) << info.message;
}

TEST_F(TetGen, ThatAnswersNonsenseIsAnError) {
  for (const char* body : {"cat > /dev/null", "cat > /dev/null; echo no mesh here",
                           "cat > /dev/null; head -c 4096 /dev/zero", "cat", "exit 3"})
    EXPECT_EQ(failure(cube(), {.helper = script(body)}).reason, "TETGEN_CRASHED") << body;
}

TEST_F(TetGen, ThatAnswersWithoutEndIsStopped) {
  const ErrorInfo info =
      failure(cube(), {.address_space = 1 << 20, .helper = script("exec cat /dev/zero")});
  EXPECT_EQ(info.reason, "TETGEN_CRASHED");
  EXPECT_NE(info.message.find("no end"), std::string::npos) << info.message;
}

TEST_F(TetGen, ThatHangsIsStoppedAtTheTimeLimit) {
  const ErrorInfo info = failure(cube(), {.seconds = 0.1, .helper = script("exec sleep 600")});
  EXPECT_EQ(info.reason, "TETGEN_TOO_SLOW");
  EXPECT_NE(info.message.find("0.1 s"), std::string::npos) << info.message;
}

TEST_F(TetGen, ThatHangsWithItsStreamsClosedIsStoppedToo) {
  EXPECT_EQ(failure(cube(), {.seconds = 0.1, .helper = script("exec sleep 600 <&- >&-")}).reason,
            "TETGEN_TOO_SLOW");
}

TEST_F(TetGen, StopsWhenTheRunIsCancelled) {
  for (const char* body : {"exec sleep 600", "exec sleep 600 <&- >&-"}) {
    std::stop_source stop;
    const remeshd::Run run{.stop = stop.get_token()};
    std::jthread canceller([&] {
      std::this_thread::sleep_for(std::chrono::milliseconds(50));
      stop.request_stop();
    });
    const ErrorInfo info = failure(cube(), {.helper = script(body)}, run);
    EXPECT_EQ(info.kind, ErrorKind::Cancelled) << body;
  }
}

TEST_F(TetGen, DoesNotStartInACancelledRun) {
  std::stop_source stop;
  stop.request_stop();
  const fs::path witness = folder_ / "started";
  const ErrorInfo info =
      failure(cube(), {.helper = script("touch " + witness.string())}, {.stop = stop.get_token()});
  EXPECT_EQ(info.kind, ErrorKind::Cancelled);
  EXPECT_FALSE(fs::exists(witness));
}

TEST_F(TetGen, KeepsToItsAddressSpace) {
  const ErrorInfo info = failure(sphere(200, 400), {.address_space = 48 << 20});
  EXPECT_EQ(info.reason, "TETGEN_OUT_OF_MEMORY");
  EXPECT_NE(info.message.find("48 MiB"), std::string::npos) << info.message;
}

TEST_F(TetGen, InheritsNoFileDescriptorAndNoBlockedSignal) {
  const int leaky = open("/dev/null", O_RDONLY);  // not close-on-exec
  ASSERT_EQ(dup2(leaky, 77), 77);
  sigset_t term, before;
  sigemptyset(&term);
  sigaddset(&term, SIGTERM);
  pthread_sigmask(SIG_BLOCK, &term, &before);
  const fs::path seen = folder_ / "seen";
  failure(cube(), {.helper = script("ls /proc/self/fd > " + seen.string() +
                                    "; grep SigBlk /proc/self/status >> " + seen.string())});
  pthread_sigmask(SIG_SETMASK, &before, nullptr);
  close(leaky);
  close(77);
  std::ifstream in(seen);
  const std::string text{std::istreambuf_iterator<char>(in), {}};
  EXPECT_EQ(text.find("77\n"), std::string::npos) << text;
  EXPECT_NE(text.find("SigBlk:\t0000000000000000"), std::string::npos) << text;
}

TEST_F(TetGen, RefusesTwoBoxesThatCross) {
  TetGenSurface s = cube();
  add_box(s, {0.5, 0.25, 0.25}, {1.5, 0.75, 0.75});
  const ErrorInfo info = failure(s);
  EXPECT_EQ(info.reason, "TETGEN_REFUSED");
  EXPECT_EQ(info.stage, "control mesh");
  EXPECT_NE(info.message.find("the surface cuts itself"), std::string::npos) << info.message;
}

TEST_F(TetGen, RefusesAnOpenSurface) {
  TetGenSurface s = cube();
  s.triangles.pop_back();
  EXPECT_EQ(failure(s).reason, "TETGEN_REFUSED");
}

// TetGen 1.5.0 dies of these: what its own process is for.
TEST_F(TetGen, FailsOnNothingAndOnFlatThings) {
  for (const TetGenSurface& s :
       {TetGenSurface{}, TetGenSurface{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}}}) {
    const ErrorInfo info = failure(s);
    EXPECT_TRUE(info.reason == "TETGEN_CRASHED" || info.reason == "TETGEN_REFUSED") << info.message;
  }
}

TEST_F(TetGen, RefusesCoordinatesThatAreNotFiniteAndIndicesOutOfRange) {
  TetGenSurface nan = cube(), infinite = cube(), beyond = cube(), negative = cube();
  nan.points[3].y = std::numeric_limits<double>::quiet_NaN();
  infinite.points[3].y = HUGE_VAL;
  beyond.triangles[2][1] = 8;
  negative.triangles[2][1] = -1;
  for (const TetGenSurface* s : {&nan, &infinite, &beyond, &negative}) {
    const ErrorInfo info = failure(*s);
    EXPECT_EQ(info.reason, "TETGEN_REFUSED");
    EXPECT_NE(info.message.find("not finite or a corner"), std::string::npos) << info.message;
  }
}

}  // namespace
}  // namespace remeshd::kernel
