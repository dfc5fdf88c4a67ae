#include "server/config/config_file.h"
#include "tests/server/config/read.h"

namespace remeshd::test {
namespace {

TEST(PrintedConfigurations, ReadBackToTheSameSettings) {
  Settings settings;
  settings.daemon.listen = {"127.0.0.1:0", "unix:/a \"b\"\\c"};
  settings.daemon.store = "/st\xC3\xB6re\n#x";
  settings.daemon.queue_wait = 0.1;
  settings.daemon.memory = 5ULL << 40U;
  settings.daemon.workers = 3;
  settings.log_level = "off";
  const std::string text = print_config(settings);
  const ConfigFile file(text);
  const Settings back = read_configuration({"--config", file.path()}, {}).settings;
  for (const Option& option : option_table())
    EXPECT_EQ(option.get(back), option.get(settings)) << text;
  EXPECT_EQ(print_config(back), text);
}

TEST(PrintedConfigurations, HaveEveryOption) {
  EXPECT_EQ(read_config_text(print_config({}), "f").size(), option_table().size());
}

TEST(CheckedSettings, NeedAnAddressThatIsOne) {
  Settings settings;
  EXPECT_NO_THROW(check_settings(settings));
  settings.daemon.listen = {"127.0.0.1:0", "0"};
  EXPECT_ANY_THROW(check_settings(settings));
  settings.daemon.listen = {};
  EXPECT_EQ(complaint([&] { check_settings(settings); }), "listen: no address is given");
}

}  // namespace
}  // namespace remeshd::test
