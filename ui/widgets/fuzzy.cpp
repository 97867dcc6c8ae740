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

} // namespace

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
