#pragma once

#include <filesystem>
#include <memory>
#include <vector>

#include "platform/gles/renderer.h"
#include "runtime/guide/guide.h"
#include "runtime/model/museum.h"
#include "runtime/model/result.h"
#include "runtime/plan/planner.h"

namespace docent {

/// A museum with everything that runs it: changed as one when a new database is taken up. Neither
/// copied nor moved, because its parts borrow each other.
struct Exhibition {
  Museum museum;
  std::unique_ptr<Planner> planner;
  std::unique_ptr<Guide> guide;
  std::vector<Pixels> pictures;  ///< Decoded images, until they are in texture memory.

  Exhibition() = default;
  Exhibition(const Exhibition&) = delete;
  Exhibition& operator=(const Exhibition&) = delete;
};

/// Reads a database and makes all of it ready; takes a while, so not on the frame thread.
Result<std::unique_ptr<Exhibition>> load_exhibition(const std::filesystem::path& database,
                                                    const GuideSettings& settings);

/// Carries the building, the body and the pictures into texture memory. Frame thread.
void upload(Exhibition& exhibition, Renderer& renderer);

/// Gives the memory of its texts and pictures back. Frame thread.
void release(const Exhibition& exhibition, Renderer& renderer) noexcept;

/// Applies what the worker's text cache changed. Frame thread; does not allocate.
void apply_texts(Guide& guide, Renderer& renderer) noexcept;

}  // namespace docent
