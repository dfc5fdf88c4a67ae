#include "engine/kernel/tetgen.h"

#include <algorithm>
#include <atomic>
#include <cassert>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <span>
#include <string>
#include <system_error>
#include <utility>

#include "engine/base/error.h"
#include "engine/base/union_find.h"
#include "engine/kernel/helper_process.h"
#include "engine/kernel/tetgen_protocol.h"
#include "engine/mesh/quality.h"

namespace remeshd::kernel {
namespace {

using namespace tetgen_protocol;

constexpr const char* kProgram = "remeshd-tetgen";

std::atomic<std::uint64_t> crashes = 0;

Error crashed(const std::string& how) {
  ++crashes;
  return error::tetgen_crashed(how);
}

template <typename T>
void put(std::vector<std::byte>& bytes, std::span<const T> values) {
  const auto raw = std::as_bytes(values);
  const std::size_t end = bytes.size();
  bytes.resize(end + raw.size());
  std::ranges::copy(raw, bytes.begin() + static_cast<std::ptrdiff_t>(end));
}

/// Takes `count` values off the front; false where there are fewer.
template <typename T>
bool take(std::span<const std::byte>& bytes, std::vector<T>& values, std::uint64_t count) {
  if (count > bytes.size() / sizeof(T)) return false;
  values.resize(count);
  if (count > 0) std::memcpy(values.data(), bytes.data(), count * sizeof(T));
  bytes = bytes.subspan(count * sizeof(T));
  return true;
}

static_assert(sizeof(Vec3) == 3 * sizeof(double));

std::vector<std::byte> encode(RequestHeader header, const TetGenSurface& surface) {
  header.points = surface.points.size();
  header.triangles = surface.triangles.size();
  std::vector<std::byte> bytes;
  bytes.reserve(sizeof header + surface.points.size() * sizeof(Vec3) +
                surface.triangles.size() * sizeof(Triangle));
  put(bytes, std::span(&std::as_const(header), 1));
  put(bytes, std::span(surface.points));
  put(bytes, std::span(surface.triangles));
  return bytes;
}

std::string why_refused(Status status) {
  switch (status) {
    case Status::SelfIntersection:
      return "the surface cuts itself";
    case Status::SmallFeature:
      return "the surface has a detail too small for its size";
    case Status::CloseFacets:
      return "two facets of the surface nearly touch";
    case Status::InputError:
      return "it cannot read the surface";
    case Status::BadNumber:
      return "the surface has a coordinate that is not finite or a corner that is no point of it";
    default:
      return "an error of its own";
  }
}

/// Whether all corners are indices of points.
template <typename Corners>
bool in_range(const std::vector<Corners>& all, std::size_t points) {
  return std::ranges::all_of(all, [&](const Corners& corners) {
    return std::ranges::all_of(
        corners, [&](std::int32_t p) { return p >= 0 && static_cast<std::size_t>(p) < points; });
  });
}

void turn_positive(TetMesh& mesh) {
  for (Tet& t : mesh.tets)
    if (tet_volume(mesh.nodes, t) < 0) std::swap(t[2], t[3]);
}

QualityMesh decode(std::span<const std::byte> bytes, const TetGenLimits& limits) {
  std::vector<AnswerHeader> header;
  if (!take(bytes, header, 1) || header[0].magic != kAnswerMagic)
    throw crashed("it gave no answer");
  const auto& [magic, status, points, tets, facets, segments] = header[0];
  if (status == Status::OutOfMemory) throw error::tetgen_out_of_memory(limits.address_space);
  if (status != Status::Meshed) throw error::tetgen_refused(why_refused(status));
  QualityMesh out;
  TetMesh& mesh = out.filling.mesh;
  if (!take(bytes, mesh.nodes, points) || !take(bytes, mesh.tets, tets) ||
      !take(bytes, out.filling.regions, tets) || !take(bytes, out.facets, facets) ||
      !take(bytes, out.facet_markers, facets) || !take(bytes, out.segments, segments) ||
      !take(bytes, out.segment_markers, segments) || !bytes.empty() ||
      !in_range(mesh.tets, points) || !in_range(out.facets, points) ||
      !in_range(out.segments, points))
    throw crashed("its answer is damaged");
  if (mesh.tets.empty()) throw error::tetgen_refused("the surface closes nothing off");
  turn_positive(mesh);
  return out;
}

QualityMesh ask(const std::vector<std::byte>& request, const TetGenLimits& limits, const Run& run) {
  const std::filesystem::path helper = limits.helper.empty() ? find_tetgen_helper() : limits.helper;
  // Should this process die unnoticed, the child's limit on processor time ends it.
  const auto processor_seconds = static_cast<long long>(std::ceil(limits.seconds)) + 1;
  const HelperEnd end =
      run_helper(helper, {std::to_string(limits.address_space), std::to_string(processor_seconds)},
                 request, {.seconds = limits.seconds, .answer_bytes = limits.address_space}, run);
  switch (end.kind) {
    case HelperEnd::Kind::Exited:
      return decode(end.answer, limits);
    case HelperEnd::Kind::TimedOut:
      throw error::tetgen_too_slow(limits.seconds);
    case HelperEnd::Kind::NotStarted:
      throw error::tetgen_missing(helper.string(), std::generic_category().message(end.code));
    case HelperEnd::Kind::TalkedTooMuch:
      throw crashed("its answer has no end");
    case HelperEnd::Kind::Signalled:
      break;
  }
  throw crashed("signal " + std::to_string(end.code) + " ended it");
}

template <typename Corners>
Corners sorted(Corners corners) {
  std::ranges::sort(corners);
  return corners;
}

/// The part of the mesh that each tet is in, parts being separated by surface facets; a part has
/// the number of its first tet.
std::vector<std::int32_t> find_regions(const QualityMesh& out) {
  std::vector<Triangle> walls;
  for (const Triangle& facet : out.facets) walls.push_back(sorted(facet));
  std::ranges::sort(walls);
  struct Side {
    Triangle facet;
    std::int32_t tet;
  };
  const std::vector<Tet>& tets = out.filling.mesh.tets;
  std::vector<Side> sides;
  for (std::size_t t = 0; t < tets.size(); ++t)
    for (const auto& [i, j, k] : kTetFacets)
      sides.push_back(
          {sorted(Triangle{tets[t][i], tets[t][j], tets[t][k]}), static_cast<std::int32_t>(t)});
  std::ranges::stable_sort(sides, {}, &Side::facet);
  UnionFind parts(tets.size());
  for (std::size_t s = 0; s + 1 < sides.size(); ++s) {
    if (sides[s].facet != sides[s + 1].facet) continue;
    if (std::ranges::binary_search(walls, sides[s].facet)) continue;
    parts.join(sides[s].tet, sides[s + 1].tet);
  }
  std::vector<std::int32_t> region(tets.size());
  for (std::size_t t = 0; t < tets.size(); ++t)
    region[t] = parts.find(static_cast<std::int32_t>(t));
  return region;
}

}  // namespace

std::uint64_t tetgen_crashes() { return crashes; }

std::filesystem::path find_tetgen_helper() {
  if (const char* set = std::getenv("REMESHD_TETGEN"); set != nullptr && *set != '\0') return set;
  std::error_code failure;
  const auto folder = std::filesystem::read_symlink("/proc/self/exe", failure).parent_path();
  auto beside = folder / kProgram;
  if (std::filesystem::exists(beside, failure)) return beside;
  return folder.parent_path() / "libexec" / "remeshd" / kProgram;
}

TetGenMesh run_tetgen(const TetGenSurface& surface, const TetGenLimits& limits, const Run& run) {
  return ask(encode({}, surface), limits, run).filling;
}

QualityMesh run_tetgen(const MarkedSurface& marked, const TetGenQuality& quality,
                       const TetGenLimits& limits, const Run& run) {
  assert(marked.triangle_markers.size() == marked.surface.triangles.size() &&
         marked.segment_markers.size() == marked.segments.size());
  std::vector<std::byte> request =
      encode({.segments = marked.segments.size(),
              .task = quality.split_surface ? Task::MeshSplittingSurface : Task::MeshKeepingSurface,
              .radius_edge = quality.radius_edge,
              .max_volume = quality.max_volume,
              .most_added = quality.most_added},
             marked.surface);
  put(request, std::span(marked.triangle_markers));
  put(request, std::span(marked.segments));
  put(request, std::span(marked.segment_markers));
  QualityMesh out = ask(request, limits, run);
  const std::size_t before = marked.surface.points.size();
  if (quality.most_added > 0 && out.filling.mesh.nodes.size() >= before + quality.most_added)
    throw error::tetgen_refused("the mesh needs " + std::to_string(quality.most_added) +
                                " nodes or more beside those of the surface");
  out.filling.regions = find_regions(out);
  return out;
}

}  // namespace remeshd::kernel
