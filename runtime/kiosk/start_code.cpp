#include "runtime/kiosk/start_code.h"

#include <link.h>
#include <sys/mman.h>
#include <unistd.h>

#include <cstddef>
#include <cstdint>
#include <span>

namespace docent::kiosk {
namespace {

/// Smaller ones are not worth the faults with which their pages come back.
constexpr std::size_t large = 16 * 1024 * 1024;

/// Segments that may not be written to hold nothing but bytes of the file: what the dynamic linker
/// relocates lies in a writable one. So giving them back loses nothing.
int give_back(dl_phdr_info* library, std::size_t, void*) noexcept {
  const auto page = static_cast<std::uintptr_t>(sysconf(_SC_PAGESIZE));
  for (const ElfW(Phdr) & segment : std::span(library->dlpi_phdr, library->dlpi_phnum)) {
    if (segment.p_type != PT_LOAD || (segment.p_flags & PF_W) != 0 || segment.p_memsz < large)
      continue;
    const std::uintptr_t begin = (library->dlpi_addr + segment.p_vaddr) / page * page;
    const std::uintptr_t end = library->dlpi_addr + segment.p_vaddr + segment.p_memsz;
    // NOLINTNEXTLINE(performance-no-int-to-ptr): the linker tells addresses as numbers
    madvise(reinterpret_cast<void*>(begin), end - begin, MADV_DONTNEED);
  }
  return 0;
}

}  // namespace

void give_back_code_of_start() noexcept {
  dl_iterate_phdr(give_back, nullptr);
}

}  // namespace docent::kiosk
