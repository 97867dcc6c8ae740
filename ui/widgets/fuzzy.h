#pragma once

#include <optional>
#include <string_view>

namespace stretch::ui {

/// How well a text answers what was typed: every typed letter in order, case aside; matches at the start of
/// words and beside each other count more. Empty when it does not match; the higher the better. Nothing typed
/// matches everything.
[[nodiscard]] std::optional<int> fuzzyScore(std::string_view typed, std::string_view text);

/// How well a text answers typed words, each by itself: as a word of the text best, then as the beginning of
/// one, then, of three letters and more, anywhere in one; or, where that is taken, all typed letters are
/// beginnings of words that follow each other: "frsel" is "Frame the selection". Empty where any typed word
/// is not there: scattered letters are no answer. The higher the better; nothing typed is in everything.
[[nodiscard]] std::optional<int> wordScore(std::string_view typed, std::string_view text,
                                           bool takesBeginnings = true);

/// Whether a text holds every typed word, in any order. Case, and the blanks, '_', '-' and '.' that part
/// words, do not count: "melee attack" is in "1H_Melee_Attack_Chop". Nothing typed is in everything.
[[nodiscard]] bool holdsWords(std::string_view typed, std::string_view text);

} // namespace stretch::ui
