#pragma once

#include <spng.h>

#include <memory>

namespace docent::image {

struct FreePng {
  void operator()(spng_ctx* context) const noexcept { spng_ctx_free(context); }
};
/// A PNG file while it is read or written.
using PngContext = std::unique_ptr<spng_ctx, FreePng>;

}  // namespace docent::image
