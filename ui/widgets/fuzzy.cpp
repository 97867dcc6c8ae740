#include "ui/widgets/fuzzy.h"

#include <algorithm>
#include <cctype>
#include <string>
#include <vector>

namespace stretch::ui {

namespace {

char lower(char c) {
  return static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
}

bool startsWord(std::string_view text, std::size_t at) {
  return at == 0 || std::isalnum(static_cast<unsigned char>(text[at - 1])) == 0;
}

int letterScore(std::string_view text, std::size_t at) {
  return 1 + (startsWord(text, at) ? 8 : 0);
}

/// What parts words in names.
bool partsWords(char c) {
  return c == ' ' || c == '_' || c == '-' || c == '.';
}

std::vector<std::string> wordsOf(std::string_view text) {
  std::vector<std::string> words(1);
  for (const char c : text) {
    if (std::isalnum(static_cast<unsigned char>(c)) != 0 || static_cast<unsigned char>(c) > 127U) {
      words.back() += lower(c);
    } else if (!words.back().empty()) {
      words.emplace_back();
    }
  }
  if (words.back().empty()) {
    words.pop_back();
  }
  return words;
}

/// How well a typed word is in the words of a text; 0: not at all.
int scoreOfWord(const std::string& typed, const std::vector<std::string>& words) {
  constexpr std::size_t leastInside = 3;
  int best = 0;
  for (std::size_t i = 0; i < words.size(); ++i) {
    const std::size_t at = words[i].find(typed);
    const int score = words[i] == typed                                        ? 30
                      : at == 0                                                ? 20
                      : at != std::string::npos && typed.size() >= leastInside ? 8
                                                                               : 0;
    best = std::max(best, score + (score > 0 && i == 0 ? 10 : 0));
  }
  return best;
}

/// Whether the letters are beginnings of words from the `word`-th on, each of them used once and in order.
bool beginsWords(std::string_view letters, const std::vector<std::string>& words, std::size_t word) {
  if (letters.empty()) {
    return true;
  }
  for (; word < words.size(); ++word) {
    std::size_t common = 0;
    while (common < std::min(letters.size(), words[word].size()) && letters[common] == words[word][common]) {
      ++common;
      if (beginsWords(letters.substr(common), words, word + 1)) {
        return true;
      }
    }
  }
  return false;
}

} // namespace

std::optional<int> wordScore(std::string_view typed, std::string_view text, bool takesBeginnings) {
  constexpr int asBeginnings = 10;
  constexpr std::size_t mostLetters = 12; // longer ones are words, not beginnings of some
  const std::vector<std::string> asked = wordsOf(typed);
  const std::vector<std::string> words = wordsOf(text);
  const int length = static_cast<int>(text.size() / 4);
  int sum = 0;
  bool all = true;
  std::string letters;
  for (const std::string& word : asked) {
    const int score = scoreOfWord(word, words);
    sum += score;
    all = all && score > 0;
    letters += word;
  }
  if (all) {
    return sum - length;
  }
  const bool begins = takesBeginnings && letters.size() <= mostLetters && beginsWords(letters, words, 0);
  return begins ? std::optional(asBeginnings - length) : std::nullopt;
}

bool holdsWords(std::string_view typed, std::string_view text) {
  std::string letters;
  for (const char c : text) {
    if (!partsWords(c)) {
      letters += lower(c);
    }
  }
  std::string word;
  for (const char c : typed) {
    if (!partsWords(c)) {
      word += lower(c);
      continue;
    }
    if (letters.find(word) == std::string::npos) {
      return false;
    }
    word.clear();
  }
  return letters.find(word) != std::string::npos;
}

std::optional<int> fuzzyScore(std::string_view typed, std::string_view text) {
  while (!typed.empty() && typed.back() == ' ') {
    typed.remove_suffix(1);
  }
  constexpr int besideBonus = 10;
  // scores[at]: the best match of the letters from the current one on, the current one at `at`; from the last
  // letter back.
  std::vector<std::optional<int>> scores(text.size() + 1);
  const int lengthPenalty = static_cast<int>(text.size() / 3);
  if (typed.empty()) {
    return -lengthPenalty;
  }
  for (std::size_t letter = typed.size(); letter-- > 0;) {
    std::vector<std::optional<int>> next(text.size() + 1);
    std::optional<int> bestLater;
    for (std::size_t at = text.size(); at-- > 0;) {
      const bool last = letter + 1 == typed.size();
      const std::optional<int>& beside = scores[at + 1];
      if (beside && !last) {
        bestLater = std::max(bestLater.value_or(*beside), *beside);
      }
      if (lower(text[at]) != lower(typed[letter])) {
        continue;
      }
      if (last) {
        next[at] = letterScore(text, at);
      } else if (bestLater) {
        const int rest = beside ? std::max(*bestLater, *beside + besideBonus) : *bestLater;
        next[at] = letterScore(text, at) + rest;
      }
    }
    scores = std::move(next);
  }
  std::optional<int> best;
  for (std::size_t at = 0; at < text.size(); ++at) {
    if (scores[at]) {
      const int score = *scores[at] - static_cast<int>(at / 6) - lengthPenalty;
      best = std::max(best.value_or(score), score);
    }
  }
  return best;
}

} // namespace stretch::ui
