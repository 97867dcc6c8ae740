#pragma once

#include <string>
#include <utility>
#include <variant>

#include "core/base/check.h"

namespace stretch {

/// An error that a file, a user or a geometry caused; a person reads it.
struct Error {
  std::string what;   ///< The fault: "the accessor reads past the end of its buffer view".
  std::string where;  ///< Place in the file or the command line: "accessors[3]". May be empty.
  std::string remedy; ///< The way out: "export the file again". May be empty.

  /// One line without a newline: "where: what; remedy".
  [[nodiscard]] std::string line() const {
    const std::string head = where.empty() ? what : where + ": " + what;
    return remedy.empty() ? head : head + "; " + remedy;
  }
};

/// The error with the file named before the place in it, unless it is named already.
[[nodiscard]] inline Error inFile(const std::string& file, Error error) {
  if (!error.where.starts_with(file)) {
    error.where = error.where.empty() ? file : file + ": " + error.where;
  }
  return error;
}

/// A value, or the reason why there is none. Reading the side that is not there is a broken invariant.
template <typename T>
class [[nodiscard]] Result {
public:
  Result(T value) : state_(std::in_place_index<0>, std::move(value)) {}
  Result(Error error) : state_(std::in_place_index<1>, std::move(error)) {}

  [[nodiscard]] bool ok() const { return state_.index() == 0; }
  explicit operator bool() const { return ok(); }

  [[nodiscard]] const T& value() const& {
    check(ok(), "Result::value() read from an error");
    return *std::get_if<0>(&state_);
  }
  [[nodiscard]] T& value() & {
    check(ok(), "Result::value() read from an error");
    return *std::get_if<0>(&state_);
  }
  [[nodiscard]] T&& value() && {
    check(ok(), "Result::value() read from an error");
    return std::move(*std::get_if<0>(&state_));
  }
  [[nodiscard]] const Error& error() const {
    check(state_.index() == 1, "Result::error() read from a value");
    return *std::get_if<1>(&state_);
  }

  const T& operator*() const& { return value(); }
  T& operator*() & { return value(); }
  const T* operator->() const { return &value(); }
  T* operator->() { return &value(); }

private:
  std::variant<T, Error> state_;
};

/// For operations that answer nothing but success: `return Success{};`.
struct Success {};
using Status = Result<Success>;

} // namespace stretch
