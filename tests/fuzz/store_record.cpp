// What a store keeps of one revision: the head of its pack, the recipe, the pack as a file. The
// first byte chooses which. Checksums are put right here, for no mutation would meet one.
#include <nlohmann/json.hpp>

#include "engine/base/error.h"
#include "server/session/recipe.h"
#include "server/store/array_codec.h"
#include "server/store/checked_line.h"
#include "server/store/first_layout.h"
#include "server/store/pack_head.h"
#include "server/store/packed_text.h"
#include "server/store/packs.h"
#include "tests/fuzz/documents.h"
#include "tests/fuzz/finding.h"
#include "tests/fuzz/input.h"
#include "tests/fuzz/scratch_folder.h"
#include "tests/fuzz/targets.h"

namespace remeshd::fuzz {
namespace {

using nlohmann::json;

const std::string kId(64, 'a');
const std::string kBase(64, 'b');

void check_head(std::string_view start) {
  store_version_of(start);
  size_of_pack_head(start);
  const auto head = read_pack_head(start);
  if (!head || head->store_version < 2) return;
  // What is written is the recipe that was read, and the hash of what follows is told anew.
  const std::string text = write_pack_head(*head);
  const auto again = read_pack_head(text);
  expect(again.has_value(), "a head that is written and not read");
  expect(again->record == head->record && again->first == head->first, "another record");
  expect(write_pack_head(*again) == text, "a head that is written in two ways");
  const auto size = size_of_pack_head(text);
  expect(size && *size == text.size(), "a head whose size is told wrong");
}

void raw_head(std::string_view bytes) { check_head(bytes); }

void head_with_checksum(std::string_view bytes) {
  Input input(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
  const std::string line = checked_line(input.until('\n'));
  check_head(line + std::string(input.rest()));
}

void packed_bytes(std::string_view bytes) {
  const std::string text = unpacked(bytes);
  expect(unpacked(packed(text)) == text, "a text that is packed is another");
}

void base64_text(std::string_view text) {
  const std::string bytes = from_base64(text);
  expect(from_base64(base64(bytes)) == bytes, "bytes that are written as letters are others");
}

void recipe_text(std::string_view text) {
  const Recipe recipe = read_recipe(std::string(text));
  const std::string written = write_recipe(recipe);
  expect(read_recipe(written) == recipe, "a recipe that is written is another");
  expect(write_recipe(read_recipe(written)) == written, "a recipe that is written in two ways");
}

/// The head's JSON, a line break, recipe and data. A second pack is its base, if it says so.
void pack_file(std::string_view bytes) {
  Input input(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
  const ScratchFolder folder;
  std::filesystem::create_directories(folder.path() / "tmp");
  Packs packs(folder.path(), folder.path() / "tmp");
  StoredArray array{.name = "nodes", .type = StoredType::F64, .components = 3};
  array.own(std::string(4800, 'x'));
  packs.put({.id = kBase, .model_name = "m"}, {}, "", {{array}}, nullptr);

  json head = json::parse(input.until('\n'), nullptr, false);
  const std::string rest(input.rest());
  if (head.is_object()) {
    head["data"] = content_hash(rest);
    head["id"] = kId;
    if (head.contains("recipe") && head["recipe"].is_number_unsigned())
      head["recipe_hash"] = content_hash(rest.substr(0, head["recipe"].get<std::size_t>()));
    if (head.contains("base") && head["base"] == kBase)
      head["base_content"] = packs.head(kBase)->content;
  }
  const std::string text = head.dump(-1, ' ', false, json::error_handler_t::replace);
  folder.write(std::filesystem::path(kId.substr(0, 2)) / kId.substr(2), checked_line(text) + rest);

  static_cast<void>(packs.head(kId));
  static_cast<void>(packs.is_whole(kId));
  static_cast<void>(packs.fault_of(kId));
  expect(packs.list() == std::vector{kId, kBase}, "a pack is not in the list");
  const StoredArrays arrays = packs.get(kId);
  // What was read can be written again, and what comes of it is the same.
  const std::string other(64, 'c');
  packs.put({.id = other, .model_name = "m"}, {}, "", arrays, nullptr);
  expect(content_hash(packs.get(other)) == content_hash(arrays), "arrays that are stored change");
}

/// An object of the first layout, of which packs are made.
void first_object(std::string_view bytes) {
  const ScratchFolder folder;
  for (const char* name : {"packs", "tmp", "quarantine"})
    std::filesystem::create_directories(folder.path() / name);
  folder.write(std::filesystem::path("objects") / "aa" / "bb", bytes);
  Packs packs(folder.path() / "packs", folder.path() / "tmp");
  Quarantine quarantine(folder.path() / "quarantine", folder.path() / "tmp");
  FirstLayout(folder.path()).bring_in(packs, quarantine);
  expect(packs.list().empty(), "an object of the wrong name was taken for a revision");
}

constexpr void (*kKinds[])(std::string_view) = {
    raw_head, head_with_checksum, packed_bytes, base64_text, recipe_text, pack_file, first_object};

/// A pack of two arrays, the first as differences to those of its base, as `pack_file` takes it.
std::string real_pack() {
  const ScratchFolder folder;
  std::filesystem::create_directories(folder.path() / "tmp");
  Packs packs(folder.path(), folder.path() / "tmp");
  StoredArray array{.name = "nodes", .type = StoredType::F64, .components = 3};
  array.own(std::string(4800, 'x'));
  const StoredArrays base{{array}};
  packs.put({.id = kBase, .model_name = "m"}, {}, "", base, nullptr);
  std::string changed(4800, 'x');
  changed[77] = 'y';
  array.own(changed);
  StoredArray other{.name = "documents"};
  other.own("some text");
  const Packs::Base on{kBase, &base};
  packs.put({.id = kId, .parent = kBase, .root = kBase, .model_name = "m", .nodes = 200},
            {.design = "plate", .number = 2, .id = kId}, packed("a recipe"), {{array, other}}, &on);
  std::ifstream in(packs.path_of(kId), std::ios::binary);
  const std::string bytes((std::istreambuf_iterator<char>(in)), {});
  return bytes.substr(bytes.find('{'));
}

}  // namespace
}  // namespace remeshd::fuzz

int fuzz_store_record(const std::uint8_t* data, std::size_t size) {
  using namespace remeshd;
  fuzz::Input input(data, size);
  const auto kind = fuzz::kKinds[input.byte() % std::size(fuzz::kKinds)];
  try {
    kind(input.rest());
  } catch (const Error& error) {
    fuzz::expect(!error.info().message.empty(), "an error without a message");
  }
  return 0;
}

remeshd::fuzz::Seeds remeshd::fuzz::store_record_seeds() {
  const auto of_kind = [](int kind, const std::string& bytes) {
    return static_cast<char>(kind) + bytes;
  };
  const std::string pack = real_pack();
  Recipe recipe{.revision = kId,
                .parent = kBase,
                .algorithm_version = 13,
                .model = source_of_every_type(),
                .edit = "{}"};
  recipe.options.size = 0.5;
  recipe.digests = {{ArrayName::Nodes, std::string(64, 'c')}};
  const std::string first_head =
      R"({"created_ns":1,"design":"plate","format":"remeshd-revision-1",)"
      R"("id":")" +
      kId +
      R"(","model_name":"m","nodes":5,"number":1,)"
      R"("parent":"","tets":4})"
      "\nbytes";
  return {of_kind(0, checked_line(pack.substr(0, pack.find('\n'))) + "recipe"),
          of_kind(0, first_head),
          of_kind(1, pack),
          of_kind(2, packed("a text that is packed")),
          of_kind(2, packed(std::string(100000, 'a'))),
          of_kind(3, base64("some bytes")),
          of_kind(4, write_recipe(recipe)),
          of_kind(5, pack),
          of_kind(6, first_head)};
}
