#include "tests/bench/peers.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>
#include <utility>

#include "tests/support/child_process.h"

namespace remeshd::bench {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr int kMostTries = 12;
/// TetGen's largest volume of a tet over the cube of the surface's edge length: so that the inside
/// gets as many nodes as an even mesh of that edge length has.
constexpr double kTetGenVolume = 0.2;

fs::path beside_this_program(const std::string& name) {
  return fs::read_symlink("/proc/self/exe").parent_path() / name;
}

fs::path in_path(const std::string& name) {
  for (const char* folder : {"/usr/bin", "/usr/local/bin"})
    if (fs::exists(fs::path(folder) / name)) return fs::path(folder) / name;
  return {};
}

std::string exact(double x) {
  std::array<char, 40> text{};
  std::snprintf(text.data(), text.size(), "%.17g", x);
  return text.data();
}

/// Runs a program that prints a line of JSON.
/// Throws std::runtime_error where it does not.
json ask(const fs::path& program, std::vector<std::string> arguments, double seconds) {
  arguments.insert(arguments.begin(), program.filename().string());
  const test::ChildEnd child = test::run_child(program.string(), arguments, seconds);
  json answer = json::parse(child.output, nullptr, false);
  if (!child.well() || answer.is_discarded())
    throw std::runtime_error(child.how() + ": " + child.errors);
  return answer;
}

/// The number after a label in what TetGen says.
double said(const std::string& talk, const std::string& label) {
  const std::size_t at = talk.find(label);
  if (at == std::string::npos) throw std::runtime_error("TetGen does not tell its " + label);
  return std::stod(talk.substr(at + label.size()));
}

/// The numbered lines of a .node or .ele file, without their numbers; `first` is that of the first.
std::vector<std::vector<double>> read_table(const fs::path& file, std::size_t columns) {
  std::ifstream in(file);
  std::size_t count = 0;
  std::string line;
  if (!(in >> count) || !std::getline(in, line))
    throw std::runtime_error("cannot read " + file.string());
  std::vector<std::vector<double>> rows(count, std::vector<double>(columns));
  for (std::vector<double>& row : rows) {
    double number = 0;
    in >> number;
    for (double& x : row) in >> x;
    std::getline(in, line);
  }
  if (!in) throw std::runtime_error("cannot read " + file.string());
  return rows;
}

}  // namespace

const std::vector<Peer>& all_peers() {
  static const std::vector<Peer> peers{
      {"hxt", "Gmsh HXT, optimised", std::numeric_limits<std::uint32_t>::max()},
      {"delaunay", "Gmsh Delaunay, optimised", 300'000},
      {"tetgen", "TetGen on Gmsh's surface", std::numeric_limits<std::uint32_t>::max()},
      {"netgen", "Netgen", 30'000},
  };
  return peers;
}

const Peer& peer_named(const std::string& name) {
  for (const Peer& peer : all_peers())
    if (peer.name == name) return peer;
  throw std::runtime_error("there is no peer " + name);
}

bool available(const Peer& peer) {
  if (!fs::exists(beside_this_program("remesh-peer-gmsh"))) return false;
  if (peer.name == "netgen") return fs::exists(beside_this_program("remesh-peer-netgen"));
  if (peer.name == "tetgen") return !in_path("tetgen").empty();
  return true;
}

PeerSession::PeerSession(fs::path folder, const std::string& name, const std::string& model_file,
                         double exact_volume, bool sized, double limit_seconds)
    : folder_(std::move(folder)),
      name_(name),
      geometry_((folder_ / (name + ".brep")).string()),
      sized_(sized),
      limit_seconds_(limit_seconds) {
  const json made = ask(beside_this_program("remesh-peer-gmsh"),
                        {"geometry", model_file, geometry_}, limit_seconds_);
  made.at("faces").get_to(faces_);
  made.at("cpu").get_to(seconds_);
  const double volume = made.at("volume").get<double>();
  if (!(std::fabs(volume - exact_volume) <= 1e-6 * exact_volume))
    throw std::runtime_error("the peers' geometry of " + name + " has a volume of " +
                             exact(volume) + ", not " + exact(exact_volume));
  read_sizes();
}

Sample PeerSession::run(const Peer& peer, std::uint32_t nodes, double start) {
  try {
    const std::string key =
        peer.name + " " + name_ + " " + std::to_string(nodes) + (sized_ ? " sized" : "");
    if (!sizes_.contains(key)) {
      sizes_[key] = find_size(peer, nodes, start);
      write_sizes();
    }
    Sample sample = mesh(peer, sizes_.at(key).size);
    sample.geometry = seconds_;
    // HXT's differ by some from run to run.
    if (std::fabs(sample.nodes / static_cast<double>(sizes_.at(key).nodes) - 1) > kSameNodes)
      throw std::runtime_error("another number of nodes than before: remove " +
                               (folder_ / "sizes.json").string());
    return sample;
  } catch (const std::exception& failure) {
    return {.failure = failure.what()};
  }
}

PeerSession::Size PeerSession::find_size(const Peer& peer, std::uint32_t nodes,
                                         double start) const {
  Size best;
  double least = HUGE_VAL, size = start;
  std::optional<double> fine, coarse;  // sizes known to give too many and too few
  for (int k = 0; k < kMostTries; ++k) {
    const std::uint32_t made = mesh(peer, size).nodes;
    if (made == 0) throw std::runtime_error("no node at an edge length of " + exact(size));
    const double times = made / static_cast<double>(nodes);
    if (std::fabs(std::log(times)) < least) {
      least = std::fabs(std::log(times));
      best = {size, made};
    }
    if (least <= 0.5 * kSameNodes) break;
    (times > 1 ? fine : coarse) = size;
    if (fine && coarse && *coarse < 1.01 * *fine) break;  // a jump
    // Nodes go by the cube of the edge length, or a little less where many are on faces.
    size *= std::pow(times, 0.36);
    if (fine && coarse && (size <= *fine || size >= *coarse)) size = std::sqrt(*fine * *coarse);
  }
  return best;
}

Sample PeerSession::mesh(const Peer& peer, double size) const {
  if (peer.name == "tetgen") return tetgen(size);
  if (peer.name == "netgen")
    return read_sample(
        ask(beside_this_program("remesh-peer-netgen"), {geometry_, exact(size)}, limit_seconds_));
  if (sized_)
    return read_sample(ask(beside_this_program("remesh-peer-gmsh"),
                           {"mesh", geometry_, exact(size), peer.name, "12"}, limit_seconds_));
  return read_sample(ask(beside_this_program("remesh-peer-gmsh"),
                         {"mesh", geometry_, exact(size), peer.name}, limit_seconds_));
}

/// The time is that of Gmsh's surface and of TetGen without its files.
Sample PeerSession::tetgen(double size) const {
  const fs::path surface = folder_ / (name_ + ".smesh");
  Sample sample =
      read_sample(ask(beside_this_program("remesh-peer-gmsh"),
                      {"surface", geometry_, exact(size), surface.string()}, limit_seconds_));
  const std::string options = "-pq1.2a" + exact(kTetGenVolume * size * size * size) + "YFB";
  const test::ChildEnd child =
      test::run_child("tetgen", {"tetgen", options, surface.string()}, limit_seconds_);
  if (!child.well()) throw std::runtime_error("TetGen: " + child.how() + ": " + child.errors);
  const double seconds =
      said(child.output, "Total running seconds:") - said(child.output, "Output seconds:");
  sample.cpu += seconds;
  sample.wall += seconds;
  sample.peak_bytes = std::max(sample.peak_bytes, child.peak_bytes);

  const auto points = read_table(folder_ / (name_ + ".1.node"), 3);
  const auto corners = read_table(folder_ / (name_ + ".1.ele"), 4);
  std::vector<Vec3> nodes;
  nodes.reserve(points.size());
  for (const auto& p : points) nodes.push_back({p[0], p[1], p[2]});
  std::vector<Tet> tets;
  tets.reserve(corners.size());
  for (const auto& c : corners)  // numbered from 0, as the surface is
    tets.push_back({static_cast<int>(c[0]), static_cast<int>(c[1]), static_cast<int>(c[2]),
                    static_cast<int>(c[3])});
  describe_mesh(nodes, tets, sample);
  return sample;
}

void PeerSession::read_sizes() {
  std::ifstream in(folder_ / "sizes.json");
  const json stored = json::parse(in, nullptr, false);
  if (!stored.is_object()) return;
  for (const auto& [key, size] : stored.items())
    sizes_[key] = {size.at("size").get<double>(), size.at("nodes").get<std::uint32_t>()};
}

void PeerSession::write_sizes() const {
  json stored;
  for (const auto& [key, size] : sizes_) stored[key] = {{"size", size.size}, {"nodes", size.nodes}};
  std::ofstream(folder_ / "sizes.json") << stored.dump(1) << "\n";
}

}  // namespace remeshd::bench
