// A stored revision, as arrays by name or in one piece as older programs wrote it. The first byte
// chooses a real image, whether the revision that was read is edited too; what follows are changes
// of its arrays. Whoever could forge a checksum, or a disk that meets one, must not make the engine
// read beyond an array.
#include <algorithm>
#include <cstring>
#include <fstream>

#include "engine/revision/storage/memory_use.h"
#include "engine/revision/storage/stored_revision.h"
#include "server/session/mesh_arrays.h"
#include "server/store/pack_head.h"
#include "tests/fuzz/finding.h"
#include "tests/fuzz/input.h"
#include "tests/fuzz/targets.h"
#include "tests/support/cases.h"
#include "tests/support/stored.h"

namespace remeshd::fuzz {
namespace {

constexpr std::uint8_t kEdit = 0xF0;  // all of these: to edit takes long

ModelSource small_model(double hole) {
  return test::model_of(
      {test::block("plate", 4, 4, 2),
       test::placed(test::cylinder("hole", hole, 2), 0.5, 0, 0, Nature::Subtractive)});
}

StoredArrays older_bytes(const char* object) {
  std::ifstream in(std::string(REMESHD_CASES_DIR) + "/first_layout_store/objects/" + object,
                   std::ios::binary);
  const std::string bytes((std::istreambuf_iterator<char>(in)), {});
  const auto head = read_pack_head(bytes);
  expect(head.has_value(), "the older store of the cases is gone");
  StoredArray array{.name = kOlderBytes};
  array.own(bytes.substr(head->size));
  return {{std::move(array)}};
}

/// A first mesh, one whose nodes followed its surfaces, and one of an older format.
const std::vector<StoredArrays>& images() {
  static const std::vector<StoredArrays> all = [] {
    const Revision first = make_revision(Revision::none(), small_model(1), {.nodes = 40}, {});
    const Revision followed = make_revision(first, small_model(1.0001), {}, {});
    return std::vector<StoredArrays>{
        test::copied(image_of(first)), test::copied(image_of(followed)),
        older_bytes("2b/bc3af054b0ea2fdada83c8f9418cb1d825549904c21ab25afc379202a99e66")};
  }();
  return all;
}

enum Change : std::uint8_t { kOverwrite, kCut, kInsert, kType, kDrop, kRepeat, kChanges };

/// Pre: there is an array.
void change(StoredArrays& image, Input& input) {
  const std::size_t which = input.byte() % image.arrays.size();
  StoredArray& array = image.arrays[which];
  const auto how = static_cast<Change>(input.byte() % kChanges);
  std::string bytes = array.flat();
  const std::size_t at = bytes.empty() ? 0 : input.number(2) % bytes.size();
  switch (how) {
    case kOverwrite: {
      const std::string_view by = input.take(input.byte() % 33);
      bytes.replace(at, std::min(by.size(), bytes.size() - at), by.substr(0, bytes.size() - at));
      break;
    }
    case kCut:
      bytes.resize(at);
      break;
    case kInsert:
      bytes.insert(at, input.take(input.byte() % 33));
      break;
    case kType:
      array.type = StoredType{static_cast<std::uint8_t>(input.byte() % 6)};
      array.components = input.byte();
      return;
    case kDrop:
      image.arrays.erase(image.arrays.begin() + static_cast<std::ptrdiff_t>(which));
      return;
    case kRepeat:
      bytes += bytes.substr(at);
      break;
    default:
      break;
  }
  array.own(std::move(bytes));
}

/// What a daemon does with a revision that it read.
void use(const Revision& revision, bool edited) {
  const std::string stored = test::stored_bytes(revision);
  expect(test::stored_bytes(test::stored_and_loaded(revision)) == stored,
         "a revision that is stored and read is another");
  for (const MeshArray& array : mesh_arrays(revision.output)) {
    std::string bytes;
    array.read(0, array.bytes, bytes);
    expect(bytes.size() == array.bytes, "an array of another size than it says");
  }
  memory_blocks(revision);
  if (edited) make_revision(revision, small_model(1.1), {}, {.max_nodes = 2000});
}

}  // namespace
}  // namespace remeshd::fuzz

int fuzz_revision_image(const std::uint8_t* data, std::size_t size) {
  using namespace remeshd;
  fuzz::Input input(data, size);
  const std::uint8_t first = input.byte();
  StoredArrays image = fuzz::images()[first % 16 % fuzz::images().size()];
  while (!input.empty() && !image.arrays.empty()) fuzz::change(image, input);
  try {
    fuzz::use(revision_of(image, nullptr, {}), (first & fuzz::kEdit) == fuzz::kEdit);
  } catch (const Error& error) {
    fuzz::expect(!error.info().message.empty(), "an error without a message");
  }
  return 0;
}

remeshd::fuzz::Seeds remeshd::fuzz::revision_image_seeds() {
  Seeds seeds;
  for (int image = 0; image < static_cast<int>(images().size()); ++image) {
    for (const int edit : {0, static_cast<int>(kEdit)})
      seeds.emplace_back(1, static_cast<char>(image + edit));
    // Each change once in each array.
    for (std::size_t array = 0; array < images()[static_cast<std::size_t>(image)].arrays.size();
         ++array)
      for (int how = 0; how < kChanges; ++how) {
        const char start[] = {static_cast<char>(image), static_cast<char>(array),
                              static_cast<char>(how),   static_cast<char>(array * 16),
                              static_cast<char>(how),   4};
        seeds.push_back(std::string(start, sizeof start) + std::string("\0\0\1\0", 4));
      }
  }
  return seeds;
}
