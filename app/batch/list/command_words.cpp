#include "app/batch/list/command_words.h"

#include <optional>

namespace stretch::app {

Result<std::vector<std::string>> commandWords(std::string_view line) {
  std::vector<std::string> words;
  std::optional<std::string> word;
  char quote = '\0';
  const auto put = [&](char letter) { word = word.value_or("") + letter; };
  for (std::size_t i = 0; i < line.size(); ++i) {
    const char letter = line[i];
    if (letter == '\\' && quote != '\'' && i + 1 < line.size()) {
      put(line[++i]);
    } else if (quote != '\0') {
      quote = letter == quote ? '\0' : quote;
      if (quote != '\0') {
        put(letter);
      }
    } else if (letter == '\'' || letter == '"') {
      quote = letter;
      word = word.value_or("");
    } else if (letter == ' ' || letter == '\t' || letter == '\r') {
      if (word) {
        words.push_back(*std::exchange(word, std::nullopt));
      }
    } else if (letter == '#' && words.empty() && !word) {
      break;
    } else {
      put(letter);
    }
  }
  if (quote != '\0') {
    return Error{std::string("a ") + quote + " is not closed", "", "close it, or put a \\ before it"};
  }
  if (word) {
    words.push_back(*std::move(word));
  }
  return words;
}

} // namespace stretch::app
