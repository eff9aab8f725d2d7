#include "runtime/update/update.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <optional>

#include "platform/file/read_file.h"
#include "platform/file/write_file.h"
#include "platform/signature/signed_text.h"
#include "platform/sqlite/content_reader.h"
#include "platform/sqlite/signature_block.h"
#include "runtime/schema/schema.h"

namespace docent::update {
namespace {

using release::Answer;
using release::DeviceState;
using release::Kept;
using release::Manifest;
using release::Time;

constexpr int patience_at_start = 2, patience = 120;  // seconds for whoever has the lock
constexpr std::uint64_t largest_health = 4096;

/// Would the kiosk show it? Every byte of it is looked at.
Result<void> check_database(const std::filesystem::path& file,
                            std::span<const signature::PublicKey> keys) {
  const Result<sqlite::Database> database = sqlite::open_database(file, schema::largest_shown);
  if (!database) return std::unexpected(database.error());
  if (!keys.empty())
    if (const Result<void> trusted = sqlite::check_signature(*database, file, keys); !trusted)
      return trusted;
  const Result<Museum> museum = sqlite::read_museum(*database, file, sqlite::Videos::LeaveInFile);
  if (!museum) return std::unexpected(museum.error());
  return {};
}

void tell_metrics(const Settings& settings, const DeviceState& state) {
  const std::string text = metrics(state);
  auto file = settings.store.database;
  const Result<void> told =
      file::replace_file(file.replace_filename("update.prom"), std::as_bytes(std::span(text)));
  if (!told) fmt::print(stderr, "docent-update: {}\n", told.error().what);  // no reason to stop
}

/// A manifest that was read and verified, with what the server calls its version.
struct Offer {
  std::optional<Manifest> manifest;  ///< Empty: the one known already.
  std::string etag;
};

Result<Offer> look(const Settings& settings, const DeviceState& state) {
  const std::string where = name_in(settings.source, release::manifest_name);
  const Result<Text> text =
      fetch_text(settings.source, release::manifest_name, release::largest_manifest, state.etag);
  if (!text) return std::unexpected(text.error());
  if (text->response.kind == https::Response::Kind::NotModified) return Offer{};
  if (text->response.kind == https::Response::Kind::NotFound)
    return std::unexpected(
        Error{Errc::NotFound, fmt::format("{}: there is no release; 'docent-content release' makes "
                                          "one",
                                          where)});
  const Result<std::string> verified =
      signature::read_signed_text(text->bytes, signature::Purpose::Release, settings.keys, where);
  if (!verified) return std::unexpected(verified.error());
  Result<Manifest> manifest = release::parse_manifest(*verified, where);
  if (!manifest) return std::unexpected(manifest.error());
  return Offer{.manifest = std::move(*manifest), .etag = text->response.etag};
}

/// Asked for only while a release is being rolled out.
std::optional<release::Health> look_at_health(const Settings& settings, const Manifest& manifest) {
  if (manifest.rollout.hours == 0) return std::nullopt;
  const Result<Text> text = fetch_text(settings.source, release::health_name, largest_health);
  return text ? release::parse_health(text->bytes) : std::nullopt;
}

Outcome outcome_of(Answer answer, const Manifest& manifest, const DeviceState& state) {
  const std::uint64_t offered = manifest.version;
  switch (answer) {
    case Answer::Take:
      return {"taken", state.shown, fmt::format("release {} is taken", offered)};
    case Answer::Current:
      return {"current", state.shown, fmt::format("release {} is shown already", offered)};
    case Answer::NotYet:
      return {
          "not_yet", state.shown,
          fmt::format("release {} is being rolled out and has not come to this kiosk", offered)};
    case Answer::Stopped:
      return {"stopped", state.shown,
              fmt::format("release {} is not taken: it was withdrawn, or kiosks went back from it",
                          offered)};
    case Answer::WentBack:
      return {"went_back", state.shown,
              fmt::format("release {} is not taken again: this kiosk went back from it", offered)};
    case Answer::OtherGroup:
      break;
  }
  return {"other_group", state.shown, fmt::format("release {} is for other kiosks", offered)};
}

/// Will the same manifest get the same answer for ever?
bool is_final(Answer answer) {
  return answer == Answer::Take || answer == Answer::Current || answer == Answer::WentBack ||
         answer == Answer::OtherGroup;
}

/// Brings what a newer program will show, so that it and its content change together. It is no
/// matter of today: where it fails, it is tried again with the next release.
void keep_for_newer_programs(const Settings& settings, const Manifest& manifest,
                             DeviceState& state) {
  for (const release::ReleasedFile& file : manifest.files)
    if (file.schema > settings.device.schema &&
        !keep(settings.store, settings.source, manifest.version, file, state))
      return;
}

Result<void> take(const Settings& settings, const Manifest& manifest, DeviceState& state,
                  Time now) {
  const release::ReleasedFile& file = *file_for(manifest, settings.device.schema);
  if (file.size > schema::largest_shown)
    return std::unexpected(Error{
        Errc::InvalidInput,
        fmt::format("release {} holds a database of {} MB, and the most that a kiosk shows is {}; "
                    "it is not fetched",
                    manifest.version, file.size >> 20U, schema::largest_shown >> 20U)});
  const Result<Kept> kept = keep(settings.store, settings.source, manifest.version, file, state);
  if (!kept) return std::unexpected(kept.error());
  const Result<void> sound = check_database(file_of(settings.store, *kept), settings.keys);
  if (!sound) {
    state.refused.push_back(manifest.version);  // it would be no better the next time
    state.etag.clear();                         // and whoever asks is told so
    if (const Result<void> saved = save_state(settings.store, state); !saved) return saved;
    return sound;
  }
  keep_for_newer_programs(settings, manifest, state);
  return show(settings.store, *kept, state, now);
}

/// Shows the newest release before this one that is still sound, and never this one again.
Result<Outcome> go_back_from_shown(const Settings& settings, DeviceState& state, Time now) {
  const std::uint64_t left = state.shown;
  while (const Kept* before = release::one_before(state, settings.device.schema)) {
    const Kept kept = *before;
    if (check_database(file_of(settings.store, kept), settings.keys)) {
      state.refused.push_back(left);
      state.etag.clear();
      if (const Result<void> shown = show(settings.store, kept, state, now); !shown)
        return std::unexpected(shown.error());
      tell_metrics(settings, state);
      return Outcome{"back", state.shown,
                     fmt::format("went back from release {} to release {}; {} is not taken again",
                                 left, state.shown, left)};
    }
    std::erase(state.kept, kept);
  }
  return std::unexpected(
      Error{Errc::InvalidInput,
            fmt::format("there is no release before {} on this kiosk; what is shown stays", left)});
}

Result<DeviceState> open_store(const Settings& settings) {
  Result<DeviceState> state = load_state(settings.store);
  if (!state) return state;
  if (const Result<void> recovered = recover(settings.store, *state); !recovered)
    return std::unexpected(recovered.error());
  return state;
}

}  // namespace

Result<Outcome> update(const Settings& settings, Time now) {
  const StoreLock lock(settings.store, patience);
  if (!lock.is_held()) return std::unexpected(lock.why());
  Result<DeviceState> state = open_store(settings);
  if (!state) return std::unexpected(state.error());
  const Result<Offer> offer = look(settings, *state);
  if (!offer) return std::unexpected(offer.error());
  if (!offer->manifest)
    return Outcome{"current", state->shown, "the release has not changed since it was last seen"};
  const Manifest& manifest = *offer->manifest;
  const Result<Answer> answer =
      release::decide(manifest, look_at_health(settings, manifest), *state, settings.device, now);
  if (!answer) return std::unexpected(answer.error());
  state->seen = manifest.version;
  state->seen_issued = manifest.issued;
  // An answer that a file of it may still be missing for, or that time changes, is asked for again.
  state->etag = is_final(*answer) ? offer->etag : std::string();
  if (*answer == Answer::Take) {
    if (const Result<void> taken = take(settings, manifest, *state, now); !taken)
      return std::unexpected(taken.error());
  } else if (*answer == Answer::Current) {
    keep_for_newer_programs(settings, manifest, *state);
  }
  if (const Result<void> saved = save_state(settings.store, *state); !saved)
    return std::unexpected(saved.error());
  forget(settings.store, *state, settings.device.schema);
  tell_metrics(settings, *state);
  return outcome_of(*answer, manifest, *state);
}

Result<Outcome> go_back(const Settings& settings, Time now) {
  const StoreLock lock(settings.store, patience);
  if (!lock.is_held()) return std::unexpected(lock.why());
  Result<DeviceState> state = open_store(settings);
  if (!state) return std::unexpected(state.error());
  return go_back_from_shown(settings, *state, now);
}

Result<Outcome> prepare_start(const Settings& settings, Time now) {
  const StoreLock lock(settings.store, patience_at_start);
  if (!lock.is_held()) return std::unexpected(lock.why());
  Result<DeviceState> state = open_store(settings);
  if (!state) return std::unexpected(state.error());
  const std::uint32_t schema = settings.device.schema;
  if (sqlite::schema_version_of(settings.store.database) != schema)
    if (const Kept* kept = release::newest_kept(*state, schema);
        kept != nullptr && check_database(file_of(settings.store, *kept), settings.keys)) {
      const Kept own = *kept;
      if (const Result<void> shown = show(settings.store, own, *state, now); !shown)
        return std::unexpected(shown.error());
      return Outcome{"changed", state->shown,
                     fmt::format("shows release {}, which this program can show", own.version)};
    }
  const bool is_third = release::note_start(*state, now);
  if (is_third)
    if (Result<Outcome> back = go_back_from_shown(settings, *state, now)) return back;
  if (const Result<void> saved = save_state(settings.store, *state); !saved)
    return std::unexpected(saved.error());
  return Outcome{"current", state->shown, "the kiosk starts with what it has"};
}

std::string metrics(const DeviceState& state) {
  std::string text = fmt::format(
      "# HELP docent_release_shown The release that this kiosk shows; 0: copied by hand.\n"
      "# TYPE docent_release_shown gauge\ndocent_release_shown {}\n"
      "# HELP docent_release_seen The newest release that this kiosk has seen.\n"
      "# TYPE docent_release_seen gauge\ndocent_release_seen {}\n"
      "# HELP docent_release_went_back Releases that this kiosk has gone back from.\n"
      "# TYPE docent_release_went_back gauge\n",
      state.shown, state.seen);
  for (const std::uint64_t version : state.refused)
    text += fmt::format("docent_release_went_back{{release=\"{}\"}} 1\n", version);
  return text;
}

}  // namespace docent::update
