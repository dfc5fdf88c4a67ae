#include "server/tier/sealed_object.h"

#include <gtest/gtest.h>

#include <string>

namespace remeshd::test {
namespace {

const std::string kKey = "recipe/ab/abcd", kFarm = "the key of this farm";

std::string why_not(const std::string& key, const std::string& object,
                    const std::string& farm = kFarm) {
  try {
    unsealed(key, object, farm);
    return "";
  } catch (const WrongObject& why) {
    return why.what();
  }
}

TEST(SealedObject, GivesItsBytes) {
  for (const std::string& bytes : {std::string(), std::string("some\nbytes\0more", 15)})
    EXPECT_EQ(unsealed(kKey, sealed(kKey, bytes, kFarm), kFarm), bytes);
}

TEST(SealedObject, BelongsToItsKeyAndFarm) {
  const std::string object = sealed(kKey, "bytes", kFarm);
  EXPECT_EQ(why_not("recipe/ab/abce", object), "it belongs to another key");
  EXPECT_EQ(why_not(kKey, object, "another farm's key"), "it was not sealed with the farm's key");
  EXPECT_EQ(why_not(kKey, "<html>\n"), "it is no object of remeshd");
  EXPECT_EQ(why_not(kKey, ""), "it is no object of remeshd");
}

TEST(SealedObject, TellsOfEveryBitThatChanges) {
  const std::string object = sealed(kKey, "a body of some bytes", kFarm);
  for (std::size_t bit = 0; bit < 8 * object.size(); ++bit) {
    std::string changed = object;
    changed[bit / 8] = static_cast<char>(changed[bit / 8] ^ (1 << bit % 8));
    EXPECT_NE(why_not(kKey, changed), "") << "bit " << bit;
  }
}

TEST(SealedObject, TellsOfEveryLengthButItsOwn) {
  const std::string object = sealed(kKey, "a body of some bytes", kFarm);
  for (std::size_t size = 0; size < object.size(); ++size)
    EXPECT_NE(why_not(kKey, object.substr(0, size)), "") << size << " bytes";
  EXPECT_EQ(why_not(kKey, object + "x"), "it is cut off or too long");
}

}  // namespace
}  // namespace remeshd::test
