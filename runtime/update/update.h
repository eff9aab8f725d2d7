#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "platform/signature/key.h"
#include "runtime/release/decision.h"
#include "runtime/update/source.h"
#include "runtime/update/store.h"

namespace docent::update {

struct Settings {
  Store store;
  Source source;
  std::vector<signature::PublicKey> keys{};
  release::Device device;
};

/// What came of it, for people and for programs.
struct Outcome {
  std::string status{};       ///< In snake case: taken, current, not_yet, ...
  std::uint64_t release = 0;  ///< The one that is shown now; 0: a database copied by hand, or none.
  std::string sentence{};
};

/// Looks once for a release, and takes it where release::decide says so. Whatever fails, what was
/// shown is shown.
Result<Outcome> update(const Settings& settings, release::Time now);

/// Shows the release before the one shown, which is not taken again.
Result<Outcome> go_back(const Settings& settings, release::Time now);

/// The kiosk is about to start. Goes back where it starts for the third time within ten minutes of
/// an update, and changes to a kept release of the program's own schema version where the database
/// shown is of another.
Result<Outcome> prepare_start(const Settings& settings, release::Time now);

/// What a device tells of its releases, as node_exporter's textfile collector reads it.
std::string metrics(const release::DeviceState& state);

}  // namespace docent::update
