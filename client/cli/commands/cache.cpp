#include <google/protobuf/util/time_util.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <map>
#include <memory>
#include <optional>

#include "client/cli/choice.h"
#include "client/cli/commands/command.h"
#include "client/cli/exit_code.h"
#include "client/cli/reply.h"
#include "client/cli/table.h"
#include "proto/json_writer.h"

namespace remeshd::cli {
namespace {

namespace v1 = remesh::v1;

constexpr double kMegabyte = 1e6;

std::string megabytes(std::uint64_t bytes) {
  return rounded(static_cast<double>(bytes) / kMegabyte, 4);
}

std::string state_of(const v1::CacheEntry& entry) {
  switch (entry.state()) {
    case v1::CacheEntry::STATE_STORED:
      return "stored";
    case v1::CacheEntry::STATE_MEMORY:
      return "memory";
    case v1::CacheEntry::STATE_RECIPE:
      return "recipe";
    case v1::CacheEntry::STATE_OUTDATED:
      return "outdated";
    default:
      return "?";
  }
}

const std::map<std::string, v1::CacheOrder> kOrders{{"used", v1::CACHE_ORDER_UNSPECIFIED},
                                                    {"bytes", v1::CACHE_ORDER_BYTES},
                                                    {"created", v1::CACHE_ORDER_CREATED}};

void add_ls(CLI::App& cache, Action& action) {
  struct Arguments {
    std::string design, order = "used", json;
    bool pinned = false, reverse = false;
  };
  auto* command =
      cache.add_subcommand("ls", "Meshes with what they take, what would go first at the top");
  const auto arguments = std::make_shared<Arguments>();
  command->add_option("--design", arguments->design, "Those of this design only");
  command->add_flag("--pinned", arguments->pinned, "Pinned ones only");
  only(*command->add_option("--by", arguments->order, "Order [used]"),
       {"used", "bytes", "created"});
  command->add_flag("-r,--reverse", arguments->reverse, "The other way round");
  command->add_option("--json", arguments->json, "Write the list here; `-`: to stdout")
      ->type_name("FILE");
  command->callback([arguments, &action] {
    action = [arguments](Session& session) {
      v1::ListCacheEntriesRequest request;
      request.mutable_filter()->set_design(arguments->design);
      request.mutable_filter()->set_pinned(arguments->pinned);
      request.set_order(kOrders.at(arguments->order));
      request.set_descending(arguments->reverse);
      const auto entries = session.client().list_cache(request, session.call());
      if (!arguments->json.empty()) {
        v1::ListCacheEntriesResponse all;
        for (const auto& entry : entries) *all.add_entries() = entry;
        session.write_text(arguments->json, write_json(all));
      }
      if (arguments->json == "-") return kFine;
      std::vector<std::vector<std::string>> rows{
          {"id", "state", "disk MB", "memory MB", "remade", "places", "used", "pin"}};
      for (const auto& entry : entries)
        rows.push_back({entry.revision().substr(0, kShownDigits), state_of(entry),
                        megabytes(entry.disk_bytes()), megabytes(entry.memory_bytes()),
                        std::to_string(entry.depth()), std::to_string(entry.places()),
                        google::protobuf::util::TimeUtil::ToString(entry.used()),
                        entry.pinned() ? "*" : ""});
      write_table(session.out(), rows);
      return kFine;
    };
  });
}

void add_stat(CLI::App& cache, Action& action) {
  auto* command = cache.add_subcommand("stat", "Sums, budgets and counters, as JSON");
  command->callback([&action] {
    action = [](Session& session) {
      session.write_text("-", write_json(session.client().cache_stats(session.call())));
      return kFine;
    };
  });
}

void add_gc(CLI::App& cache, Action& action) {
  struct Arguments {
    std::optional<double> megabytes, unused_days, recipes_unused_days;
    bool dry_run = false, tier = false;
  };
  auto* command = cache.add_subcommand(
      "gc",
      "Let meshes go from the disk, those used longest ago first; they are made again of "
      "their recipes when they are asked for");
  const auto arguments = std::make_shared<Arguments>();
  command
      ->add_option("--disk", arguments->megabytes, "Megabytes that may stay [the daemon's budget]")
      ->check(CLI::Range(0.0, 1e9))
      ->type_name("MB");
  command->add_option("--unused", arguments->unused_days, "Also what was not used for so many days")
      ->check(CLI::Range(0.0, 10000.0))
      ->type_name("DAYS");
  auto* tier = command->add_flag("--tier", arguments->tier,
                                 "Meshes of the shared tier instead, those written longest ago "
                                 "first; those that are pinned, or "
                                 "that others stand on, stay");
  command
      ->add_option(
          "--recipes-unused", arguments->recipes_unused_days,
          "With --tier: also recipes that were not written for so many days, where nothing "
          "that stays is made of them; each a week after the first run that found it")
      ->check(CLI::Range(0.0, 10000.0))
      ->type_name("DAYS")
      ->needs(tier);
  command->add_flag("-n,--dry-run", arguments->dry_run, "Only tell what would go");
  command->callback([arguments, &action] {
    action = [arguments](Session& session) {
      constexpr double kDay = 86400;  // s
      v1::CollectGarbageRequest request;
      if (arguments->megabytes)
        request.set_disk_bytes(
            static_cast<std::uint64_t>(std::llround(kMegabyte * *arguments->megabytes)));
      if (arguments->unused_days) request.set_unused_seconds(kDay * *arguments->unused_days);
      request.set_dry_run(arguments->dry_run);
      request.set_tier(arguments->tier);
      if (arguments->recipes_unused_days)
        request.set_recipes_unused_seconds(kDay * *arguments->recipes_unused_days);
      const auto reply = session.client().collect_garbage(request, session.call());
      session.out() << "meshes    " << reply.meshes() << '\n';
      if (arguments->tier) session.out() << "recipes   " << reply.recipes() << '\n';
      session.out() << "freed MB  " << megabytes(reply.bytes_freed())
                    << (arguments->tier ? "\ntier MB   " : "\ndisk MB   ")
                    << megabytes(reply.disk_bytes()) << '\n';
      return kFine;
    };
  });
}

void add_verify(CLI::App& cache, Action& action) {
  auto* command = cache.add_subcommand(
      "verify",
      "Compare all that is stored with its checksums; exit code 8 where something is "
      "wrong and was not repaired");
  const auto repair = std::make_shared<bool>(false);
  command->add_flag("--repair", *repair, "Make damaged meshes again of their recipes");
  command->callback([repair, &action] {
    action = [repair](Session& session) {
      bool wrong = false;
      const auto show = [&](const v1::VerifyCacheResponse& message) {
        if (!message.has_finding()) return;
        const auto& finding = message.finding();
        wrong |= !finding.repaired();
        session.out() << finding.revision().substr(0, kShownDigits) << "  " << finding.what()
                      << (finding.repaired() ? " (repaired)" : "") << '\n';
      };
      const auto last = session.client().verify_cache(*repair, show, session.call());
      session.console().note(std::to_string(last.findings()) + " findings in " +
                             megabytes(last.bytes_read()) + " MB");
      return wrong ? kFileFailed : kFine;
    };
  });
}

void add_pin(CLI::App& cache, Action& action) {
  struct Arguments {
    std::string revision;
    bool off = false;
  };
  auto* command = cache.add_subcommand("pin", "Keep the mesh of a revision from going, or let it");
  const auto arguments = std::make_shared<Arguments>();
  command->add_option("REV", arguments->revision, "Revision")->required();
  command->add_flag("--off", arguments->off, "Let it go again");
  command->callback([arguments, &action] {
    action = [arguments](Session& session) {
      const auto entry =
          session.client().set_pin(arguments->revision, !arguments->off, session.call());
      session.console().note(entry.revision().substr(0, kShownDigits) +
                             (entry.pinned() ? " stays" : " may go"));
      return kFine;
    };
  });
}

}  // namespace

void add_cache_command(CLI::App& app, Action& action) {
  auto* cache = app.add_subcommand("cache", "The meshes that the daemon holds: for operators");
  cache->require_subcommand(1);
  add_ls(*cache, action);
  add_stat(*cache, action);
  add_gc(*cache, action);
  add_verify(*cache, action);
  add_pin(*cache, action);
}

}  // namespace remeshd::cli
