#pragma once

#include <string>

namespace stretch::test {

/// Compares a text with tests/recorded/NAME.txt, which holds what was right when it was looked at: words are
/// the same, numbers at most `tolerance` apart, or that share of the larger one. Where they differ, or
/// without a record, the text is written to `recorded-differences` beside the test program, and the answer
/// names the first line that differs and says what to do; empty when equal.
///
/// For what many small decisions make together, such as everything that is read of a body: a change of any of
/// them shows, and the difference of two records tells what it means. What a number ought to be is told by
/// tests of its own.
[[nodiscard]] std::string differenceFromRecord(const std::string& name, const std::string& text,
                                               double tolerance = 1e-4);

/// Fails the test with that answer where they differ.
void compareWithRecord(const std::string& name, const std::string& text, double tolerance);

} // namespace stretch::test
