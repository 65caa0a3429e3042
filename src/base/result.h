// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <stdexcept>
#include <string>
#include <utility>
#include <variant>

namespace dorsum {

// Why an expected failure happened; `main` maps each to one exit code.
enum class ErrorCode {
  kAnswerIsNo,  // the question was answered, and the answer is no (exit 1)
  kUsage,       // wrong arguments or option values (exit 2)
  kBadInput,    // a file, image or folder is unusable, or nowhere to write (exit 3)
  kDevice,      // camera or controller (exit 4)
  kInternal,    // our fault (exit 5)
  kCancelled,   // interrupted by the user (exit 130)
};

// One sentence that says what is wrong, where, and what to do.
struct Error {
  ErrorCode code = ErrorCode::kInternal;
  std::string message;
};

inline Error BadInput(std::string message) { return {ErrorCode::kBadInput, std::move(message)}; }
inline Error UsageError(std::string message) { return {ErrorCode::kUsage, std::move(message)}; }
inline Error Cancelled() { return {ErrorCode::kCancelled, "interrupted"}; }

// A value, or the reason why there is none. Reading the wrong side is a broken contract and throws.
template <class T>
class [[nodiscard]] Result {
 public:
  Result(T value) : state_(std::move(value)) {}      // NOLINT(google-explicit-constructor)
  Result(Error error) : state_(std::move(error)) {}  // NOLINT(google-explicit-constructor)

  bool ok() const { return std::holds_alternative<T>(state_); }
  explicit operator bool() const { return ok(); }

  const T& value() const& { return Checked(); }
  T& value() & { return const_cast<T&>(Checked()); }
  T&& value() && { return std::move(const_cast<T&>(Checked())); }
  const T& operator*() const& { return value(); }
  T& operator*() & { return value(); }
  const T* operator->() const { return &value(); }
  T* operator->() { return &value(); }

  const Error& error() const {
    if (ok()) throw std::logic_error("Result::error() of a value");
    return std::get<Error>(state_);
  }

 private:
  const T& Checked() const {
    if (!ok()) throw std::logic_error("Result::value() of an error: " + std::get<Error>(state_).message);
    return std::get<T>(state_);
  }
  std::variant<T, Error> state_;
};

// Success, or the reason for failure.
class [[nodiscard]] Status {
 public:
  Status() = default;
  Status(Error error) : failed_(true), error_(std::move(error)) {}  // NOLINT(google-explicit-constructor)
  bool ok() const { return !failed_; }
  explicit operator bool() const { return ok(); }
  const Error& error() const {
    if (ok()) throw std::logic_error("Status::error() of a success");
    return error_;
  }

 private:
  bool failed_ = false;
  Error error_;
};

}  // namespace dorsum

#define DORSUM_CONCAT_INNER(a, b) a##b
#define DORSUM_CONCAT(a, b) DORSUM_CONCAT_INNER(a, b)

// Returns the error of a Status or Result expression from the enclosing function, if it has one.
#define DORSUM_RETURN_IF_ERROR(expr)                        \
  do {                                                      \
    if (auto dorsum_status = (expr); !dorsum_status.ok()) { \
      return dorsum_status.error();                         \
    }                                                       \
  } while (false)

// Declares `lhs` with the value of a Result expression, or returns its error.
#define DORSUM_ASSIGN_OR_RETURN(lhs, expr) \
  DORSUM_ASSIGN_OR_RETURN_INNER(DORSUM_CONCAT(dorsum_result_, __LINE__), lhs, expr)
#define DORSUM_ASSIGN_OR_RETURN_INNER(tmp, lhs, expr) \
  auto tmp = (expr);                                  \
  if (!tmp.ok()) return tmp.error();                  \
  lhs = std::move(tmp).value()
