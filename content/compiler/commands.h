#pragma once

namespace CLI {
class App;
}

/// The commands of docent-content, one file each. A command adds itself and its options to `app`;
/// when it is the one that was called, it runs and leaves its exit code in `exit_code`. What it
/// throws is reported by main.
namespace docent {}
