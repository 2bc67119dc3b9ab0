#pragma once

#include "microslip.h"
#include "microslip/error.hpp"
#include "microslip/status.hpp"

#include <algorithm>
#include <atomic>
#include <new>
#include <stdexcept>
#include <string>
#include <string_view>

namespace microslip::c {

/// A call that is refused for another reason than a value out of range.
struct Refusal : std::runtime_error {
  Refusal(microslip_code why, const std::string& text) : std::runtime_error(text), code(why) {}
  microslip_code code;
};

/// Writes code and text, cut to the space there is; returns the code.
inline microslip_code report(microslip_error* error, microslip_code code, std::string_view text) noexcept {
  if (!error) return code;
  error->code = code;
  const std::size_t length = std::min<std::size_t>(text.size(), MICROSLIP_ERROR_LENGTH - 1);
  std::copy_n(text.data(), length, error->text);
  error->text[length] = 0;
  return code;
}

/// Runs the body of a call, which returns nothing or reports itself. Whatever it throws becomes a code and a text.
template <class Body> microslip_code guarded(microslip_error* error, Body body) noexcept {
  try {
    if constexpr (std::is_same_v<decltype(body()), void>) {
      body();
      return report(error, MICROSLIP_OK, "");
    } else {
      return body();
    }
  } catch (const Refusal& refusal) {
    return report(error, refusal.code, refusal.what());
  } catch (const Error& refusal) {
    return report(error, MICROSLIP_INVALID_OPTION, refusal.what());
  } catch (const std::bad_alloc&) {
    return report(error, MICROSLIP_OUT_OF_MEMORY, "not enough memory");
  } catch (const std::exception& fault) {
    return report(error, MICROSLIP_INTERNAL_ERROR, fault.what());
  } catch (...) {
    return report(error, MICROSLIP_INTERNAL_ERROR, "unknown exception");
  }
}

/// Returns the pointer or refuses a null one by name.
template <class Value> Value* require_pointer(std::string_view name, Value* pointer) {
  if (!pointer) throw Refusal(MICROSLIP_NULL_POINTER, std::string(name) + " is NULL");
  return pointer;
}

/// A mark on a handle that one thread at a time may use.
using InUse = std::atomic<bool>;
static_assert(InUse::is_always_lock_free);

/// Sets a handle's mark for the time of a call; `granted` is false while another thread has set it.
class Use {
public:
  explicit Use(InUse& mark) noexcept : mark_(mark.exchange(true, std::memory_order_acquire) ? nullptr : &mark) {}
  Use(const Use&) = delete;
  Use& operator=(const Use&) = delete;
  ~Use() {
    if (mark_) mark_->store(false, std::memory_order_release);
  }
  bool granted() const noexcept { return mark_ != nullptr; }

private:
  InUse* mark_;
};

/// `guarded` with a handle that has a mark `in_use`: refused if the handle is NULL or another thread uses it.
template <class Handle, class Body>
microslip_code guarded_use(microslip_error* error, std::string_view name, Handle* handle, Body body) noexcept {
  return guarded(error, [&] {
    const Use use(require_pointer(name, handle)->in_use);
    if (!use.granted()) throw Refusal(MICROSLIP_IN_USE, std::string(name) + " is in use by another thread");
    return body();
  });
}

/// Guards calls that have no error, take no memory and throw nothing themselves.
template <class Handle, class Body> microslip_code with_handle(Handle* handle, const Body& body) noexcept {
  if (!handle) return MICROSLIP_NULL_POINTER;
  const Use use(handle->in_use);
  return use.granted() ? body() : MICROSLIP_IN_USE;
}

inline void require_size(std::string_view name, std::size_t size, std::size_t wanted) {
  if (size == wanted) return;
  throw Refusal(MICROSLIP_WRONG_SIZE,
                std::string(name) + " = " + std::to_string(size) + ": must be " + std::to_string(wanted));
}

/// Throws Error for rows longer than their list; they may be shorter.
inline void require_at_most(std::string_view name, std::size_t size, std::size_t longest) {
  if (size <= longest) return;
  throw Refusal(MICROSLIP_WRONG_SIZE,
                std::string(name) + " = " + std::to_string(size) + ": must be at most " + std::to_string(longest));
}

/// A text to be released by microslip_free_text.
inline char* text_copy(std::string_view text) {
  char* const copy = new char[text.size() + 1];
  std::copy_n(text.data(), text.size(), copy);
  copy[text.size()] = 0;
  return copy;
}

/// The code that stands for a status: the first five are the same.
constexpr microslip_code code_of(Status status) {
  return static_cast<microslip_code>(static_cast<int>(status));
}
static_assert(code_of(Status::ok) == MICROSLIP_OK && code_of(Status::invalid_input) == MICROSLIP_INVALID_INPUT &&
              code_of(Status::not_converged) == MICROSLIP_NOT_CONVERGED &&
              code_of(Status::no_contact) == MICROSLIP_NO_CONTACT &&
              code_of(Status::no_solution) == MICROSLIP_NO_SOLUTION &&
              code_of(Status::out_of_range) == MICROSLIP_OUT_OF_RANGE &&
              code_of(Status::implausible) == MICROSLIP_IMPLAUSIBLE);

/// An enumerator from the number that stands for it, of `count` that begin with 0.
template <class Choice> Choice choice(std::string_view field, int value, int count) {
  return static_cast<Choice>(require_count(field, value, 0, count - 1));
}

} // namespace microslip::c
