#include "server/store/json_number.h"

#include <gtest/gtest.h>

#include "server/store/checked_line.h"
#include "server/store/journal_line.h"

namespace remeshd {
namespace {

using nlohmann::json;

template <typename Number>
void expect_none(const char* text) {
  EXPECT_THROW(whole_number<Number>(json::parse(text)), json::exception) << text;
}

TEST(WholeNumbers, AreThoseThatTheTypeCanHold) {
  EXPECT_EQ(whole_number<std::uint32_t>(json::parse("4294967295")), 4294967295U);
  EXPECT_EQ(whole_number<std::int64_t>(json::parse("-9223372036854775808")),
            std::numeric_limits<std::int64_t>::min());
  EXPECT_EQ(whole_number<std::uint64_t>(json::parse("18446744073709551615")), ~std::uint64_t{0});
  expect_none<std::uint32_t>("4294967296");
  expect_none<std::uint32_t>("-1");
  expect_none<std::int64_t>("18446744073709551615");
  for (const char* text : {"1e300", "1.5", "1.0", "\"1\"", "true", "null", "[1]"})
    expect_none<std::uint64_t>(text);
}

TEST(WholeNumbers, OfAFieldThatMayBeMissing) {
  const json object = json::parse(R"({"a": 3, "b": 1e300})");
  EXPECT_EQ(number_or(object, "a", 0U), 3U);
  EXPECT_EQ(number_or(object, "c", 7U), 7U);
  EXPECT_THROW(number_or(object, "b", 0U), json::exception);
}

TEST(WholeNumbers, OutOfRangeMakeALineOfTheJournalUnreadable) {
  const auto line = [](const char* number) {
    return checked_line(std::string(R"({"version": 2, "number": )") + number +
                        R"(, "operations": []})");
  };
  EXPECT_TRUE(read_journal_line(line("18446744073709551615")));
  EXPECT_FALSE(read_journal_line(line("1e300")));
  EXPECT_FALSE(read_journal_line(line("-1")));
}

}  // namespace
}  // namespace remeshd
