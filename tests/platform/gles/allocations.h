#pragma once

namespace docent::test {

/// How often this thread has called operator new.
long allocations_of_this_thread() noexcept;

}  // namespace docent::test
