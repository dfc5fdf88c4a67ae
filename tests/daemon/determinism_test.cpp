#include <array>
#include <future>
#include <set>

#include "tests/daemon/process.h"
#include "tests/daemon/timeless.h"

/// The same model, options and seed give the same bytes: one test for each thing that might change
/// them. What is compared of every revision of some chains of edits is all that a client can get:
/// the report but for its seconds, and the mesh with its ids, cells, names and maps.
namespace remeshd::test {
namespace {

struct Step {
  v1::ModelEdit edit;
  v1::MeshOptions options;
};
struct Chain {
  bool even;
  std::string model;
  std::vector<Step> steps;
};

std::string case_text(const std::string& name) {
  return read_document(std::string(REMESHD_CASES_DIR) + "/" + name + ".json");
}
v1::ModelEdit change(const std::string& name) { return parse_edit(case_text(name + ".edit")); }

v1::MeshOptions options(std::uint32_t iterations, v1::Start start) {
  v1::MeshOptions options;
  options.set_iterations(iterations);
  options.set_start(start);
  return options;
}

/// They go every way but those to a mesh that cannot be had otherwise.
std::vector<Chain> chains() {
  return {{true,
           "tool1-a",
           {{set("hole_circle", 36.02), {}},
            {change("tool1-ac"), {}},
            {set("hole_turn", 15 + 1e-13), {}},
            {change("tool1-ab"), {}}}},
          {true,
           "tool2-b",
           {{change("tool2-bc"), {}}, {set("pipe_x", 23.98), {}}, {change("tool2-cd"), {}}}},
          // A mesh from one iteration wears the chain out.
          {true,
           "tool3-a",
           {{change("tool3-ab"), options(1, v1::START_RANDOM)},
            {set("boss_x", 37), options(5, v1::START_LATTICE)},
            {set("boss_x", 37.02), {}}}},
          {false, "tool1-a", {{set("hole_circle", 36.02), {}}, {change("tool1-ac"), {}}}}};
}

/// A client's side of a chain.
class ChainRun {
 public:
  ChainRun(v1::RemeshService::Stub& stub, Chain chain, std::uint32_t threads = 1)
      : stub_(stub), chain_(std::move(chain)), threads_(threads) {}

  [[nodiscard]] bool ended() const { return next_ > chain_.steps.size(); }
  /// Makes the next revision of the chain; the first one is the model itself.
  void step() {
    grpc::ClientContext context;
    v1::RevisionResult result;
    grpc::Status status;
    if (next_ == 0) {
      v1::CreateRevisionRequest request;
      *request.mutable_model() = parse_model(case_text(chain_.model));
      request.mutable_options()->set_nodes(1500);
      request.mutable_options()->set_iterations(5);
      request.mutable_options()->mutable_sizing()->set_even(chain_.even);
      request.set_threads(threads_);
      v1::CreateRevisionResponse reply;
      status = stub_.CreateRevision(&context, request, &reply);
      result = reply.result();
    } else {
      v1::EditRevisionRequest request;
      request.set_base(head_);
      *request.mutable_edit() = chain_.steps[next_ - 1].edit;
      *request.mutable_options() = chain_.steps[next_ - 1].options;
      request.set_threads(threads_);
      v1::EditRevisionResponse reply;
      status = stub_.EditRevision(&context, request, &reply);
      result = reply.result();
    }
    EXPECT_TRUE(status.ok()) << status.error_message();
    ++next_;
    head_ = result.revision().id();
    const v1::Report& report = result.report();
    ways_.insert(report.way());
    cached_ += report.cached() ? 1 : 0;
    answers_.push_back(timeless(report).SerializeAsString() + mesh());
  }
  ChainRun& to_the_end() {
    while (!ended()) step();
    return *this;
  }

  [[nodiscard]] const std::vector<std::string>& answers() const { return answers_; }
  [[nodiscard]] const std::set<v1::Report::Way>& ways() const { return ways_; }
  [[nodiscard]] std::size_t cached() const { return cached_; }  ///< answers

 private:
  /// Header, all arrays and checksum.
  [[nodiscard]] std::string mesh() const {
    grpc::ClientContext context;
    v1::GetMeshRequest request;
    request.set_revision(head_);
    const auto reader = stub_.GetMesh(&context, request);
    std::string bytes;
    for (v1::GetMeshResponse message; reader->Read(&message);) bytes += message.SerializeAsString();
    EXPECT_TRUE(reader->Finish().ok());
    return bytes;
  }

  v1::RemeshService::Stub& stub_;
  Chain chain_;
  std::uint32_t threads_;
  std::size_t next_ = 0;
  std::string head_;
  std::vector<std::string> answers_;
  std::set<v1::Report::Way> ways_;
  std::size_t cached_ = 0;
};

using Answers = std::vector<std::vector<std::string>>;  ///< by chain and step

Answers in_turn(v1::RemeshService::Stub& stub) {
  Answers all;
  for (const Chain& chain : chains()) all.push_back(ChainRun(stub, chain).to_the_end().answers());
  return all;
}

/// All chains, one step of each in turn.
std::vector<ChainRun> interleaved(v1::RemeshService::Stub& stub) {
  std::vector<ChainRun> all;
  for (const Chain& chain : chains()) all.emplace_back(stub, chain);
  for (bool more = true; more;) {
    more = false;
    for (ChainRun& run : all) {
      if (run.ended()) continue;
      run.step();
      more = true;
    }
  }
  return all;
}

/// Says which answers differ, not what is in them.
void expect_same(const Answers& a, const Answers& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t c = 0; c < a.size(); ++c) {
    ASSERT_EQ(a[c].size(), b[c].size());
    for (std::size_t k = 0; k < a[c].size(); ++k) {
      EXPECT_GT(a[c][k].size(), 100000U);
      EXPECT_TRUE(a[c][k] == b[c][k]) << "chain " << c << ", step " << k;
    }
  }
}

class Determinism : public DaemonTest {
 protected:
  [[nodiscard]] Engine make_engine() const override { return production_engine(); }

  /// The answers of a daemon in this process as `--local` has one: no port, everything in memory.
  static Answers local() {
    DaemonOptions options;
    options.listen.clear();
    Daemon daemon(options, production_engine());
    return in_turn(*v1::RemeshService::NewStub(daemon.in_process_channel()));
  }
};

/// Memory at other addresses, filled with other bytes, and another history of containers.
TEST_F(Determinism, EveryRunGivesTheSameBytes) {
  const Process first({"--listen", "127.0.0.1:0"}, {"MALLOC_PERTURB_=85"});
  const Process second({"--listen", "127.0.0.1:0"}, {"MALLOC_PERTURB_=170", "MALLOC_ARENA_MAX=1"});
  const auto one = connect(first), other = connect(second);
  std::set<v1::Report::Way> ways;
  Answers backwards(chains().size());
  for (std::size_t c = backwards.size(); c-- > 0;) {
    ChainRun run(*other, chains()[c]);
    backwards[c] = run.to_the_end().answers();
    ways.insert(run.ways().begin(), run.ways().end());
  }
  expect_same(in_turn(*one), backwards);
  for (const auto way : {v1::Report::WAY_UNCHANGED, v1::Report::WAY_MORPHED, v1::Report::WAY_LOCAL,
                         v1::Report::WAY_RENEWED})
    EXPECT_TRUE(ways.contains(way)) << v1::Report::Way_Name(way);
}

TEST_F(Determinism, TheDaemonGivesTheSameBytesAsLocal) {
  const Process process({"--listen", "127.0.0.1:0"});
  expect_same(local(), in_turn(*connect(process)));
}

/// Threads of a computation, and computations side by side.
TEST_F(Determinism, AnyNumberOfThreadsGivesTheSameBytes) {
  options_.threads = 8;
  options_.workers = 3;
  const Answers one = in_turn(stub());
  start();
  std::vector<std::future<std::vector<std::string>>> side_by_side;
  std::uint32_t threads = 2;
  for (const Chain& chain : chains())
    side_by_side.push_back(std::async(std::launch::async, [this, chain, threads = threads++] {
      return ChainRun(*stub_, chain, threads * threads - 1).to_the_end().answers();
    }));
  Answers many;
  for (auto& answers : side_by_side) many.push_back(answers.get());
  expect_same(one, many);
}

/// Cold: every base has left memory by the time it is edited. Warm: none has. Known: the answers
/// are there already, and are found by their keys.
TEST_F(Determinism, AColdCacheGivesTheSameBytesAsAWarmOne) {
  const Answers warm = local();
  use_store();
  options_.cache = 1;
  for (const std::size_t known : {0U, 1U}) {
    std::vector<ChainRun> all = interleaved(stub());
    Answers answers;
    for (const ChainRun& run : all) {
      EXPECT_EQ(run.cached(), known * run.answers().size());
      answers.push_back(run.answers());
    }
    expect_same(warm, answers);
    // The last result, and its base, which was in use when that came.
    EXPECT_LE(info().load().cached_revisions(), 2U);
  }
}

/// A restart before every edit: what it starts from has been stored and loaded, each time.
TEST_F(Determinism, ARestartChangesNoByte) {
  const Answers without = local();
  use_store();
  Answers with;
  for (const Chain& chain : chains()) {
    Chain one = chain;
    with.emplace_back();
    for (std::size_t k = 0; k <= chain.steps.size(); ++k) {
      start();
      // Steps before the last are answered by the store.
      one.steps.assign(chain.steps.begin(), chain.steps.begin() + static_cast<std::ptrdiff_t>(k));
      ChainRun run(stub(), one);
      run.to_the_end();
      EXPECT_EQ(run.cached(), k);
      with.back().push_back(run.answers().back());
    }
  }
  expect_same(without, with);
}

}  // namespace
}  // namespace remeshd::test
