// remeshd-tetgen: TetGen in a process of its own, because TetGen may abort, hang or eat memory.
// Started by run_tetgen (engine/kernel/tetgen.h); speaks engine/kernel/tetgen_protocol.h.
#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <tetgen.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <new>
#include <vector>

#include "engine/kernel/tetgen_protocol.h"

namespace {

using namespace remeshd::kernel::tetgen_protocol;

constexpr int kExitUsage = 2, kExitBrokenStream = 3;

struct Request {
  RequestHeader header;
  std::vector<double> points;  // x y z, x y z, ...
  std::vector<std::int32_t> triangles, triangle_markers;
  std::vector<std::int32_t> segments, segment_markers;
};

bool read_all(void* to, std::size_t size) {
  char* at = static_cast<char*>(to);
  while (size > 0) {
    const ssize_t n = read(STDIN_FILENO, at, size);
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) return false;
    at += n;
    size -= static_cast<std::size_t>(n);
  }
  return true;
}

bool write_all(int fd, const void* from, std::size_t size) {
  const char* at = static_cast<const char*>(from);
  while (size > 0) {
    const ssize_t n = write(fd, at, size);
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) return false;
    at += n;
    size -= static_cast<std::size_t>(n);
  }
  return true;
}

template <typename T>
bool read_values(std::vector<T>& values, std::uint64_t count) {
  values.resize(count);
  return read_all(values.data(), values.size() * sizeof(T));
}

bool read_request(Request& request) {
  RequestHeader& header = request.header;
  if (!read_all(&header, sizeof header) || header.magic != kRequestMagic ||
      !read_values(request.points, 3 * header.points) ||
      !read_values(request.triangles, 3 * header.triangles))
    return false;
  return header.task == Task::Fill || (read_values(request.triangle_markers, header.triangles) &&
                                       read_values(request.segments, 2 * header.segments) &&
                                       read_values(request.segment_markers, header.segments));
}

/// False where numbers would make TetGen read beyond its lists, or loop.
bool numbers_are_sound(const Request& request) {
  const auto points = static_cast<std::int64_t>(request.points.size() / 3);
  const auto is_point = [&](std::int32_t p) { return p >= 0 && p < points; };
  const RequestHeader& header = request.header;
  return std::ranges::all_of(request.points, [](double x) { return std::isfinite(x); }) &&
         std::ranges::all_of(request.triangles, is_point) &&
         std::ranges::all_of(request.segments, is_point) &&
         (header.task == Task::Fill ||
          (std::isfinite(header.radius_edge) && header.max_volume >= 0 &&
           std::isfinite(header.max_volume)));
}

void fill(tetgenio& in, const Request& request) {
  in.numberofpoints = static_cast<int>(request.points.size() / 3);
  in.pointlist = new REAL[request.points.size()];
  std::ranges::copy(request.points, in.pointlist);
  const int triangles = static_cast<int>(request.triangles.size() / 3);
  in.facetlist = new tetgenio::facet[static_cast<std::size_t>(triangles)];
  for (int t = 0; t < triangles; ++t) tetgenio::init(&in.facetlist[t]);
  in.numberoffacets = triangles;
  for (int t = 0; t < triangles; ++t) {
    tetgenio::facet& facet = in.facetlist[t];
    facet.polygonlist = new tetgenio::polygon[1];
    tetgenio::init(facet.polygonlist);
    facet.numberofpolygons = 1;
    facet.polygonlist->vertexlist = new int[3];
    facet.polygonlist->numberofvertices = 3;
    std::copy_n(&request.triangles[3 * static_cast<std::size_t>(t)], 3,
                facet.polygonlist->vertexlist);
  }
  if (request.header.task == Task::Fill) return;
  in.facetmarkerlist = new int[request.triangle_markers.size()];
  std::ranges::copy(request.triangle_markers, in.facetmarkerlist);
  in.numberofedges = static_cast<int>(request.segment_markers.size());
  in.edgelist = new int[request.segments.size()];
  std::ranges::copy(request.segments, in.edgelist);
  in.edgemarkerlist = new int[request.segment_markers.size()];
  std::ranges::copy(request.segment_markers, in.edgemarkerlist);
}

/// p: keep the surface; A: number the regions it encloses; Y: add no point on it; q, a: bounds on
/// the shape and volume of tets; S: on the number of points added; Q: quiet. Never Y with A, which
/// aborts now and then.
std::array<char, 80> switches(const RequestHeader& header) {
  std::array<char, 80> text{"pAQ"};
  if (header.task == Task::Fill) return text;
  const char* surface = header.task == Task::MeshKeepingSurface ? "Y" : "";
  const int used = header.max_volume > 0
                       ? std::snprintf(text.data(), text.size(), "pQ%sq%.4fa%.9e", surface,
                                       header.radius_edge, header.max_volume)
                       : std::snprintf(text.data(), text.size(), "pQ%s", surface);
  if (header.most_added > 0)
    std::snprintf(text.data() + used, text.size() - used, "S%u",
                  static_cast<std::uint32_t>(header.most_added));
  return text;
}

Status mesh(const Request& request, tetgenio& out) {
  if (!numbers_are_sound(request)) return Status::BadNumber;
  try {
    tetgenio in;
    fill(in, request);
    std::array<char, 80> text = switches(request.header);
    tetrahedralize(text.data(), &in, &out);
    return Status::Meshed;
  } catch (int code) {  // TetGen throws its exit code
    const bool known = (code >= 1 && code <= 5) || code == 10;
    return known ? static_cast<Status>(code) : Status::Unknown;
  } catch (const std::bad_alloc&) {
    return Status::OutOfMemory;
  }
}

/// The markers as a vector; zeros where TetGen gives none.
std::vector<std::int32_t> markers(const int* list, std::size_t count) {
  return list != nullptr ? std::vector<std::int32_t>(list, list + count)
                         : std::vector<std::int32_t>(count, 0);
}

bool answer(int fd, Status status, Task task, const tetgenio& out) {
  AnswerHeader header;
  header.status = status;
  if (status != Status::Meshed) return write_all(fd, &header, sizeof header);
  const auto points = static_cast<std::size_t>(out.numberofpoints);
  const auto tets = static_cast<std::size_t>(out.numberoftetrahedra);
  header.points = points;
  header.tets = tets;
  if (task != Task::Fill) {
    header.facets = static_cast<std::uint64_t>(out.numberoftrifaces);
    header.segments = static_cast<std::uint64_t>(out.numberofedges);
  }
  std::vector<std::int32_t> regions(tets, 0);
  if (out.numberoftetrahedronattributes == 1)
    for (std::size_t t = 0; t < tets; ++t)
      regions[t] = static_cast<std::int32_t>(out.tetrahedronattributelist[t]);
  return write_all(fd, &header, sizeof header) &&
         write_all(fd, out.pointlist, points * 3 * sizeof(double)) &&
         write_all(fd, out.tetrahedronlist, tets * 4 * sizeof(std::int32_t)) &&
         write_all(fd, regions.data(), tets * sizeof(std::int32_t)) &&
         write_all(fd, out.trifacelist, header.facets * 3 * sizeof(std::int32_t)) &&
         write_all(fd, markers(out.trifacemarkerlist, header.facets).data(),
                   header.facets * sizeof(std::int32_t)) &&
         write_all(fd, out.edgelist, header.segments * 2 * sizeof(std::int32_t)) &&
         write_all(fd, markers(out.edgemarkerlist, header.segments).data(),
                   header.segments * sizeof(std::int32_t));
}

void limit(int resource, rlim_t value) {
  const rlimit both{value, value};
  setrlimit(resource, &both);
}

bool number(const char* text, rlim_t& value) {
  const char* end = text + std::strlen(text);
  return std::from_chars(text, end, value).ptr == end && text != end;
}

}  // namespace

int main(int argc, char** argv) {
  rlim_t bytes = 0, seconds = 0;
  if (argc != 3 || !number(argv[1], bytes) || !number(argv[2], seconds)) {
    std::fputs(
        "usage: remeshd-tetgen ADDRESS_SPACE_BYTES PROCESSOR_SECONDS\n"
        "A part of remeshd, which starts it and speaks to it over its stdin.\n",
        stderr);
    return kExitUsage;
  }
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  limit(RLIMIT_CORE, 0);
  limit(RLIMIT_AS, bytes);
  limit(RLIMIT_CPU, seconds);
  limit(RLIMIT_FSIZE, 0);

  // TetGen prints to stdout what it comes across, with Q or without.
  const int to_parent = dup(STDOUT_FILENO);
  const int nowhere = open("/dev/null", O_WRONLY | O_CLOEXEC);
  if (to_parent < 0 || nowhere < 0 || dup2(nowhere, STDOUT_FILENO) < 0) return kExitBrokenStream;
  limit(RLIMIT_NOFILE, 0);  // it has all that it needs open

  Request request;
  tetgenio out;
  Status status = Status::OutOfMemory;
  try {
    if (!read_request(request)) return kExitBrokenStream;
    status = mesh(request, out);
    // Without the destructors: the system takes memory back faster.
    _exit(answer(to_parent, status, request.header.task, out) ? 0 : kExitBrokenStream);
  } catch (const std::bad_alloc&) {
    _exit(answer(to_parent, Status::OutOfMemory, Task::Fill, out) ? 0 : kExitBrokenStream);
  }
}
