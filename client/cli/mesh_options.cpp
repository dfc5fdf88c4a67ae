#include "client/cli/mesh_options.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "client/cli/choice.h"
#include "engine/base/text/nearest_name.h"

namespace remeshd::cli {
namespace {

using remesh::v1::Warning;

constexpr std::uint32_t kMostIterations = 1000;
const std::string kMembership = "membership";
const std::string kControlMesh = "control-mesh";
const std::string kLattice = "lattice";
const std::string kRandom = "random";

/// Warnings of what a model asks for and its mesh lacks.
constexpr std::array kLosses{Warning::GROUP_EMPTIED,          Warning::FACE_LOST,
                             Warning::FEATURE_WITHOUT_EFFECT, Warning::CHORDS_COARSE,
                             Warning::DETAIL_NOT_RESOLVED,    Warning::EDGES_STRAIGHT};

std::string names_of_losses() {
  std::string names;
  for (const Warning::Code code : kLosses)
    names += (names.empty() ? "" : ", ") + Warning::Code_Name(code);
  return names;
}

std::string check_size(const std::string& text) {
  double value = 0;
  if (!CLI::detail::lexical_cast(text, value) || !std::isfinite(value) || value <= 0)
    return text + " is no length above 0";
  return {};
}

std::string check_edges_per_circle(const std::string& text) {
  std::uint32_t value = 0;
  if (!CLI::detail::lexical_cast(text, value) || (value != 0 && (value < 3 || value > 360)))
    return text + " is neither 0 nor within 3..360";
  return {};
}

std::string check_growth(const std::string& text) {
  double value = 0;
  if (!CLI::detail::lexical_cast(text, value) || !(value > 1 && value <= 2))
    return text + " is no factor above 1, at most 2";
  return {};
}

/// CLI11 alone would take -1 for the largest number there is.
std::string check_digits(const std::string& text) {
  return text.find_first_not_of("0123456789") == std::string::npos
             ? std::string()
             : text + " is no whole number from 0";
}

std::uint32_t to_iterations(const std::string& text) {
  std::uint32_t value = 0;
  const char* end = text.data() + text.size();
  const auto [stop, problem] = std::from_chars(text.data(), end, value);
  return problem == std::errc{} && stop == end ? value : 0;
}

std::string check_iterations(const std::string& text) {
  if (text == "auto") return {};
  const std::uint32_t value = to_iterations(text);
  if (value < 1 || value > kMostIterations) return text + " is neither `auto` nor within 1..1000";
  return {};
}

/// The warning of that name, or CODE_UNSPECIFIED.
Warning::Code warning_of(const std::string& name) {
  Warning::Code code = Warning::CODE_UNSPECIFIED;
  Warning::Code_Parse(name, &code);
  return code;
}

std::string check_warning(const std::string& name) {
  if (warning_of(name) != Warning::CODE_UNSPECIFIED) return {};
  std::vector<std::string> known;
  const auto* names = Warning::Code_descriptor();
  for (int k = 0; k < names->value_count(); ++k)
    if (names->value(k)->number() != Warning::CODE_UNSPECIFIED)
      known.push_back(names->value(k)->name());
  std::string list;
  for (const std::string& each : known) list += (list.empty() ? "" : ", ") + each;
  return name + " is no warning" + suggestion(name, known) + "; there are " + list;
}

/// What an option is where it is not given, as the help tells it.
std::string told(MeshingOptions::Unset unset, const std::string& otherwise) {
  return " [" + (unset == MeshingOptions::Unset::OfBase ? "the base's" : otherwise) + "]";
}

}  // namespace

void MeshingOptions::add_to(CLI::App& command, Unset unset) {
  add_mesh_to(command, unset);
  command.add_option("--threads", threads, "Threads; never change the result [1]")
      ->check(CLI::Range(1U, 1024U))
      ->type_name("N");
  command
      .add_option("--design", design,
                  "Design that the revision belongs to [the model's name; of an edit its base's]")
      ->type_name("NAME");
  command.add_flag("--keep-head", keep_head, "Do not move the head of the design");
}

void MeshingOptions::add_mesh_to(CLI::App& command, Unset unset) {
  auto* count = command.add_option("--nodes", nodes, "Nodes to aim at" + told(unset, "15000"))
                    ->check(CLI::Range(20U, 5'000'000U))
                    ->type_name("N");
  command.add_option("--size", size, "Edge length to aim at, in the model's unit")
      ->check(CLI::Validator(check_size, "", ""))
      ->type_name("L")
      ->excludes(count);
  command
      .add_option("--iterations", iterations,
                  "Iterations, or `auto`: until quality stops improving" + told(unset, "auto"))
      ->check(CLI::Validator(check_iterations, "", ""))
      ->type_name("K|auto");
  command.add_option("--seed", seed, "Seed of all random choices" + told(unset, "1"))
      ->check(CLI::Validator(check_digits, "", ""))
      ->type_name("S");
  only(*command.add_option(
           "--inside", inside,
           "What tells inside from outside: the features' formulas, or a control mesh on the "
           "tessellated boundary" +
               told(unset, "membership")),
       {kMembership, kControlMesh});
  only(*command.add_option(
           "--start", start,
           "Where new nodes start: on a lattice, or at random" + told(unset, "lattice")),
       {kLattice, kRandom});
  command
      .add_option("--threshold", threshold,
                  "Clean up tets of a volume-length measure below this" + told(unset, "0.52"))
      ->check(CLI::Range(0.0, 0.8))
      ->type_name("Q");
  command
      .add_option("--order", order,
                  "Order of the tets: 2 has nodes on their edges too, on the true geometry" +
                      told(unset, "1"))
      ->check(CLI::Range(1U, 2U))
      ->type_name("1|2");
  command
      .add_option("--hold", hold,
                  "Keep the connectivity while no surface is further than this from where it was "
                  "when that was made, x edge length" +
                      told(unset, "0: a hundredth"))
      ->check(CLI::Range(0.0, 10.0))
      ->type_name("H");
  command.add_flag("--no-clean-up", no_clean_up, "Leave slivers in");
  add_sizing_to(command, unset);
  command
      .add_option("--fail-on", fail_on,
                  "Warnings that are errors, e.g. GROUP_EMPTIED,FALLBACK; exit code 4")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->check(CLI::Validator(check_warning, "", ""))
      ->type_name("CODE[,CODE]");
  command.add_flag("--strict", strict,
                   "What is lost is an error: " + names_of_losses() + "; exit code 4");
}

void MeshingOptions::add_sizing_to(CLI::App& command, Unset unset) {
  auto* one_length = command.add_flag(
      "--even", even, "One edge length everywhere: no rule, and no size of the model, holds");
  command
      .add_option("--edges-per-circle", edges_per_circle,
                  "Edges on a whole circle of any radius; 0: no such rule" + told(unset, "12"))
      ->check(CLI::Validator(check_edges_per_circle, "", ""))
      ->type_name("N")
      ->excludes(one_length);
  command
      .add_option("--layers", layers,
                  "Edges across walls and gaps; 0: no such rule" + told(unset, "1"))
      ->check(CLI::Range(0U, 16U))
      ->type_name("N")
      ->excludes(one_length);
  command
      .add_option("--min-size", min_size,
                  "Edge length below which no rule goes" +
                      told(unset, "a tenth of the edge length aimed at"))
      ->check(CLI::Validator(check_size, "", ""))
      ->type_name("L")
      ->excludes(one_length);
  command
      .add_option("--growth", growth,
                  "Growth of edge lengths from one tet to the next" + told(unset, "1.3"))
      ->check(CLI::Validator(check_growth, "", ""))
      ->type_name("G")
      ->excludes(one_length);
}

remesh::v1::MeshOptions MeshingOptions::to_message() const {
  remesh::v1::MeshOptions message;
  if (nodes) message.set_nodes(*nodes);
  if (size) message.set_size(*size);
  if (!iterations.empty())
    message.set_iterations(iterations == "auto" ? 0 : to_iterations(iterations));
  if (seed) message.set_seed(*seed);
  if (inside == kMembership) message.set_inside(remesh::v1::INSIDE_TEST_MEMBERSHIP);
  if (inside == kControlMesh) message.set_inside(remesh::v1::INSIDE_TEST_CONTROL_MESH);
  if (start == kLattice) message.set_start(remesh::v1::START_LATTICE);
  if (start == kRandom) message.set_start(remesh::v1::START_RANDOM);
  if (threshold) message.set_threshold(*threshold);
  if (order) message.set_order(*order);
  if (hold) message.set_hold(*hold);
  if (no_clean_up) message.set_clean_up(false);
  if (even) message.mutable_sizing()->set_even(true);
  if (edges_per_circle) message.mutable_sizing()->set_edges_per_circle(*edges_per_circle);
  if (layers) message.mutable_sizing()->set_layers(*layers);
  if (min_size) message.mutable_sizing()->set_min_size(*min_size);
  if (growth) message.mutable_sizing()->set_growth(*growth);
  return message;
}

google::protobuf::RepeatedField<int> MeshingOptions::warning_codes() const {
  google::protobuf::RepeatedField<int> codes;
  for (const std::string& name : fail_on) codes.Add(warning_of(name));
  if (strict)
    for (const Warning::Code code : kLosses)
      if (std::ranges::find(codes, code) == codes.end()) codes.Add(code);
  return codes;
}

}  // namespace remeshd::cli
