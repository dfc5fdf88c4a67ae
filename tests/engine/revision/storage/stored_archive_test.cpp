#include "engine/revision/storage/stored_archive.h"

#include <gtest/gtest.h>

#include <cereal/types/string.hpp>
#include <cereal/types/vector.hpp>
#include <sstream>

namespace remeshd {
namespace {

class Archive : public StoredArchive<Archive> {
 public:
  explicit Archive(std::string_view bytes) : StoredArchive(this, bytes) {}
};

}  // namespace
}  // namespace remeshd

template <>
struct cereal::traits::detail::get_output_from_input<remeshd::Archive> {
  using type = cereal::PortableBinaryOutputArchive;
};

namespace remeshd {
namespace {

template <typename... Values>
std::string written(const Values&... values) {
  std::ostringstream out(std::ios::binary);
  cereal::PortableBinaryOutputArchive archive(out);
  archive(values...);
  return std::move(out).str();
}

TEST(StoredArchive, ReadsWhatCerealWrote) {
  const std::string bytes = written(std::string("text"), std::vector<double>{1, 2}, true, 7U);
  std::string text;
  std::vector<double> numbers;
  bool on = false;
  unsigned last = 0;
  Archive archive(bytes);
  archive(text, numbers, on, last);
  EXPECT_EQ(text, "text");
  EXPECT_EQ(numbers, (std::vector<double>{1, 2}));
  EXPECT_TRUE(on);
  EXPECT_EQ(last, 7U);
  EXPECT_THROW(archive(last), Error) << "nothing is left";
}

TEST(StoredArchive, TakesNoMemoryForAListLongerThanWhatFollows) {
  std::vector<std::vector<double>> lists;
  try {
    const std::string bytes = written(std::uint64_t{1} << 60U);
    Archive archive(bytes);
    archive(lists);
    ADD_FAILURE() << "it was read";
  } catch (const Error& error) {
    EXPECT_STREQ(error.what(), "a stored list is cut off");
  }
}

TEST(StoredArchive, ReadsNoSwitchThatIsNeitherOnNorOff) {
  bool on = false;
  const std::string bytes = written(std::uint8_t{2});
  Archive archive(bytes);
  EXPECT_THROW(archive(on), Error);
}

}  // namespace
}  // namespace remeshd
