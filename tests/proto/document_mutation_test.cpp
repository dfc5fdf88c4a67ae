#include <gtest/gtest.h>

#include <filesystem>

#include "engine/base/random.h"
#include "proto/document.h"
#include "proto/document_error.h"
#include "proto/json_writer.h"

namespace remeshd {
namespace {

/// A text with a few bytes changed, left out, doubled or replaced by what JSON is made of.
std::string mutated(std::string text, Random& random) {
  static constexpr char kPieces[] = "{}[]:,\"\\0-9.eEnulltrue\x00\x80\xFF\xED\xA0 ";
  for (std::uint64_t n = 1 + random.below(4); n > 0 && !text.empty(); --n) {
    const std::size_t at = random.below(text.size());
    const std::size_t length = 1 + random.below(6);
    switch (random.below(4)) {
      case 0:
        text[at] = kPieces[random.below(sizeof kPieces - 1)];
        break;
      case 1:
        text.erase(at, length);
        break;
      case 2:
        text.insert(at, text.substr(random.below(text.size()), length * 4));
        break;
      default:
        text.resize(at);
    }
  }
  return text;
}

TEST(Document, HoweverDamagedIsReadOrRefusedInWords) {
  Random random(20090101);
  int taken = 0, refused = 0;
  for (const auto& file : std::filesystem::directory_iterator(REMESHD_CASES_DIR)) {
    if (file.path().extension() != ".json") continue;
    const std::string text = read_document(file.path());
    for (int i = 0; i < 200; ++i) {
      const std::string damaged = mutated(text, random);
      try {
        std::visit(
            [&](const auto& message) {
              // What is taken can be written and taken again.
              parse_document(write_document(message));
            },
            parse_document(damaged));
        ++taken;
      } catch (const DocumentError& error) {
        EXPECT_FALSE(error.info().reason.empty());
        EXPECT_LT(error.info().message.size(), 1000U);
        ++refused;
      }
    }
  }
  EXPECT_GT(taken, 0);
  EXPECT_GT(refused, 1000);
}

}  // namespace
}  // namespace remeshd
