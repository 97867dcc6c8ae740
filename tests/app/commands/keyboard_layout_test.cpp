#include <catch2/catch.hpp>

#include <set>

#include "app/commands/table/keyboard_layout.h"
#include "tests/support/app/key_tables.h"

using namespace stretch::app;
namespace test = stretch::test;

namespace {

/// The places of a US keyboard in rows, and what another layout prints there; a blank prints nothing.
PrintedKeys printedBy(const std::vector<std::string>& texts) {
  const std::string places = "`1234567890-=QWERTYUIOP[]ASDFGHJKL;'\\ZXCVBNM,./";
  REQUIRE(texts.size() == places.size());
  PrintedKeys printed;
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (texts[i] != " ") {
      printed[static_cast<Key>(places[i])] = texts[i];
    }
  }
  return printed;
}

/// One text for each character of UTF-8.
std::vector<std::string> characters(const std::string& row) {
  std::vector<std::string> texts;
  for (const char c : row) {
    if ((static_cast<unsigned char>(c) & 0xC0U) == 0x80U) {
      texts.back() += c;
    } else {
      texts.emplace_back(1, c);
    }
  }
  return texts;
}

KeyboardLayout layoutOf(const std::string& row) {
  return KeyboardLayout(printedBy(characters(row)));
}

KeyboardLayout french() {
  return layoutOf("²&é\"'(-è_çà)=azertyuiop $qsdfghjklmù*wxcvbn,;:!");
}

KeyboardLayout german() {
  return layoutOf(" 1234567890ß qwertzuiopü+asdfghjklöä#yxcvbnm,.-");
}

KeyboardLayout dvorak() {
  return layoutOf("`1234567890[]',.pyfgcrl/=aoeuidhtns-\\;qjkxbmwvz");
}

KeyboardLayout russian() {
  return layoutOf("ё1234567890-=йцукенгшщзхъфывапролджэ\\ячсмитьбю.");
}

Key keyAt(const KeyboardLayout& layout, char place) {
  return layout.keyAt(static_cast<Key>(place));
}

} // namespace

TEST_CASE("Letters of a key go by what the layout prints") {
  CHECK(keyAt(french(), 'W') == Key{'Z'});
  CHECK(keyAt(french(), 'Q') == Key{'A'});
  CHECK(keyAt(french(), ';') == Key{'M'});
  CHECK(keyAt(german(), 'Y') == Key{'Z'});
  CHECK(keyAt(german(), 'Z') == Key{'Y'});
  CHECK(keyAt(dvorak(), '/') == Key{'Z'});
  CHECK(keyAt(dvorak(), ';') == Key{'S'});
}

TEST_CASE("Digits go by their place and are shown as digits") {
  CHECK(keyAt(french(), '1') == Key{'1'});
  CHECK(keyAt(french(), '6') == Key{'6'}); // Prints a minus.
  CHECK(french().chordText({Key{'6'}, true}) == "Ctrl+6");
  CHECK(keyAt(french(), '-') == Key::minus);
}

TEST_CASE("A layout without Latin letters goes by place") {
  CHECK(russian() == KeyboardLayout());
  CHECK(keyAt(russian(), 'Z') == Key{'Z'});
  CHECK(keyAt(russian(), '/') == Key::slash); // Prints a period.
  CHECK(KeyboardLayout(PrintedKeys{}) == KeyboardLayout());
}

TEST_CASE("Every key stands at one place of every layout") {
  for (const KeyboardLayout& layout : {french(), german(), dvorak(), russian()}) {
    std::set<Key> reached;
    for (const Key place : test::allKeys()) {
      reached.insert(layout.keyAt(place));
    }
    CHECK(reached.size() == test::allKeys().size());
  }
}

TEST_CASE("A key that another one has driven from its place stands where that came from") {
  CHECK(keyAt(german(), '/') == Key::minus);
  CHECK(keyAt(german(), '-') == Key::slash); // Shift with it types a question mark.
}

TEST_CASE("Chords are shown as the keyboard is labelled") {
  CHECK(french().chordText({Key{'Z'}, true}) == "Ctrl+Z");
  CHECK(french().chordText({Key::period}) == ":");
  CHECK(german().chordText({Key{'['}, false, false, true}) == "Alt+Ü");
  CHECK(german().chordText({Key::slash, false, true}) == "Shift+ß");
  CHECK(KeyboardLayout().chordText({Key::slash, false, true}) == "?");
  CHECK(french().chordText({Key::pageUp, false, true}) == "Shift+Page Up");
}

TEST_CASE("Letters of a label are capitals where there are such, and signs stay as they are printed") {
  const KeyboardLayout layout = layoutOf("à1234567890þ÷qwertyuiopÿ]asdfghjkl;'\\zxcvbnm,./");
  CHECK(layout.chordText({static_cast<Key>('`')}) == "À");
  CHECK(layout.chordText({Key::minus}) == "Þ");
  CHECK(layout.chordText({static_cast<Key>('=')}) == "÷");
  CHECK(layout.chordText({static_cast<Key>('[')}) == "ÿ");
}
