#include "server/config/ascii_form.h"
#include "server/config/config_file.h"
#include "tests/server/config/read.h"

namespace remeshd::test {
namespace {

using testing::StartsWith;

// U+FCFF and U+00E9: toml++ takes either for a place in its code that is never reached.
const std::string kStrange = "\xEF\xB3\xBF", kAccent = "\xC3\xA9", kOrderMark = "\xEF\xBB\xBF";

std::string only_text(const std::string& text) {
  const auto given = read_config_text(text, "f");
  return given.size() == 1 ? std::get<std::string>(given.front().value) : "";
}

TEST(ConfigText, TakesAnyCharacterInStringsAndComments) {
  for (const std::string& strange : {kStrange, kAccent})
    for (const std::string& text :
         {"store = \"" + strange + "\"", "store = '" + strange + "'",
          "# " + strange + "\nstore = '" + strange + "' # " + strange,
          "store = '''\n" + strange + "'''", "store = \"\"\"" + strange + "\"\"\"",
          "store = \"\"\"\\\n  " + strange + "\"\"\"", kOrderMark + "store = '" + strange + "'"})
      EXPECT_EQ(only_text(text), strange) << text;
}

TEST(ConfigText, TakesThemNowhereElse) {
  for (const std::string& strange : {kStrange, kAccent, kOrderMark})
    for (const std::string& text :
         {"store" + strange + " = 1", "\n" + strange, "store = 1 " + strange,
          "store = \"x\" " + strange, "store = 'x'" + strange, "store = '''x'''" + strange,
          "store = \"\\" + strange + "\"", "store = 1e4\"x\"''x'" + strange + "'",
          "store = 1e4\"[\"'" + strange + "'", "store = \"x\n" + strange + "\"",
          "[" + strange + "]"})
      EXPECT_THAT(complaint([&] { read_config_text(text, "f"); }), StartsWith("f:")) << text;
}

TEST(ConfigText, NamesUnknownKeysAsTheyAre) {
  EXPECT_THAT(complaint([&] { read_config_text("\n'" + kAccent + "' = 1", "f"); }),
              StartsWith("f:2: " + kAccent + " is unknown"));
}

TEST(ConfigText, ThatIsNotUtf8IsRefusedWithItsLine) {
  for (const std::string bytes : {"\xE9", "\xC3", "\xED\xA0\x80", "\xF5\x80\x80\x80"})
    EXPECT_EQ(complaint([&] { read_config_text("\nstore = '" + bytes + "'", "f"); }),
              "f:2: the line is not UTF-8");
}

TEST(AsciiForm, GivesBackWhatItTellsOtherwise) {
  for (const std::string& text :
       {std::string("plain ?"), kAccent, "?" + kAccent + "a9" + kStrange}) {
    const AsciiForm form(text);
    EXPECT_TRUE(std::ranges::all_of(form.text(), [](char c) { return c > 0; }));
    EXPECT_EQ(form.original(form.text()), text);
  }
}

TEST(AsciiForm, MayBeCutOff) {
  const AsciiForm form("a" + kAccent);
  EXPECT_EQ(form.original(form.text().substr(0, form.text().find(':') + 1)), "a");
}

}  // namespace
}  // namespace remeshd::test
