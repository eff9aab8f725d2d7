#include "runtime/kiosk/allocations.h"

#include <malloc.h>

#include <cstdlib>
#include <new>

// Where the linker put the program's code: the names are its.
// NOLINTNEXTLINE(bugprone-reserved-identifier,readability-identifier-naming)
extern "C" const char __executable_start, etext;

namespace {

thread_local docent::kiosk::Allocations counted;

/// Is this address in the program's own code?
bool is_own(const void* caller) noexcept {
  const auto* address = static_cast<const char*>(caller);
  return address >= &__executable_start && address < &etext;
}

void count(const void* caller) noexcept {
  ++counted.all;
  if (is_own(caller)) ++counted.own;
}

void* allocate(std::size_t size) {
  if (void* memory = std::malloc(size == 0 ? 1 : size)) return memory;
  throw std::bad_alloc();
}

void* allocate(std::size_t size, std::align_val_t alignment) {
  const auto step = static_cast<std::size_t>(alignment);
  if (void* memory = std::aligned_alloc(step, (size + step - 1) / step * step)) return memory;
  throw std::bad_alloc();
}

}  // namespace

// All forms, so that what one of them took is never given back to another's: under a sanitizer the
// forms left out are the sanitizer's own, and LLVM inside the graphics driver uses nothrow.
void* operator new(std::size_t size) {
  count(__builtin_return_address(0));
  return allocate(size);
}
void* operator new[](std::size_t size) {
  count(__builtin_return_address(0));
  return allocate(size);
}
void* operator new(std::size_t size, std::align_val_t alignment) {
  count(__builtin_return_address(0));
  return allocate(size, alignment);
}
void* operator new[](std::size_t size, std::align_val_t alignment) {
  count(__builtin_return_address(0));
  return allocate(size, alignment);
}
void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  count(__builtin_return_address(0));
  return std::malloc(size == 0 ? 1 : size);
}
void* operator new[](std::size_t size, const std::nothrow_t&) noexcept {
  count(__builtin_return_address(0));
  return std::malloc(size == 0 ? 1 : size);
}
void operator delete(void* memory, const std::nothrow_t&) noexcept {
  std::free(memory);
}
void operator delete[](void* memory, const std::nothrow_t&) noexcept {
  std::free(memory);
}
void operator delete(void* memory) noexcept {
  std::free(memory);
}
void operator delete[](void* memory) noexcept {
  std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
  std::free(memory);
}
void operator delete[](void* memory, std::size_t) noexcept {
  std::free(memory);
}
void operator delete(void* memory, std::align_val_t) noexcept {
  std::free(memory);
}
void operator delete[](void* memory, std::align_val_t) noexcept {
  std::free(memory);
}
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept {
  std::free(memory);
}
void operator delete[](void* memory, std::size_t, std::align_val_t) noexcept {
  std::free(memory);
}

namespace docent::kiosk {

/// Blocks above the threshold are mappings of their own, which go back to the system when freed and
/// of which only what was written is in memory. Left to itself glibc would raise the threshold with
/// the first picture and keep all of them in its heap for months.
///
/// While starting, that is good for the database, for pictures, and for Mesa, which keeps each
/// shader in several 32 KB slabs and writes to a part of them. A software driver takes and frees
/// blocks of 64 KB in every frame, and mapping those each time costs the frame thread half as much
/// again.
void prepare_allocator_for(Phase phase) noexcept {
  constexpr int mesa_slab = 32 * 1024, picture = 256 * 1024;
  mallopt(M_MMAP_THRESHOLD, phase == Phase::Start ? mesa_slab : picture);
  mallopt(M_ARENA_MAX, 2);  // the frame's and the worker's; the driver's threads hardly allocate
  if (phase == Phase::Frames) give_back_freed_memory();
}

void give_back_freed_memory() noexcept {
  malloc_trim(0);
}

Allocations allocations_on_this_thread() noexcept {
  return counted;
}

}  // namespace docent::kiosk
