#include "server/config/plain_characters.h"

#include "tests/server/config/read.h"

namespace remeshd::test {
namespace {

// U+FCFF, which toml++ takes for a place in its code that is never reached.
const std::string kStrange = "\xEF\xB3\xBF";

TEST(PlainCharacters, OutsideOfQuotesAreAscii) {
  for (const std::string& text :
       {"ab" + kStrange + " = 1", kStrange, "a = 1 " + kStrange, "a = \"x\" " + kStrange,
        "a = 'x'" + kStrange, "a = '''x'''" + kStrange, "a = \"\\" + kStrange + "\"",
        "a = \"\"\"\\\n  " + kStrange + "\"\"\"", "a = 1e4\"x\"''x'" + kStrange + "'",
        "a = \"x\n" + kStrange + "\""}) {
    const std::string last = std::to_string(1 + std::count(text.begin(), text.end(), '\n'));
    EXPECT_EQ(complaint([&] { check_plain_characters(text, "f"); }),
              "f:" + last + ": a character that is not ASCII stands outside of quotes")
        << text;
  }
}

TEST(PlainCharacters, InStringsAndCommentsMayBeAny) {
  for (const std::string& text :
       {"# " + kStrange + "\na = 1", std::string("\xEF\xBB\xBF# a mark"),
        "a = \"" + kStrange + "\"", "a = \"\\\"" + kStrange + "\"",
        "a = ['" + kStrange + "\\', '" + kStrange + "']", "\"" + kStrange + "\" = 1",
        "a = \"\"\"\n\"" + kStrange + "\"\"\"\nb = 2", "a = '''\n'" + kStrange + "'''\n",
        "a = \"" + kStrange, std::string("a = \"\\"), std::string()})
    EXPECT_NO_THROW(check_plain_characters(text, "f")) << text;
}

}  // namespace
}  // namespace remeshd::test
