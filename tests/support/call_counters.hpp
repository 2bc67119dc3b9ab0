// Counts memory taken, locks, writes and exceptions of calls that must do none of it: replaces the functions by which
// they could, and passes on to the real ones. The sanitizers replace the C functions themselves; with them only the C++
// ones are counted. A program includes this once.
#pragma once

#include "tests/support/sanitized.hpp"

#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <new>

#include <dlfcn.h>
#include <pthread.h>
#include <unistd.h>

#include <gtest/gtest.h>

namespace {

struct Counts {
  std::atomic<int> allocations = 0, locks = 0, writes = 0, throws = 0;
};
Counts counts;
std::atomic<bool> counting = false;

void count(std::atomic<int>& what) {
  if (counting) ++what;
}

/// The function of this name that this program hides.
template <class Function> Function* real(const char* name) {
  return reinterpret_cast<Function*>(dlsym(RTLD_NEXT, name));
}

} // namespace

void* operator new(std::size_t size) {
  count(counts.allocations);
  if (void* memory = std::malloc(size)) return memory;
  throw std::bad_alloc();
}
void* operator new(std::size_t size, std::align_val_t alignment) {
  count(counts.allocations);
  const auto step = static_cast<std::size_t>(alignment);
  if (void* memory = std::aligned_alloc(step, (size + step - 1) / step * step)) return memory;
  throw std::bad_alloc();
}
void operator delete(void* memory) noexcept {
  count(counts.allocations);
  std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
  operator delete(memory);
}
void operator delete(void* memory, std::align_val_t) noexcept {
  operator delete(memory);
}
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept {
  operator delete(memory);
}

extern "C" {

/// Every exception begins with this.
void* __cxa_allocate_exception(std::size_t size) noexcept {
  count(counts.throws);
  return real<void*(std::size_t)>("__cxa_allocate_exception")(size);
}

#ifndef MICROSLIP_SANITIZED
void* __libc_malloc(std::size_t size);
void* __libc_calloc(std::size_t number, std::size_t size);
void* __libc_realloc(void* memory, std::size_t size);
void* __libc_memalign(std::size_t alignment, std::size_t size);
void __libc_free(void* memory);

void* malloc(std::size_t size) noexcept {
  count(counts.allocations);
  return __libc_malloc(size);
}
void* calloc(std::size_t number, std::size_t size) noexcept {
  count(counts.allocations);
  return __libc_calloc(number, size);
}
void* realloc(void* memory, std::size_t size) noexcept {
  count(counts.allocations);
  return __libc_realloc(memory, size);
}
void* aligned_alloc(std::size_t alignment, std::size_t size) noexcept {
  count(counts.allocations);
  return __libc_memalign(alignment, size);
}
void free(void* memory) noexcept {
  count(counts.allocations);
  __libc_free(memory);
}

int pthread_mutex_lock(pthread_mutex_t* mutex) noexcept {
  count(counts.locks);
  static auto* const lock = real<int(pthread_mutex_t*)>("pthread_mutex_lock");
  return lock(mutex);
}
int pthread_mutex_trylock(pthread_mutex_t* mutex) noexcept {
  count(counts.locks);
  static auto* const lock = real<int(pthread_mutex_t*)>("pthread_mutex_trylock");
  return lock(mutex);
}
ssize_t write(int file, const void* bytes, std::size_t size) {
  count(counts.writes);
  static auto* const real_write = real<ssize_t(int, const void*, std::size_t)>("write");
  return real_write(file, bytes, size);
}
std::FILE* fopen(const char* path, const char* mode) {
  count(counts.writes);
  static auto* const open_file = real<std::FILE*(const char*, const char*)>("fopen");
  return open_file(path, mode);
}
#endif
}

namespace microslip {
namespace {

/// Whether something was written to standard output or error meanwhile, through any function.
class Silence {
public:
  Silence() {
    std::fflush(nullptr);
    for (int k = 0; k < 2; ++k) {
      saved_[k] = dup(k + 1);
      catch_[k] = std::tmpfile();
      dup2(fileno(catch_[k]), k + 1);
    }
  }
  ~Silence() { end(); }
  long end() {
    if (ended_) return bytes_;
    std::fflush(nullptr);
    for (int k = 0; k < 2; ++k) {
      bytes_ += lseek(fileno(catch_[k]), 0, SEEK_END);
      dup2(saved_[k], k + 1);
      close(saved_[k]);
      std::fclose(catch_[k]);
    }
    ended_ = true;
    return bytes_;
  }

private:
  int saved_[2];
  std::FILE* catch_[2];
  long bytes_ = 0;
  bool ended_ = false;
};

template <class Call> void expect_silent(Call call) {
  for (auto* number : {&counts.allocations, &counts.locks, &counts.writes, &counts.throws}) *number = 0;
  Silence silence;
  counting = true;
  call();
  counting = false;
  EXPECT_EQ(silence.end(), 0);
  EXPECT_EQ(counts.allocations, 0);
  EXPECT_EQ(counts.locks, 0);
  EXPECT_EQ(counts.writes, 0);
  EXPECT_EQ(counts.throws, 0);
}

} // namespace
} // namespace microslip
