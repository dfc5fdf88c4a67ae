#include <atomic>
#include <cstdio>
#include <random>
#include <thread>
#include <vector>

#include "tests/service/goals.h"
#include "tests/service/kept_revisions.h"
#include "tests/service/load_program.h"
#include "tests/service/requests.h"
#include "tests/service/served_daemon.h"
#include "tests/service/timing.h"

// The daemon is killed at random moments, also while it opens its store, and clients make, edit and
// delete revisions meanwhile: what it acknowledged must be there afterwards, to the bit.
namespace remeshd::test {
namespace {

struct Settings {
  int kills = 1000;
  int revisions = 200;
  unsigned seed = 1;
  bool goals = false;
};

constexpr std::uint32_t kNodes = 200;
constexpr int kClients = 2;

class Client {
 public:
  Client(KeptRevisions& kept, int revisions, int number)
      : kept_(kept),
        most_(static_cast<std::size_t>(revisions)),
        number_(number),
        random_(static_cast<unsigned>(number)) {}

  /// Makes, edits and deletes until a call finds no daemon.
  void run(v1::RemeshService::Stub& stub) {
    while (step(stub)) {
    }
  }

 private:
  /// A size that no one asked for before, so that every request makes another revision.
  double next_size() { return 10 + 1e-4 * (kClients * ++steps_ + number_); }

  bool step(v1::RemeshService::Stub& stub) {
    const auto base = kept_.any(random_);
    if (base && kept_.count() > most_) return remove(stub, *base);
    const unsigned dice = random_() % 10;
    if (base && dice == 0) return remove(stub, *base);
    return base && dice < 6 ? edit(stub, *base) : create(stub);
  }

  bool ended(v1::RemeshService::Stub& stub, const grpc::Status& status, const std::string& id) {
    if (status.error_code() == grpc::StatusCode::UNAVAILABLE) return false;
    if (status.ok()) {
      // Acknowledged from here on, whether or not its bytes can be read before the next kill.
      kept_.made(id);
      if (random_() % 2 == 0)
        if (const auto bytes = mesh_hash(stub, id)) kept_.read(id, *bytes);
    }
    return true;
  }

  bool create(v1::RemeshService::Stub& stub) {
    grpc::ClientContext context;
    v1::CreateRevisionResponse reply;
    v1::CreateRevisionRequest request = create_block(kNodes, next_size());
    request.set_design("client-" + std::to_string(number_));
    const grpc::Status status = stub.CreateRevision(&context, request, &reply);
    return ended(stub, status, reply.result().revision().id());
  }

  bool edit(v1::RemeshService::Stub& stub, const std::string& base) {
    grpc::ClientContext context;
    v1::EditRevisionResponse reply;
    v1::EditRevisionRequest request = set_parameter(base, "size", next_size());
    request.set_design("client-" + std::to_string(number_));
    const grpc::Status status = stub.EditRevision(&context, request, &reply);
    return ended(stub, status, reply.result().revision().id());
  }

  bool remove(v1::RemeshService::Stub& stub, const std::string& id) {
    kept_.deleting(id);
    grpc::ClientContext context;
    v1::DeleteRevisionRequest request;
    v1::DeleteRevisionResponse reply;
    request.set_revision(id);
    request.set_allow_head(true);
    const grpc::Status status = stub.DeleteRevision(&context, request, &reply);
    if (status.ok()) kept_.deleted(id);
    return status.error_code() != grpc::StatusCode::UNAVAILABLE;
  }

  KeptRevisions& kept_;
  const std::size_t most_;
  const int number_;
  std::mt19937 random_;
  int steps_ = 0;
};

class Kills {
 public:
  explicit Kills(const Settings& settings) : settings_(settings), random_(settings.seed) {
    for (int i = 0; i < kClients; ++i) clients_.emplace_back(kept_, settings.revisions, i);
  }

  int run() {
    Goals goals(settings_.goals);
    const std::vector<std::string> arguments = {"--store", store_.path(), "--threads", "1"};
    for (int kills = 0; kills < settings_.kills;) {
      if (random_() % 2 == 0) {
        kill_while_opening(arguments);
        if (++kills == settings_.kills) break;
      }
      const auto start = Clock::now();
      ServedDaemon daemon(arguments);
      daemon.info();
      ready_.push_back(seconds_since(start));
      check(daemon);
      kill_under_load(daemon);
      ++kills;
    }
    ServedDaemon last(arguments);
    check(last);

    goals.tell("kills", settings_.kills);
    goals.tell("  of them while it opened its store", opening_);
    goals.tell("revisions in the end", static_cast<double>(kept_.count()));
    goals.tell("meshes compared", static_cast<double>(sum_.read));
    goals.must_be_at_most("acknowledged and lost", static_cast<double>(sum_.lost), "", 0);
    goals.must_be_at_most("deleted and there again", static_cast<double>(sum_.risen), "", 0);
    goals.must_be_at_most("of wrong bytes", static_cast<double>(sum_.wrong), "", 0);
    goals.tell("ready after a start, median", median(ready_), "s");
    goals.at_most("ready after a start, at most", percentile(ready_, 1), "s", 2);
    return goals.exit_status();
  }

 private:
  double milliseconds(int most) { return 1e-3 * static_cast<double>(random_() % (1000U * most)); }

  void kill_while_opening(const std::vector<std::string>& arguments) {
    std::vector<std::string> all = {"--listen", "127.0.0.1:0"};
    all.insert(all.end(), arguments.begin(), arguments.end());
    Process process(all);
    std::this_thread::sleep_for(duration_of(1e-3 * milliseconds(50)));
    process.signal(SIGKILL);
    process.wait();
    ++opening_;
  }

  void check(ServedDaemon& daemon) {
    const KeptRevisions::Check check = kept_.compare(daemon.stub(), 5, random_);
    sum_.lost += check.lost;
    sum_.risen += check.risen;
    sum_.wrong += check.wrong;
    sum_.read += check.read;
    if (check.lost + check.risen + check.wrong > 0)
      std::printf("log of the daemon that lacks something:\n%s\n", daemon.process().log().c_str());
  }

  void kill_under_load(ServedDaemon& daemon) {
    std::vector<std::jthread> threads;
    for (Client& client : clients_)
      threads.emplace_back(
          [&client, stub = v1::RemeshService::NewStub(daemon.connect())] { client.run(*stub); });
    std::this_thread::sleep_for(duration_of(1e-3 * milliseconds(250)));
    daemon.process().signal(SIGKILL);
    daemon.process().wait();
  }

  const Settings settings_;
  std::mt19937 random_;
  StoreFolder store_{"kills"};
  KeptRevisions kept_;
  std::vector<Client> clients_;
  std::vector<double> ready_;
  int opening_ = 0;
  KeptRevisions::Check sum_;
};

}  // namespace
}  // namespace remeshd::test

int main(int argc, char** argv) {
  remeshd::test::Settings settings;
  remeshd::test::LoadProgram program("What is left after kill -9 at random moments",
                                     settings.goals);
  CLI::App& options = program.options();
  options.add_option("--kills", settings.kills);
  options.add_option("--revisions", settings.revisions, "that the store has at most, about");
  options.add_option("--seed", settings.seed, "of the moments");
  return program.run(argc, argv, [&] { return remeshd::test::Kills(settings).run(); });
}
