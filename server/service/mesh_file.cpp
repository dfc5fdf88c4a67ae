#include "server/service/mesh_file.h"

#include <algorithm>
#include <utility>

#include "client/library/mesh_arrays.h"
#include "remesh/v1/mesh.pb.h"
#include "remeshd/mesh_file.h"
#include "server/service/encode.h"
#include "server/session/mesh_arrays.h"
#include "server/session/session_error.h"

namespace remeshd {
namespace {

using Writer = std::string (*)(const client::Mesh&);

struct Format {
  const char* name;
  Writer write;  ///< of a mesh; null: of the model
};
constexpr Format kFormats[] = {
    {"vtu", client::to_vtu}, {"msh", client::to_msh}, {"inp", client::to_inp}, {"step", nullptr}};

/// Peak memory of a writer, x the bytes of the arrays: the copy of the mesh, and the file, which
/// has up to 2.2 times as many, also while its string grows and both its old and its new buffer
/// exist.
constexpr std::uint64_t kPeakShare = 6;

/// Peak memory of writing a model's file, and more for each face: 25 MB was measured for 80 faces.
constexpr std::uint64_t kModelBytes = 16U << 20U, kFaceBytes = 512U << 10U;

/// The mesh as a client has it that received all its arrays.
client::Mesh mesh_of(const HeldRevision& revision) {
  client::Mesh mesh;
  mesh.revision = revision.record.id;
  mesh.parent = revision.record.parent;
  mesh.model_name = revision.revision.source.name;
  mesh.unit = revision.revision.source.unit;
  mesh.options = in_one_line(revision.revision.options);
  mesh.algorithm_version = revision.record.algorithm_version;
  std::string bytes;
  for (const MeshArray& array : mesh_arrays(revision.revision.output)) {
    const auto name = static_cast<remesh::v1::MeshArray>(static_cast<int>(array.name));
    const client::KnownArray* known = client::find_array(name);
    if (known == nullptr) continue;
    bytes.clear();
    bytes.reserve(array.bytes);
    array.read(0, array.bytes, bytes);
    known->read(bytes, mesh);
  }
  return mesh;
}

ModelLabels labels_of(const HeldRevision& held) {
  const RevisionRecord& record = held.record;
  const ModelSource& source = held.revision.source;
  ModelLabels labels{.name = source.name, .unit = source.unit, .file = record.id + ".step"};
  labels.description.push_back("exact boundary of revision " + record.id);
  if (!record.parent.empty()) labels.description.push_back("edited from " + record.parent);
  labels.origin = "remeshd, algorithm version " + std::to_string(record.algorithm_version);
  return labels;
}

const Format* find_format(std::string_view name) {
  const auto* found =
      std::ranges::find_if(kFormats, [&](const Format& format) { return name == format.name; });
  return found == std::end(kFormats) ? nullptr : found;
}

}  // namespace

const std::vector<std::string>& mesh_file_formats() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> out;
    for (const Format& format : kFormats) out.emplace_back(format.name);
    return out;
  }();
  return names;
}

void check_mesh_file_format(std::string_view format) {
  if (find_format(format) != nullptr) return;
  std::string known;
  for (const std::string& name : mesh_file_formats()) known += (known.empty() ? "" : ", ") + name;
  throw error::option_invalid("format", "is none of " + known);
}

std::string mesh_file(const Session& session, const HeldRevision& revision, std::string_view format,
                      const Run& run) {
  if (const Writer write = find_format(format)->write) return write(mesh_of(revision));
  return session.step_of(revision, labels_of(revision), run);
}

std::uint64_t mesh_file_memory(const HeldRevision& revision, std::string_view format) {
  if (find_format(format)->write == nullptr)
    return kModelBytes + kFaceBytes * revision.revision.cells.boundary.faces.size();
  std::uint64_t bytes = 0;
  for (const MeshArray& array : mesh_arrays(revision.revision.output)) bytes += array.bytes;
  return kPeakShare * bytes;
}

}  // namespace remeshd
