#include "client/cli/choice.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <sstream>

#include "engine/base/text/nearest_name.h"

namespace remeshd::cli {
namespace {

std::string joined(const std::vector<std::string>& words, const std::string& between) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : between) + word;
  return text;
}

bool is_plain(const std::string& word) {
  return !word.empty() && std::ranges::all_of(word, [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '-' || c == '.';
  });
}

}  // namespace

void only(CLI::Option& option, const std::vector<std::string>& words) {
  option.type_name(joined(words, "|"))
      ->check(CLI::Validator(
          [words](const std::string& given) {
            if (std::ranges::find(words, given) != words.end()) return std::string();
            return given + " is none of " + joined(words, ", ") + suggestion(given, words);
          },
          "", ""));
}

std::vector<std::string> words_of(const std::string& type_name) {
  std::vector<std::string> words;
  std::istringstream in(type_name);
  for (std::string word; std::getline(in, word, '|');)
    if (is_plain(word)) words.push_back(word);
  return words;
}

}  // namespace remeshd::cli
