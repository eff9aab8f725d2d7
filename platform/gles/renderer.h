#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>

#include "platform/display.h"
#include "platform/gles/holdings.h"
#include "runtime/model/result.h"
#include "runtime/scene/shown_list.h"

namespace docent::gles {

struct RendererOptions {
  std::uint32_t samples = 4;  ///< For each pixel of the model; 0 or 1: jagged, in half the time.
  /// The model (building, avatars and way) is drawn in horizontal strips, so that its multisampled
  /// buffers take no more bytes than this, or than 64 rows do. A GPU is quicker with all of the
  /// screen in one strip.
  std::size_t buffer_bytes = std::size_t{5} << 20;
};

/// Draws draw lists with OpenGL ES 3. Made, used and destroyed on the thread on which a context is
/// current; that context outlives it.
///
/// `draw` does not allocate, cannot fail, and shows less where a list asks for what the holdings
/// have not.
class Renderer {
 public:
  Renderer(Renderer&&) noexcept;
  Renderer& operator=(Renderer&&) noexcept;
  ~Renderer();

  /// Draws one of everything into a corner of the target, so that the driver has compiled what
  /// frames need. Takes about a tenth of a second on a CPU.
  void warm_up(RenderTarget target);

  /// Draws into the target what differs from the list before, which was drawn into it, too; all of
  /// it where there was none.
  ///
  /// Where that is all of the model it is drawn with `fineness` of the picture's lines and columns,
  /// in (0, 1], and enlarged. Each list that leaves it as it is then draws some rows of it anew
  /// with all of them.
  ///
  /// A Plain target is given the parts of the picture that it lacks: `age` is as Display::age()
  /// says, where each of these calls is presented.
  void draw(const scene::DrawList& list, const Holdings& holdings, const RenderTarget& target,
            const scene::Change& change = {}, float fineness = 1, std::uint32_t age = 0) noexcept;
  /// Is any of the picture still one that was enlarged?
  bool is_coarse() const noexcept;

 private:
  friend Result<Renderer> make_renderer(const RendererOptions&);
  struct Parts;
  explicit Renderer(std::unique_ptr<Parts> parts) noexcept;
  std::unique_ptr<Parts> parts_;
};

/// Compiles the shaders in the current context. Fails with the driver's own words.
Result<Renderer> make_renderer(const RendererOptions& options = {});

}  // namespace docent::gles
