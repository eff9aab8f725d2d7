#pragma once

namespace docent::test {

/// How often this program has called operator new.
long allocation_count() noexcept;

}  // namespace docent::test
