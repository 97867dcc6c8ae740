#include <catch2/catch.hpp>

#include "ui/widgets/arithmetic.h"

using namespace stretch::ui;

TEST_CASE("Sums are typed into number fields, by the rules of school") {
  CHECK(typedNumber("1+2*3", 0.0) == 7.0);
  CHECK(typedNumber("(1+2)*3", 0.0) == 9.0);
  CHECK(typedNumber("10/4-1", 0.0) == 1.5);
  CHECK(typedNumber("-2,5", 0.0) == -2.5);
  CHECK(typedNumber("2*-3", 0.0) == -6.0);
}

TEST_CASE("Sums of many terms are reckoned from left to right, and a sign may stand before a number") {
  CHECK(typedNumber("10-4-3", 0.0) == 3.0);
  CHECK(typedNumber("24/4/3", 0.0) == 2.0);
  CHECK(typedNumber("+3", 0.0) == 3.0);
  CHECK(typedNumber("2--1", 0.0) == 3.0);
}

TEST_CASE("A sum may go on from the value that is there") {
  CHECK(typedNumber("+=0.5", 2.0) == 2.5);
  CHECK(typedNumber("-=0.5", 2.0) == 1.5);
  CHECK(typedNumber("*=3", 2.0) == 6.0);
  CHECK(typedNumber("/=4", 2.0) == 0.5);
}

TEST_CASE("What is no number stays untyped") {
  for (const char* text : {"", "1+", "(1", "2)", "*3", "1/0", "?=2", "one"}) {
    INFO(text);
    CHECK_FALSE(typedNumber(text, 1.0));
  }
}
