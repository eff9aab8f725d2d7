#pragma once

#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "platform/gles/renderer.h"
#include "platform/signature/key.h"
#include "runtime/guide/guide.h"
#include "runtime/kiosk/kiosk_status.h"
#include "runtime/model/museum.h"
#include "runtime/model/result.h"
#include "runtime/plan/planner.h"

namespace docent::kiosk {

/// A museum with everything that runs it: replaced as a whole by a new database. Neither copied nor
/// moved, because its parts borrow each other.
struct Exhibition {
  Museum museum;
  ContentFacts content;
  std::unique_ptr<plan::Planner> planner;
  std::unique_ptr<guide::Guide> guide;
  std::vector<Pixels> scenery_pictures;  ///< By image, until they are in texture memory.

  Exhibition() = default;
  Exhibition(const Exhibition&) = delete;
  Exhibition& operator=(const Exhibition&) = delete;
};

/// Reads a museum that can be shown and, where there are keys, is signed with one of them, and
/// writes down of which database, where `facts` are wanted. Fails with a sentence.
Result<Museum> read_museum(const std::filesystem::path& database,
                           std::span<const signature::PublicKey> keys,
                           ContentFacts* facts = nullptr);
/// What a museum is, in a line for the journal: its title and how much it holds.
std::string summary(const Museum& museum);

/// Reads a database and makes all of it ready. Takes a while, so do not call on the frame thread.
Result<std::unique_ptr<Exhibition>> load_exhibition(const std::filesystem::path& database,
                                                    std::span<const signature::PublicKey> keys,
                                                    const guide::GuideSettings& settings);

/// Carries the building with its pictures and the body into texture memory. Frame thread.
void upload(Exhibition& exhibition, gles::Renderer& renderer);

/// Applies what the worker's cache of pieces changed; false where that is nothing. Frame thread;
/// does not allocate.
bool apply_pieces(guide::Guide& guide, gles::Renderer& renderer) noexcept;

}  // namespace docent::kiosk
