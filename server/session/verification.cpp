#include "server/session/verification.h"

namespace remeshd {

CacheVerification::CacheVerification(Archive& archive) : archive_(archive) {
  for (const RevisionRecord& record :
       archive.store().read([](Catalogue& catalogue) { return catalogue.revisions(); })) {
    if (record.bytes == 0) continue;
    meshes_.push_back({record.id, record.bytes});
    bytes_total_ += record.bytes;
  }
}

std::optional<CacheFault> CacheVerification::next() {
  const Mesh& mesh = meshes_[next_++];
  bytes_read_ += mesh.bytes;
  return archive_.check_stored(mesh.id);
}

}  // namespace remeshd
