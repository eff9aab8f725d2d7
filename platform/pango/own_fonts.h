#pragma once

#include <fontconfig/fontconfig.h>

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "platform/file_descriptor.h"
#include "platform/handle.h"
#include "runtime/model/livery.h"

/// Internal to pango.
namespace docent::pango {

/// The fonts that a museum brings along, beside this machine's. They lie in memory: nothing is
/// written anywhere. A configuration that is in use is never changed, because Pango reads it on a
/// thread of its own.
class OwnFonts {
 public:
  /// Takes these files besides those before, whose museum may still be shown for some minutes, and
  /// in place of older ones. One that cannot be read is left out. False where they are the same.
  bool take(std::span<const FontFile> files);
  /// Null: there are none, and this machine's are enough.
  FcConfig* config() const noexcept { return config_.get(); }

 private:
  std::vector<std::size_t> taken_;  ///< A hash of each file.
  std::vector<FileDescriptor> memory_, before_;
  std::unique_ptr<FcConfig, CloseWith<FcConfigDestroy>> config_;
};

}  // namespace docent::pango
