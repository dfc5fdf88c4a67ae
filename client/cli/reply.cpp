#include "client/cli/reply.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cctype>
#include <sstream>

#include "client/cli/table.h"
#include "client/cli/warnings.h"
#include "proto/json_writer.h"

namespace remeshd::cli {
namespace {

using remesh::v1::Report;

std::string share(std::uint32_t part, std::uint32_t whole) {
  if (whole == 0) return std::to_string(part);
  return std::to_string(part) + " (" + rounded(100.0 * part / whole, 4) + " %)";
}

std::string nodes_of(const Report& report) {
  const std::string corners = std::to_string(report.nodes());
  return report.order() == 2 ? corners + " and " + std::to_string(report.mid_nodes()) + " on edges"
                             : corners;
}

void write_summary(std::ostream& out, const remesh::v1::RevisionResult& reply) {
  const Report& report = reply.report();
  const auto& quality = report.quality();
  write_table(
      out, {{"revision", reply.revision().id()},
            {"design", short_name(reply.revision())},
            {"way", way_name(report.way())},
            {"edge length", rounded(report.edge_length())},
            {"nodes", nodes_of(report)},
            {"tets", std::to_string(report.tets())},
            {"nodes kept", share(report.nodes_kept(), report.nodes())},
            {"tets kept", share(report.tets_kept(), report.tets())},
            {"volume",
             rounded(report.volume(), 8) + " (exact " + rounded(report.exact_volume(), 8) + ")"},
            {"verified", std::to_string(report.verification().tets_proved()) + " tets, " +
                             std::to_string(report.verification().tets_inherited()) + " inherited"},
            {"chord error", rounded(report.verification().chord_error(), 3)},
            {"volume error", rounded(report.verification().volume_error(), 3) +
                                 " (relative; what chords cut off does not count)"},
            {"volume-length", "mean " + rounded(quality.volume_length_mean(), 4) +
                                  ", 1st percentile " + rounded(quality.volume_length_p01(), 4) +
                                  ", minimum " + rounded(quality.volume_length_min(), 4)},
            {"dihedral", rounded(quality.dihedral_min(), 4) + " to " +
                             rounded(quality.dihedral_max(), 4) + " degrees"},
            {"seconds",
             rounded(report.seconds().total(), 4) + (report.cached() ? " (from the cache)" : "")}});
}

}  // namespace

std::string way_name(remesh::v1::Report::Way way) {
  if (way == remesh::v1::Report::WAY_TETGEN) return "TetGen";
  std::string name = remesh::v1::Report::Way_Name(way).substr(std::string("WAY_").size());
  std::ranges::transform(name, name.begin(), [](unsigned char c) { return std::tolower(c); });
  return name;
}

std::string short_name(const remesh::v1::RevisionInfo& revision) {
  if (revision.design().empty()) return revision.id().substr(0, 12);
  return revision.design() + "@" + std::to_string(revision.number());
}

void ReplyFiles::add_to(CLI::App& command) {
  meshes.add_to(command);
  command.add_option("--json", report, "Write the Report here; `-`: to stdout")->type_name("FILE");
}

void ReplyFiles::check() const {
  meshes.check(report);
  check_text_file(report);
}

void note_head_conflict(Session& session, const remesh::v1::RevisionResult& reply,
                        const std::string& why) {
  if (reply.head_conflict())
    session.console().note("the head of " + reply.revision().design() + " stays at " +
                           std::to_string(reply.head_number()) + ": " + why);
}

void deliver(Session& session, const remesh::v1::RevisionResult& reply, const ReplyFiles& files) {
  show_warnings(session, reply.report().warnings());
  note_head_conflict(session, reply, "it is not the base of this edit any more");
  session.write_mesh_of(reply.revision().id(), files.meshes);
  if (!files.report.empty()) session.write_text(files.report, write_json(reply.report()));
  if (files.report == kStandardStream) return;
  std::ostringstream summary;
  write_summary(summary, reply);
  if (!files.meshes.take_stdout())
    session.out() << summary.str();
  else
    session.console().text(summary.str());
}

}  // namespace remeshd::cli
