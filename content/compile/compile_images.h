#pragma once

#include <cstddef>
#include <cstdint>

#include "config/museum_config.h"
#include "content/compile/report.h"
#include "runtime/model/museum.h"

namespace docent::compile {

/// Reads the exhibits' images, each file once, and ties the exhibits to them. The museum's exhibits
/// are those of the config, in its order. Problems go into the report, with the place of `image`.
/// A check makes only pictures that are touched: the others stay empty. Videos that have more than
/// `many_bytes` together are told of, because a kiosk reads all of its database when it starts.
enum class Images : std::uint8_t { Make, Check };
void compile_images(const config::MuseumConfig& config, Images use, unsigned jobs, Museum& museum,
                    Report& report, std::size_t many_bytes = std::size_t{200} << 20U);

}  // namespace docent::compile
