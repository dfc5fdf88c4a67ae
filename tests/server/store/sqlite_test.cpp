#include "server/store/sqlite.h"

#include <gtest/gtest.h>

#include <functional>

#include "engine/base/error.h"

namespace remeshd::test {
namespace {

struct SqliteTest : testing::Test {
  Sqlite database{":memory:"};

  SqliteTest() {
    database.execute("CREATE TABLE numbers(n INTEGER PRIMARY KEY, name TEXT)");
    database.execute("INSERT INTO numbers VALUES(1, 'one'), (2, 'two'), (3, 'three')");
  }
  std::string name_of(int n) {
    auto row = database.prepare("SELECT name FROM numbers WHERE n = ?");
    row.bind(n);
    return row.step() ? row.text(0) : "";
  }
};

TEST_F(SqliteTest, AStatementIsAsNewAtItsNextUse) {
  EXPECT_EQ(name_of(1), "one");  // with rows that were not asked for
  EXPECT_EQ(name_of(2), "two");
  auto unbound = database.prepare("SELECT name FROM numbers WHERE n = ?");
  EXPECT_FALSE(unbound.step());
}

TEST_F(SqliteTest, TheSameTextMayRunInsideItself) {
  auto outer = database.prepare("SELECT n FROM numbers ORDER BY n");
  for (int i = 1; i <= 3; ++i) {
    ASSERT_TRUE(outer.step());
    EXPECT_EQ(outer.number(0), i);
    auto inner = database.prepare("SELECT n FROM numbers ORDER BY n");
    ASSERT_TRUE(inner.step());
    EXPECT_EQ(inner.number(0), 1);
  }
}

TEST_F(SqliteTest, TheSameTextMayRunMoreTimesAtOnceThanBefore) {
  const std::function<int(int)> nested = [&](int depth) {
    auto row = database.prepare("SELECT n FROM numbers ORDER BY n");
    EXPECT_TRUE(row.step());
    return depth > 1 ? 1 + nested(depth - 1) : 1;
  };
  for (int depth = 1; depth <= 3; ++depth) EXPECT_EQ(nested(depth), depth);
}

TEST_F(SqliteTest, AStatementThatFailedWorksTheNextTime) {
  const auto insert = [&](int n) {
    database.prepare("INSERT INTO numbers VALUES(?, 'again')").bind(n).run();
  };
  EXPECT_THROW(insert(1), Error);
  EXPECT_NO_THROW(insert(4));
  EXPECT_EQ(name_of(4), "again");
}

TEST_F(SqliteTest, NoStatementKeepsAChangeFromBeingGivenUp) {
  database.execute("SAVEPOINT change");
  database.prepare("DELETE FROM numbers WHERE n = ?").bind(std::int64_t{1}).run();
  EXPECT_EQ(name_of(1), "");
  database.execute("ROLLBACK TO change; RELEASE change");
  EXPECT_EQ(name_of(1), "one");
}

TEST_F(SqliteTest, ManyTextsAreNotAllKept) {
  for (int n = 0; n < 1000; ++n) {
    auto row = database.prepare("SELECT " + std::to_string(n));
    ASSERT_TRUE(row.step());
    EXPECT_EQ(row.number(0), n);
  }
}

}  // namespace
}  // namespace remeshd::test
