#pragma once

#include <string>
#include <utility>
#include <variant>

#include "source/internal_error.h"

namespace texbrdf {

/// A fault of the environment or of a request, told in one line for a person.
struct Failure {
  std::string message;
};

/// A value, or the reason why there is none (C++20 has no std::expected).
template <typename T>
class [[nodiscard]] Result {
 public:
  Result(T value) : state_(std::move(value)) {}            // NOLINT(google-explicit-constructor)
  Result(Failure failure) : state_(std::move(failure)) {}  // NOLINT(google-explicit-constructor)

  explicit operator bool() const { return std::holds_alternative<T>(state_); }
  const T& operator*() const& { return get(); }
  T& operator*() & { return const_cast<T&>(get()); }
  T&& operator*() && { return std::move(const_cast<T&>(get())); }
  const T* operator->() const { return &get(); }
  T* operator->() { return const_cast<T*>(&get()); }
  const std::string& error() const {
    require(!*this, "Result::error on a value");
    return std::get<Failure>(state_).message;
  }

 private:
  const T& get() const {
    require(static_cast<bool>(*this), "Result read without a value");
    return *std::get_if<T>(&state_);
  }
  std::variant<T, Failure> state_;
};

}  // namespace texbrdf
