#include "server/guard/tokens.h"

#include <gmock/gmock.h>

#include <fstream>

#include "server/guard/secret_file.h"
#include "tests/server/transport/sockets.h"

namespace remeshd::test {
namespace {

using testing::HasSubstr;

class TokenFiles : public testing::Test {
 protected:
  std::string write(const std::string& text, int mode = 0600) const {
    std::string path = folder_.file("tokens");
    std::ofstream(path) << text;
    std::filesystem::permissions(path, static_cast<std::filesystem::perms>(mode));
    return path;
  }
  std::string complaint(const std::string& text, int mode = 0600) const {
    try {
      Tokens::read(write(text, mode));
    } catch (const SecretFileError& error) {
      return error.what();
    }
    return "none";
  }

  Folder folder_;
};

TEST_F(TokenFiles, NameTheTenantOfEachToken) {
  const Tokens tokens = Tokens::read(write(
      "# a comment\n\nanna 0123456789abcdef\n  ben\tfedcba9876543210  \nanna another-of-annas\n"));
  EXPECT_EQ(tokens.tenant_of("0123456789abcdef"), "anna");
  EXPECT_EQ(tokens.tenant_of("another-of-annas"), "anna");
  EXPECT_EQ(tokens.tenant_of("fedcba9876543210"), "ben");
  for (const char* wrong : {"", "0123456789abcdeF", "0123456789abcde", "0123456789abcdef0", "anna"})
    EXPECT_EQ(tokens.tenant_of(wrong), std::nullopt) << wrong;
}

TEST_F(TokenFiles, NameEveryTenantOnce) {
  const Tokens tokens = Tokens::read(write(
      "ben 0123456789abcdef\nanna fedcba9876543210\n..b fedcba9876543211\nben a-second-of-bens\n"));
  EXPECT_EQ(tokens.tenants(), (std::set<std::string>{"..b", "anna", "ben"}));
}

TEST_F(TokenFiles, NameNoTenantByWhatNamesAnotherFolder) {
  for (const char* name : {".", "..", "a/b", "../anna"})
    EXPECT_THAT(complaint(std::string(name) + " 0123456789abcdef\n"), HasSubstr("a tenant's name"))
        << name;
}

TEST_F(TokenFiles, NameTenantsByUpToSixtyFourLettersDigitsDotsAndDashes) {
  const std::string longest = "azAZ09.-_" + std::string(55, 'x');
  EXPECT_EQ(complaint(longest + " 0123456789abcdef\n"), "none");
  for (const std::string& name : {longest + 'x', std::string("a[b"), std::string("a@b"),
                                  std::string("a{b"), std::string("a`b"), std::string("a:b")})
    EXPECT_THAT(complaint(name + " 0123456789abcdef\n"), HasSubstr("a tenant's name")) << name;
}

TEST_F(TokenFiles, OfAnotherFormNameTheLineAndNoToken) {
  EXPECT_THAT(complaint("anna 0123456789abcdef\nben\n"), HasSubstr("tokens:2: is not"));
  EXPECT_THAT(complaint("anna 0123456789abcdef more\n"), HasSubstr("tokens:1: is not"));
  EXPECT_THAT(complaint("an/na 0123456789abcdef\n"), HasSubstr("a tenant's name"));
  EXPECT_THAT(complaint("anna short-secret\n"),
              testing::AllOf(HasSubstr("16 to 512"), testing::Not(HasSubstr("short-secret"))));
  EXPECT_THAT(complaint("anna 0123456789abcdef\nben 0123456789abcdef\n"),
              HasSubstr("tokens:2: the token stands in an earlier line"));
  EXPECT_THAT(complaint("# none\n"), HasSubstr("has no token"));
}

TEST_F(TokenFiles, ThatOthersMayReadOrChangeAreRefused) {
  const std::string text = "anna 0123456789abcdef\n";
  EXPECT_EQ(complaint(text, 0600), "none");
  EXPECT_EQ(complaint(text, 0440), "none");  // as secrets are mounted for a group
  for (const int mode : {0644, 0604, 0602, 0620})
    EXPECT_THAT(complaint(text, mode), HasSubstr("others may read or change it")) << mode;
}

TEST_F(TokenFiles, ThatAreNoneAreRefused) {
  EXPECT_THROW(Tokens::read(folder_.file("none")), SecretFileError);
  EXPECT_THROW(Tokens::read(folder_.file("")), SecretFileError);
}

}  // namespace
}  // namespace remeshd::test
