#include "engine/kernel/tetgen.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <span>
#include <string>
#include <system_error>
#include <utility>

#include "engine/base/error.h"
#include "engine/kernel/helper_process.h"
#include "engine/kernel/tetgen_protocol.h"

namespace remeshd::kernel {
namespace {

using namespace tetgen_protocol;

constexpr const char* kProgram = "remeshd-tetgen";

template <typename T>
void put(std::vector<std::byte>& bytes, std::span<const T> values) {
  const auto raw = std::as_bytes(values);
  bytes.insert(bytes.end(), raw.begin(), raw.end());
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

std::vector<std::byte> encode(const TetGenSurface& surface) {
  const RequestHeader header{.points = surface.points.size(),
                             .triangles = surface.triangles.size()};
  std::vector<std::byte> bytes;
  bytes.reserve(sizeof header + surface.points.size() * sizeof(Vec3) +
                surface.triangles.size() * sizeof(Triangle));
  put(bytes, std::span(&header, 1));
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

bool in_range(const TetMesh& mesh) {
  const auto points = static_cast<std::int64_t>(mesh.nodes.size());
  return std::ranges::all_of(mesh.tets, [&](const Tet& tet) {
    return std::ranges::all_of(tet, [&](std::int32_t p) { return p >= 0 && p < points; });
  });
}

void turn_positive(TetMesh& mesh) {
  for (Tet& t : mesh.tets) {
    const Vec3& a = mesh.nodes[t[0]];
    if (dot(cross(mesh.nodes[t[1]] - a, mesh.nodes[t[2]] - a), mesh.nodes[t[3]] - a) < 0)
      std::swap(t[2], t[3]);
  }
}

TetGenMesh decode(std::span<const std::byte> bytes, const TetGenLimits& limits) {
  std::vector<AnswerHeader> header;
  if (!take(bytes, header, 1) || header[0].magic != kAnswerMagic)
    throw error::tetgen_crashed("it gave no answer");
  const auto& [magic, status, points, tets] = header[0];
  if (status == Status::OutOfMemory) throw error::tetgen_out_of_memory(limits.address_space);
  if (status != Status::Meshed) throw error::tetgen_refused(why_refused(status));
  TetGenMesh out;
  if (!take(bytes, out.mesh.nodes, points) || !take(bytes, out.mesh.tets, tets) ||
      !take(bytes, out.regions, tets) || !bytes.empty() || !in_range(out.mesh))
    throw error::tetgen_crashed("its answer is damaged");
  if (out.mesh.tets.empty()) throw error::tetgen_refused("the surface closes nothing off");
  turn_positive(out.mesh);
  return out;
}

}  // namespace

std::filesystem::path find_tetgen_helper() {
  if (const char* set = std::getenv("REMESHD_TETGEN"); set != nullptr && *set != '\0') return set;
  std::error_code failure;
  const auto folder = std::filesystem::read_symlink("/proc/self/exe", failure).parent_path();
  auto beside = folder / kProgram;
  if (std::filesystem::exists(beside, failure)) return beside;
  return folder.parent_path() / "libexec" / "remeshd" / kProgram;
}

TetGenMesh run_tetgen(const TetGenSurface& surface, const TetGenLimits& limits, const Run& run) {
  const std::filesystem::path helper = limits.helper.empty() ? find_tetgen_helper() : limits.helper;
  // Should this process die unnoticed, the processor's own clock ends the child.
  const auto processor_seconds = static_cast<long long>(std::ceil(limits.seconds)) + 1;
  const HelperEnd end = run_helper(
      helper, {std::to_string(limits.address_space), std::to_string(processor_seconds)},
      encode(surface), {.seconds = limits.seconds, .answer_bytes = limits.address_space}, run);
  switch (end.kind) {
    case HelperEnd::Kind::Exited:
      return decode(end.answer, limits);
    case HelperEnd::Kind::TimedOut:
      throw error::tetgen_too_slow(limits.seconds);
    case HelperEnd::Kind::NotStarted:
      throw error::tetgen_missing(helper.string(), std::generic_category().message(end.code));
    case HelperEnd::Kind::TalkedTooMuch:
      throw error::tetgen_crashed("its answer has no end");
    case HelperEnd::Kind::Signalled:
      break;
  }
  throw error::tetgen_crashed("signal " + std::to_string(end.code) + " ended it");
}

}  // namespace remeshd::kernel
